//! What is lost when a scene is written for another program.

use crate::Describe;
use crate::xml::Excerpt;
use lancer_scene::{Compose, MaterialRef, Name, Scene, Surface};
use lancer_words::n7_2009::{that, that_and_another, those};
use lancer_words::{Lang, export as words};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// Something that a format of another program cannot hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Loss {
    /// A composition of colours other than the plain sum.
    Compose {
        /// What it was.
        compose: Compose,
    },
    /// Lamps, ambient light and background: the format holds bodies alone.
    Lights,
    /// A feature of some objects, lamps, materials or views.
    Of {
        /// What they lose.
        feature: Feature,
        /// The first of them.
        first: Name,
        /// How many there are.
        count: usize,
    },
}

/// What an object, a lamp, a material or a view can have and a format cannot hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Feature {
    /// Being there although hidden.
    Hidden,
    /// A reflectance that is not constant.
    Law,
    /// Blinn's highlight.
    Highlight,
    /// A highlight of another strength in each channel.
    HighlightColour,
    /// A shininess for each channel.
    Shininess,
    /// Transparency that differs between channels.
    Filter,
    /// A refraction index for each channel.
    Dispersion,
    /// Transparent objects that block lamps wholly.
    Shadows,
    /// Parts of one mesh with different refraction indices.
    PartIndices,
    /// Several samples a pixel.
    Samples,
    /// A plane, which has no end.
    Plane,
    /// A sphere's or a cone's roundness.
    Roundness,
    /// A coefficient that the material model of the format has no place for.
    Coefficients,
}

/// The losses found while writing, those of one feature counted together.
#[derive(Default)]
pub(super) struct Losses(pub(super) Vec<Loss>);

impl Losses {
    /// Notes that something of that name loses a feature.
    pub(super) fn of(&mut self, lost: Feature, name: &Name) {
        for loss in &mut self.0 {
            if let Loss::Of { feature, count, .. } = loss
                && *feature == lost
            {
                *count += 1;
                return;
            }
        }
        self.0.push(Loss::Of { feature: lost, first: name.clone(), count: 1 });
    }

    /// Notes each feature that is lost.
    pub(super) fn of_each(&mut self, features: impl IntoIterator<Item = (bool, Feature)>, name: &Name) {
        features.into_iter().filter(|(lost, _)| *lost).for_each(|(_, feature)| self.of(feature, name));
    }
}

impl Feature {
    fn told(self, lang: Lang, those: String) -> String {
        match self {
            Feature::Hidden => words::hidden(lang, those),
            Feature::Law => words::law(lang, those),
            Feature::Highlight => words::highlight(lang, those),
            Feature::HighlightColour => words::highlight_colour(lang, those),
            Feature::Shininess => words::shininess(lang, those),
            Feature::Filter => words::filter(lang, those),
            Feature::Dispersion => words::dispersion(lang, those),
            Feature::Shadows => words::shadows(lang, those),
            Feature::PartIndices => words::part_indices(lang, those),
            Feature::Samples => words::samples(lang, those),
            Feature::Plane => words::plane(lang, those),
            Feature::Roundness => words::roundness(lang, those),
            Feature::Coefficients => words::coefficients(lang, those),
        }
    }
}

impl Describe for Loss {
    fn code(&self) -> &'static str {
        "export::loss"
    }

    fn message(&self, lang: Lang) -> String {
        match self {
            Loss::Compose { compose } => words::compose(lang, compose.word()),
            Loss::Lights => words::lights(lang),
            Loss::Of { feature, first, count } => {
                let first = Excerpt::new(first);
                let named = match count.saturating_sub(1) {
                    0 => that(lang, first),
                    1 => that_and_another(lang, first),
                    others => those(lang, first, others),
                };
                feature.told(lang, named)
            }
        }
    }

    fn label(&self, _lang: Lang) -> String {
        String::new()
    }

    fn help(&self, _lang: Lang) -> Option<String> {
        None
    }
}

/// Notes what is hidden: other programs have no word for it.
pub(super) fn hidden(scene: &Scene, losses: &mut Losses) {
    let lights = scene.lights.iter().filter(|light| !light.visible).map(|light| &light.name);
    let objects = scene.objects.iter().filter(|object| !object.visible).map(|object| &object.name);
    lights.chain(objects).for_each(|name| losses.of(Feature::Hidden, name));
}

/// The surfaces of the visible objects, each once and with the name of its material or of its first object.
pub(super) fn surfaces_in_use(scene: &Scene) -> Vec<(Surface, Name)> {
    let named: HashMap<&str, &Surface> =
        scene.materials.iter().map(|material| (&*material.name, &material.surface)).collect();
    let (mut surfaces, mut seen) = (Vec::new(), HashSet::new());
    let mut geometries = HashSet::new();
    for object in scene.objects.iter().filter(|object| object.visible) {
        // the parts of a geometry are looked at once, however many objects show it
        let parts = object.shape.geometry().filter(|geometry| geometries.insert(Arc::as_ptr(geometry)));
        let parts = parts.map_or(&[][..], |geometry| geometry.parts.as_slice());
        for material in std::iter::once(&object.material).chain(parts.iter().map(|part| &part.material)) {
            let found = match material {
                MaterialRef::Default => None,
                MaterialRef::Named(name) => named.get(&**name).map(|surface| (*surface, name.clone())),
                MaterialRef::Inline(surface) => Some((&**surface, object.name.clone())),
            };
            surfaces.extend(
                found.filter(|(surface, _)| seen.insert(std::ptr::from_ref(*surface))).map(|(s, n)| (s.clone(), n)),
            );
        }
    }
    surfaces
}
