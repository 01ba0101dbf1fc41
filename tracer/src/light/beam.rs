//! SDL: `spotlight point_at V radius F falloff F tightness F`, and the same for `cylinder`.

use crate::math::Vec3;

/// How a light's beam is bounded.
#[derive(Clone, Copy, Debug)]
pub enum Beam {
    /// Every direction alike.
    Point,
    /// A cone about `axis` (unit, away from the light); `radius` and `falloff` are cosines.
    Spot {
        /// Where the light looks.
        axis: Vec3,
        /// Cosine of the angle up to which it is brightest.
        radius: f64,
        /// Cosine of the angle where it ends.
        falloff: f64,
        /// Exponent of the cosine.
        tightness: f64,
    },
    /// A tube about `axis`; `radius` and `falloff` are lengths.
    Cylinder {
        /// Where the light looks.
        axis: Vec3,
        /// Distance from the axis up to which it is brightest.
        radius: f64,
        /// Distance where it ends.
        falloff: f64,
        /// Exponent of the nearness to the axis.
        tightness: f64,
    },
}

/// A cubic that rises from 0 at `low` to 1 at `high`; 1 wherever `x` is at least `high`, also with `high` below `low`.
fn smooth_step(low: f64, high: f64, x: f64) -> f64 {
    if x >= high {
        1.0
    } else if x < low {
        0.0
    } else {
        let t = (x - low) / (high - low);
        (3.0 - 2.0 * t) * t * t
    }
}

impl Beam {
    /// The share of light at `point`, seen from which the light lies at `location`, in unit direction `towards`.
    #[inline]
    pub fn strength(&self, point: Vec3, location: Vec3, towards: Vec3) -> f64 {
        match *self {
            Beam::Point => 1.0,
            Beam::Spot { axis, radius, falloff, tightness } => {
                let cos = -towards.dot(axis);
                if cos <= 0.0 {
                    return 0.0;
                }
                cos.powf(tightness) * smooth_step(falloff, radius, cos)
            }
            Beam::Cylinder { axis, radius, falloff, tightness } => {
                let from_light = point - location;
                let along = from_light.dot(axis);
                if along <= 0.0 {
                    return 0.0;
                }
                let off = (from_light - axis * along).length();
                if off >= falloff {
                    return 0.0;
                }
                let narrow = if tightness > 0.0 { (1.0 - off / falloff).powf(tightness) } else { 1.0 };
                let edge = if radius > 0.0 { smooth_step(-falloff, -radius, -off) } else { 1.0 };
                narrow * edge
            }
        }
    }
}
