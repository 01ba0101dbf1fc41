//! SDL: `slope {V, lo, hi altitude V, lo, hi}`, `aoi`: patterns that look at the surface, not only at the point.

use super::wave::folded;
use crate::math::{vec3, Vec3};

/// What a texture may ask about the surface that it is evaluated on.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceContext {
    /// Where the ray goes, of length one.
    pub ray_direction: Vec3,
    /// The surface's own normal, of length one.
    pub geometric_normal: Vec3,
    /// The normal after the texture's `normal`, of length one.
    pub normal: Vec3,
    /// The point of the surface, before any warp.
    pub point: Vec3,
    /// The surface's own coordinates, for `uv_mapping`.
    pub uv: [f64; 2],
}

impl SurfaceContext {
    /// For media, fog, functions and others that have no surface.
    pub const NONE: SurfaceContext = SurfaceContext {
        ray_direction: Vec3::Z,
        geometric_normal: Vec3::Y,
        normal: Vec3::Y,
        point: Vec3::ZERO,
        uv: [0.0; 2],
    };

    /// The place in the plane of uv coordinates.
    #[inline]
    pub fn uv_point(&self) -> Vec3 {
        vec3(self.uv[0], self.uv[1], 0.0)
    }
}

/// Parameters of `slope`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// The direction, or the point to look towards.
    pub direction: Vec3,
    /// The value that is stretched to 0.
    pub low: f64,
    /// The value that is stretched to 1.
    pub high: f64,
    /// Whether `direction` is a point.
    pub point_at: bool,
    /// A direction whose gradient is added, with the range that it is stretched from.
    pub altitude: Option<(Vec3, f64, f64)>,
}

impl Slope {
    pub(super) fn value(&self, p: Vec3, surface: &SurfaceContext) -> f64 {
        let stretch = |v: f64, low: f64, high: f64| if high != low { (v - low) / (high - low) } else { v };
        let towards = if self.point_at { self.direction - p } else { self.direction };
        let slope_weight = if self.point_at { 1.0 } else { towards.length() };
        let cosine = surface.normal.dot(towards.normalized()).clamp(-1.0, 1.0);
        let slope = stretch(0.5 + cosine.asin() / std::f64::consts::PI, self.low, self.high);
        let value = match self.altitude {
            None => slope,
            Some((direction, low, high)) => {
                let weight = direction.length();
                let altitude = stretch(p.dot(direction.normalized()), low, high);
                (slope_weight * slope + weight * altitude) / (slope_weight + weight)
            }
        };
        if value < 0.0 {
            value - value.floor()
        } else {
            folded(value)
        }
    }
}

/// `aoi`: 1 where the ray meets the surface head-on, 0.5 where it grazes.
pub(super) fn angle_of_incidence(surface: &SurfaceContext) -> f64 {
    let cosine = surface.normal.dot(surface.ray_direction).clamp(-1.0, 1.0);
    0.5 + cosine.asin().abs() / std::f64::consts::PI
}
