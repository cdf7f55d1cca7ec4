//! The controls in the bar of a pane: steps, size, depth and samples, pictures, and the rest.

use super::live::LiveView;
use crate::bars::sign_text;
use crate::chrome::{SIDE, icon_menu, icon_switch};
use crate::entry::Entry;
use crate::{Action, Context, ViewAction};
use egui::{Button, RichText, Role, Ui, WidgetInfo};
use egui_material_icons::icons as icon;
use lancer_document::navigate::Side;
use lancer_document::{Item, attribute};
use lancer_formats::picture::Format;
use lancer_scene::{View, limits};
use lancer_words::{studio::menu, studio::view as words};

/// The formats of pictures, with their names.
const FORMATS: [(Format, &str); 6] = [
    (Format::RawPpm, "PPM (P6)"),
    (Format::Png, "PNG"),
    (Format::Qoi, "QOI"),
    (Format::Bmp, "BMP"),
    (Format::Tiff, "TIFF"),
    (Format::Exr, "OpenEXR"),
];

/// In a bar that is narrower, everything stands in one menu, so that the title has room.
const ROOMY: f32 = 200.0;

/// The sizes that are offered.
const SIZES: [[u32; 2]; 6] = [[320, 240], [640, 480], [800, 600], [1280, 720], [1920, 1080], [3840, 2160]];

/// Draws the controls, from the right to the left; gives what they ask for.
pub fn header(ui: &mut Ui, context: &Context<'_>, live: &LiveView, view: &View) -> Vec<Action> {
    let (lang, name) = (context.lang, &view.name);
    let mut actions = Vec::new();
    ui.spacing_mut().item_spacing.x = 2.0;
    let narrow = ui.available_width() < ROOMY;
    icon_menu(ui, icon::ICON_MORE_VERT, SIDE, &words::more_of(lang, name), |ui| {
        if narrow {
            ui.menu_button(words::steps_of(lang, name), |ui| steps(ui, context, view, &mut actions));
            ui.menu_button(words::picture_settings_of(lang, name), |ui| {
                picture(ui, context, live, view, &mut actions);
            });
            ui.menu_button(words::save_of(lang, name), |ui| pictures(ui, context, view, &mut actions));
            ui.separator();
        }
        more(ui, context, live, view, &mut actions);
    });
    if narrow {
        return actions;
    }
    icon_menu(ui, icon::ICON_IMAGE, SIDE, &words::save_of(lang, name), |ui| pictures(ui, context, view, &mut actions));
    icon_menu(ui, icon::ICON_TUNE, SIDE, &words::picture_settings_of(lang, name), |ui| {
        picture(ui, context, live, view, &mut actions);
    });
    icon_menu(ui, icon::ICON_LAYERS, SIDE, &words::steps_of(lang, name), |ui| steps(ui, context, view, &mut actions));
    let paused = live.session().status().paused;
    let (sign, text) = match paused {
        true => (icon::ICON_PLAY_ARROW, menu::resume(lang)),
        false => (icon::ICON_PAUSE, menu::pause(lang)),
    };
    if paused || !live.session().is_finished() {
        let text = format!("{text} · {name}");
        if icon_switch(ui, paused, sign, &text).clicked() {
            actions.push(Action::View(name.clone(), ViewAction::Pause(!paused)));
        }
    }
    actions
}

/// One step that sets an attribute of the view.
fn set(context: &Context<'_>, view: &View, attribute: &'static str, change: impl FnOnce(&mut View)) -> Option<Action> {
    let edit = attribute::edit_view(context.document.stage(), &view.name, change)?;
    Some(Action::Apply(attribute::set(&Item::View(view.name.clone()), attribute), edit))
}

/// The subject's steps as switches.
fn steps(ui: &mut Ui, context: &Context<'_>, view: &View, actions: &mut Vec<Action>) {
    let lang = context.lang;
    ui.add_enabled(false, egui::Checkbox::new(&mut true, words::hidden_surfaces(lang)))
        .on_disabled_hover_text(words::always(lang));
    let mut chosen = view.steps;
    let mut changed = ui.checkbox(&mut chosen.shadows, words::shadows(lang)).changed();
    changed |= ui.checkbox(&mut chosen.reflection, words::reflection(lang)).changed();
    changed |= ui.checkbox(&mut chosen.transparency, words::transparency(lang)).changed();
    if changed {
        actions.extend(set(context, view, "without", |view| view.steps = chosen));
    }
}

