//! What makes a scene or a view legal: the ranges and rules of SPEC §2 and §3, in one place for readers and edits.

use crate::{Environment, Material, MaterialRef, Name, NameKind, Object, PointLight, Rgb, Scene, Shape, Surface, View};
use glam::DVec3;
use std::collections::HashSet;
use std::sync::Arc;

/// The bounds of the numbers.
pub mod limits {
    /// The greatest magnitude of a length or a coordinate.
    pub const COORDINATE: f64 = 1e9;
    /// The least length, index, radius, edge, size or factor where more than 0 is demanded.
    pub const LEAST: f64 = 1e-9;
    /// The greatest depth limit.
    pub const DEPTH: u32 = 64;
    /// The greatest shininess.
    pub const SHININESS: f64 = 10_000.0;
    /// The greatest width and height of a picture in pixels.
    pub const PIXELS: u32 = 65_535;
    /// The greatest number of samples along a pixel's side.
    pub const SAMPLES: u32 = 64;
    /// The least and the greatest field of view in degrees.
    pub const FOV: (f64, f64) = (1.0, 179.0);
    /// Directions whose angle has a smaller sine count as parallel: decimal fractions that are meant to be collinear
    /// miss it by rounding alone.
    pub const SMALLEST_SINE: f64 = 1e-12;
}

