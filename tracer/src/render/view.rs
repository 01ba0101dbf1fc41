//! The picture's plane: light through any point of it.

use super::Random;
use crate::color::Rgb;
use crate::shade::{Radiance, Tracer};

/// The size of the whole picture, in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Pixels per row.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
}

/// A thread's tracer, looking through the camera.
pub struct View<'t, 's> {
    /// What follows the rays.
    pub tracer: &'t mut Tracer<'s>,
    /// The picture's size.
    pub size: Size,
}

impl View<'_, '_> {
    /// Light through one point, in pixels from the left and from the top. Random numbers depend on the point alone.
    pub fn sample(&mut self, x: f64, y: f64) -> Radiance {
        let scene = self.tracer.scene;
        self.tracer.random = Random::seeded(x.to_bits(), y.to_bits(), 0);
        match scene.camera.path(x / self.size.width as f64, y / self.size.height as f64) {
            Some(path) => self.tracer.trace(&path, 1.0),
            None => Radiance { rgb: Rgb::BLACK, transmit: 1.0 },
        }
    }
}
