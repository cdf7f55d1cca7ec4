//! Materials to begin with: coefficients that look like something known.
//!
//! Metals mirror with their published reflectance; what is transparent has its published index and mirrors with
//! Fresnel's share at normal incidence, `((n-1)/(n+1))²`. The model's coefficients do not change with the angle, so
//! both are what is seen from straight above.

use lancer_scene::{Highlight, Reflectance, Rgb, Surface};
use lancer_words::{Lang, preset as words};

/// A material to begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "each is what its name says")]
pub enum Preset {
    Chrome,
    Silver,
    Gold,
    Copper,
    Brass,
    Aluminium,
    Iron,
    Mirror,
    Glass,
    FlintGlass,
    BottleGlass,
    Water,
    Ice,
    Diamond,
    SoapBubble,
    Plaster,
    Terracotta,
    Plastic,
    Rubber,
    Marble,
    Porcelain,
    Jade,
    Obsidian,
    Lacquer,
    Luminous,
}

/// The groups in which menus show the presets.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// Metals and mirrors.
    Metal,
    /// What lets light through.
    Transparent,
    /// Everything else.
    Opaque,
}

impl Family {
    /// The groups in the order in which menus show them.
    pub const ALL: [Family; 3] = [Family::Metal, Family::Transparent, Family::Opaque];

    /// The name.
    pub fn text(self, lang: Lang) -> String {
        match self {
            Family::Metal => words::metals(lang),
            Family::Transparent => words::transparent(lang),
            Family::Opaque => words::opaque(lang),
        }
    }
}

/// A polished metal of a reflectance at normal incidence.
fn metal(r: f64, g: f64, b: f64) -> Surface {
    let reflectance = Rgb::new(r, g, b);
    let share = |part: f64| reflectance.map(|value| (value * part * 1000.0).round() / 1000.0);
    Surface {
        ka: share(0.06),
        kd: share(0.08),
        ks: reflectance,
        shininess: Rgb::splat(200.0),
        kr: reflectance,
        ..Surface::default()
    }
}

/// Something clear: Fresnel's share is mirrored, the rest of `color` let through.
fn clear(index: Rgb, color: Rgb) -> Surface {
    let mirrored = index.map(|n| {
        let root = (n - 1.0) / (n + 1.0);
        (root * root * 1000.0).round() / 1000.0
    });
    Surface {
        ka: Rgb::BLACK,
        kd: Rgb::BLACK,
        ks: Rgb::splat(0.9),
        shininess: Rgb::splat(250.0),
        kr: mirrored,
        kt: mirrored.zip(color, |mirrored, color| ((1.0 - mirrored) * color * 1000.0).round() / 1000.0),
        index,
        ..Surface::default()
    }
}

/// Something opaque of a colour, with a highlight and perhaps a mirror image.
fn opaque(color: [f64; 3], ks: f64, shininess: f64, kr: f64) -> Surface {
    let color = Rgb::from(color);
    Surface {
        ka: color.map(|value| (value * 400.0).round() / 1000.0),
        kd: color,
        ks: Rgb::splat(ks),
        shininess: Rgb::splat(shininess),
        kr: Rgb::splat(kr),
        ..Surface::default()
    }
}

impl Preset {
    /// Every preset, in the order in which menus show them.
    pub const ALL: [Preset; 25] = [
        Preset::Chrome,
        Preset::Silver,
        Preset::Gold,
        Preset::Copper,
        Preset::Brass,
        Preset::Aluminium,
        Preset::Iron,
        Preset::Mirror,
        Preset::Glass,
        Preset::FlintGlass,
        Preset::BottleGlass,
        Preset::Water,
        Preset::Ice,
        Preset::Diamond,
        Preset::SoapBubble,
        Preset::Plaster,
        Preset::Terracotta,
        Preset::Plastic,
        Preset::Rubber,
        Preset::Marble,
        Preset::Porcelain,
        Preset::Jade,
        Preset::Obsidian,
        Preset::Lacquer,
        Preset::Luminous,
    ];

    /// The group that it belongs to.
    pub fn family(self) -> Family {
        use Preset as P;
        match self {
            P::Chrome | P::Silver | P::Gold | P::Copper | P::Brass | P::Aluminium | P::Iron | P::Mirror => {
                Family::Metal
            }
            P::Glass | P::FlintGlass | P::BottleGlass | P::Water | P::Ice | P::Diamond | P::SoapBubble => {
                Family::Transparent
            }
            P::Plaster
            | P::Terracotta
            | P::Plastic
            | P::Rubber
            | P::Marble
            | P::Porcelain
            | P::Jade
            | P::Obsidian
            | P::Lacquer
            | P::Luminous => Family::Opaque,
        }
    }

