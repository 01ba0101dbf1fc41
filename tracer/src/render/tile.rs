//! A rectangle of pixels, the unit of work.

use std::ops::Range;

use crate::color::Rgb;
use crate::prepare::Scene;
use crate::shade::{Radiance, Tracer};

/// Pixels per side; POV-Ray's anti-aliasing looks across pixels of one such block only, so this is part of the picture.
pub const SIDE: usize = 32;

/// A rectangle of pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct Tile {
    /// Columns, 0 at the left.
    pub columns: Range<usize>,
    /// Rows, 0 at the top.
    pub rows: Range<usize>,
}

/// The tiles of a part of the picture, row by row.
pub fn tiles(columns: Range<usize>, rows: Range<usize>) -> Vec<Tile> {
    let cut = |range: Range<usize>| -> Vec<Range<usize>> {
        range.clone().step_by(SIDE).map(|start| start..(start + SIDE).min(range.end)).collect()
    };
    let (columns, rows) = (cut(columns), cut(rows));
    rows.iter().flat_map(|r| columns.iter().map(|c| Tile { columns: c.clone(), rows: r.clone() })).collect()
}

/// The size of the whole picture, in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Pixels per row.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
}

impl Tile {
    /// Colours of the tile's pixels, row by row, one ray each.
    pub fn render(&self, tracer: &mut Tracer, size: Size) -> Vec<[f32; 4]> {
        let mut colors = Vec::with_capacity(self.columns.len() * self.rows.len());
        for y in self.rows.clone() {
            for x in self.columns.clone() {
                let seen = sample(tracer, size, x as f64 + 0.5, y as f64 + 0.5);
                colors.push(pixel(&seen));
            }
        }
        colors
    }
}

/// Light through one point of the picture, in pixels from the left and from the top.
pub fn sample(tracer: &mut Tracer, size: Size, x: f64, y: f64) -> Radiance {
    let scene: &Scene = tracer.scene;
    match scene.camera.path(x / size.width as f64, y / size.height as f64) {
        Some(path) => tracer.trace(&path, 1.0),
        None => Radiance { rgb: Rgb::BLACK, transmit: 1.0 },
    }
}

/// Light as it is stored.
pub fn pixel(seen: &Radiance) -> [f32; 4] {
    let Rgb { r, g, b } = seen.rgb;
    [r as f32, g as f32, b as f32, (1.0 - seen.transmit) as f32]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_once() {
        let mut seen = vec![0; 70 * 40];
        for tile in tiles(3..70, 0..40) {
            for y in tile.rows.clone() {
                for x in tile.columns.clone() {
                    seen[y * 70 + x] += 1;
                }
            }
        }
        assert!(seen.iter().enumerate().all(|(i, &n)| n == usize::from(i % 70 >= 3)));
    }
}
