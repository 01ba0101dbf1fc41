//! The primitives, ready to be hit: one file each. Every one stands in its own space and answers five questions.
//!
//! An intersection routine *offers* crossings to its caller, who answers with the new limit: the crossing's own `t`
//! when it is taken, the old limit when it is refused (then the next one is offered), negative infinity to stop. So
//! one routine serves nearest hits, shadows, clipping and CSG, and returns the last limit.

mod arc;
mod bicubic_patch;
mod blob;
mod boxes;
mod cone;
mod container;
mod curve;
mod disc;
mod height_field;

mod hypercomplex;
mod isosurface;
mod julia_fractal;
mod lathe;
mod lemon;
mod ovus;
mod parametric;
mod plane;
mod poly;
mod polygon;
mod prism;
mod quadric;
mod sor;
mod sphere;
mod sphere_sweep;
mod superellipsoid;
#[cfg(test)]
mod tests;
mod text;
mod torus;
mod triangle;

pub use bicubic_patch::BicubicPatch;
pub use blob::Blob;
pub use boxes::Cuboid;
pub use cone::{disc_frame, frame, Cone};
pub use curve::{closed_curves, segments, Segment};
pub use disc::Disc;
pub use height_field::HeightField;
pub use isosurface::Isosurface;
pub use julia_fractal::JuliaFractal;
pub use lathe::Lathe;
pub use lemon::Lemon;
pub use ovus::Ovus;
pub use parametric::Parametric;
pub use plane::Plane;
pub use poly::Poly;
pub use polygon::{rings, Polygon};
pub use prism::Prism;
pub use quadric::Quadric;
pub use sor::Sor;
pub use sphere::{spherical_uv, Sphere};
pub use sphere_sweep::SphereSweep;
pub use superellipsoid::Superellipsoid;
pub use text::Text;
pub use torus::Torus;
pub use triangle::{interpolated_normal, Facet, Triangle};

use std::sync::Arc;

use crate::accel::Counters;
use crate::math::{Bounds, Ray, Vec3};
use crate::mesh::Mesh;

/// Where a ray meets a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Parameter of the ray.
    pub t: f64,
    /// Which part of the primitive: face, triangle, cap.
    pub part: u32,
    /// Coordinates on that part, where it needs them.
    pub u: f64,
    /// See `u`.
    pub v: f64,
}

impl Crossing {
    /// A crossing of a primitive with a single part.
    #[inline]
    pub fn at(t: f64) -> Crossing {
        Crossing { t, part: 0, u: 0.0, v: 0.0 }
    }

    /// A crossing of one part.
    #[inline]
    pub fn on(t: f64, part: u32) -> Crossing {
        Crossing { t, part, u: 0.0, v: 0.0 }
    }
}

/// What every primitive answers, in its own space.
pub trait Primitive {
    /// Where its surface lies.
    fn bounds(&self) -> Bounds;

    /// Where its inside lies.
    fn solid_bounds(&self) -> Bounds {
        self.bounds()
    }

    /// Offers crossings with `from < t <= limit`; see the module.
    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64;

    /// Whether the point lies inside; patches have no inside.
    fn inside(&self, point: Vec3) -> bool;

    /// Outward normal, of any length, for shading.
    fn normal(&self, point: Vec3, crossing: &Crossing) -> Vec3;

    /// Outward normal of the true surface where it differs from that for shading.
    fn geometric_normal(&self, point: Vec3, crossing: &Crossing) -> Vec3 {
        self.normal(point, crossing)
    }

    /// Surface coordinates for `uv_mapping`, for shapes that have them.
    fn uv(&self, _point: Vec3, _crossing: &Crossing) -> Option<[f64; 2]> {
        None
    }

    /// Whether it encloses a volume.
    fn solid(&self) -> bool {
        true
    }

    /// Whether a ray is told all crossings, not only the first ones.
    fn tells_all(&self) -> bool {
        true
    }
}

