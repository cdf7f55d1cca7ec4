//! The entities of a file, one after the other. A broken one is told and passed over, up to the next line that begins one.

use super::problem::Quantity;
use super::tokens::{Token, Tokens};
use super::{ENTITIES, NffProblem};
use crate::xml::{Excerpt, Guess};
use crate::{Diagnostic, Span};
use glam::DVec3;
use lancer_scene::{Rgb, limits};

/// The most errors and warnings that are told.
const MOST_TOLD: usize = 100;
/// The most corners of a polygon; cutting takes time with the square of their number.
const MOST_CORNERS: u32 = 4096;
/// Distances and exponents that nothing depends on may be as great as anybody writes them.
const ANY: f64 = f64::MAX;

/// An entity.
#[derive(Clone, Debug)]
pub(super) enum Entity {
    View(View),
    Background(Rgb),
    Light {
        position: DVec3,
        color: Option<Rgb>,
    },
    Fill(Fill),
    Sphere {
        span: Span,
        center: DVec3,
        radius: f64,
    },
    Cone {
        span: Span,
        ends: [DVec3; 2],
        radii: [f64; 2],
    },
    Polygon(Vec<DVec3>),
    /// Corners and the normals there.
    Patch(Vec<(DVec3, DVec3)>),
}

/// `v`
#[derive(Clone, Debug)]
pub(super) struct View {
    pub(super) span: Span,
    pub(super) from: DVec3,
    pub(super) at: DVec3,
    pub(super) up: DVec3,
    /// Degrees from the centre of the top row of pixels to that of the bottom row.
    pub(super) angle: f64,
    pub(super) resolution: [u32; 2],
}

/// `f`
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fill {
    pub(super) color: Rgb,
    pub(super) diffuse: f64,
    pub(super) specular: f64,
    pub(super) shine: f64,
    pub(super) transmittance: f64,
    pub(super) index: f64,
}

/// What is said of a file, up to a limit.
#[derive(Debug, Default)]
pub(super) struct Sink {
    pub(super) of_scene: Vec<Diagnostic>,
    /// Of the view alone.
    pub(super) of_view: Vec<Diagnostic>,
    full: bool,
}

impl Sink {
    pub(super) fn error(&mut self, span: Span, problem: NffProblem) {
        self.push(Diagnostic::error(span, problem));
    }

    pub(super) fn warn(&mut self, span: Span, problem: NffProblem) {
        self.push(Diagnostic::warning(span, problem));
    }

    fn push(&mut self, diagnostic: Diagnostic) {
        if self.of_scene.len() < MOST_TOLD {
            self.of_scene.push(diagnostic);
        } else if !self.full && diagnostic.severity == crate::Severity::Error {
            self.full = true;
            self.of_scene.push(Diagnostic::error(diagnostic.span, NffProblem::More));
        }
    }
}

/// Why an entity is passed over: a problem and its place.
type Fault = (Span, NffProblem);

/// Reads entities.
pub(super) struct Entities<'t> {
    tokens: Tokens<'t>,
}

