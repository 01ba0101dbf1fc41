//! SDL: `warp { repeat V offset V flip V }`: copies of a slab along one axis.

use crate::math::Vec3;

/// Parameters of `repeat`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeat {
    /// Along which axis, 0..3.
    pub axis: usize,
    /// Thickness of the slab; negative for one below 0.
    pub width: f32,
    /// Shift from one copy to the next.
    pub offset: Vec3,
    /// Axes along which every other copy is mirrored.
    pub flip: [bool; 3],
}

impl Repeat {
    /// POV-Ray works with the width in single precision, and so the copies come out.
    pub fn new(axis: usize, width: f64, offset: Vec3, flip: [bool; 3]) -> Repeat {
        Repeat { axis, width: width as f32, offset, flip }
    }

    /// Where `p` comes from.
    pub fn apply(&self, p: Vec3) -> Vec3 {
        let copy = (p[self.axis] / f64::from(self.width)).floor();
        let mut q = p;
        q[self.axis] -= f64::from(copy as f32 * self.width);
        if copy.rem_euclid(2.0) == 1.0 {
            for axis in (0..3).filter(|&a| self.flip[a]) {
                q[axis] = if axis == self.axis { f64::from(self.width) - q[axis] } else { -q[axis] };
            }
        }
        q + self.offset * copy
    }
}
