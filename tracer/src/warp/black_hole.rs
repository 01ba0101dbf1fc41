//! SDL: `warp { black_hole V, F strength F falloff F inverse repeat V turbulence V }`.

use crate::math::Vec3;
use crate::pattern::point_in_cube;

/// Parameters of `black_hole`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlackHole {
    /// The centre (of the first block, if repeated).
    pub center: Vec3,
    /// How far it reaches.
    pub radius: f64,
    /// Factor of the displacement.
    pub strength: f64,
    /// Exponent of the displacement's fall towards the radius.
    pub falloff: f64,
    /// Push instead of pull.
    pub inverse: bool,
    /// Size of the blocks with a hole each; 0 along an axis that is not repeated.
    pub repeat: Option<Vec3>,
    /// How far the centres of repeated holes are shifted at random, towards larger coordinates.
    pub turbulence: Vec3,
}

impl BlackHole {
    /// A hole is moved to lie in its block, and the block grows to hold it wherever turbulence shifts it (probed).
    pub(super) fn fitted(mut self) -> BlackHole {
        let Some(mut repeat) = self.repeat else { return self };
        for axis in 0..3 {
            if repeat[axis] != 0.0 {
                self.center[axis] = self.center[axis].max(self.radius);
                repeat[axis] = repeat[axis].max(self.center[axis] + self.radius + self.turbulence[axis]);
            }
        }
        self.repeat = Some(repeat);
        self
    }

    /// Where `p` comes from: further out for a pull, since the pattern moves against the points.
    pub fn apply(&self, p: Vec3) -> Vec3 {
        let from_center = p - self.center_near(p);
        let distance = from_center.length();
        if distance >= self.radius {
            return p;
        }
        let share = ((self.radius - distance) / self.radius).powf(self.falloff) * self.strength;
        let displacement = from_center * share.min(1.0);
        if self.inverse {
            p - displacement
        } else {
            p + displacement
        }
    }

    fn center_near(&self, p: Vec3) -> Vec3 {
        let Some(repeat) = self.repeat else { return self.center };
        let mut block = Vec3::ZERO;
        for axis in (0..3).filter(|&a| repeat[a] != 0.0) {
            block[axis] = (p[axis] / repeat[axis]).floor();
        }
        let corner = self.center + block.mul_each(repeat);
        if self.turbulence == Vec3::ZERO {
            return corner;
        }
        let random = point_in_cube(block.x as i64, block.y as i64, block.z as i64) - block;
        corner + random.mul_each(self.turbulence)
    }
}