impl<'t> Entities<'t> {
    pub(super) fn of(text: &'t str) -> Entities<'t> {
        Entities { tokens: Tokens::of(text) }
    }

    /// The next entity that is whole.
    pub(super) fn next_entity(&mut self, sink: &mut Sink) -> Option<Entity> {
        loop {
            let word = self.tokens.next()?;
            match self.entity(word, sink) {
                Ok(entity) => return Some(entity),
                Err((span, problem)) => {
                    if word.text == "v" {
                        sink.of_view.push(Diagnostic::error(span, problem.clone()));
                    }
                    sink.error(span, problem);
                    if sink.full {
                        return None;
                    }
                    self.pass_over();
                }
            }
        }
    }

    /// Goes to the next line that begins with an entity's word.
    fn pass_over(&mut self) {
        while let Some(token) = self.tokens.peek() {
            if token.first && ENTITIES.contains(&token.text) {
                return;
            }
            self.tokens.next();
        }
    }

    fn entity(&mut self, word: Token<'t>, sink: &mut Sink) -> Result<Entity, Fault> {
        Ok(match word.text {
            "v" => Entity::View(self.view(word.span)?),
            "b" => Entity::Background(self.color(sink)?),
            "l" => {
                let position = self.point()?;
                let colored = self.tokens.peek().is_some_and(|token| !token.first);
                Entity::Light { position, color: if colored { Some(self.color(sink)?) } else { None } }
            }
            "f" => Entity::Fill(Fill {
                color: self.color(sink)?,
                diffuse: self.clamped(Quantity::Diffuse, 1.0, sink)?,
                specular: self.clamped(Quantity::Specular, 1.0, sink)?,
                shine: self.number(Quantity::Shine, 0.0, ANY)?.0.min(limits::SHININESS),
                transmittance: self.clamped(Quantity::Transmittance, 1.0, sink)?,
                index: self.number(Quantity::Index, 0.0, limits::COORDINATE)?.0,
            }),
            "s" => {
                let (span, center) = (word.span, self.point()?);
                Entity::Sphere { span, center, radius: self.radius(sink)? }
            }
            "c" => {
                let (base, base_radius) = (self.point()?, self.radius(sink)?);
                let (top, top_radius) = (self.point()?, self.radius(sink)?);
                Entity::Cone { span: word.span, ends: [base, top], radii: [base_radius, top_radius] }
            }
            "p" => {
                let corners = self.count(Quantity::Corners, 3, MOST_CORNERS)?;
                Entity::Polygon((0..corners).map(|_| self.point()).collect::<Result<_, _>>()?)
            }
            "pp" => {
                let corners = self.count(Quantity::Corners, 3, MOST_CORNERS)?;
                let corner = |_| Ok((self.point()?, self.point()?));
                Entity::Patch((0..corners).map(corner).collect::<Result<_, Fault>>()?)
            }
            _ => return Err((word.span, NffProblem::UnknownEntity { word: Excerpt::new(word.text) })),
        })
    }

    fn view(&mut self, span: Span) -> Result<View, Fault> {
        const WORDS: [&str; 6] = ["from", "at", "up", "angle", "hither", "resolution"];
        let (mut from, mut at, mut up, mut angle, mut resolution) = (None, None, None, None, None);
        while let Some(token) = self.tokens.peek().filter(|token| !ENTITIES.contains(&token.text)) {
            self.tokens.next();
            match token.text {
                "from" => from = Some(self.point()?),
                "at" => at = Some(self.point()?),
                "up" => up = Some(self.point()?),
                "angle" => angle = Some(self.number(Quantity::Angle, limits::FOV.0, limits::FOV.1)?.0),
                "hither" => drop(self.number(Quantity::Hither, -ANY, ANY)?),
                "resolution" => {
                    let mut pixels = || self.count(Quantity::Pixels, 1, limits::PIXELS);
                    resolution = Some([pixels()?, pixels()?]);
                }
                other => {
                    let guess = Guess::among(other, WORDS);
                    return Err((token.span, NffProblem::UnknownOfView { word: Excerpt::new(other), guess }));
                }
            }
        }
        let lacks = |word: &'static str| (span, NffProblem::ViewLacks { word });
        Ok(View {
            span,
            from: from.ok_or_else(|| lacks("from"))?,
            at: at.ok_or_else(|| lacks("at"))?,
            up: up.ok_or_else(|| lacks("up"))?,
            angle: angle.ok_or_else(|| lacks("angle"))?,
            resolution: resolution.ok_or_else(|| lacks("resolution"))?,
        })
    }

    fn token(&mut self, due: Quantity) -> Result<Token<'t>, Fault> {
        match self.tokens.peek() {
            // an entity's word ends what came before it, so that it is read itself
            Some(token) if ENTITIES.contains(&token.text) => {
                Err((token.span, NffProblem::NotANumber { found: Excerpt::new(token.text), due }))
            }
            Some(token) => {
                self.tokens.next();
                Ok(token)
            }
            None => Err((self.tokens.end(), NffProblem::Ended { due })),
        }
    }

    /// A number within a range, and its place.
    fn number(&mut self, what: Quantity, least: f64, greatest: f64) -> Result<(f64, Span), Fault> {
        let token = self.token(what)?;
        let is_number = token.text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.'));
        let number = token.text.parse().ok().filter(|number: &f64| is_number && number.is_finite());
        let Some(number) = number else {
            return Err((token.span, NffProblem::NotANumber { found: Excerpt::new(token.text), due: what }));
        };
        if number < least || number > greatest {
            return Err((token.span, NffProblem::OutOfRange { what, found: number, least, greatest }));
        }
        Ok((number, token.span))
    }

    /// A number from 0 to `greatest`; what is outside is brought there with a warning.
    fn clamped(&mut self, what: Quantity, greatest: f64, sink: &mut Sink) -> Result<f64, Fault> {
        let (found, span) = self.number(what, -ANY, ANY)?;
        let taken = found.clamp(0.0, greatest);
        if taken != found {
            sink.warn(span, NffProblem::Clamped { what, found, taken });
        }
        Ok(taken)
    }

    fn color(&mut self, sink: &mut Sink) -> Result<Rgb, Fault> {
        let mut channel = || self.clamped(Quantity::Channel, 1.0, sink);
        Ok(Rgb::new(channel()?, channel()?, channel()?))
    }

    fn point(&mut self) -> Result<DVec3, Fault> {
        let mut coordinate =
            || self.number(Quantity::Coordinate, -limits::COORDINATE, limits::COORDINATE).map(|(number, _)| number);
        Ok(DVec3::new(coordinate()?, coordinate()?, coordinate()?))
    }

    fn radius(&mut self, sink: &mut Sink) -> Result<f64, Fault> {
        let (radius, span) = self.number(Quantity::Radius, -limits::COORDINATE, limits::COORDINATE)?;
        if radius < 0.0 {
            sink.warn(span, NffProblem::InsideOnly);
        }
        Ok(radius.abs())
    }

    fn count(&mut self, what: Quantity, least: u32, greatest: u32) -> Result<u32, Fault> {
        let token = self.token(what)?;
        let count = token.text.parse().ok().filter(|count| (least..=greatest).contains(count));
        let wrong = || NffProblem::Count { what, found: Excerpt::new(token.text), least, greatest };
        count.ok_or_else(|| (token.span, wrong()))
    }
}
