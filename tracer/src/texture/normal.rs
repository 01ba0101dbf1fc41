//! SDL: `normal { PATTERN amount slope_map {...} | normal_map {...} | list accuracy F no_bump_scale }`.

use std::sync::Arc;

use crate::math::Vec3;
use crate::pattern::{Pattern, SurfaceContext};

/// A perturbation of the surface normal; shared ones are cheap to clone.
#[derive(Clone, Debug)]
pub enum Normal {
    /// Leaves the normal alone.
    Smooth,
    /// Along the gradient of the pattern's value.
    Gradient(Arc<(Pattern, f64)>),
}

impl Normal {
    /// The normal `n` (of length one) at `p`, perturbed; of length one.
    pub fn perturb(&self, _p: Vec3, n: Vec3, _surface: &SurfaceContext) -> Vec3 {
        n
    }
}
