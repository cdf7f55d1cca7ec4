//! The reader of native view documents: views, and everything that is wrong with the document.

use super::contents::{contents, no_contents};
use super::fields::{Fields, Stands};
use super::naming::AutomaticNames;
use super::read_scene::claim;
use super::root::{DocumentKind, check_root};
use super::sink::Sink;
use super::vocabulary::{EYE, SCREEN, VIEW, VIEWS};
use super::{Document, Element, Excerpt, StructureProblem};
use crate::{Outcome, Span};
use lancer_scene::{Name, NameKind, Screen, ScreenSpec, View, Views};
use std::collections::HashMap;

/// Reads native views: the root `views`, or one bare `view`.
pub fn read_views(document: &Document) -> Outcome<Views> {
    let mut sink = Sink::new(document);
    let views = read(document, &mut sink).map(|read| read.views);
    sink.finish(views)
}

/// Views with the elements that they were read from, in their order.
pub(super) struct ReadViews<'d> {
    pub(super) views: Views,
    pub(super) elements: Vec<Element<'d>>,
}

/// The views as far as they could be read.
pub(super) fn read<'d>(document: &'d Document, sink: &mut Sink<'d>) -> Option<ReadViews<'d>> {
    if !check_root(document, DocumentKind::Views, sink) {
        return None;
    }
    let root = document.root();
    let mut names = HashMap::new();
    let read = if root.name() == VIEW.name {
        vec![(root, view(root, Stands::AtRoot, &mut names, sink))]
    } else {
        Fields::read(root, &VIEWS, Stands::AtRoot, sink);
        let elements = contents(root, &VIEWS, sink);
        if root.elements().next().is_none() {
            sink.warning(root.name_span(), StructureProblem::NoViews);
        }
        elements.into_iter().map(|(_, element)| (element, view(element, Stands::Within, &mut names, sink))).collect()
    };
    let mut automatic = AutomaticNames::new(names.into_keys());
    let elements = read.iter().map(|(element, _)| *element).collect();
    let views = read.into_iter().map(|(_, view)| {
        let (name, view) = view?;
        Some(View { name: name.unwrap_or_else(|| automatic.next(VIEW.name)), ..view })
    });
    Some(ReadViews { views: views.collect::<Option<_>>()?, elements })
}

/// One view, with its name if it has one.
fn view<'d>(
    element: Element<'d>,
    stands: Stands,
    names: &mut HashMap<Name, Span>,
    sink: &mut Sink<'d>,
) -> Option<(Option<Name>, View)> {
    let fields = Fields::read(element, &VIEW, stands, sink);
    let name = fields.text_of("name").map(|(name, span)| (Name::from(name), span));
    if let Some((name, span)) = &name {
        claim(names, name, *span, NameKind::View, sink);
    }
    let name = name.map(|(name, _)| name);
    let (mut eye, mut screen) = (None, None);
    for (rule, child) in contents(element, &VIEW, sink) {
        match rule.name {
            "eye" => eye = Some(child),
            _ => screen = Some(child),
        }
    }
    let spoken_name = name.clone().unwrap_or_else(|| VIEW.name.into());
    let screen = screen.map(|screen| (screen, screen_of(screen, sink)));
    let Some(eye) = eye else {
        let sample = "<eye at=\"0 1 5\" look-at=\"0 0 0\"/>";
        let problem = StructureProblem::MissingElement { name: EYE.name, parent: VIEW.name, sample };
        sink.error(element.name_span(), problem);
        return None;
    };
    let eye_fields = Fields::read(eye, &EYE, Stands::Within, sink);
    no_contents(eye, &EYE, sink);
    let at = eye_fields.point("at");
    let looks = eye.attribute("look-at").is_some();
    // The element that gives the screen, for what is wrong with the whole.
    let (giver, spec) = match screen {
        None if looks => {
            let spec = looked_at(&eye_fields);
            (eye_fields, spec)
        }
        None => {
            // one that was meant is told already
            if !eye_fields.meant("look-at") {
                sink.error(eye.name_span(), StructureProblem::NoScreen { name: Excerpt::new(&spoken_name) });
            }
            return None;
        }
        Some((screen, _)) if looks => {
            sink.error(screen.name_span(), StructureProblem::ScreenBesideLookAt);
            return None;
        }
        Some((_, (screen_fields, spec))) => {
            let mut idle = false;
            for name in ["up", "fov"] {
                if let Some(attribute) = eye.attribute(name) {
                    sink.error(attribute.name_span, StructureProblem::NeedsLookAt { name });
                    idle = true;
                }
            }
            if idle {
                return None;
            }
            (screen_fields, spec)
        }
    };
    let view = View {
        name: spoken_name,
        width: fields.integer("width")?,
        height: fields.integer("height")?,
        eye: at?,
        screen: spec?,
        samples: fields.integer("samples")?,
        depth: match fields.span("depth") {
            None => None,
            Some(_) => Some(fields.integer("depth")?),
        },
        steps: fields.steps("without")?,
    };
    let rule = view.check();
    let view = giver.checked(view, rule, sink)?;
    if view.resolved_screen().is_ok_and(|screen| screen.is_mirrored(view.eye)) {
        sink.warning(giver.name_span(), StructureProblem::MirroredScreen);
    }
    Some((name, view))
}

