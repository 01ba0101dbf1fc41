//! SDL: `crackle form <a,b,c> metric F offset F solid repeat V`: cells around one random point per unit cube; 3.8 repeats
//! them after so many cubes.

use std::sync::LazyLock;

use super::cells::{point_in_cube, TOLERANCE};
use crate::math::{vec3, Vec3};
use crate::noise::NoiseGenerator;

/// Steps to the cube itself and to the neighbours that may hold a near point, those nearest first: all up to two steps
/// away, but for those two steps away along more than one axis.
static CUBES: LazyLock<Vec<[i8; 3]>> = LazyLock::new(|| {
    let steps = (0..125_i8).map(|i| [i / 25 - 2, i / 5 % 5 - 2, i % 5 - 2]);
    let far = |cube: &[i8; 3]| cube.iter().filter(|step| step.abs() == 2).count();
    let mut cubes: Vec<_> = steps.filter(|cube| far(cube) <= 1).collect();
    cubes.sort_by_key(|cube| cube.iter().map(|step| step * step).sum::<i8>());
    cubes
});

/// Parameters of `crackle`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crackle {
    /// Weights of the distances to the nearest, second and third point.
    pub form: Vec3,
    /// Exponent of the Minkowski distance.
    pub metric: f64,
    /// Distance in a fourth dimension.
    pub offset: f64,
    /// One value per cell instead of the distances.
    pub solid: bool,
    /// After how many cubes along each axis the points come again; 0: never.
    pub repeat: [i64; 3],
}

impl Default for Crackle {
    fn default() -> Crackle {
        Crackle { form: vec3(-1.0, 1.0, 0.0), metric: 2.0, offset: 0.0, solid: false, repeat: [0; 3] }
    }
}

impl Crackle {
    /// A number that grows with the distance.
    #[inline]
    fn rank(&self, d: Vec3) -> f64 {
        if self.metric == 2.0 {
            d.length_squared() + self.offset * self.offset
        } else if self.metric == 1.0 {
            d.x.abs() + d.y.abs() + d.z.abs() + self.offset
        } else {
            let power = |v: f64| v.abs().powf(self.metric);
            power(d.x) + power(d.y) + power(d.z) + power(self.offset)
        }
    }

    /// The distance of a rank.
    #[inline]
    fn distance(&self, rank: f64) -> f64 {
        if self.metric == 2.0 {
            rank.sqrt()
        } else if self.metric == 1.0 {
            rank
        } else {
            rank.powf(1.0 / self.metric)
        }
    }

    /// How far along each axis a cube lies from the one that its point repeats.
    #[inline]
    fn beyond_first(&self, cube: [i64; 3]) -> [i64; 3] {
        std::array::from_fn(|axis| match self.repeat[axis] {
            0 => 0,
            period => cube[axis].div_euclid(period) * period,
        })
    }

    pub(super) fn value(&self, p: Vec3, generator: NoiseGenerator) -> f64 {
        let c = p.map(|v| (v - TOLERANCE).floor());
        let (x, y, z) = (c.x as i64, c.y as i64, c.z as i64);
        // How many of the nearest points count, so that cubes beyond the last of them need not be asked.
        let counted = if self.solid {
            1
        } else if self.form.z == 0.0 {
            2
        } else {
            3
        };
        let gaps = [p.x - c.x, p.y - c.y, p.z - c.z].map(|f| [f + 1.0, f, 0.0, 1.0 - f, 2.0 - f]);
        let mut nearest = [f64::INFINITY; 3];
        let mut center = p;
        for &[dx, dy, dz] in &*CUBES {
            let gap = |axis: usize, step: i8| gaps[axis][(step + 2) as usize];
            if self.rank(vec3(gap(0, dx), gap(1, dy), gap(2, dz))) > nearest[counted - 1] {
                continue;
            }
            let cube = [x + i64::from(dx), y + i64::from(dy), z + i64::from(dz)];
            let [bx, by, bz] = self.beyond_first(cube);
            let first = point_in_cube(cube[0] - bx, cube[1] - by, cube[2] - bz);
            let point = first + vec3(bx as f64, by as f64, bz as f64);
            let rank = self.rank(point - p);
            if rank < nearest[0] {
                nearest = [rank, nearest[0], nearest[1]];
                center = first;
            } else if rank < nearest[1] {
                nearest = [nearest[0], rank, nearest[1]];
            } else if rank < nearest[2] {
                nearest[2] = rank;
            }
        }
        if self.solid {
            return generator.noise(center);
        }
        let [d1, d2, d3] = nearest.map(|r| self.distance(r));
        (self.form.x * d1 + self.form.y * d2 + self.form.z * d3).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

    #[test]
    fn repeats_after_so_many_cubes_along_the_axes_that_are_said() {
        let mut random = Random::new(3);
        for solid in [false, true] {
            let crackle = Crackle { solid, repeat: [3, 2, 0], ..Crackle::default() };
            let plain = Crackle { solid, ..Crackle::default() };
            let value = |c: &Crackle, p| c.value(p, NoiseGenerator::from_number(2));
            let mut differ = false;
            for _ in 0..200 {
                let p = random.vector(5.0);
                let here = value(&crackle, p);
                for period in [vec3(3.0, 0.0, 0.0), vec3(-6.0, 2.0, 0.0)] {
                    assert!((here - value(&crackle, p + period)).abs() < 1e-9, "{p:?}");
                }
                differ |= (here - value(&crackle, p + Vec3::Z)).abs() > 0.01;
                // Far from the seams the first copy is the plain pattern.
                let wide = Crackle { repeat: [100, 100, 100], ..plain };
                let q = p + Vec3::splat(50.0);
                assert_eq!(value(&wide, q), value(&plain, q));
            }
            assert!(differ);
        }
    }
}
