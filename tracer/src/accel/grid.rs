//! `--accelerator grid`: cells of one size, walked through from face to face (3D-DDA; Fujimoto, Tanaka and Iwata 1986).

use super::boxes::entry;
use super::{Counters, Query};
use crate::math::{Bounds, Vec3};

/// Cells wanted per item.
const DENSITY: f64 = 3.0;
/// Most cells along one axis.
const MOST: f64 = 128.0;
/// Share of a cell by which boxes reach into neighbours: a ray through an edge may be taken to pass on either side.
const OVERLAP: f64 = 1e-5;

/// Cell numbers along the three axes.
type Place = [i32; 3];

/// A uniform grid.
#[derive(Debug)]
pub struct Grid {
    bounds: Bounds,
    counts: Place,
    size: Vec3,
    /// Where the items of each cell start in `items`, and where the last ones end.
    starts: Vec<u32>,
    items: Vec<u32>,
    /// The lowest and highest cell of each item.
    ranges: Vec<[Place; 2]>,
}

impl Grid {
    /// Builds the grid over finite boxes.
    pub fn build(boxes: &[Bounds]) -> Grid {
        let bounds = boxes.iter().fold(Bounds::EMPTY, |sum, b| sum.union(b));
        let extent = if boxes.is_empty() { Vec3::ZERO } else { bounds.max - bounds.min };
        // Flat scenes have one layer of cells.
        let thick: Vec<f64> =
            (0..3).map(|a| extent[a]).filter(|&e| e > extent.max_element() * 1e-3).collect();
        let product: f64 = thick.iter().product();
        let per_length = (DENSITY * boxes.len() as f64 / product).powf(1.0 / thick.len().max(1) as f64);
        let counts: Place =
            [0, 1, 2].map(|axis| (extent[axis] * per_length).round().clamp(1.0, MOST).max(1.0) as i32);
        let size = Vec3::from([0, 1, 2].map(|axis| (extent[axis] / f64::from(counts[axis])).max(1e-300)));
        let mut grid =
            Grid { bounds, counts, size, starts: Vec::new(), items: Vec::new(), ranges: Vec::new() };
        grid.ranges =
            boxes.iter().map(|b| [grid.place(b.min, -OVERLAP), grid.place(b.max, OVERLAP)]).collect();
        grid.fill();
        grid
    }

    /// Lists the items of each cell, in order of their numbers.
    fn fill(&mut self) {
        let mut sizes = vec![0u32; self.counts.iter().map(|&c| c as usize).product::<usize>() + 1];
        for range in &self.ranges {
            cells(range).for_each(|place| sizes[self.index(place) + 1] += 1);
        }
        for i in 1..sizes.len() {
            sizes[i] += sizes[i - 1];
        }
        self.items = vec![0; sizes.last().map_or(0, |&n| n as usize)];
        let mut next = sizes.clone();
        for (item, range) in self.ranges.iter().enumerate() {
            for place in cells(range) {
                let at = &mut next[self.index(place)];
                self.items[*at as usize] = item as u32;
                *at += 1;
            }
        }
        self.starts = sizes;
    }

    fn index(&self, [x, y, z]: Place) -> usize {
        ((z * self.counts[1] + y) * self.counts[0] + x) as usize
    }

    /// The cell of a point, moved by a share of a cell; the nearest where the point is outside.
    fn place(&self, point: Vec3, shift: f64) -> Place {
        [0, 1, 2].map(|axis| {
            let cell = ((point[axis] - self.bounds.min[axis]) / self.size[axis] + shift).floor();
            cell.clamp(0.0, f64::from(self.counts[axis] - 1)) as i32
        })
    }

    fn items_at(&self, place: Place) -> &[u32] {
        let index = self.index(place);
        &self.items[self.starts[index] as usize..self.starts[index + 1] as usize]
    }

    /// See [`super::Accelerator::along`].
    #[inline]
    pub fn along(
        &self,
        query: &Query,
        mut limit: f64,
        counters: &mut Counters,
        mut visit: impl FnMut(u32, f64, &mut Counters) -> f64,
    ) -> f64 {
        if self.items.is_empty() {
            return limit;
        }
        counters.boxes += 1;
        let Some(start) = entry(&self.bounds, query, limit) else { return limit };
        let ray = &query.ray;
        let mut place = self.place(ray.at(start), 0.0);
        let step = query.negative.map(|negative| if negative { -1 } else { 1 });
        // Parameters at which the ray leaves the cell along each axis.
        let mut leave = [0, 1, 2].map(|axis| {
            let face = place[axis] + i32::from(!query.negative[axis]);
            let face = self.bounds.min[axis] + f64::from(face) * self.size[axis];
            (face - ray.origin[axis]) * query.inverse[axis]
        });
        let stride = [0, 1, 2].map(|axis| self.size[axis] * query.inverse[axis].abs());
        let mut before: Option<Place> = None;
        loop {
            counters.cells += 1;
            for &item in self.items_at(place) {
                // The cells of an item lie together: one that was in the cell before has been visited.
                let range = &self.ranges[item as usize];
                if !before.is_some_and(|cell| holds(range, cell)) {
                    limit = visit(item, limit, counters);
                }
            }
            let axis = if leave[0] <= leave[1] && leave[0] <= leave[2] {
                0
            } else if leave[1] <= leave[2] {
                1
            } else {
                2
            };
            if leave[axis] > limit {
                return limit;
            }
            before = Some(place);
            place[axis] += step[axis];
            if place[axis] < 0 || place[axis] >= self.counts[axis] {
                return limit;
            }
            leave[axis] += stride[axis];
        }
    }

    /// See [`super::Accelerator::around`].
    pub fn around(&self, point: Vec3, mut visit: impl FnMut(u32) -> bool) -> bool {
        self.bounds.contains(point) && self.items_at(self.place(point, 0.0)).iter().any(|&item| visit(item))
    }
}

fn holds(range: &[Place; 2], place: Place) -> bool {
    (0..3).all(|axis| range[0][axis] <= place[axis] && place[axis] <= range[1][axis])
}

/// All cells of a range.
fn cells(range: &[Place; 2]) -> impl Iterator<Item = Place> {
    let [low, high] = *range;
    (low[2]..=high[2])
        .flat_map(move |z| (low[1]..=high[1]).flat_map(move |y| (low[0]..=high[0]).map(move |x| [x, y, z])))
}
