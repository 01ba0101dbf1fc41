//! A picture that several threads fill, and that can be looked at meanwhile.

use std::sync::Mutex;

use super::tile::Tile;

/// Linear red, green, blue (as seen against black) and alpha, row by row from the top.
#[derive(Debug)]
pub struct Picture {
    /// Pixels per row.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    pixels: Mutex<Vec<[f32; 4]>>,
}

impl Picture {
    /// A picture without anything in it.
    pub fn empty(width: usize, height: usize) -> Picture {
        Picture { width, height, pixels: Mutex::new(vec![[0.0; 4]; width * height]) }
    }

    /// Puts a finished tile in its place.
    pub fn put(&self, tile: &Tile, colors: &[[f32; 4]]) {
        let mut pixels = self.pixels.lock().expect("no thread panics with the picture in hand");
        for (row, colors) in tile.rows.clone().zip(colors.chunks(tile.columns.len())) {
            let start = row * self.width + tile.columns.start;
            pixels[start..start + colors.len()].copy_from_slice(colors);
        }
    }

    /// The pixels so far.
    pub fn snapshot(&self) -> Vec<[f32; 4]> {
        self.pixels.lock().expect("no thread panics with the picture in hand").clone()
    }
}
