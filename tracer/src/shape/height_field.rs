//! SDL: `height_field { png "hills.png" smooth water_level 0.1 }`.
//!
//! Vertex (column, row) stands at x = column / (columns - 1), z = 1 - row / (rows - 1). Each cell is two triangles,
//! parted by the diagonal from its corner at larger x to that at larger z. Boxes over 2 x 2, 4 x 4, ... cells with the
//! range of heights form a tree that a ray goes down from near to far.

use super::{Crossing, Facet, Primitive};
use crate::accel::Counters;
use crate::math::{vec3, Bounds, Ray, Vec3};

const NEAREST: f64 = 1e-6;
/// Heights are counted in this many steps, normals of corners in that many, as in POV-Ray.
const HEIGHT_STEPS: f64 = 65536.0;
const NORMAL_STEPS: f64 = 32767.0;
/// Levels of the tree at most; more would need more cells than memory holds.
const LEVELS: usize = 20;

/// The range of heights over squares of cells.
#[derive(Clone, Debug)]
struct Level {
    columns: usize,
    ranges: Vec<[f32; 2]>,
}

/// Hills. A crossing's part is the number of the cell times two, plus one for the triangle at larger x and z.
#[derive(Clone, Debug)]
pub struct HeightField {
    /// Row 0 at z = 0.
    heights: Vec<f64>,
    columns: usize,
    rows: usize,
    water_level: f64,
    smooth: bool,
    /// From single cells to the whole.
    levels: Vec<Level>,
}

impl HeightField {
    /// `heights` row by row, the first at z = 1; none with less than one cell.
    pub fn new(
        heights: &[f64],
        columns: usize,
        rows: usize,
        water_level: f64,
        smooth: bool,
    ) -> Option<HeightField> {
        if columns < 2 || rows < 2 || heights.len() != columns * rows {
            return None;
        }
        let heights: Vec<f64> = heights.chunks(columns).rev().flatten().copied().collect();
        let (w, h) = (columns - 1, rows - 1);
        let cells = (0..w * h).map(|i| {
            let at = i / w * columns + i % w;
            let corners = [at, at + 1, at + columns, at + columns + 1].map(|k| heights[k] as f32);
            // A step outward past the rounding to single precision.
            [
                corners.iter().copied().fold(f32::MAX, f32::min) - 1e-6,
                corners.iter().copied().fold(f32::MIN, f32::max) + 1e-6,
            ]
        });
        let mut levels = vec![Level { columns: w, ranges: cells.collect() }];
        let (mut w, mut h) = (w, h);
        while w * h > 1 && levels.len() < LEVELS {
            let below = &levels[levels.len() - 1];
            let (w2, h2) = (w.div_ceil(2), h.div_ceil(2));
            let mut ranges = vec![[f32::MAX, f32::MIN]; w2 * h2];
            for (i, [low, high]) in below.ranges.iter().enumerate() {
                let above = &mut ranges[i / w / 2 * w2 + i % w / 2];
                *above = [above[0].min(*low), above[1].max(*high)];
            }
            (w, h) = (w2, h2);
            levels.push(Level { columns: w, ranges });
        }
        Some(HeightField { heights, columns, rows, water_level, smooth, levels })
    }

    fn vertex(&self, column: usize, row: usize) -> Vec3 {
        vec3(
            column as f64 / (self.columns - 1) as f64,
            self.heights[row * self.columns + column],
            row as f64 / (self.rows - 1) as f64,
        )
    }

    /// The two triangles of a cell.
    fn facets(&self, column: usize, row: usize) -> [Facet; 2] {
        let (a, b) = (self.vertex(column, row), self.vertex(column + 1, row));
        let (c, d) = (self.vertex(column, row + 1), self.vertex(column + 1, row + 1));
        [Facet::new(a, b, c), Facet::new(d, c, b)]
    }

