//! What must hold of a test's picture whatever the program says: the lines of an `.expect` file.

use lancer_render::Still;
use lancer_scene::Picture;
use std::fs;
use std::path::Path;

/// One line.
pub(crate) struct Expectation {
    /// File and line, for messages.
    place: String,
    claim: Claim,
}

enum Claim {
    Pixel { x: u32, y: u32, bytes: [u8; 3], tolerance: u8 },
    Count { kind: Kind, count: u64 },
    SameAs { name: String, tolerance: u8 },
}

#[derive(Clone, Copy)]
enum Kind {
    Primary,
    Hits,
    Reflected,
    Refracted,
    Shadow,
    Total,
}

impl Expectation {
    /// The expectations of a file, or everything that is wrong with it.
    pub(crate) fn read(path: &Path) -> Result<Vec<Expectation>, Vec<String>> {
        let text = fs::read_to_string(path).map_err(|error| vec![error.to_string()])?;
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let (mut expectations, mut problems) = (Vec::new(), Vec::new());
        for (number, line) in (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty()) {
            let place = format!("{name}:{number}");
            match claim(line) {
                _ if line.starts_with('#') => {
                    if claim(line.trim_start_matches('#')).is_some() {
                        problems.push(format!("{place}: `{line}` claims nothing while it is a comment"));
                    }
                }
                Some(claim) => expectations.push(Expectation { place, claim }),
                None => problems.push(format!("{place}: `{line}` is no expectation; see tests/scenes/README.md")),
            }
        }
        if !text.lines().any(|line| line.starts_with('#')) {
            problems.push(format!("{name}: no line says where the numbers come from"));
        }
        if expectations.is_empty() {
            problems.push(format!("{name}: no line says what must hold"));
        }
        if problems.is_empty() { Ok(expectations) } else { Err(problems) }
    }

    /// What is wrong with a picture, if it does not meet the expectation. `other` gives the picture of another test.
    pub(crate) fn unmet<'a>(&self, still: &Still, other: impl Fn(&str) -> Option<&'a Still>) -> Option<String> {
        let unmet = match &self.claim {
            Claim::Pixel { x, y, bytes, tolerance } => match still.picture.pixel(*x, *y) {
                Some(found) if near(found, *bytes, *tolerance) => return None,
                Some(found) => format!("pixel {x} {y} is {found:?}, but must be {bytes:?} ± {tolerance}"),
                None => format!("pixel {x} {y} lies outside the picture"),
            },
            Claim::Count { kind, count } => match kind.of(still) {
                found if found == *count => return None,
                found => format!("{found} rays instead of {count}"),
            },
            Claim::SameAs { name, tolerance } => match other(name) {
                Some(other) => {
                    let differing = differing(&still.picture, &other.picture, *tolerance)?;
                    format!("{differing} differ from {name} by more than {tolerance}")
                }
                None => format!("there is no picture of {name}"),
            },
        };
        Some(format!("{}: {unmet}", self.place))
    }
}

impl Kind {
    fn of(self, still: &Still) -> u64 {
        match self {
            Kind::Primary => still.counts.primary,
            Kind::Hits => still.counts.primary_hits,
            Kind::Reflected => still.counts.reflected,
            Kind::Refracted => still.counts.refracted,
            Kind::Shadow => still.counts.shadow,
            Kind::Total => still.counts.total(),
        }
    }
}

/// The claim of a line.
fn claim(line: &str) -> Option<Claim> {
    let (line, tolerance) = match line.split_once('±') {
        Some((line, tolerance)) => (line, tolerance.trim().parse().ok()?),
        None => (line, 0),
    };
    let words: Vec<&str> = line.split_whitespace().collect();
    match words.as_slice() {
        ["pixel", x, y, "=", r, g, b] => Some(Claim::Pixel {
            x: x.parse().ok()?,
            y: y.parse().ok()?,
            bytes: [r.parse().ok()?, g.parse().ok()?, b.parse().ok()?],
            tolerance,
        }),
        ["count", kind, "=", count] if tolerance == 0 => {
            let kind = match *kind {
                "primary" => Kind::Primary,
                "hits" => Kind::Hits,
                "reflected" => Kind::Reflected,
                "refracted" => Kind::Refracted,
                "shadow" => Kind::Shadow,
                "total" => Kind::Total,
                _ => return None,
            };
            Some(Claim::Count { kind, count: count.parse().ok()? })
        }
        ["same", "as", name] => Some(Claim::SameAs { name: (*name).to_owned(), tolerance }),
        _ => None,
    }
}

fn near(a: [u8; 3], b: [u8; 3], tolerance: u8) -> bool {
    a.into_iter().zip(b).all(|(a, b)| a.abs_diff(b) <= tolerance)
}

/// How many pixels of two pictures differ by more than the tolerance, if any do.
fn differing(a: &Picture, b: &Picture, tolerance: u8) -> Option<String> {
    if (a.width, a.height) != (b.width, b.height) {
        return Some("the sizes".to_owned());
    }
    let differ = |(a, b): (&[u8; 3], &[u8; 3])| !near(*a, *b, tolerance);
    match a.bytes.iter().zip(&b.bytes).filter(|pair| differ(*pair)).count() {
        0 => None,
        count => Some(format!("{count} pixels")),
    }
}
