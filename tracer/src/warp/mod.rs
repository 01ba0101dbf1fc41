//! SDL: `warp { ... }` and transforms: from a point to the point that a pattern is asked at.

use crate::math::{Transform, Vec3};
use crate::pattern::TurbulenceModifier;

/// One step on the way from a point to the pattern's own space.
#[derive(Clone, Debug)]
pub enum Warp {
    /// A transform of the pattern, undone.
    Transform(Box<Transform>),
    /// `warp { turbulence V }`.
    Turbulence(TurbulenceModifier),
}

impl Warp {
    /// Where `p` comes from.
    #[inline]
    pub fn apply(&self, p: Vec3) -> Vec3 {
        match self {
            Warp::Transform(t) => t.inverse_point(p),
            Warp::Turbulence(t) => t.displace(p),
        }
    }
}
