//! What is lost when a scene or views are written in the format of 2009.

use crate::Describe;
use crate::xml::Excerpt;
use lancer_scene::{Compose, Name};
use lancer_words::{Lang, n7_2009 as words};

/// Something that the format cannot hold.
#[derive(Clone, Debug, PartialEq)]
pub enum Loss {
    /// The scene's title.
    Title {
        /// What it was.
        title: String,
    },
    /// A background that is not the ambient light.
    Background,
    /// A medium around the objects.
    WorldIndex,
    /// A depth limit other than 6.
    Depth {
        /// What it was.
        depth: u32,
    },
    /// A composition other than the subject's.
    Compose {
        /// What it was.
        compose: Compose,
    },
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

/// What an object, a lamp, a material or a view can have and the format cannot hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Feature {
    /// Being there although hidden.
    Hidden,
    /// A name that reading does not give again.
    Name,
    /// A material that no visible object has.
    Unused,
    /// A reflectance that is not constant.
    Law,
    /// Blinn's highlight.
    Highlight,
    /// A shininess for each channel.
    Shininess,
    /// A refraction index for each channel.
    Dispersion,
    /// A cube's centre, edge and rotation.
    Cube,
    /// A cone's roundness.
    Cone,
    /// A mesh's position, rotation and scale.
    Placement,
    /// A mesh's file.
    File,
    /// Smooth normals.
    Smooth,
    /// Several materials on one mesh.
    Parts,
    /// How a view's screen was given.
    Screen,
    /// Pixels that are not square.
    Proportion,
    /// Several samples a pixel.
    Samples,
    /// A view's own depth limit.
    ViewDepth,
    /// Steps left out.
    Steps,
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

    pub(super) fn push(&mut self, loss: Loss) {
        self.0.push(loss);
    }
}

impl Feature {
    fn told(self, lang: Lang, those: String) -> String {
        match self {
            Feature::Hidden => words::loss_hidden(lang, those),
            Feature::Name => words::loss_name(lang, those),
            Feature::Unused => words::loss_unused(lang, those),
            Feature::Law => words::loss_law(lang, those),
            Feature::Highlight => words::loss_highlight(lang, those),
            Feature::Shininess => words::loss_shininess(lang, those),
            Feature::Dispersion => words::loss_dispersion(lang, those),
            Feature::Cube => words::loss_cube(lang, those),
            Feature::Cone => words::loss_cone(lang, those),
            Feature::Placement => words::loss_placement(lang, those),
            Feature::File => words::loss_file(lang, those),
            Feature::Smooth => words::loss_smooth(lang, those),
            Feature::Parts => words::loss_parts(lang, those),
            Feature::Screen => words::loss_screen(lang, those),
            Feature::Proportion => words::loss_proportion(lang, those),
            Feature::Samples => words::loss_samples(lang, those),
            Feature::ViewDepth => words::loss_view_depth(lang, those),
            Feature::Steps => words::loss_steps(lang, those),
        }
    }
}

impl Describe for Loss {
    fn code(&self) -> &'static str {
        "n7::loss"
    }

    fn message(&self, lang: Lang) -> String {
        match self {
            Loss::Title { title } => words::loss_title(lang, Excerpt::new(title)),
            Loss::Background => words::loss_background(lang),
            Loss::WorldIndex => words::loss_world_index(lang),
            Loss::Depth { depth } => words::loss_depth(lang, depth),
            Loss::Compose { compose } => words::loss_compose(lang, compose.word()),
            Loss::Of { feature, first, count } => {
                let others = count.saturating_sub(1);
                let those = match others {
                    0 => words::that(lang, Excerpt::new(first)),
                    1 => words::that_and_another(lang, Excerpt::new(first)),
                    others => words::those(lang, Excerpt::new(first), others),
                };
                feature.told(lang, those)
            }
        }
    }

    fn label(&self, _lang: Lang) -> String {
        String::new()
    }

    fn help(&self, lang: Lang) -> Option<String> {
        Some(words::loss_help(lang))
    }
}
