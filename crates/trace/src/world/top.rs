//! The top level: the hierarchy over the bodies that have bounds, and the list of those that have none.

use super::body::{Body, Geometry};
use super::few::Few;
use crate::bvh::{Bounds, Bvh};

/// The bodies of a world, in the order in which rays are brought to them.
#[derive(Debug, Default)]
pub(crate) struct Top {
    unbounded: Vec<u32>,
    /// The other bodies' numbers and boxes, in document order: what the hierarchy was built over.
    bounds: Vec<(u32, Bounds)>,
    bvh: Bvh,
    /// The numbers in the order of the leaves.
    order: Vec<u32>,
    /// The same bodies if they are few.
    few: Option<Few>,
}

impl Top {
    /// The top level over bodies; `None` where `before` is just that.
    pub(crate) fn over(bodies: &[Body], before: &Top) -> Option<Top> {
        let (mut unbounded, mut bounds) = (Vec::new(), Vec::new());
        for (number, body) in (0_u32..).zip(bodies) {
            match (body.geometry.bounds(), &body.geometry) {
                (Some(around), _) => bounds.push((number, around)),
                (None, Geometry::Plane { .. }) => unbounded.push(number),
                // a mesh without facets has neither bounds nor points
                (None, Geometry::Sphere { .. } | Geometry::Cone(_) | Geometry::Facets(_)) => {}
            }
        }
        if unbounded == before.unbounded && bounds == before.bounds {
            return None;
        }
        let boxes: Vec<Bounds> = bounds.iter().map(|(_, bounds)| *bounds).collect();
        let (bvh, order) = Bvh::build(&boxes);
        let order = order.into_iter().map(|item| bounds[item as usize].0).collect();
        let few = Few::of(bodies, &bounds);
        Some(Top { unbounded, bounds, bvh, order, few })
    }

    /// The bodies that every ray is tried against.
    pub(crate) fn unbounded(&self) -> &[u32] {
        &self.unbounded
    }

    /// The others by the balls around them, if they are few.
    pub(crate) fn few(&self) -> Option<&Few> {
        self.few.as_ref()
    }

    /// The hierarchy over the others, and their numbers in the order of its leaves.
    pub(crate) fn bounded(&self) -> (&Bvh, &[u32]) {
        (&self.bvh, &self.order)
    }
}
