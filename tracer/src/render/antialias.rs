//! `+A threshold +AM method +R depth +J jitter +AG gamma`: more rays where neighbours differ.
//!
//! Both methods look at the pixels of one tile only (and at the row above and the column left of it, or at the corners
//! on its rim), as POV-Ray does.

use super::tile::Tile;
use super::view::View;
use super::Random;
use crate::color::Rgb;
use crate::graph::settings::Antialiasing;
use crate::shade::Radiance;

/// A colour with what it is compared by.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    light: Radiance,
    encoded: [f64; 4],
}

impl Seen {
    fn new(light: Radiance, settings: &Antialiasing) -> Seen {
        let encode = |c: f64| c.max(0.0).powf(1.0 / settings.gamma);
        let Rgb { r, g, b } = light.rgb;
        Seen { light, encoded: [encode(r), encode(g), encode(b), light.transmit] }
    }

    fn differs(&self, other: &Seen, settings: &Antialiasing) -> bool {
        let pairs = self.encoded.iter().zip(&other.encoded);
        pairs.map(|(a, b)| (a - b).abs()).sum::<f64>() >= settings.threshold
    }
}

/// A point of the picture, displaced at random by at most half of `reach` in x and y.
fn jittered(x: f64, y: f64, reach: f64) -> (f64, f64) {
    if reach <= 0.0 {
        return (x, y);
    }
    let mut random = Random::seeded(x.to_bits(), y.to_bits(), 1);
    (x + (random.unit() - 0.5) * reach, y + (random.unit() - 0.5) * reach)
}

/// Method 1: pixels that differ from the one above or to the left get a grid of `depth` times `depth` further rays.
pub fn fixed_grid(view: &mut View, tile: &Tile, settings: &Antialiasing) -> Vec<Radiance> {
    let (left, top) = (tile.columns.start as f64 + 0.5, tile.rows.start as f64 + 0.5);
    let (width, height) = (tile.columns.len(), tile.rows.len());
    let center = |column: usize, row: usize| (left + column as f64, top + row as f64);
    let mut first = |(x, y): (f64, f64)| Seen::new(view.sample(x, y), settings);
    // What lies outside the tile is looked at, but keeps its one ray.
    let above: Vec<Seen> = (0..width).map(|column| first((left + column as f64, top - 1.0))).collect();
    let mut pixels = vec![Seen::default(); width * height];
    let mut refined = vec![false; width * height];
    for row in 0..height {
        let outside = Seen::new(view.sample(left - 1.0, top + row as f64), settings);
        for (column, rim) in above.iter().enumerate() {
            let here = row * width + column;
            let (x, y) = center(column, row);
            pixels[here] = Seen::new(view.sample(x, y), settings);
            let beside = (column > 0).then(|| here - 1);
            let over = (row > 0).then(|| here - width);
            let differs = |at: Option<usize>, outside: &Seen| {
                at.map_or(outside, |at| &pixels[at]).differs(&pixels[here], settings)
            };
            let (from_left, from_top) = (differs(beside, &outside), differs(over, rim));
            let wanted = [
                (beside.filter(|_| from_left), (x - 1.0, y)),
                (over.filter(|_| from_top), (x, y - 1.0)),
                (Some(here).filter(|_| from_left || from_top), (x, y)),
            ];
            for (at, (x, y)) in wanted {
                if let Some(at) = at.filter(|&at| !std::mem::replace(&mut refined[at], true)) {
                    pixels[at] = Seen::new(grid_mean(view, x, y, pixels[at].light, settings), settings);
                }
            }
        }
    }
    pixels.iter().map(|seen| seen.light).collect()
}

/// The mean of a pixel's first ray and its grid.
fn grid_mean(view: &mut View, x: f64, y: f64, first: Radiance, settings: &Antialiasing) -> Radiance {
    let depth = settings.depth;
    let step = 1.0 / f64::from(depth);
    let offset = |i: u32| (f64::from(i) + 0.5) * step - 0.5;
    let mut sum = first;
    for row in 0..depth {
        for column in 0..depth {
            let (x, y) = jittered(x + offset(column), y + offset(row), settings.jitter * step);
            sum.add_scaled(&view.sample(x, y), 1.0);
        }
    }
    let mut mean = Radiance::BLACK;
    mean.add_scaled(&sum, 1.0 / f64::from(depth * depth + 1));
    mean
}

/// Method 2: rays through the pixels' corners; squares whose corners differ are quartered, up to `depth` - 1 times.
pub fn recursive(view: &mut View, tile: &Tile, settings: &Antialiasing) -> Vec<Radiance> {
    let (width, height) = (tile.columns.len(), tile.rows.len());
    let mut corners = Vec::with_capacity((width + 1) * (height + 1));
    for y in tile.rows.start..=tile.rows.end {
        for x in tile.columns.start..=tile.columns.end {
            corners.push(Seen::new(view.sample(x as f64, y as f64), settings));
        }
    }
    let cells = 1usize << (settings.depth - 1);
    let side = cells + 1;
    let mut pixel = Pixel { settings, side, corner: (0.0, 0.0), known: vec![None; side * side] };
    let mut colors = Vec::with_capacity(width * height);
    for row in 0..height {
        for column in 0..width {
            let at = row * (width + 1) + column;
            pixel.corner = ((tile.columns.start + column) as f64, (tile.rows.start + row) as f64);
            pixel.known.fill(None);
            for (x, y, corner) in
                [(0, 0, at), (cells, 0, at + 1), (0, cells, at + width + 1), (cells, cells, at + width + 2)]
            {
                pixel.known[y * side + x] = Some(corners[corner]);
            }
            colors.push(pixel.square(view, 0, 0, cells, settings.depth - 1));
        }
    }
    colors
}

/// The rays of one pixel on their grid.
struct Pixel<'a> {
    settings: &'a Antialiasing,
    side: usize,
    corner: (f64, f64),
    known: Vec<Option<Seen>>,
}

impl Pixel<'_> {
    /// The colour of a square of the grid.
    fn square(&mut self, view: &mut View, x: usize, y: usize, size: usize, level: u32) -> Radiance {
        let places = [(x, y), (x + size, y), (x, y + size), (x + size, y + size)];
        let corners = places.map(|(x, y)| self.at(view, x, y));
        let differ = |i: usize| corners[..i].iter().any(|c| c.differs(&corners[i], self.settings));
        let parts = if level > 0 && (1..4).any(differ) {
            let half = size / 2;
            [(0, 0), (half, 0), (0, half), (half, half)]
                .map(|(dx, dy)| self.square(view, x + dx, y + dy, half, level - 1))
        } else {
            corners.map(|corner| corner.light)
        };
        let mut mean = Radiance::BLACK;
        parts.iter().for_each(|part| mean.add_scaled(part, 0.25));
        mean
    }

    /// The ray through a point of the grid, shot when first asked for.
    fn at(&mut self, view: &mut View, x: usize, y: usize) -> Seen {
        let index = y * self.side + x;
        if let Some(seen) = self.known[index] {
            return seen;
        }
        let place = |corner: f64, i: usize| corner + i as f64 / (self.side - 1) as f64;
        let (left, top) = (place(self.corner.0, x), place(self.corner.1, y));
        let (x, y) = jittered(left, top, self.settings.jitter / f64::from((1 << self.settings.depth) + 1));
        let seen = Seen::new(view.sample(x, y), self.settings);
        self.known[index] = Some(seen);
        seen
    }
}
