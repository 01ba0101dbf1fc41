//! SDL: `density_file df3 "a.df3" interpolate 0|1|2`: voxels in the unit cube.

use crate::graph::pattern as graph;
use crate::graph::Shared;
use crate::image::cubic_weights;
use crate::math::Vec3;

/// The voxels of a file; copies share them.
#[derive(Clone, Debug)]
pub struct DensityFile(Shared<graph::DensityFile>);

/// Up to four neighbours along one axis with their weights.
type Neighbours = [(usize, f64); 4];

impl DensityFile {
    /// The voxels of a graph node.
    pub fn new(node: &Shared<graph::DensityFile>) -> DensityFile {
        DensityFile(node.clone())
    }

    /// The value at `p`; 0 outside the cube.
    pub fn value(&self, p: Vec3) -> f64 {
        let [nz, ny, nx] = self.0.size;
        if self.0.voxels.is_empty() || !(0..3).all(|axis| (0.0..1.0).contains(&p[axis])) {
            return 0.0;
        }
        let (xs, ys, zs) = (self.along(p.x, nx), self.along(p.y, ny), self.along(p.z, nz));
        let used = match self.0.interpolate {
            1 => 2,
            2 => 4,
            _ => 1,
        };
        let mut sum = 0.0;
        for &(z, wz) in &zs[..used] {
            for &(y, wy) in &ys[..used] {
                for &(x, wx) in &xs[..used] {
                    sum += wx * wy * wz * f64::from(self.0.voxels[(z * ny + y) * nx + x]);
                }
            }
        }
        // Cubics overshoot.
        sum.clamp(0.0, 1.0)
    }

    /// The voxels around a place. Their values stand at their lower corners, and after the last comes the first again.
    /// What stands before the first follows from an index that has wrapped around (probed).
    fn along(&self, share: f64, size: usize) -> Neighbours {
        let before_first = u32::MAX as usize % size;
        let place = share * size as f64;
        let first = (place as usize).min(size - 1);
        let t = place - first as f64;
        let (before, next, after) =
            (first.checked_sub(1).unwrap_or(before_first), (first + 1) % size, (first + 2) % size);
        match self.0.interpolate {
            1 => [(first, 1.0 - t), (next, t), (0, 0.0), (0, 0.0)],
            2 => {
                let [a, b, c, d] = cubic_weights(t);
                [(before, a), (first, b), (next, c), (after, d)]
            }
            _ => [(first, 1.0), (0, 0.0), (0, 0.0), (0, 0.0)],
        }
    }
}
