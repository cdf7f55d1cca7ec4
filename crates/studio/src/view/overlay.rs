//! What is drawn over a picture: outlines of what is selected, grid and axes, the axis of a movement, a rectangle.

use super::gesture::{Gesture, Scope};
use super::mapping::Mapping;
use crate::theme::Palette;
use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2};
use lancer_document::gizmo::Constraint;
use lancer_document::wireframe::{Grid, Polyline, Wireframes, grid};
use lancer_document::{Axis, Item, focus, navigate};
use lancer_render::Region;
use lancer_trace::Camera;
use lancer_words::{Lang, studio::view as words};

/// An outline of more lines than these, of a rugged mesh, is drawn finely, so that the picture is seen through it.
const FINE: usize = 1000;
/// The letters of the axes; colour alone tells nobody anything.
const LETTERS: [&str; 3] = ["x", "y", "z"];

/// Draws the lines over a picture.
pub(crate) fn draw(
    painter: &Painter,
    scope: &Scope<'_>,
    gesture: Option<&Gesture>,
    with_grid: bool,
    wireframes: &mut Wireframes,
) {
    let Ok(camera) = Camera::new(scope.view) else { return };
    let (stage, palette) = (scope.context.document.stage(), scope.context.palette);
    let painter = painter.with_clip_rect(painter.clip_rect().intersect(scope.mapping.rect));
    let on_screen = |line: &Polyline| line.iter().map(|point| scope.mapping.to_screen(*point)).collect::<Vec<_>>();
    if with_grid {
        let vertical = navigate::vertical(stage);
        let ground = focus(scope.view, &stage.scene, None).point;
        ground_grid(&painter, &grid(&camera, vertical, ground), palette, &on_screen);
        // with the grid lamps are seen too, so that they can be clicked
        for light in &stage.scene.lights {
            for line in wireframes.outline(stage, &Item::Light(light.name.clone()), &camera) {
                halo(&painter, on_screen(&line), palette.grid, 1.0);
            }
        }
    }
    let selection = scope.context.document.selection();
    for item in selection.iter() {
        let primary = selection.primary() == Some(item);
        let (lines, color) = (wireframes.outline(stage, item, &camera), palette.outline(primary));
        if lines.len() > FINE {
            let stroke = Stroke::new(1.0, color.gamma_multiply(0.35));
            painter.extend(lines.iter().map(|line| Shape::line(on_screen(line), stroke)));
        } else {
            halos(&painter, lines.iter().map(on_screen).collect(), color, 1.5);
        }
    }
    match gesture {
        Some(Gesture::Move { drag, constraint: Constraint::Along(axis), .. }) => {
            let along = axis.direction();
            let reach = (drag.grabbed - camera.eye()).length() * 50.0;
            let [color] = [palette.axes[axis_number(*axis)]];
            // towards the eye the line ends where it can still be projected
            let ends = [-1.0, 1.0].map(|side| {
                (0..40)
                    .map(|halving| drag.grabbed + along * (side * reach / f64::from(1 << halving.min(30))))
                    .find_map(|point| camera.project(point))
            });
            if let [Some(a), Some(b)] = ends {
                halo(&painter, vec![scope.mapping.to_screen(a), scope.mapping.to_screen(b)], color, 1.5);
            }
        }
        Some(Gesture::Mark { from }) => {
            if let Some(to) = painter.ctx().input(|input| input.pointer.latest_pos()) {
                rectangle(&painter, Rect::from_two_pos(*from, to), palette);
            }
        }
        Some(Gesture::Undecided { .. } | Gesture::Navigate { .. } | Gesture::Move { .. }) | None => {}
    }
}

fn axis_number(axis: Axis) -> usize {
    match axis {
        Axis::X => 0,
        Axis::Y => 1,
        Axis::Z => 2,
    }
}

/// Draws ground and axes, each axis with its letter.
fn ground_grid(painter: &Painter, grid: &Grid, palette: &Palette, on_screen: &dyn Fn(&Polyline) -> Vec<Pos2>) {
    let lines = |lines: &[Polyline], stroke: Stroke| {
        painter.extend(lines.iter().map(|line| Shape::line(on_screen(line), stroke)));
    };
    lines(&grid.minor, Stroke::new(1.0, palette.grid.gamma_multiply(0.35)));
    lines(&grid.major, Stroke::new(1.0, palette.grid.gamma_multiply(0.8)));
    for ((axis, letter), color) in grid.axes.iter().zip(LETTERS).zip(palette.axes) {
        for line in axis {
            let line = on_screen(line);
            halo(painter, line.clone(), color, 1.5);
            let seen =
                line.last().and_then(|end| line.first().and_then(|start| clipped(*start, *end, painter.clip_rect())));
            if let Some(place) = seen {
                label(painter, place, letter, color);
            }
        }
    }
}

