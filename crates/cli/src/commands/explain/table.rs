//! The table of a ray's sum: every factor of every term, and the running sum after each (subject §2.5, §2.6).

use lancer_scene::{Compose, Rgb};
use lancer_trace::Channels;
use lancer_trace::RayTree;
use lancer_trace::explain::{Course, Entry, Factor, Part, RayNames, Way, account};
use lancer_trace::observe::{LampLight, Omitted, RayNode, SurfaceNode};
use lancer_words::cli::usage;
use lancer_words::digits::{channel, length, triple};
use lancer_words::{Lang, explain as words};

/// A line of a ray's story.
pub(super) enum Line {
    /// A sentence.
    Text(String),
    /// A label and a value for each channel.
    Row {
        /// What the values are.
        label: String,
        /// Red, green, blue.
        cells: [String; 3],
    },
    /// An empty line.
    Blank,
}

impl Line {
    /// A row of channel values.
    pub(super) fn values(label: String, value: Rgb) -> Line {
        Line::Row { label, cells: value.to_array().map(channel) }
    }

    /// A row of the values of some channels, with a dash in the others.
    pub(super) fn carried(label: String, value: Rgb, channels: Channels) -> Line {
        let cell = |index: usize| match channels.contains(index) {
            true => channel(value[index]),
            false => "–".to_owned(),
        };
        Line::Row { label, cells: [cell(0), cell(1), cell(2)] }
    }

    /// A row of anything.
    pub(super) fn cells(label: String, cells: [String; 3]) -> Line {
        Line::Row { label, cells }
    }
}

/// The rows of the sum of the point that a ray sees.
pub(super) fn terms(
    (tree, names): (&RayTree, &RayNames<'_>),
    node: &RayNode,
    surface: &SurfaceNode,
    compose: Compose,
    lang: Lang,
) -> Vec<Line> {
    let mut table = Table { names, node, lang, term: String::new(), lines: Vec::new() };
    for entry in account(tree, node, surface, compose) {
        table.entry(entry);
    }
    table.lines
}

struct Table<'a> {
    names: &'a RayNames<'a>,
    node: &'a RayNode,
    lang: Lang,
    /// The name of the term that begins, until a row bears it.
    term: String,
    lines: Vec<Line>,
}

impl Table<'_> {
    fn entry(&mut self, entry: Entry<'_>) {
        let lang = self.lang;
        match entry {
            Entry::Begin(part) => match part {
                Part::Ambient => self.term = words::ambient(lang),
                Part::Mirror => self.term = words::mirror(lang),
                Part::Glass => self.term = words::glass(lang),
                Part::Diffuse => self.term = words::diffuse(lang),
                Part::Highlight => self.term = words::highlight(lang),
                Part::Lamp { name, distance } => {
                    let lamp = words::lamp(lang, name, length(distance)) + &usage::colon(lang);
                    self.lines.push(Line::Text(lamp));
                }
            },
            Entry::Omitted { part, why } => {
                let remark = match why {
                    Omitted::NoCoefficient if part == Part::Mirror => words::no_mirror(lang),
                    Omitted::NoCoefficient => words::no_glass(lang),
                    Omitted::DepthReached => words::depth_reached(lang, self.node.level),
                    Omitted::StepLeftOut => words::step_left_out(lang),
                };
                self.remark(&remark);
            }
            Entry::Way(way) => {
                let remark = self.way(&way);
                self.remark(&remark);
            }
            Entry::Lamp { light, cos_s } => {
                let told = match light {
                    LampLight::Lit(lit) => words::lights(lang, lit.cos_l, cos_s, lit.cos_s),
                    LampLight::Blocked { by, .. } => words::blocked(lang, by),
                    LampLight::Behind { cos_l } => words::behind(lang, channel(*cos_l)),
                    LampLight::AtPoint => words::at_point(lang),
                };
                self.lines.push(Line::Text(format!("  {told}")));
            }
            Entry::Value { sign, factor, value } => {
                let what = self.factor(&factor);
                self.row(sign, &what, value);
            }
            Entry::Sum { sign, part, so_far } => {
                let what = match part {
                    Part::Ambient => "Ka·Ia".to_owned(),
                    Part::Mirror => "Kr·Ir".to_owned(),
                    Part::Glass => "Kt·It".to_owned(),
                    Part::Lamp { .. } => words::lamp_term(lang),
                    Part::Diffuse => words::diffuse(lang),
                    Part::Highlight => words::highlight(lang),
                };
                self.term = "E".to_owned();
                self.row(sign, &what, so_far);
            }
        }
    }

    /// A row of a term: its name (once), a sign, what the values are, the values in the ray's channels.
    fn row(&mut self, sign: &str, what: &str, value: Rgb) {
        let term = std::mem::take(&mut self.term);
        self.lines.push(Line::carried(format!("{term:<10} {sign:>1} {what}"), value, self.node.channels));
    }

    /// What is to be said of a term beside its values.
    fn remark(&mut self, remark: &str) {
        let term = std::mem::take(&mut self.term);
        self.lines.push(Line::Text(format!("{term:<10}   {remark}")));
    }

    fn factor(&self, factor: &Factor) -> String {
        match factor {
            Factor::Symbol(symbol) => (*symbol).to_owned(),
            Factor::Power { n } => format!("cosⁿ s, n = {}", triple(n.to_array())),
            Factor::Seen { symbol, rays } => {
                let names: Vec<String> = rays.iter().map(|&ray| self.names.of(ray)).collect();
                words::seen_along(self.lang, symbol, names.join(", "))
            }
            Factor::Clamped => words::clamped_term(self.lang),
        }
    }

    fn way(&self, way: &Way) -> String {
        let lang = self.lang;
        let told = match way.course {
            Course::Straight => words::straight_on(lang),
            Course::Bent { indices, cos_i, cos_r } => words::bent(lang, indices, cos_i, cos_r),
            Course::Reflected { indices, cos_i, cos_critical } => words::not_bent(lang, indices, cos_i, cos_critical),
        };
        let Some(channels) = way.channels else { return told };
        let names = words::channels(lang);
        let carried: Vec<&str> = channels.iter().map(|channel| names[channel].as_str()).collect();
        format!("{}{} {told}", carried.join(", "), usage::colon(lang))
    }
}
