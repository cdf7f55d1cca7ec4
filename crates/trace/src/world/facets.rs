//! A set of facets in a scene: shared geometry with its hierarchy, where it stands, surfaces of parts, smooth normals.

use super::packed::Packed;
use super::packs::Packs;
use super::placed::{Carrying, Placed};
use super::surfaces::Surfaces;
use crate::Ray;
use crate::bvh::{Block, Bounds, Bvh, Margin, Sight};
use glam::{DMat3, DVec3};
use lancer_scene::{Mesh, Part};
use std::sync::Arc;

/// Facets in the order of the document. A clone costs a few counters.
#[derive(Clone, Debug)]
pub(crate) struct Facets {
    packed: Arc<Packed>,
    /// `None`: the facets stand where the packed geometry has them.
    placed: Option<Arc<Placed>>,
    /// What brings normals of the geometry to the world, up to their length; `None`: the facets are flat.
    normals: Option<Arc<DMat3>>,
    /// Runs of facets with surfaces of their own: `(first, end, surface)`, ascending.
    parts: Arc<[(u32, u32, u32)]>,
}

impl Facets {
    /// Facets without parts that stand where they are.
    pub(crate) fn flat(packed: Arc<Packed>) -> Facets {
        Facets { packed, placed: None, normals: None, parts: Arc::default() }
    }

    /// Facets that are given by their corners.
    pub(crate) fn separate(facets: &[[DVec3; 3]]) -> Facets {
        Facets::flat(Arc::new(Packed::separate(facets)))
    }

    /// The facets of a mesh where its placement brings them, without parts.
    pub(crate) fn of_mesh(mesh: &Mesh, packs: &Packs) -> Facets {
        let carrying = Carrying::of(&mesh.placement);
        let packed = packs.get(mesh);
        let placed = match carrying {
            Carrying::Nothing | Carrying::Facets { .. } => None,
            Carrying::Rays { linear, inverse } => {
                let corners = |first: u32, count: u32| {
                    let blocks = &packed.blocks()[first as usize..(first + count) as usize];
                    blocks.iter().flat_map(Block::numbers).flat_map(|facet| packed.corners(facet))
                };
                Some(Arc::new(Placed::new((linear, inverse), mesh.placement.position, packed.bvh(), corners)))
            }
        };
        let normals = mesh.smooth.then(|| {
            // the cross products of the linear part's columns: P0P1 × P0P2 goes by them, as every normal does
            let DMat3 { x_axis: x, y_axis: y, z_axis: z } = mesh.placement.linear();
            Arc::new(DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y)))
        });
        Facets { packed, placed, normals, parts: Arc::default() }
    }

    /// The facets with these parts, whose materials are given their numbers.
    #[must_use]
    pub(crate) fn with_parts(mut self, parts: &[Part], surfaces: &mut Surfaces) -> Facets {
        let end = |part: &Part| part.first.saturating_add(part.count);
        let parts: Vec<(u32, u32, u32)> =
            parts.iter().map(|part| (part.first, end(part), surfaces.number(&part.material))).collect();
        if *self.parts != *parts {
            self.parts = parts.into();
        }
        self
    }

    /// What the facets share with others of the same geometry.
    pub(crate) fn packed(&self) -> &Arc<Packed> {
        &self.packed
    }

    /// How many facets there are.
    pub(crate) fn len(&self) -> u32 {
        self.packed.len()
    }

    /// `P0 P1 P2` of a facet, in the world.
    #[inline]
    pub(crate) fn corners(&self, facet: u32) -> [DVec3; 3] {
        let corners = self.packed.corners(facet);
        match &self.placed {
            Some(placed) => [placed.apply(corners[0]), placed.apply(corners[1]), placed.apply(corners[2])],
            None => corners,
        }
    }

    /// The smooth normals at the corners of a facet, of unit length or 0; `None` where the facets are flat.
    pub(crate) fn normals(&self, facet: u32) -> Option<[DVec3; 3]> {
        let matrix = self.normals.as_deref()?;
        let normals = self.packed.smooth_normals();
        let [a, b, c] = self.packed.geometry().facets[facet as usize];
        Some([a, b, c].map(|vertex| (*matrix * normals[vertex as usize]).normalize_or_zero()))
    }

    /// The surface of the part that a facet belongs to, if it belongs to one.
    pub(crate) fn surface(&self, facet: u32) -> Option<u32> {
        let next = self.parts.partition_point(|&(first, _, _)| first <= facet);
        let &(_, end, surface) = self.parts.get(next.checked_sub(1)?)?;
        (facet < end).then_some(surface)
    }

    /// The surfaces of the facets in order, each run of facets with one surface once, where `otherwise` is the one of
    /// facets that belong to no part.
    pub(crate) fn surfaces(&self, otherwise: u32) -> impl Iterator<Item = u32> + '_ {
        let len = self.len();
        let mut reached = 0;
        let parts = self.parts.iter().take_while(move |(first, _, _)| *first < len);
        let runs = parts.flat_map(move |&(first, end, surface)| {
            let gap = (first > reached).then_some(otherwise);
            let part = (end > first).then_some(surface);
            reached = reached.max(end);
            gap.into_iter().chain(part)
        });
        let parted = self.parts.iter().map(|&(_, end, _)| end).max().unwrap_or(0);
        runs.chain((parted < len).then_some(otherwise))
    }

    /// The hierarchy over the facets; a leaf counts blocks.
    pub(crate) fn bvh(&self) -> &Bvh {
        self.packed.bvh()
    }

    /// The facets in the order of the leaves, relative to the hierarchy's origin.
    pub(crate) fn blocks(&self) -> &[Block] {
        self.packed.blocks()
    }

    /// `(M, position)`: a point `p` of the world is at `M·(p - position)` in the space of hierarchy and blocks. `None`
    /// where that space is the world.
    pub(crate) fn to_local(&self) -> Option<&(DMat3, DVec3)> {
        self.placed.as_deref().map(|placed| &placed.to_local)
    }

    /// A ray in the space of hierarchy and blocks: its origin and its direction, which is no unit vector there, so that
    /// distances stay the same numbers.
    pub(crate) fn local_ray(&self, origin: DVec3, direction: DVec3) -> (DVec3, DVec3) {
        match self.to_local() {
            Some((matrix, position)) => (*matrix * (origin - *position), *matrix * direction),
            None => (origin, direction),
        }
    }

    /// How much wider the boxes have to be for a ray, in the space of the hierarchy: the way there and the test of a
    /// facet in the world are both counted.
    pub(crate) fn margin(&self) -> Margin {
        self.placed.as_deref().map_or_else(|| self.bvh().margin(), |placed| placed.margin)
    }

    /// The box around all facets in the world.
    pub(crate) fn bounds(&self) -> Option<Bounds> {
        self.placed.as_deref().map_or_else(|| self.bvh().bounds(), |placed| placed.bounds)
    }

    /// Visits every facet that the ray may hit before `limit`, as [`Bvh::visit`] does.
    pub(crate) fn visit(&self, ray: &Ray, limit: f64, mut visit: impl FnMut(u32, f64) -> f64) -> f64 {
        let (origin, direction) = self.local_ray(ray.origin, ray.direction);
        let sight = Sight::new(self.bvh(), origin, direction, self.margin().at(ray.origin));
        self.bvh().visit(&sight, limit, |first, count, mut limit| {
            for facet in self.blocks()[first as usize..(first + count) as usize].iter().flat_map(Block::numbers) {
                limit = visit(facet, limit);
                if limit < 0.0 {
                    break;
                }
            }
            limit
        })
    }
}