/// The point nearest to the end of a line that lies well inside of a rectangle.
fn clipped(start: Pos2, end: Pos2, rect: Rect) -> Option<Pos2> {
    let inside = rect.shrink(14.0);
    (0..=64).rev().map(|part| start.lerp(end, part as f32 / 64.0)).find(|place| inside.contains(*place))
}

/// A letter that can be read on every picture.
fn label(painter: &Painter, place: Pos2, text: &str, color: Color32) {
    let font = FontId::proportional(13.0);
    let galley = painter.layout_no_wrap(text.to_owned(), font, color);
    let rect = Align2::CENTER_CENTER.anchor_size(place, galley.size()).expand2(egui::vec2(4.0, 1.0));
    painter.rect_filled(rect, 4.0, Color32::from_black_alpha(170));
    painter.galley(Align2::CENTER_CENTER.anchor_size(place, galley.size()).min, galley, color);
}

/// A line that can be seen on every picture: dark around, coloured inside.
fn halo(painter: &Painter, points: Vec<Pos2>, color: Color32, width: f32) {
    halos(painter, vec![points], color, width);
}

/// Lines that meet: what is dark around one lies below the others.
fn halos(painter: &Painter, lines: Vec<Vec<Pos2>>, color: Color32, width: f32) {
    let dark = Stroke::new(width + 2.0, Color32::from_black_alpha(110));
    painter.extend(lines.iter().map(|points| Shape::line(points.clone(), dark)));
    painter.extend(lines.into_iter().map(|points| Shape::line(points, Stroke::new(width, color))));
}

/// Marks the pixel that is explained: four ticks around it, dark around so that they are seen on any picture.
pub(crate) fn explained(painter: &Painter, mapping: &Mapping, (x, y): (u32, u32), size: [u32; 2], palette: &Palette) {
    let pixel = mapping.region_rect(Region { x, y, width: 1, height: 1 }, size);
    for (color, width) in [(Color32::from_black_alpha(170), 4.0), (palette.outline(true), 1.5)] {
        for way in [Vec2::X, -Vec2::X, Vec2::Y, -Vec2::Y] {
            let ends = [pixel.center() + way * 5.0, pixel.center() + way * 12.0];
            painter.line_segment(ends, Stroke::new(width, color));
        }
    }
}

/// A dashed rectangle.
pub(crate) fn rectangle(painter: &Painter, rect: Rect, palette: &Palette) {
    let corners = [rect.left_top(), rect.right_top(), rect.right_bottom(), rect.left_bottom(), rect.left_top()];
    painter.add(Shape::line(corners.to_vec(), Stroke::new(3.0, Color32::from_black_alpha(110))));
    painter.extend(Shape::dashed_line(&corners, Stroke::new(1.5, palette.outline(true)), 6.0, 4.0));
}

/// A hint in the middle of the upper edge: what a gesture does just now.
pub(crate) fn hint(painter: &Painter, rect: Rect, gesture: Option<&Gesture>, marking: bool, lang: Lang) {
    let text = match gesture {
        Some(Gesture::Move { constraint: Constraint::Along(axis), .. }) => {
            words::along(lang, LETTERS[axis_number(*axis)])
        }
        Some(Gesture::Move { constraint: Constraint::ViewPlane, .. }) => words::in_plane(lang),
        Some(Gesture::Mark { .. }) => words::drag_region(lang),
        Some(Gesture::Undecided { .. } | Gesture::Navigate { .. }) | None if marking => words::drag_region(lang),
        Some(Gesture::Undecided { .. } | Gesture::Navigate { .. }) | None => return,
    };
    let galley = painter.layout_no_wrap(text, FontId::proportional(12.5), Color32::WHITE);
    let place = rect.center_top() + egui::vec2(0.0, 20.0);
    let around = Align2::CENTER_CENTER.anchor_size(place, galley.size());
    painter.rect_filled(around.expand2(egui::vec2(10.0, 5.0)), 6.0, Color32::from_black_alpha(180));
    painter.galley(around.min, galley, Color32::WHITE);
}
