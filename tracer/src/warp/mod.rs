//! SDL: `warp { ... }` and transforms: from a point to the point that a pattern is asked at.

mod black_hole;
mod build;
mod mapping;
mod repeat;

pub use black_hole::BlackHole;
pub use mapping::{Mapping, Projection};
pub use repeat::Repeat;

use crate::math::{Transform, Vec3};
use crate::pattern::TurbulenceModifier;

/// One step on the way from a point to the pattern's own space.
#[derive(Clone, Debug)]
pub enum Warp {
    /// A transform of the pattern, undone.
    Transform(Box<Transform>),
    /// `turbulence V`.
    Turbulence(TurbulenceModifier),
    /// `repeat V`.
    Repeat(Repeat),
    /// `black_hole V, F`.
    BlackHole(Box<BlackHole>),
    /// `cylindrical`, `spherical`, `toroidal`, `planar`.
    Mapping(Box<Mapping>),
    /// `cubic`.
    Cubic,
}

impl Warp {
    /// Where `p` comes from.
    #[inline]
    pub fn apply(&self, p: Vec3) -> Vec3 {
        match self {
            Warp::Transform(t) => t.inverse_point(p),
            Warp::Turbulence(t) => t.displace(p),
            Warp::Repeat(repeat) => repeat.apply(p),
            Warp::BlackHole(hole) => hole.apply(p),
            Warp::Mapping(mapping) => mapping.apply(p),
            Warp::Cubic => mapping::cubic(p),
        }
    }
}