/// The screen that an eye derives from the point that it looks at.
fn looked_at(eye: &Fields<'_>) -> Option<ScreenSpec> {
    Some(ScreenSpec::LookAt { look_at: eye.point("look-at")?, up: eye.point("up")?, fov: eye.number("fov")? })
}

/// The three ways to give a screen, each with the attributes that it takes and samples for those that it needs.
pub(super) const FORMS: [&[(&str, Option<&str>)]; 3] = [
    &[("origin", Some("-1 0.75 0")), ("u", Some("2 0 0")), ("v", Some("0 -1.5 0"))],
    &[("center", Some("0 0 0")), ("size", Some("2 1.5")), ("up", None)],
    &[("corners", Some("-1 -0.75 0  1 -0.75 0  1 0.75 0  -1 0.75 0"))],
];

/// The screen that an element gives, in one of three ways.
fn screen_of<'d>(element: Element<'d>, sink: &mut Sink<'d>) -> (Fields<'d>, Option<ScreenSpec>) {
    let fields = Fields::read(element, &SCREEN, Stands::Within, sink);
    no_contents(element, &SCREEN, sink);
    let known = |name: &str| SCREEN.attribute(name).is_some();
    let Some(first) = element.attributes().find(|attribute| known(attribute.name)) else {
        if fields.are_sound() {
            sink.error(element.name_span(), StructureProblem::EmptyScreen);
        }
        return (fields, None);
    };
    let takes = |form: &[(&'static str, Option<&'static str>)], wanted: &str| {
        form.iter().find(|(name, _)| *name == wanted).copied()
    };
    let form = FORMS.into_iter().find(|form| takes(form, first.name).is_some()).unwrap_or(FORMS[0]);
    let mut sound = fields.are_sound();
    for attribute in element.attributes() {
        if let (Some(known), None) = (SCREEN.attribute(attribute.name), takes(form, attribute.name)) {
            let other = takes(form, first.name).map_or(form[0].0, |(name, _)| name);
            sink.error(attribute.name_span, StructureProblem::MixedScreen { name: known.name, other });
            sound = false;
        }
    }
    for (name, sample) in form {
        if let (None, Some(sample)) = (element.attribute(name), sample) {
            let problem = StructureProblem::MissingAttribute { name, element: SCREEN.name, sample };
            sink.error(element.name_span(), problem);
            sound = false;
        }
    }
    let spec = match form[0].0 {
        "origin" => frame(&fields).map(ScreenSpec::Frame),
        "center" => centered(&fields),
        _ => fields.corners("corners").map(ScreenSpec::Corners),
    };
    (fields, spec.filter(|_| sound))
}

fn frame(fields: &Fields<'_>) -> Option<Screen> {
    Some(Screen { origin: fields.point("origin")?, u: fields.point("u")?, v: fields.point("v")? })
}

fn centered(fields: &Fields<'_>) -> Option<ScreenSpec> {
    let (center, size) = (fields.point("center")?, fields.pair("size")?);
    Some(ScreenSpec::Centered { center, size, up: fields.point("up")? })
}
