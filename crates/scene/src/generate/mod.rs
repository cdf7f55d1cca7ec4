//! Scenes made by calculation: families of one shape in any size, for measuring, for tests and for looking at.
//!
//! Each family is a function of a whole number, its size, to a scene and a view of it. Nothing comes from outside: no
//! clock, no random numbers but those of [`Random`], no function of the machine's library, so the same size is the same
//! scene on every machine. The vertices of meshes are rounded to 32 bits, so that a program that holds no more traces
//! the very same facets.

mod course;
mod field;
mod grid;
mod knot;
mod lattice;
mod mountain;
mod nest;
mod noise;
mod pebble;
mod random;
mod sphereflake;
mod sponge;
mod tetrahedron;

pub use random::Random;

use crate::{
    Color, Invalid, List, Material, MaterialRef, Mesh, MeshGeometry, Object, Placement, PointLight, Reflectance, Rgb,
    Scene, ScreenSpec, Shape, Steps, Surface, View,
};
use glam::DVec3;
use std::ops::RangeInclusive;
use std::sync::Arc;

/// A family of scenes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// What the subject asks for at once: a plane, spheres of mirror, glass and copper, two cubes, three lamps.
    Course,
    /// Spheres that carry nine spheres each, after E. Haines' database «balls»; the size is how often.
    Sphereflake,
    /// Tetrahedra of tetrahedra, after E. Haines' database «tetra»; the size is how often.
    Tetrahedron,
    /// A fractal mountain behind four glass spheres, after E. Haines' database «mount»; the size is how often its
    /// square is quartered.
    Mountain,
    /// A rough landscape over a square; the size is its cells along a side.
    Field,
    /// A tube along a trefoil knot; the size is its cells around the tube.
    Knot,
    /// A closed, dented body of nearly equal facets; the size is its facets along an edge of an icosahedron.
    Pebble,
    /// Glass within glass, balls and cubes in turn; the size is how many.
    Nest,
    /// Balls at the points of a lattice in space, and struts between them; the size is its cells along an edge.
    Lattice,
    /// Menger's sponge; the size is how often its middles are taken away.
    Sponge,
}

impl Family {
    /// Every family, in the order in which lists show them.
    pub const ALL: [Family; 10] = [
        Family::Course,
        Family::Sphereflake,
        Family::Tetrahedron,
        Family::Mountain,
        Family::Field,
        Family::Knot,
        Family::Pebble,
        Family::Nest,
        Family::Lattice,
        Family::Sponge,
    ];

    /// The word for it on a command line.
    pub const fn word(self) -> &'static str {
        match self {
            Family::Course => "course",
            Family::Sphereflake => "sphereflake",
            Family::Tetrahedron => "tetrahedron",
            Family::Mountain => "mountain",
            Family::Field => "field",
            Family::Knot => "knot",
            Family::Pebble => "pebble",
            Family::Nest => "nest",
            Family::Lattice => "lattice",
            Family::Sponge => "sponge",
        }
    }

    /// The sizes that there are. The largest has some millions of facets or half a million spheres.
    pub const fn sizes(self) -> RangeInclusive<u32> {
        match self {
            Family::Course => 1..=1,
            Family::Sphereflake => 0..=6,
            Family::Tetrahedron => 1..=11,
            Family::Mountain => 1..=11,
            Family::Field => 1..=2000,
            Family::Knot => 3..=500,
            Family::Pebble => 1..=500,
            Family::Nest => 1..=12,
            Family::Lattice => 1..=40,
            Family::Sponge => 0..=4,
        }
    }

    /// The size where none is given; of the published databases it is the published one.
    pub const fn usual_size(self) -> u32 {
        match self {
            Family::Course => 1,
            Family::Sphereflake => 4,
            Family::Tetrahedron | Family::Mountain => 6,
            Family::Field => 708,
            Family::Knot => 100,
            Family::Pebble => 59,
            Family::Nest => 6,
            Family::Lattice => 4,
            Family::Sponge => 3,
        }
    }

    /// The scene of that size, and a view of it.
    ///
    /// # Errors
    /// A size that does not lie within [`Family::sizes`].
    pub fn generate(self, size: u32) -> Result<(Scene, View), Invalid> {
        let sizes = self.sizes();
        if !sizes.contains(&size) {
            let [value, min, max] = [size, *sizes.start(), *sizes.end()].map(f64::from);
            return Err(Invalid::OutOfRange { field: "size", value, min, max });
        }
        Ok(match self {
            Family::Course => course::course(),
            Family::Sphereflake => sphereflake::sphereflake(size),
            Family::Tetrahedron => tetrahedron::tetrahedron(size),
            Family::Mountain => mountain::mountain(size),
            Family::Field => field::field(size),
            Family::Knot => knot::knot(size),
            Family::Pebble => pebble::pebble(size),
            Family::Nest => nest::nest(size),
            Family::Lattice => lattice::lattice(size),
            Family::Sponge => sponge::sponge(size),
        })
    }
}

/// The background of E. Haines' databases.
const SKY: Color = Rgb::new(0.078, 0.361, 0.753);

/// A named material.
fn material(name: &str, surface: Surface) -> Material {
    Material { name: name.into(), surface }
}

/// A surface that scatters light of a colour, and gives back the ambient light in the same colour.
fn matte(color: Color) -> Surface {
    Surface { ka: color, kd: color, ks: Rgb::BLACK, w: Reflectance::Constant, ..Surface::default() }
}

/// A lamp of a colour.
fn lamp(name: &str, position: DVec3, color: Color) -> PointLight {
    PointLight { color, ..PointLight::new(name, position) }
}

/// An object of a named material.
fn object(name: impl AsRef<str>, material: &str, shape: Shape) -> Object {
    Object { material: MaterialRef::Named(material.into()), ..Object::new(name.as_ref(), shape) }
}

/// A mesh that stands where its vertices are, its facets flat.
fn mesh(positions: Vec<DVec3>, facets: Vec<[u32; 3]>) -> Shape {
    let geometry = MeshGeometry { positions, facets, ..MeshGeometry::default() };
    Shape::Mesh(Mesh { geometry: Arc::new(geometry), source: None, placement: Placement::default(), smooth: false })
}

/// The nearest point with coordinates of 32 bits.
fn single(point: DVec3) -> DVec3 {
    DVec3::from(point.to_array().map(|coordinate| f64::from(coordinate as f32)))
}

/// A view of one sample a pixel that looks at a point, and how far to the left and to the right in degrees.
fn view(size: [u32; 2], eye: DVec3, look_at: DVec3, up: DVec3, fov: f64) -> View {
    View {
        name: "front".into(),
        width: size[0],
        height: size[1],
        eye,
        screen: ScreenSpec::LookAt { look_at, up, fov },
        samples: 1,
        depth: None,
        steps: Steps::default(),
    }
}

/// A list of new items.
fn list<T>(items: impl IntoIterator<Item = T>) -> List<T> {
    items.into_iter().collect()
}