/// Size, depth and samples.
fn picture(ui: &mut Ui, context: &Context<'_>, live: &LiveView, view: &View, actions: &mut Vec<Action>) {
    let lang = context.lang;
    let title = |ui: &mut Ui, text: String| ui.label(RichText::new(text).small().color(context.palette.weak));
    title(ui, words::size(lang));
    let mut fit = live.fit;
    if ui.checkbox(&mut fit, words::fit(lang)).changed() {
        actions.push(Action::View(view.name.clone(), ViewAction::Fit(fit)));
    }
    let own = [view.width, view.height];
    for size in (!SIZES.contains(&own)).then_some(own).into_iter().chain(SIZES) {
        let [width, height] = size;
        if ui.radio(size == own, format!("{width} × {height}")).clicked() && size != own {
            actions.extend(set(context, view, "width", |view| [view.width, view.height] = size));
        }
    }
    ui.separator();
    title(ui, words::depth(lang));
    let world = context.document.stage().scene.world.depth;
    let mut of_world = view.depth.is_none();
    if ui.checkbox(&mut of_world, words::depth_of_world(lang, world)).changed() {
        actions.extend(set(context, view, "depth", |view| view.depth = (!of_world).then_some(world)));
    }
    let depth = view.depth.unwrap_or(world);
    if let Some(depth) = stepper(ui, context, &words::depth(lang), depth, 0, limits::DEPTH, &depth.to_string()) {
        actions.extend(set(context, view, "depth", |view| view.depth = Some(depth)));
    }
    ui.separator();
    title(ui, words::samples(lang));
    let samples = view.samples;
    let text = format!("{samples} × {samples}");
    if let Some(samples) = stepper(ui, context, &words::samples(lang), samples, 1, limits::SAMPLES, &text) {
        actions.extend(set(context, view, "samples", |view| view.samples = samples));
    }
}

/// A number between two buttons; gives the new one.
fn stepper(
    ui: &mut Ui,
    context: &Context<'_>,
    what: &str,
    value: u32,
    least: u32,
    most: u32,
    text: &str,
) -> Option<u32> {
    let lang = context.lang;
    ui.horizontal(|ui| {
        let less = ui.add_enabled_ui(value > least, |ui| {
            crate::chrome::icon_button(ui, icon::ICON_REMOVE, &words::fewer(lang, what)).clicked()
        });
        ui.add_sized([56.0, 20.0], egui::Label::new(text));
        let more = ui.add_enabled_ui(value < most, |ui| {
            crate::chrome::icon_button(ui, icon::ICON_ADD, &words::more(lang, what)).clicked()
        });
        if less.inner {
            Some(value - 1)
        } else if more.inner {
            Some(value + 1)
        } else {
            None
        }
    })
    .inner
}

/// Where pictures go.
fn pictures(ui: &mut Ui, context: &Context<'_>, view: &View, actions: &mut Vec<Action>) {
    let lang = context.lang;
    let mut format = |ui: &mut Ui, format: Format, name: &str| {
        if ui.button(words::save_as(lang, name)).clicked() {
            actions.push(Action::View(view.name.clone(), ViewAction::SavePicture(format)));
            ui.close();
        }
    };
    format(ui, Format::PlainPpm, &words::ppm(lang));
    for (kind, name) in FORMATS {
        format(ui, kind, name);
    }
    ui.separator();
    if ui.button(menu::copy_picture(lang)).clicked() {
        actions.push(Action::View(view.name.clone(), ViewAction::CopyPicture));
        ui.close();
    }
}

/// Everything else that can be done with a view.
fn more(ui: &mut Ui, context: &Context<'_>, live: &LiveView, view: &View, actions: &mut Vec<Action>) {
    let lang = context.lang;
    let detached = context.settings.layout.is_detached(&view.name);
    let groups: [&[(Entry, ViewAction, Option<bool>)]; 3] = [
        &[
            (Entry::Frame, ViewAction::Frame, None),
            (Entry::Look(Side::Front), ViewAction::Look(Side::Front), None),
            (Entry::Look(Side::Right), ViewAction::Look(Side::Right), None),
            (Entry::Look(Side::Top), ViewAction::Look(Side::Top), None),
            (Entry::Grid, ViewAction::Grid(!live.grid), Some(live.grid)),
        ],
        &[(Entry::Restart, ViewAction::Restart, None), (Entry::NoRegion, ViewAction::First(None), None)],
        &[
            (Entry::SplitRight, ViewAction::Split(egui_tiles::LinearDir::Horizontal), None),
            (Entry::SplitBelow, ViewAction::Split(egui_tiles::LinearDir::Vertical), None),
            (Entry::Detach, if detached { ViewAction::Attach } else { ViewAction::Detach }, None),
            (Entry::CloseView, ViewAction::Close, None),
        ],
    ];
    for (place, group) in groups.into_iter().enumerate() {
        if place > 0 {
            ui.separator();
        }
        for (entry, action, checked) in group {
            if matches!(entry, Entry::NoRegion) && live.region().is_none() {
                continue;
            }
            let text = if matches!(action, ViewAction::Attach) { menu::attach(lang) } else { entry.name(lang) };
            let keys = entry.keys().first().map(|keys| menu::keys(lang, &ui.ctx().format_shortcut(keys)));
            let sign = if checked == &Some(true) { Some(icon::ICON_CHECK) } else { None };
            let button = Button::new((sign_text(sign), text.as_str())).shortcut_text(keys.unwrap_or_default());
            let response = ui.add(button);
            response.widget_info(|| WidgetInfo::labeled(Role::MenuItem, true, &text));
            if response.clicked() {
                actions.push(Action::View(view.name.clone(), action.clone()));
                ui.close();
            }
        }
    }
}
