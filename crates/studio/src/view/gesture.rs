//! What the pointer and the keys do in a view: turn, shift, go nearer, move what is selected, mark a rectangle.
//!
//! A gesture is one step of the document however long it lasts. Its previews are edits of the stage before it, so what
//! is kept here is only where it began and how far it has come.

use super::mapping::Mapping;
use crate::{Action, Context, ViewAction};
use egui::{Key, Modifiers, PointerButton, Pos2, Response, Ui, Vec2};
use lancer_document::gizmo::{self, Axis, Constraint, Drag};
use lancer_document::{Item, StepName, attribute, focus, navigate};
use lancer_scene::{DVec3, Edit, Stage, View};
use lancer_trace::{Camera, World};
use std::sync::Arc;

/// Degrees that a point of movement turns a view by.
const DEGREES_A_POINT: f64 = 0.4;
/// Degrees that an arrow key turns a view by.
const DEGREES_A_KEY: f64 = 5.0;
/// Points that an arrow key shifts a view by.
const POINTS_A_KEY: f32 = 24.0;
/// How much nearer a page key goes.
const FACTOR_A_KEY: f64 = 0.85;
/// How much nearer a point of the wheel goes.
const FACTOR_A_POINT: f64 = 0.997;
/// After this time without the wheel or a key, in seconds, their movement is a step.
const REST: f64 = 0.5;
/// How near in points the pointer must be to grab what has no surface.
const REACH: f32 = 12.0;

/// A gesture that is going on.
#[derive(Clone, Debug)]
pub enum Gesture {
    /// The button is down, and it is not known yet on what.
    Undecided {
        /// Where it was pressed.
        from: Pos2,
    },
    /// The eye moves.
    Navigate {
        /// What it moves around.
        pivot: DVec3,
        /// How far.
        travel: Travel,
        /// What moves it.
        by: Mover,
    },
    /// What is selected moves.
    Move {
        /// What was grabbed.
        drag: Drag,
        /// Where it may go.
        constraint: Constraint,
        /// The grid that it snaps to.
        grid: f64,
    },
    /// A rectangle is marked.
    Mark {
        /// Its first corner.
        from: Pos2,
    },
}

/// What moves the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mover {
    /// A drag turns.
    Turn,
    /// A drag shifts.
    Shift,
    /// The wheel or a key, until it has rested.
    Pulse {
        /// The time at which it has.
        until: f64,
    },
}

/// How far the eye has moved.
#[derive(Clone, Copy, Debug)]
pub struct Travel {
    /// Degrees to the right and down.
    turn: (f64, f64),
    /// Pixels of the view to the right and down.
    shift: (f64, f64),
    /// How many times as far from the pivot.
    factor: f64,
}

impl Default for Travel {
    fn default() -> Travel {
        Travel { turn: (0.0, 0.0), shift: (0.0, 0.0), factor: 1.0 }
    }
}

impl Travel {
    /// The view after the movement.
    fn of(&self, view: &View, vertical: DVec3, pivot: DVec3) -> View {
        let turned = navigate::orbit(view, vertical, pivot, self.turn.0, self.turn.1);
        let shifted = navigate::pan(&turned, pivot, self.shift.0, self.shift.1);
        if self.factor == 1.0 { shifted } else { navigate::dolly(&shifted, pivot, self.factor) }
    }
}

/// Everything that a gesture is made from.
pub(crate) struct Scope<'a> {
    /// What may be read.
    pub context: &'a Context<'a>,
    /// The view as the document has it.
    pub view: &'a Arc<View>,
    /// Where its picture stands.
    pub mapping: Mapping,
    /// The compiled scene.
    pub world: Option<&'a World>,
    /// Pixels of the picture.
    pub picture: [u32; 2],
    /// What stands under the pointer as far as it is known.
    pub under: Option<&'a super::Answer>,
}

