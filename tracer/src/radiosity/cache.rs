//! Gathered light, found by place.

use rustc_hash::FxHashMap;

use crate::color::Rgb;
use crate::math::Vec3;

/// Light gathered at one point.
#[derive(Clone, Copy, Debug)]
pub struct Gathered {
    /// Where.
    pub point: Vec3,
    /// The hemisphere's pole, of length one.
    pub normal: Vec3,
    /// The mean of what its rays brought.
    pub light: Rgb,
    /// Harmonic mean of the rays' lengths: how fast light changes around here.
    pub radius: f64,
    /// How many gathering rays led here; it was thrown on fewer times than light seen by less of them.
    pub bounces: u32,
}

/// Gathered light in cubes of different sizes: each lies in the cubes that it reaches, of the size next to its reach.
#[derive(Debug, Default)]
pub struct Cache {
    gathered: Vec<Gathered>,
    cubes: FxHashMap<(i32, [i64; 3]), Vec<Gathered>>,
    /// The sizes in use, as powers of two.
    sizes: Vec<i32>,
}

/// A weighted mean in the making.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mean {
    sum: Rgb,
    weight: f64,
    /// How many were added.
    pub count: usize,
}

impl Mean {
    /// The mean, if there is anything.
    pub fn light(&self) -> Rgb {
        self.sum * self.weight.recip()
    }
}

/// How far behind a point's surface, in radii, gathered light may lie that is reused.
const BEHIND: f64 = 0.05;

impl Gathered {
    /// How unlike the surroundings of another point are: 0 at the point itself, infinite beyond `bound`.
    fn difference(&self, point: Vec3, normal: Vec3, bound: f64) -> f64 {
        let away = point - self.point;
        // Most are too far away.
        if away.dot(away) >= (bound * self.radius).powi(2) {
            return f64::INFINITY;
        }
        if away.dot(self.normal + normal) < -2.0 * BEHIND * self.radius {
            return f64::INFINITY;
        }
        away.length() / self.radius + (1.0 - self.normal.dot(normal)).max(0.0).sqrt()
    }
}

fn cube(point: Vec3, size: i32) -> [i64; 3] {
    let edge = f64::from(size).exp2();
    [point.x, point.y, point.z].map(|c| (c / edge).floor() as i64)
}

impl Cache {
    /// Adds light that points up to `reach` away may use.
    pub fn insert(&mut self, gathered: Gathered, reach: f64) {
        let size = (2.0 * reach).max(1e-9).log2().ceil() as i32;
        if !self.sizes.contains(&size) {
            self.sizes.push(size);
        }
        let (low, high) = (
            cube(gathered.point - Vec3::splat(reach), size),
            cube(gathered.point + Vec3::splat(reach), size),
        );
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    self.cubes.entry((size, [x, y, z])).or_default().push(gathered);
                }
            }
        }
        self.gathered.push(gathered);
    }

    /// Everything, in the order it was added.
    pub fn all(&self) -> &[Gathered] {
        &self.gathered
    }

    /// Forgets everything.
    pub fn clear(&mut self) {
        self.gathered.clear();
        self.cubes.clear();
        self.sizes.clear();
    }

    /// Adds to a mean what may be reused at a point: differences below `bound`, through as many others.
    pub fn collect(&self, point: Vec3, normal: Vec3, bound: f64, bounces: u32, mean: &mut Mean) {
        for &size in &self.sizes {
            let Some(near) = self.cubes.get(&(size, cube(point, size))) else { continue };
            for gathered in near {
                if gathered.bounces != bounces {
                    continue;
                }
                let difference = gathered.difference(point, normal, bound);
                if difference < bound {
                    let weight = (1.0 - difference / bound).powi(2);
                    mean.sum += gathered.light * weight;
                    mean.weight += weight;
                    mean.count += 1;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::Random;

    #[test]
    fn all_that_reach_a_point_are_found() {
        let mut random = Random::new(3);
        let mut cache = Cache::default();
        for _ in 0..300 {
            let (point, radius) = (random.vector(5.0), 0.01 + 2.0 * random.unit());
            let light = Rgb { r: 1.0, g: 0.0, b: 0.0 };
            cache.insert(Gathered { point, normal: Vec3::Y, light, radius, bounces: 0 }, radius);
        }
        for _ in 0..300 {
            let point = random.vector(6.0);
            let mut mean = Mean::default();
            cache.collect(point, Vec3::Y, 1.0, 0, &mut mean);
            assert_eq!(
                mean.count,
                cache.all().iter().filter(|g| g.difference(point, Vec3::Y, 1.0) < 1.0).count()
            );
        }
    }
}
