//! SDL: `area_light axis1, axis2, size1, size2 adaptive I jitter circular orient`: the points of a light's area.

use crate::math::Vec3;

/// A grid of points about the light's location.
#[derive(Clone, Debug)]
pub struct Area {
    /// Edges of the area.
    pub axes: [Vec3; 2],
    /// Number of points along each edge.
    pub size: [usize; 2],
    /// Depth to which cells are split without looking at differences.
    pub adaptive: u32,
    /// Whether points are displaced at random, by up to half a cell.
    pub jitter: bool,
    /// Whether the square becomes a disc.
    pub circular: bool,
    /// Whether the area turns towards the point lit.
    pub orient: bool,
    /// Whether diffuse light and highlights come from every point, too.
    pub illumination: bool,
}

impl Area {
    /// The edges as seen from a point from which the light lies in unit direction `towards`.
    pub fn axes_towards(&self, towards: Vec3) -> [Vec3; 2] {
        if !self.orient {
            return self.axes;
        }
        let length = self.axes[0].length();
        // A direction near the z axis needs another helper to be perpendicular to.
        let helper = if (towards.z.abs() - 1.0).abs() < 0.01 { Vec3::Y } else { Vec3::Z };
        let first = towards.cross(helper).normalized();
        let second = towards.cross(first).normalized();
        [first * length, second * length]
    }

    /// Displacement from the centre of grid point (u, v), moved by `shift` (in cells).
    pub fn displacement(&self, axes: &[Vec3; 2], (u, v): (usize, usize), shift: [f64; 2]) -> Vec3 {
        let along = |i: usize, grid: usize| {
            if self.size[i] > 1 {
                (grid as f64 + shift[i]) / (self.size[i] - 1) as f64 - 0.5
            } else {
                0.0
            }
        };
        let (mut a, mut b) = (along(0, u), along(1, v));
        if self.circular {
            // Squares about the centre become circles of the same half width.
            let length = a.hypot(b);
            if length > 0.0 {
                let scale = a.abs().max(b.abs()) / length;
                a *= scale;
                b *= scale;
            }
        }
        axes[0] * a + axes[1] * b
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

    #[test]
    fn circular_keeps_half_width() {
        let area = Area {
            axes: [Vec3::X * 2.0, Vec3::Y * 2.0],
            size: [3, 3],
            adaptive: 0,
            jitter: false,
            circular: true,
            orient: false,
            illumination: false,
        };
        let corner = area.displacement(&area.axes, (2, 2), [0.0; 2]);
        assert!((corner.length() - 1.0).abs() < 1e-12);
        assert!((area.displacement(&area.axes, (2, 1), [0.0; 2]) - vec3(1.0, 0.0, 0.0)).length() < 1e-12);
    }
}