/// A broken rule. `field` is the attribute's name in the documents.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Invalid {
    /// A number is not finite.
    #[error("`{field}` must be finite")]
    NotFinite {
        /// The attribute.
        field: &'static str,
    },
    /// A number is outside its range.
    #[error("`{field}` must lie within {min} and {max}, not {value}")]
    OutOfRange {
        /// The attribute.
        field: &'static str,
        /// What it holds.
        value: f64,
        /// The least legal value.
        min: f64,
        /// The greatest legal value.
        max: f64,
    },
    /// The three points of a plane or a facet lie on one line.
    #[error("the three points lie on one line")]
    Collinear,
    /// The three edges of a box lie in one plane.
    #[error("the three edges lie in one plane")]
    Coplanar,
    /// The ends of a cone are in one place.
    #[error("the ends of the cone are in one place")]
    ConeFlat,
    /// Both radii of a cone are 0.
    #[error("both radii of the cone are 0")]
    ConeThin,
    /// A mesh's scale has a factor 0.
    #[error("`scale` must not be 0")]
    ScaleZero,
    /// A facet names a vertex that does not exist.
    #[error("facet {facet} names vertex {vertex}, but there are {vertices} vertices")]
    FacetVertex {
        /// The facet's number from 0.
        facet: usize,
        /// The number that it names.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A mesh has neither 0 normals nor one per vertex.
    #[error("there are {normals} normals for {vertices} vertices")]
    NormalCount {
        /// How many normals there are.
        normals: usize,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A part is empty, lies outside the facets, or overlaps the part before it.
    #[error("part {part} does not name facets of its own: the mesh has {facets} facets")]
    PartRange {
        /// The part's number from 0.
        part: usize,
        /// How many facets there are.
        facets: usize,
    },
    /// A name is empty, begins or ends with white space, or holds a control character.
    #[error("a name must not be empty, begin or end with white space, or hold control characters")]
    BadName,
    /// A name is taken.
    #[error("the name `{name}` is taken")]
    NameTaken {
        /// The name.
        name: Name,
        /// Among which things it must be unique.
        kind: NameKind,
    },
    /// A material is named that does not exist.
    #[error("there is no material `{name}`")]
    UnknownMaterial {
        /// The name.
        name: Name,
    },
    /// The screen's edges are parallel or zero.
    #[error("the screen's edges do not span a surface")]
    ScreenCollinear,
    /// The four corners of a screen are no parallelogram.
    #[error("the screen's corners are no parallelogram")]
    NotParallelogram,
    /// The eye lies in the screen's plane.
    #[error("the eye lies in the plane of the screen")]
    EyeInScreen,
    /// The eye looks at itself.
    #[error("`look-at` is the eye's own place")]
    LookAtIsEye,
    /// `up` is zero or along the sight.
    #[error("`up` points along the line of sight")]
    UpAlongSight,
}

/// `value` within `min..=max` and finite.
fn within(field: &'static str, value: f64, min: f64, max: f64) -> Result<(), Invalid> {
    if !value.is_finite() {
        Err(Invalid::NotFinite { field })
    } else if (min..=max).contains(&value) {
        Ok(())
    } else {
        Err(Invalid::OutOfRange { field, value, min, max })
    }
}

fn channels(field: &'static str, values: Rgb, min: f64, max: f64) -> Result<(), Invalid> {
    values.to_array().into_iter().try_for_each(|value| within(field, value, min, max))
}

fn point(field: &'static str, point: DVec3) -> Result<(), Invalid> {
    point.to_array().into_iter().try_for_each(|value| within(field, value, -limits::COORDINATE, limits::COORDINATE))
}

fn length(field: &'static str, value: f64) -> Result<(), Invalid> {
    within(field, value, limits::LEAST, limits::COORDINATE)
}

fn triangle(p0: DVec3, p1: DVec3, p2: DVec3) -> Result<(), Invalid> {
    point("p0", p0)?;
    point("p1", p1)?;
    point("p2", p2)?;
    let (u, v) = (p1 - p0, p2 - p0);
    // The third side too: two sides of a needle can be long while its corners nearly touch.
    let shortest = u.length().min(v.length()).min((p2 - p1).length());
    if u.cross(v).length() <= limits::SMALLEST_SINE * u.length() * v.length() || shortest == 0.0 {
        return Err(Invalid::Collinear);
    }
    Ok(())
}

/// Whether `name` is trimmed, not empty, and can be shown and written: no control characters, and neither of the two
/// characters that no document may hold.
fn name(name: &str) -> Result<(), Invalid> {
    let hidden = |character: char| character.is_control() || matches!(character, '\u{FFFE}' | '\u{FFFF}');
    if name.is_empty() || name.trim() != name || name.contains(hidden) { Err(Invalid::BadName) } else { Ok(()) }
}

impl Environment {
    /// # Errors
    /// The first rule that the environment breaks.
    pub fn check(&self) -> Result<(), Invalid> {
        channels("ambient", self.ambient, 0.0, 1.0)?;
        channels("background", self.background, 0.0, 1.0)?;
        channels("index", self.index, limits::LEAST, limits::COORDINATE)?;
        within("depth", f64::from(self.depth), 0.0, f64::from(limits::DEPTH))
    }
}

impl Surface {
    /// # Errors
    /// The first rule that the surface breaks.
    pub fn check(&self) -> Result<(), Invalid> {
        channels("ka", self.ka, 0.0, 1.0)?;
        channels("kd", self.kd, 0.0, 1.0)?;
        channels("ks", self.ks, 0.0, 1.0)?;
        channels("n", self.shininess, 0.0, limits::SHININESS)?;
        channels("kr", self.kr, 0.0, 1.0)?;
        channels("kt", self.kt, 0.0, 1.0)?;
        channels("index", self.index, limits::LEAST, limits::COORDINATE)
    }
}

impl Material {
    /// # Errors
    /// The first rule that the material breaks.
    pub fn check(&self) -> Result<(), Invalid> {
        name(&self.name)?;
        self.surface.check()
    }
}

impl PointLight {
    /// # Errors
    /// The first rule that the lamp breaks.
    pub fn check(&self) -> Result<(), Invalid> {
        name(&self.name)?;
        point("position", self.position)?;
        channels("color", self.color, 0.0, 1.0)
    }
}

impl Object {
    /// Checks the object itself; whether its materials exist is the scene's matter.
    ///
    /// # Errors
    /// The first rule that the object breaks.
    pub fn check(&self) -> Result<(), Invalid> {
        self.check_instance()?;
        self.shape.geometry().map_or(Ok(()), |geometry| geometry.check())
    }

    /// Checks all but a mesh's geometry, which objects may share.
    pub(crate) fn check_instance(&self) -> Result<(), Invalid> {
        name(&self.name)?;
        self.material.check()?;
        self.shape.check_instance()
    }
}

impl MaterialRef {
    /// Checks a surface of its own; whether a named material exists is the scene's matter.
    fn check(&self) -> Result<(), Invalid> {
        match self {
            MaterialRef::Inline(surface) => surface.check(),
            MaterialRef::Default | MaterialRef::Named(_) => Ok(()),
        }
    }
}

impl Shape {
    /// # Errors
    /// The first rule that the shape breaks.
    pub fn check(&self) -> Result<(), Invalid> {
        self.check_instance()?;
        self.geometry().map_or(Ok(()), |geometry| geometry.check())
    }

    /// Checks all but a mesh's geometry, which objects may share.
    ///
    /// # Errors
    /// The first rule that the shape breaks.
    pub fn check_instance(&self) -> Result<(), Invalid> {
        match self {
            Shape::Sphere { center, radius } => {
                point("center", *center)?;
                length("radius", *radius)
            }
            Shape::Plane { p0, p1, p2 } | Shape::Facet { p0, p1, p2 } => triangle(*p0, *p1, *p2),
            Shape::Cube { center, edge, rotation } => {
                point("center", *center)?;
                length("edge", *edge)?;
                point("rotation", *rotation)
            }
            Shape::Parallelepiped { origin, edges: [u, v, w] } => {
                point("origin", *origin)?;
                point("u", *u)?;
                point("v", *v)?;
                point("w", *w)?;
                let volume = u.cross(*v).dot(*w).abs();
                if volume <= limits::SMALLEST_SINE * u.length() * v.length() * w.length() {
                    return Err(Invalid::Coplanar);
                }
                Ok(())
            }
            Shape::Cone { base, top, base_radius, top_radius, capped: _ } => {
                point("base", *base)?;
                point("top", *top)?;
                within("base-radius", *base_radius, 0.0, limits::COORDINATE)?;
                within("top-radius", *top_radius, 0.0, limits::COORDINATE)?;
                if base.distance(*top) < limits::LEAST {
                    return Err(Invalid::ConeFlat);
                }
                if base_radius.max(*top_radius) < limits::LEAST {
                    return Err(Invalid::ConeThin);
                }
                Ok(())
            }
            Shape::Mesh(mesh) => {
                let placement = &mesh.placement;
                point("position", placement.position)?;
                point("rotation", placement.rotation)?;
                point("scale", placement.scale)?;
                if placement.scale.to_array().into_iter().any(|factor| factor.abs() < limits::LEAST) {
                    return Err(Invalid::ScaleZero);
                }
                Ok(())
            }
        }
    }
}

impl crate::MeshGeometry {
    /// # Errors
    /// The first rule that vertices, facets, normals or parts break.
    pub fn check(&self) -> Result<(), Invalid> {
        self.positions.iter().try_for_each(|position| point("vertices", *position))?;
        let (vertices, facets) = (self.positions.len(), self.facets.len());
        if !self.normals.is_empty() && self.normals.len() != vertices {
            return Err(Invalid::NormalCount { normals: self.normals.len(), vertices });
        }
        if self.normals.iter().any(|normal| !normal.is_finite()) {
            return Err(Invalid::NotFinite { field: "normals" });
        }
        for (facet, corners) in self.facets.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= vertices) {
                return Err(Invalid::FacetVertex { facet, vertex, vertices });
            }
        }
        let mut free_from = 0_u64;
        for (part, run) in self.parts.iter().enumerate() {
            let end = u64::from(run.first) + u64::from(run.count);
            if run.count == 0 || u64::from(run.first) < free_from || end > facets as u64 {
                return Err(Invalid::PartRange { part, facets });
            }
            free_from = end;
        }
        self.parts.iter().try_for_each(|part| part.material.check())
    }
}