impl Scope<'_> {
    fn stage(&self) -> &Stage {
        self.context.document.stage()
    }

    fn pivot(&self) -> DVec3 {
        focus(self.view, &self.stage().scene, self.world).point
    }

    /// The action that shows how far the eye has moved.
    fn travelled(&self, pivot: DVec3, travel: &Travel) -> Option<Action> {
        let base = self.context.document.base();
        let vertical = navigate::vertical(base);
        let edit = attribute::edit_view(base, &self.view.name, |view| *view = travel.of(view, vertical, pivot))?;
        Some(Action::Preview(edit))
    }

    /// The selected things that can be moved.
    fn movable(&self) -> impl Iterator<Item = &Item> {
        self.context.document.selection().iter().filter(|item| matches!(item, Item::Object(_) | Item::Light(_)))
    }

    /// The lamp whose star is shown there.
    pub(crate) fn lamp(&self, place: Pos2, with_grid: bool) -> Option<Item> {
        let camera = Camera::new(self.view).ok()?;
        let lamps = self.stage().scene.lights.iter().map(|light| (Item::Light(light.name.clone()), light.position));
        let selection = self.context.document.selection();
        let shown = lamps.filter(|(item, _)| with_grid || selection.contains(item));
        let near = shown.filter_map(|(item, position)| {
            let distance = self.mapping.to_screen(camera.project(position)?).distance(place);
            (distance <= REACH).then_some((item, distance))
        });
        near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(item, _)| item)
    }

    /// The point of something selected that is grabbed there; `Err` while it is not known what stands there.
    fn grabbed(&self, place: Pos2) -> Result<Option<DVec3>, NotKnown> {
        let camera = Camera::new(self.view).map_err(|_| NotKnown)?;
        let handle = self.movable().find_map(|item| {
            let point = gizmo::place_of(self.stage(), item)?;
            let on_screen = self.mapping.to_screen(camera.project(point)?);
            (on_screen.distance(place) <= REACH).then_some(point)
        });
        if handle.is_some() || self.movable().next().is_none() {
            return Ok(handle);
        }
        let near = |answer: &&super::Answer| self.mapping.to_screen(answer.point).distance(place) <= 3.0;
        let answer = self.under.filter(near).ok_or(NotKnown)?;
        let selected = |name: &lancer_scene::Name| self.movable().any(|item| *item == Item::Object(name.clone()));
        Ok(answer.picked.as_ref().filter(|picked| selected(&picked.object)).map(|picked| picked.point))
    }
}

/// It is not known yet what stands there.
struct NotKnown;

/// Goes on with the gesture of a view, or begins one; gives what it asks for. `marking` is set where the next drag
/// marks a rectangle.
pub(crate) fn follow(
    ui: &Ui,
    response: &Response,
    scope: &Scope<'_>,
    gesture: &mut Option<Gesture>,
    marking: &mut bool,
) -> Vec<Action> {
    let mut actions = Vec::new();
    let begun = matches!(gesture, Some(Gesture::Navigate { .. } | Gesture::Move { .. }));
    if begun && !scope.context.document.in_gesture() {
        // something else ended it: an undo, an edit in a panel
        *gesture = None;
    }
    begin(ui, response, scope, gesture, marking, &mut actions);
    pulse(ui, response, scope, gesture, &mut actions);
    proceed(ui, response, scope, gesture, marking, &mut actions);
    actions
}

fn navigated(scope: &Scope<'_>) -> Action {
    Action::Begin(StepName::Navigated(scope.view.name.clone()))
}

/// Begins what a button that was just pressed and moved means.
fn begin(
    ui: &Ui,
    response: &Response,
    scope: &Scope<'_>,
    gesture: &mut Option<Gesture>,
    marking: &bool,
    actions: &mut Vec<Action>,
) {
    let started = |button| response.drag_started_by(button);
    let Some(from) = ui.input(|input| input.pointer.press_origin()) else { return };
    let modifiers = ui.input(|input| input.modifiers);
    let navigate = |by| Some(Gesture::Navigate { pivot: scope.pivot(), travel: Travel::default(), by });
    let next = if started(PointerButton::Secondary) {
        navigate(Mover::Turn)
    } else if started(PointerButton::Middle) {
        navigate(Mover::Shift)
    } else if started(PointerButton::Primary) {
        if *marking || modifiers.command {
            Some(Gesture::Mark { from })
        } else if modifiers.alt {
            navigate(Mover::Turn)
        } else if modifiers.shift {
            navigate(Mover::Shift)
        } else {
            Some(Gesture::Undecided { from })
        }
    } else {
        return;
    };
    if let Some(Gesture::Navigate { .. }) = next {
        actions.push(navigated(scope));
    } else if gesture.is_some() {
        actions.push(Action::Commit);
    }
    *gesture = next;
}

