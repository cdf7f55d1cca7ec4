//! The transparent bodies that a ray is inside of (SPEC §1, media).

use super::World;
use glam::DVec3;
use lancer_scene::Rgb;

/// The media that a ray is inside of, outermost first: `(body, index of its material)`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Media(Vec<(u32, Rgb)>);

impl Media {
    /// The index of the medium that a ray with this stack travels in.
    pub(crate) fn index(&self, world: &World) -> Rgb {
        self.0.last().map_or(world.environment().index, |(_, index)| *index)
    }

    /// Entering pushes, again if the body is there already.
    #[must_use]
    pub(crate) fn entered(&self, body: u32, index: Rgb) -> Media {
        let mut media = Vec::with_capacity(self.0.len() + 1);
        media.extend_from_slice(&self.0);
        media.push((body, index));
        Media(media)
    }

    /// Leaving removes the body's last entry; leaving what is not there changes nothing.
    #[must_use]
    pub(crate) fn left(&self, body: u32) -> Media {
        let mut media = self.clone();
        if let Some(place) = media.0.iter().rposition(|(entry, _)| *entry == body) {
            media.0.remove(place);
        }
        media
    }

    /// The entries of the stack, outermost first.
    pub(crate) fn entries(&self) -> impl Iterator<Item = (u32, Rgb)> + '_ {
        self.0.iter().copied()
    }

    /// The bodies on the stack, outermost first.
    pub(crate) fn bodies(&self) -> impl Iterator<Item = u32> + '_ {
        self.0.iter().map(|(body, _)| *body)
    }

    /// The stack of a ray that starts at a point in free space: the transparent bodies around it, planes first, then
    /// by the diagonal of their bounds, longest first, ties in document order.
    pub(crate) fn around(world: &World, point: DVec3) -> Media {
        let mut inside: Vec<(u32, u32, f64)> = (0_u32..)
            .zip(world.bodies.iter())
            .filter_map(|(number, body)| Some((number, body.medium?, body)))
            .filter(|(_, _, body)| body.contains(point))
            .map(|(number, medium, body)| {
                (number, medium, body.geometry.bounds().map_or(f64::INFINITY, |bounds| bounds.diagonal()))
            })
            .collect();
        // stable: equal diagonals stay in document order
        inside.sort_by(|(_, _, a), (_, _, b)| b.total_cmp(a));
        Media(inside.into_iter().map(|(number, medium, _)| (number, world.surface(medium).index)).collect())
    }
}
