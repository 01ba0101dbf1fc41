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
    /// Length of the shortest ray: how fast light changes on the way there.
    pub nearest: f64,
    /// The shortest ray's direction, of length one.
    pub toward: Vec3,
    /// How many gathering rays led here; it was thrown on fewer times than light seen by less of them.
    pub bounces: u32,
}

/// Gathered light in cubes of different sizes: each lies in the cubes that it reaches, of the size next to its reach,
/// among those that as many others led to.
#[derive(Debug, Default)]
pub struct Cache {
    gathered: Vec<Gathered>,
    cubes: FxHashMap<(Grid, [i64; 3]), Vec<Gathered>>,
    /// The grids in use.
    grids: Vec<Grid>,
}

/// `bounces`, and the edge of the cubes as a power of two.
type Grid = (u32, i32);

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

/// Sine of the angle below the surface at which gathered light no longer counts (probed, as all weights are).
const BEHIND: f64 = 0.05;

impl Gathered {
    /// How far away light may be reused, at differences up to `bound`.
    pub fn reach(&self, bound: f64) -> f64 {
        bound * self.radius
    }

    /// How much this counts at another point: 1 at the point itself, 0 where the difference reaches `bound`.
    fn weight(&self, point: Vec3, normal: Vec3, bound: f64) -> f64 {
        let away = point - self.point;
        // Most are too far away.
        if away.dot(away) >= self.reach(bound).powi(2) {
            return 0.0;
        }
        let distance = away.length();
        let way = if distance > 0.0 { away * distance.recip() } else { Vec3::ZERO };
        let middle = (self.normal + normal).normalized();
        let below = (-way.dot(middle)).max(0.0);
        let near = way.dot(self.toward).max(0.0);
        let radius = self.nearest * near + self.radius * (1.0 - near);
        let turned = 2.0 * (1.0 - self.normal.dot(normal)).max(0.0).sqrt();
        let difference = (distance / radius + turned) / bound;
        if below >= BEHIND || difference >= 1.0 {
            return 0.0;
        }
        let weight =
            if difference < 0.5 { 1.0 - 2.0 * difference.powi(2) } else { 2.0 * (1.0 - difference).powi(2) };
        weight * (1.0 - below / BEHIND)
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
        let grid = (gathered.bounces, size);
        if !self.grids.contains(&grid) {
            self.grids.push(grid);
        }
        let (low, high) = (
            cube(gathered.point - Vec3::splat(reach), size),
            cube(gathered.point + Vec3::splat(reach), size),
        );
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    self.cubes.entry((grid, [x, y, z])).or_default().push(gathered);
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
        self.grids.clear();
    }

    /// Adds to a mean what may be reused at a point: differences below `bound`, through as many others.
    pub fn collect(&self, point: Vec3, normal: Vec3, bound: f64, bounces: u32, mean: &mut Mean) {
        for &grid in self.grids.iter().filter(|grid| grid.0 == bounces) {
            let Some(near) = self.cubes.get(&(grid, cube(point, grid.1))) else { continue };
            for gathered in near {
                let weight = gathered.weight(point, normal, bound);
                if weight > 0.0 {
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
            let (nearest, toward) = (radius * random.unit(), random.vector(1.0).normalized());
            let gathered = Gathered { point, normal: Vec3::Y, light, radius, nearest, toward, bounces: 0 };
            cache.insert(gathered, gathered.reach(1.0));
        }
        for _ in 0..300 {
            let point = random.vector(6.0);
            let mut mean = Mean::default();
            cache.collect(point, Vec3::Y, 1.0, 0, &mut mean);
            assert_eq!(
                mean.count,
                cache.all().iter().filter(|g| g.weight(point, Vec3::Y, 1.0) > 0.0).count()
            );
        }
    }
}