/// What the wheel and the keys do: a movement that lasts until they have rested.
fn pulse(ui: &Ui, response: &Response, scope: &Scope<'_>, gesture: &mut Option<Gesture>, actions: &mut Vec<Action>) {
    let dragging = matches!(
        gesture,
        Some(
            Gesture::Undecided { .. }
                | Gesture::Move { .. }
                | Gesture::Mark { .. }
                | Gesture::Navigate { by: Mover::Turn | Mover::Shift, .. }
        )
    );
    if dragging {
        return;
    }
    let mut step = Travel::default();
    if response.contains_pointer() {
        let (scroll, zoom) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        step.factor *= FACTOR_A_POINT.powf(f64::from(scroll)) / f64::from(zoom);
    }
    if response.has_focus() {
        keys(ui, scope, &mut step);
    }
    let moves = step.turn != (0.0, 0.0) || step.shift != (0.0, 0.0) || step.factor != 1.0;
    if !moves {
        return;
    }
    let until = ui.input(|input| input.time) + REST;
    ui.ctx().request_repaint_after_secs(REST as f32);
    let (pivot, mut travel) = match gesture {
        Some(Gesture::Navigate { pivot, travel, .. }) => (*pivot, *travel),
        Some(Gesture::Undecided { .. } | Gesture::Move { .. } | Gesture::Mark { .. }) | None => {
            actions.push(navigated(scope));
            (scope.pivot(), Travel::default())
        }
    };
    travel.turn = (travel.turn.0 + step.turn.0, travel.turn.1 + step.turn.1);
    travel.shift = (travel.shift.0 + step.shift.0, travel.shift.1 + step.shift.1);
    travel.factor *= step.factor;
    *gesture = Some(Gesture::Navigate { pivot, travel, by: Mover::Pulse { until } });
    actions.extend(scope.travelled(pivot, &travel));
}

/// Adds what the arrow and page keys ask for.
fn keys(ui: &Ui, scope: &Scope<'_>, step: &mut Travel) {
    let pressed = |modifiers: Modifiers, key: Key| ui.input_mut(|input| input.count_and_consume_key(modifiers, key));
    for (key, right, down) in [
        (Key::ArrowLeft, -1.0, 0.0),
        (Key::ArrowRight, 1.0, 0.0),
        (Key::ArrowUp, 0.0, -1.0),
        (Key::ArrowDown, 0.0, 1.0),
    ] {
        let shifts = pressed(Modifiers::SHIFT, key) as f64;
        let by = scope.mapping.movement(Vec2::splat(POINTS_A_KEY));
        step.shift = (step.shift.0 + shifts * right * by.0, step.shift.1 + shifts * down * by.1);
        let turns = pressed(Modifiers::NONE, key) as f64 * DEGREES_A_KEY;
        step.turn = (step.turn.0 + turns * right, step.turn.1 + turns * down);
    }
    step.factor *= FACTOR_A_KEY.powi(pressed(Modifiers::NONE, Key::PageUp) as i32);
    step.factor /= FACTOR_A_KEY.powi(pressed(Modifiers::NONE, Key::PageDown) as i32);
}