    /// Where the ray is over a square of cells and between its heights.
    fn span(&self, ray: &Ray, level: usize, column: usize, row: usize, limit: f64) -> Option<f64> {
        let [bottom, top] = self.levels[level].ranges[row * self.levels[level].columns + column];
        let (w, h) = ((self.columns - 1) as f64, (self.rows - 1) as f64);
        let size = (1usize << level) as f64;
        let bounds = Bounds {
            min: vec3(
                column as f64 * size / w,
                f64::from(bottom).max(self.water_level),
                row as f64 * size / h,
            ),
            max: vec3((column + 1) as f64 * size / w, f64::from(top), (row + 1) as f64 * size / h),
        };
        let (mut enter, mut leave) = (0.0f64, limit);
        for axis in 0..3 {
            let (o, d) = (ray.origin[axis], ray.direction[axis]);
            if d == 0.0 {
                if o < bounds.min[axis] - 1e-9 || o > bounds.max[axis] + 1e-9 {
                    return None;
                }
                continue;
            }
            let (a, b) = ((bounds.min[axis] - o) / d, (bounds.max[axis] - o) / d);
            (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
        }
        (enter <= leave + 1e-9 * (1.0 + leave.abs())).then_some(enter)
    }

    fn cell_at(&self, p: Vec3) -> (usize, usize, f64, f64) {
        let (x, z) = (p.x * (self.columns - 1) as f64, p.z * (self.rows - 1) as f64);
        let column = (x.max(0.0) as usize).min(self.columns - 2);
        let row = (z.max(0.0) as usize).min(self.rows - 2);
        (column, row, x - column as f64, z - row as f64)
    }

    /// The normal at a corner: the mean of the four planes through it, a neighbour in x and one in z; in whole steps.
    fn corner_normal(&self, column: usize, row: usize) -> Vec3 {
        let height = |column: usize, row: usize| self.heights[row * self.columns + column] * HEIGHT_STEPS;
        let here = height(column, row);
        let left = (column > 0).then(|| here - height(column - 1, row));
        let right = (column + 1 < self.columns).then(|| height(column + 1, row) - here);
        let front = (row > 0).then(|| here - height(column, row - 1));
        let back = (row + 1 < self.rows).then(|| height(column, row + 1) - here);
        let mut sum = Vec3::ZERO;
        for x in [left, right].into_iter().flatten() {
            for z in [front, back].into_iter().flatten() {
                sum += vec3(-x, 1.0, -z).normalized();
            }
        }
        let steps = sum.normalized().map(|c| (c * NORMAL_STEPS).trunc());
        // From cells and steps to the unit cube.
        vec3(steps.x * (self.columns - 1) as f64, steps.y * HEIGHT_STEPS, steps.z * (self.rows - 1) as f64)
            .normalized()
    }
}

impl Primitive for HeightField {
    fn bounds(&self) -> Bounds {
        let [low, high] = self.heights.iter().fold([f64::MAX, f64::MIN], |[l, h], &y| [l.min(y), h.max(y)]);
        Bounds { min: vec3(0.0, low.max(self.water_level), 0.0), max: vec3(1.0, high, 1.0) }
    }

    fn solid_bounds(&self) -> Bounds {
        let bounds = self.bounds();
        Bounds { min: vec3(0.0, self.water_level.min(bounds.min.y), 0.0), ..bounds }
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        mut limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let from = from.max(NEAREST);
        // Near squares go on the stack last.
        let order: [(usize, usize); 4] = std::array::from_fn(|k| {
            let near = |bit: usize, d: f64| usize::from((k >> bit & 1 == 0) == (d >= 0.0));
            (near(0, ray.direction.x), near(1, ray.direction.z))
        });
        let mut stack = [(0u8, 0u32, 0u32); 4 * LEVELS];
        let mut height = 1;
        stack[0].0 = self.levels.len() as u8 - 1;
        while height > 0 {
            height -= 1;
            let (level, column, row) = stack[height];
            let (column, row) = (column as usize, row as usize);
            if self.span(ray, level as usize, column, row, limit).is_none() {
                continue;
            }
            if level > 0 {
                let below = &self.levels[level as usize - 1];
                for (right, back) in order {
                    let (c, r) = (2 * column + right, 2 * row + back);
                    if c < below.columns && r < below.ranges.len() / below.columns {
                        stack[height] = (level - 1, c as u32, r as u32);
                        height += 1;
                    }
                }
                continue;
            }
            let cell = (row * (self.columns - 1) + column) as u32;
            for (side, facet) in self.facets(column, row).iter().enumerate() {
                if let Some(crossing) = facet.crossing(ray, 2 * cell + side as u32) {
                    let dry = ray.origin.y + crossing.t * ray.direction.y >= self.water_level;
                    if dry && crossing.t > from && crossing.t <= limit {
                        limit = offer(crossing, limit);
                    }
                }
            }
        }
        limit
    }

    fn inside(&self, p: Vec3) -> bool {
        if p.y < self.water_level || !(0.0..=1.0).contains(&p.x) || !(0.0..=1.0).contains(&p.z) {
            return false;
        }
        let (column, row, x, z) = self.cell_at(p);
        let height = |right: usize, back: usize| self.heights[(row + back) * self.columns + column + right];
        let (a, b, c, d) = (height(0, 0), height(1, 0), height(0, 1), height(1, 1));
        let ground = if x + z < 1.0 {
            a + x * (b - a) + z * (c - a)
        } else {
            d + (1.0 - x) * (c - d) + (1.0 - z) * (b - d)
        };
        p.y < ground
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        if !self.smooth {
            return self.geometric_normal(p, crossing);
        }
        let (column, row, x, z) = self.cell_at(p);
        let mut sum = Vec3::ZERO;
        for (right, back, share) in
            [(0, 0, (1.0 - x) * (1.0 - z)), (1, 0, x * (1.0 - z)), (0, 1, (1.0 - x) * z), (1, 1, x * z)]
        {
            sum += self.corner_normal(column + right, row + back) * share;
        }
        sum
    }

    fn geometric_normal(&self, _: Vec3, crossing: &Crossing) -> Vec3 {
        let cell = crossing.part as usize / 2;
        let width = self.columns - 1;
        self.facets(cell % width, cell / width)[crossing.part as usize % 2].normal()
    }
}