impl View {
    /// # Errors
    /// The first rule that the view breaks.
    pub fn check(&self) -> Result<(), Invalid> {
        name(&self.name)?;
        let count =
            |field, value: u32, min: u32, max: u32| within(field, f64::from(value), f64::from(min), f64::from(max));
        count("width", self.width, 1, limits::PIXELS)?;
        count("height", self.height, 1, limits::PIXELS)?;
        count("samples", self.samples, 1, limits::SAMPLES)?;
        self.depth.map_or(Ok(()), |depth| count("depth", depth, 0, limits::DEPTH))?;
        point("at", self.eye)?;
        match &self.screen {
            crate::ScreenSpec::Frame(screen) => {
                point("origin", screen.origin)?;
                point("u", screen.u)?;
                point("v", screen.v)?;
            }
            crate::ScreenSpec::Centered { center, size, up } => {
                point("center", *center)?;
                size.iter().try_for_each(|&size| length("size", size))?;
                point("up", *up)?;
            }
            crate::ScreenSpec::Corners(corners) => corners.iter().try_for_each(|&corner| point("corners", corner))?,
            crate::ScreenSpec::LookAt { look_at, up, fov } => {
                point("look-at", *look_at)?;
                point("up", *up)?;
                within("fov", *fov, limits::FOV.0, limits::FOV.1)?;
            }
        }
        self.resolved_screen().map(|_| ())
    }
}

impl Scene {
    /// Checks the whole scene: every part, every name, every reference.
    ///
    /// # Errors
    /// The first rule that is broken, with the name of the object, lamp or material that breaks it.
    pub fn check(&self) -> Result<(), (Option<Name>, Invalid)> {
        self.world.check().map_err(|rule| (None, rule))?;
        let at = |name: &Name| {
            let name = name.clone();
            move |rule| (Some(name), rule)
        };
        let mut materials = HashSet::new();
        for material in &self.materials {
            material.check().map_err(at(&material.name))?;
            take(&mut materials, &material.name, NameKind::Material).map_err(at(&material.name))?;
        }
        let mut names = HashSet::new();
        for light in &self.lights {
            light.check().map_err(at(&light.name))?;
            take(&mut names, &light.name, NameKind::ObjectOrLight).map_err(at(&light.name))?;
        }
        let mut geometries = HashSet::new();
        for object in &self.objects {
            object.check_instance().map_err(at(&object.name))?;
            take(&mut names, &object.name, NameKind::ObjectOrLight).map_err(at(&object.name))?;
            // Geometry that many objects share is looked at once, and the materials of its parts too.
            let geometry = object.shape.geometry().filter(|geometry| geometries.insert(Arc::as_ptr(geometry)));
            geometry.map_or(Ok(()), |geometry| geometry.check()).map_err(at(&object.name))?;
            let parts = geometry.map_or(&[][..], |geometry| &geometry.parts).iter().map(|part| &part.material);
            for name in std::iter::once(&object.material).chain(parts).filter_map(MaterialRef::name) {
                if !materials.contains(name) {
                    return Err((Some(object.name.clone()), Invalid::UnknownMaterial { name: name.clone() }));
                }
            }
        }
        Ok(())
    }
}

/// Adds a name to those taken.
fn take(taken: &mut HashSet<Name>, name: &Name, kind: NameKind) -> Result<(), Invalid> {
    if taken.insert(name.clone()) { Ok(()) } else { Err(Invalid::NameTaken { name: name.clone(), kind }) }
}