/// Goes on with the gesture and ends it.
fn proceed(
    ui: &Ui,
    response: &Response,
    scope: &Scope<'_>,
    gesture: &mut Option<Gesture>,
    marking: &mut bool,
    actions: &mut Vec<Action>,
) {
    let Some(mut current) = gesture.take() else { return };
    let (escape, pointer, time, delta) = ui.input_mut(|input| {
        let escape = input.consume_key(Modifiers::NONE, Key::Escape);
        (escape, input.pointer.latest_pos(), input.time, input.pointer.delta())
    });
    let held = ui.input(|input| input.pointer.any_down());
    if escape {
        *marking = false;
        if matches!(current, Gesture::Navigate { .. } | Gesture::Move { .. }) {
            actions.push(Action::Cancel);
        }
        return;
    }
    if let Gesture::Undecided { from } = current {
        match scope.grabbed(from) {
            Ok(Some(point)) => match moving(scope, from, point) {
                Some((name, begun)) => {
                    actions.push(Action::Begin(name));
                    current = begun;
                }
                None => return,
            },
            Ok(None) => {
                actions.push(navigated(scope));
                current = Gesture::Navigate { pivot: scope.pivot(), travel: Travel::default(), by: Mover::Turn };
            }
            Err(NotKnown) => {}
        }
    }
    let over = match &mut current {
        Gesture::Undecided { .. } => !held,
        Gesture::Navigate { pivot, travel, by } => match by {
            Mover::Turn | Mover::Shift => {
                if response.dragged() && delta != Vec2::ZERO {
                    if *by == Mover::Turn {
                        travel.turn.0 += f64::from(delta.x) * DEGREES_A_POINT;
                        travel.turn.1 += f64::from(delta.y) * DEGREES_A_POINT;
                    } else {
                        let (right, down) = scope.mapping.movement(delta);
                        travel.shift = (travel.shift.0 + right, travel.shift.1 + down);
                    }
                    actions.extend(scope.travelled(*pivot, travel));
                }
                !held
            }
            Mover::Pulse { until } => time >= *until,
        },
        Gesture::Move { drag, constraint, grid } => {
            constrain(ui, constraint);
            let snap = ui.input(|input| input.modifiers.command);
            actions.extend(pointer.and_then(|place| moved(scope, drag, *constraint, place, snap.then_some(*grid))));
            !held
        }
        Gesture::Mark { from } => {
            if !held && let Some(to) = pointer {
                *marking = false;
                let region = scope.mapping.region(*from, to, scope.picture);
                actions.push(Action::View(scope.view.name.clone(), ViewAction::First(region)));
            }
            !held
        }
    };
    if !over {
        if let Gesture::Navigate { by: Mover::Pulse { until }, .. } = current {
            ui.ctx().request_repaint_after_secs((until - time).max(0.0) as f32);
        }
        *gesture = Some(current);
    } else if matches!(current, Gesture::Navigate { .. } | Gesture::Move { .. }) {
        actions.push(Action::Commit);
    }
}

/// The movement of what is selected, grabbed at a point.
fn moving(scope: &Scope<'_>, from: Pos2, point: DVec3) -> Option<(StepName, Gesture)> {
    let camera = Camera::new(scope.view).ok()?;
    let drag = Drag { camera, start: scope.mapping.to_view(from), grabbed: point };
    let (name, _) = gizmo::moved(scope.stage(), scope.movable(), DVec3::ZERO)?;
    let vertical = navigate::vertical(scope.stage());
    let grid = lancer_document::wireframe::grid(&camera, vertical, point).step;
    Some((name, Gesture::Move { drag, constraint: Constraint::ViewPlane, grid }))
}

/// Holds or frees an axis whose key was pressed.
fn constrain(ui: &Ui, constraint: &mut Constraint) {
    for (key, axis) in [(Key::X, Axis::X), (Key::Y, Axis::Y), (Key::Z, Axis::Z)] {
        if ui.input_mut(|input| input.consume_key(Modifiers::NONE, key)) {
            let along = Constraint::Along(axis);
            *constraint = if *constraint == along { Constraint::ViewPlane } else { along };
        }
    }
}

/// The action that shows where what is selected has come to.
fn moved(scope: &Scope<'_>, drag: &Drag, constraint: Constraint, place: Pos2, grid: Option<f64>) -> Option<Action> {
    let base = scope.context.document.base();
    let mut by = drag.translation(scope.mapping.to_view(place), constraint)?;
    if let Some(step) = grid
        && let Some(anchor) = scope.movable().last().and_then(|item| gizmo::place_of(base, item))
    {
        by = gizmo::snapped(by, anchor, step);
    }
    let (_, edit): (StepName, Edit) = gizmo::moved(base, scope.movable(), by)?;
    Some(Action::Preview(edit))
}