    /// The name, also of the material that is made of it.
    pub fn text(self, lang: Lang) -> String {
        match self {
            Preset::Chrome => words::chrome(lang),
            Preset::Silver => words::silver(lang),
            Preset::Gold => words::gold(lang),
            Preset::Copper => words::copper(lang),
            Preset::Brass => words::brass(lang),
            Preset::Aluminium => words::aluminium(lang),
            Preset::Iron => words::iron(lang),
            Preset::Mirror => words::mirror(lang),
            Preset::Glass => words::glass(lang),
            Preset::FlintGlass => words::flint_glass(lang),
            Preset::BottleGlass => words::bottle_glass(lang),
            Preset::Water => words::water(lang),
            Preset::Ice => words::ice(lang),
            Preset::Diamond => words::diamond(lang),
            Preset::SoapBubble => words::soap_bubble(lang),
            Preset::Plaster => words::plaster(lang),
            Preset::Terracotta => words::terracotta(lang),
            Preset::Plastic => words::plastic(lang),
            Preset::Rubber => words::rubber(lang),
            Preset::Marble => words::marble(lang),
            Preset::Porcelain => words::porcelain(lang),
            Preset::Jade => words::jade(lang),
            Preset::Obsidian => words::obsidian(lang),
            Preset::Lacquer => words::lacquer(lang),
            Preset::Luminous => words::luminous(lang),
        }
    }

    /// Where its numbers come from, if they are published ones.
    pub fn source(self, lang: Lang) -> Option<String> {
        use Preset as P;
        match self {
            P::Chrome | P::Silver | P::Gold | P::Copper | P::Brass | P::Aluminium | P::Iron => {
                Some(words::source_metals(lang))
            }
            P::Glass | P::BottleGlass => Some(words::source_glass(lang)),
            P::FlintGlass => Some(words::source_flint_glass(lang)),
            P::Water => Some(words::source_water(lang)),
            P::Ice => Some(words::source_ice(lang)),
            P::Diamond => Some(words::source_diamond(lang)),
            P::Jade | P::Obsidian => Some(words::source_opengl(lang)),
            P::Mirror
            | P::SoapBubble
            | P::Plaster
            | P::Terracotta
            | P::Plastic
            | P::Rubber
            | P::Marble
            | P::Porcelain
            | P::Lacquer
            | P::Luminous => None,
        }
    }

    /// The coefficients.
    pub fn surface(self) -> Surface {
        match self {
            Preset::Chrome => metal(0.549, 0.556, 0.554),
            Preset::Silver => metal(0.972, 0.96, 0.915),
            Preset::Gold => metal(1.0, 0.782, 0.344),
            Preset::Copper => metal(0.955, 0.638, 0.538),
            Preset::Brass => metal(0.91, 0.778, 0.423),
            Preset::Aluminium => metal(0.913, 0.922, 0.924),
            Preset::Iron => metal(0.562, 0.565, 0.578),
            Preset::Mirror => Surface { ka: Rgb::BLACK, kd: Rgb::BLACK, kr: Rgb::WHITE, ..Surface::default() },
            Preset::Glass => clear(Rgb::splat(1.5168), Rgb::WHITE),
            Preset::FlintGlass => clear(Rgb::new(1.7209, 1.7283, 1.7464), Rgb::WHITE),
            Preset::BottleGlass => clear(Rgb::splat(1.5168), Rgb::new(0.5, 0.82, 0.55)),
            Preset::Water => clear(Rgb::splat(1.333), Rgb::new(0.94, 0.98, 1.0)),
            Preset::Ice => clear(Rgb::splat(1.309), Rgb::new(0.88, 0.95, 1.0)),
            Preset::Diamond => clear(Rgb::splat(2.419), Rgb::WHITE),
            Preset::SoapBubble => Surface {
                kr: Rgb::new(0.14, 0.1, 0.16),
                kt: Rgb::new(0.88, 0.92, 0.9),
                ..clear(Rgb::WHITE, Rgb::WHITE)
            },
            Preset::Plaster => opaque([0.82, 0.8, 0.76], 0.0, 30.0, 0.0),
            Preset::Terracotta => opaque([0.68, 0.31, 0.18], 0.04, 8.0, 0.0),
            Preset::Plastic => Surface { highlight: Highlight::Blinn, ..opaque([0.75, 0.08, 0.07], 0.55, 120.0, 0.04) },
            Preset::Rubber => opaque([0.06, 0.06, 0.065], 0.18, 6.0, 0.0),
            Preset::Marble => opaque([0.78, 0.77, 0.74], 0.4, 90.0, 0.1),
            Preset::Porcelain => Surface { w: Reflectance::Schlick, ..opaque([0.84, 0.85, 0.88], 0.6, 160.0, 0.06) },
            Preset::Jade => Surface {
                ka: Rgb::new(0.135, 0.2225, 0.1575),
                kd: Rgb::new(0.54, 0.89, 0.63),
                ks: Rgb::splat(0.316228),
                shininess: Rgb::splat(12.8),
                ..Surface::default()
            },
            Preset::Obsidian => Surface {
                ka: Rgb::new(0.05375, 0.05, 0.06625),
                kd: Rgb::new(0.18275, 0.17, 0.22525),
                ks: Rgb::new(0.332741, 0.328634, 0.346435),
                shininess: Rgb::splat(38.4),
                ..Surface::default()
            },
            Preset::Lacquer => opaque([0.03, 0.03, 0.035], 0.9, 300.0, 0.2),
            Preset::Luminous => Surface { ka: Rgb::WHITE, kd: Rgb::WHITE, ..Surface::default() },
        }
    }
}
