//! SDL: `area_light V, V, I, I adaptive I jitter`: shadows of a grid of points.
//!
//! Cells of the grid are split in four as long as their corners differ, or up to the depth of `adaptive` in any case;
//! a cell's light is the mean of its corners or of its parts. So points on seams between parts count more than others,
//! as they do in POV-Ray.

use super::shadow::Place;
use super::{Path, Tracer};
use crate::accel::RayKind;
use crate::color::Rgb;
use crate::light::{Area, Arrival, Light};
use crate::math::{Ray, Vec3};

/// Corners whose channels differ by more than this in sum make a cell be split.
const DIFFERENCE: f64 = 0.1;

/// What stays the same for all points of one light seen from one point.
struct Grid<'a> {
    number: u32,
    light: &'a Light,
    area: &'a Area,
    axes: [Vec3; 2],
    place: &'a Place<'a>,
    arrival: &'a Arrival,
    /// Shadows of grid points already computed.
    known: Vec<Option<Rgb>>,
    /// How far it is from the last surface to the grid point computed last, if the last cell had one to compute.
    last: Option<f64>,
}

impl Tracer<'_> {
    /// Light of a whole area.
    pub(super) fn area_shadow(
        &mut self,
        number: u32,
        light: &Light,
        area: &Area,
        place: &Place,
        arrival: &Arrival,
    ) -> Rgb {
        let [width, height] = area.size;
        let mut known = std::mem::take(&mut self.grid);
        known.clear();
        known.resize(width * height, None);
        let axes = area.axes_towards(arrival.direction);
        let mut grid = Grid { number, light, area, axes, place, arrival, known, last: None };
        let color = self.cell_shadow(&mut grid, [0, 0], [width - 1, height - 1], 0);
        let last = grid.last;
        self.grid = grid.known;
        if color == Rgb::BLACK || !self.scene.air_dims(light) {
            return color;
        }
        // The air dims the mean of all points once, over the last part of the way to one of them, which POV-Ray takes
        // from the point lit; or over twice the way to the middle of the light (probed).
        let ray = Ray { origin: place.point, direction: arrival.direction };
        let path = Path { ray, interiors: *place.interiors, kind: RayKind::Shadow, band: None };
        color.mul_each(self.air_filter(&path, last.unwrap_or(2.0 * arrival.distance), light))
    }

    /// All points of the grid, for `area_illumination`.
    pub(super) fn area_points(&mut self, light: &Light, area: &Area, towards: Vec3) -> Vec<Vec3> {
        let axes = area.axes_towards(towards);
        let [width, height] = area.size;
        let grid = (0..width).flat_map(|u| (0..height).map(move |v| (u, v)));
        grid.map(|at| light.location + area.displacement(&axes, at, self.shift(area))).collect()
    }

    /// How far a point is moved in its cell.
    fn shift(&mut self, area: &Area) -> [f64; 2] {
        if area.jitter {
            [self.random.unit() - 0.5, self.random.unit() - 0.5]
        } else {
            [0.0, 0.0]
        }
    }

    /// Light of the cell between two grid points.
    fn cell_shadow(&mut self, grid: &mut Grid, low: [usize; 2], high: [usize; 2], depth: u32) -> Rgb {
        grid.last = None;
        let mean = |parts: [Rgb; 4]| (parts[0] + parts[1] + parts[2] + parts[3]) * 0.25;
        let corners = [low, [high[0], low[1]], [low[0], high[1]], high].map(|at| self.grid_shadow(grid, at));
        let can_split = high[0] - low[0] > 1 || high[1] - low[1] > 1;
        let differ = |a: usize, b: usize| difference(corners[a], corners[b]) > DIFFERENCE;
        if !can_split
            || (depth >= grid.area.adaptive
                && ![(1, 0), (3, 1), (2, 0), (3, 2)].iter().any(|p| differ(p.0, p.1)))
        {
            return mean(corners);
        }
        let middle = [low[0] + high[0], low[1] + high[1]];
        let (before, after) = (middle.map(|m| m / 2), middle.map(|m| m.div_ceil(2)));
        let depth = depth + 1;
        mean([
            self.cell_shadow(grid, low, before, depth),
            self.cell_shadow(grid, [after[0], low[1]], [high[0], before[1]], depth),
            self.cell_shadow(grid, [low[0], after[1]], [before[0], high[1]], depth),
            self.cell_shadow(grid, after, high, depth),
        ])
    }

    /// Light of one grid point.
    fn grid_shadow(&mut self, grid: &mut Grid, at: [usize; 2]) -> Rgb {
        let index = at[0] * grid.area.size[1] + at[1];
        if let Some(color) = grid.known[index] {
            return color;
        }
        let shift = self.shift(grid.area);
        let offset = grid.area.displacement(&grid.axes, (at[0], at[1]), shift);
        let towards = grid.light.arrival_from(grid.light.location + offset, grid.place.point);
        // The colour is that of the light's centre; only the way differs.
        let arrival = Arrival { color: grid.arrival.color, ..towards };
        let (color, last) = self.past_objects(grid.number, grid.light, grid.place, &arrival);
        grid.last = Some(last.map_or(towards.distance, |last| last.distance));
        grid.known[index] = Some(color);
        color
    }
}

/// Sum of the channels' differences.
fn difference(a: Rgb, b: Rgb) -> f64 {
    (a.r - b.r).abs() + (a.g - b.g).abs() + (a.b - b.b).abs()
}