/// Offers parameters that come in rising order.
#[inline]
pub fn offer_rising(
    crossings: impl IntoIterator<Item = Crossing>,
    from: f64,
    mut limit: f64,
    offer: &mut impl FnMut(Crossing, f64) -> f64,
) -> f64 {
    for crossing in crossings {
        if crossing.t > limit {
            break;
        }
        if crossing.t > from {
            limit = offer(crossing, limit);
        }
    }
    limit
}

/// The enum over all primitives; each call goes straight to the primitive's own routine.
macro_rules! primitives {
    ($($variant:ident($type:ty) = $name:literal),* $(,)?) => {
        /// A primitive ready to be hit. Small ones are held inline, large ones by reference.
        #[derive(Clone, Debug)]
        #[allow(missing_docs)]
        pub enum Shape {
            $($variant($type)),*
        }

        /// SDL's names of the primitives, in the order of the counters.
        pub const SHAPE_NAMES: &[&str] = &[$($name),*];
        /// How many kinds of primitives there are.
        pub const KINDS: usize = SHAPE_NAMES.len();

        #[repr(usize)]
        enum Kind { $($variant),* }

        $(impl From<$type> for Shape {
            fn from(shape: $type) -> Shape { Shape::$variant(shape) }
        })*

        impl Primitive for Shape {
            fn bounds(&self) -> Bounds {
                match self { $(Shape::$variant(s) => s.bounds()),* }
            }
            fn solid_bounds(&self) -> Bounds {
                match self { $(Shape::$variant(s) => s.solid_bounds()),* }
            }
            #[inline]
            fn intersect(
                &self,
                ray: &Ray,
                from: f64,
                limit: f64,
                counters: &mut Counters,
                offer: &mut impl FnMut(Crossing, f64) -> f64,
            ) -> f64 {
                match self {
                    $(Shape::$variant(s) => {
                        counters.tests[Kind::$variant as usize] += 1;
                        s.intersect(ray, from, limit, counters, offer)
                    }),*
                }
            }
            fn inside(&self, point: Vec3) -> bool {
                match self { $(Shape::$variant(s) => s.inside(point)),* }
            }
            fn normal(&self, point: Vec3, crossing: &Crossing) -> Vec3 {
                match self { $(Shape::$variant(s) => s.normal(point, crossing)),* }
            }
            fn geometric_normal(&self, point: Vec3, crossing: &Crossing) -> Vec3 {
                match self { $(Shape::$variant(s) => s.geometric_normal(point, crossing)),* }
            }
            fn uv(&self, point: Vec3, crossing: &Crossing) -> Option<[f64; 2]> {
                match self { $(Shape::$variant(s) => s.uv(point, crossing)),* }
            }
            fn solid(&self) -> bool {
                match self { $(Shape::$variant(s) => s.solid()),* }
            }
            fn tells_all(&self) -> bool {
                match self { $(Shape::$variant(s) => s.tells_all()),* }
            }
        }
    };
}

primitives! {
    Sphere(Sphere) = "sphere",
    Cuboid(Cuboid) = "box",
    Cone(Cone) = "cone",
    Plane(Plane) = "plane",
    Disc(Disc) = "disc",
    Torus(Torus) = "torus",
    Quadric(Box<Quadric>) = "quadric",
    Poly(Arc<Poly>) = "poly",
    Triangle(Box<Triangle>) = "triangle",
    Polygon(Box<Polygon>) = "polygon",
    Mesh(Arc<Mesh>) = "mesh",
    Prism(Arc<Prism>) = "prism",
    Lathe(Arc<Lathe>) = "lathe",
    Sor(Arc<Sor>) = "sor",
    Superellipsoid(Superellipsoid) = "superellipsoid",
    HeightField(Arc<HeightField>) = "height_field",
    Blob(Arc<Blob>) = "blob",
    Isosurface(Arc<Isosurface>) = "isosurface",
    Parametric(Arc<Parametric>) = "parametric",
    Text(Arc<Text>) = "text",
    JuliaFractal(Box<JuliaFractal>) = "julia_fractal",
    Ovus(Box<Ovus>) = "ovus",
    Lemon(Box<Lemon>) = "lemon",
    BicubicPatch(Arc<BicubicPatch>) = "bicubic_patch",
    SphereSweep(Arc<SphereSweep>) = "sphere_sweep",
}
