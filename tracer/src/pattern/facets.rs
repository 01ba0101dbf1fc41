//! SDL: `normal { facets size F | coords F }`: flat pieces, cut out by the nearest of random points.

use super::cells::cubes_around;
use crate::math::Vec3;
use crate::noise::vector_noise;

/// What the pieces are cut out of: of the directions of normals, each of which becomes the nearest of random ones; or
/// of space, each cell of which is turned by a random amount.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facets {
    /// Of space, turned at most this far; 0 for directions.
    pub coords: f64,
    /// About how far the random points are apart.
    pub size: f64,
    /// Exponent of the distance that makes a point the nearest.
    pub metric: f64,
}

impl Facets {
    /// The normal `n` at `p`, perturbed; of any length.
    pub fn perturb(&self, p: Vec3, n: Vec3) -> Vec3 {
        let normal = n.normalized();
        let size = self.size.max(1e-6);
        if self.coords == 0.0 {
            return self.nearest(normal / size);
        }
        let turn = vector_noise(self.nearest(p / size));
        normal + (turn - normal * turn.dot(normal)) * self.coords
    }

    /// The nearest of the random points of cubes.
    fn nearest(&self, p: Vec3) -> Vec3 {
        let distance = |point: &Vec3| {
            let d = *point - p;
            if self.metric == 2.0 {
                d.length_squared()
            } else if self.metric == 1.0 {
                // Probed: of the distances along the axes, those towards smaller coordinates count as negative.
                d.x + d.y + d.z
            } else {
                let power = |v: f64| v.abs().powf(self.metric);
                power(d.x) + power(d.y) + power(d.z)
            }
        };
        cubes_around(p).min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("some cubes")
    }
}
