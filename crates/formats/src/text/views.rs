//! The views: eye and screen as the document gives them, and what differs from the usual way of computing.

use super::table::{Cell, Table};
use super::{clean, row, section};
use lancer_scene::{DVec3, ScreenSpec, Steps, View, Views};
use lancer_words::{Lang, term, text as words};

/// The views as text; every line ends with a line feed.
pub fn describe_views(views: &Views, lang: Lang) -> String {
    let mut table = Table::new([2, 3, 2]);
    for view in views {
        let screen = screen(&view.screen, lang);
        let mut rows = vec![
            [term::size(lang), words::pixels(lang, view.width, view.height)],
            [term::eye(lang), row(view.eye.to_array())],
            [term::screen(lang), screen],
        ];
        let manner = manner(view, lang);
        if !manner.is_empty() {
            rows.push([words::computed(lang), manner.join("   ")]);
        }
        for (number, row) in rows.into_iter().enumerate() {
            let name = if number == 0 { Cell::Text(clean(&view.name)) } else { Cell::Blank };
            table.push([vec![name], row.map(Cell::Text).to_vec()].concat());
        }
    }
    let lines = if views.is_empty() { vec![format!("  {}", words::none_feminine(lang))] } else { table.lines() };
    let mut text = String::new();
    section(&mut text, term::views(lang), lines);
    text
}

fn screen(screen: &ScreenSpec, lang: Lang) -> String {
    let labelled = |label: String, point: DVec3| format!("{label} {}", row(point.to_array()));
    match screen {
        ScreenSpec::Frame(screen) => [
            labelled(words::top_left(lang), screen.origin),
            labelled(words::to_the_right(lang), screen.u),
            labelled(words::downwards(lang), screen.v),
        ]
        .join("   "),
        ScreenSpec::Centered { center, size: [width, height], up } => [
            labelled(words::perpendicular(lang), *center),
            words::extent(lang, row([*width]), row([*height])),
            labelled(words::up(lang), *up),
        ]
        .join("   "),
        ScreenSpec::Corners(corners) => {
            let corners = corners.map(|corner| row(corner.to_array())).join("   ");
            format!("{}   {corners}", words::corners(lang))
        }
        ScreenSpec::LookAt { look_at, up, fov } => [
            labelled(words::looks_at(lang), *look_at),
            labelled(words::up(lang), *up),
            words::field_of_view(lang, row([*fov])),
        ]
        .join("   "),
    }
}

/// What differs from one sample a pixel, the world's depth and every step.
fn manner(view: &View, lang: Lang) -> Vec<String> {
    let samples = (view.samples != 1).then(|| words::samples(lang, view.samples));
    let depth = view.depth.map(|depth| words::view_depth(lang, depth));
    let Steps { shadows, reflection, transparency } = view.steps;
    let left_out: Vec<String> = [
        (!shadows).then(|| term::shadows(lang)),
        (!reflection).then(|| term::reflection(lang)),
        (!transparency).then(|| term::transparency(lang)),
    ]
    .into_iter()
    .flatten()
    .collect();
    let without = (!left_out.is_empty()).then(|| words::without(lang, left_out.join(", ")));
    samples.into_iter().chain(depth).chain(without).collect()
}
