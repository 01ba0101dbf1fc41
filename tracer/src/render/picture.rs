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
        Picture::begun(width, height, vec![[f32::NAN; 4]; width * height])
    }

    /// A picture some of whose pixels are finished, the others not being numbers.
    pub fn begun(width: usize, height: usize, pixels: Vec<[f32; 4]>) -> Picture {
        Picture { width, height, pixels: Mutex::new(pixels) }
    }

    /// Puts a finished tile in its place.
    pub fn put(&self, tile: &Tile, colors: &[[f32; 4]]) {
        let mut pixels = self.pixels.lock().expect("no thread panics with the picture in hand");
        for (row, colors) in tile.rows.clone().zip(colors.chunks(tile.columns.len())) {
            let start = row * self.width + tile.columns.start;
            for (pixel, color) in pixels[start..].iter_mut().zip(colors) {
                *pixel = color.map(|part| if part.is_nan() { 0.0 } else { part });
            }
        }
    }

    /// The pixels so far, black and clear where there are none.
    pub fn snapshot(&self) -> Vec<[f32; 4]> {
        let known = |pixel: [f32; 4]| if pixel[0].is_nan() { [0.0; 4] } else { pixel };
        self.unfinished().into_iter().map(known).collect()
    }

    /// The pixels so far, not numbers where there are none.
    pub fn unfinished(&self) -> Vec<[f32; 4]> {
        self.pixels.lock().expect("no thread panics with the picture in hand").clone()
    }
}
