//! A rectangle of pixels, the unit of work.

use std::ops::Range;

use super::antialias;
use super::view::View;
use crate::color::Rgb;
use crate::graph::settings::Antialiasing;
use crate::shade::Radiance;

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

impl Tile {
    /// Colours of the tile's pixels, row by row; one ray each without anti-aliasing.
    pub fn render(&self, view: &mut View, antialiasing: Option<&Antialiasing>) -> Vec<[f32; 4]> {
        let colors = match antialiasing {
            Some(settings) if settings.method == 1 => antialias::fixed_grid(view, self, settings),
            Some(settings) => antialias::recursive(view, self, settings),
            None => self.plain(view),
        };
        colors.iter().map(pixel).collect()
    }

    fn plain(&self, view: &mut View) -> Vec<Radiance> {
        let mut colors = Vec::with_capacity(self.columns.len() * self.rows.len());
        for y in self.rows.clone() {
            for x in self.columns.clone() {
                colors.push(view.sample(x as f64 + 0.5, y as f64 + 0.5));
            }
        }
        colors
    }
}

/// Light as it is stored.
fn pixel(seen: &Radiance) -> [f32; 4] {
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
