//! The picture's plane: light through any point of it.

use super::Random;
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
        self.tracer.random = Random::seeded(x.to_bits(), y.to_bits(), 0);
        let camera = &self.tracer.scene.camera;
        let ray = |x: f64, y: f64| camera.ray(x / self.size.width as f64, y / self.size.height as f64);
        let Some(lens) = &camera.lens else { return self.tracer.look(ray(x, y)) };
        // Focal blur spreads its rays over the pixel, too.
        lens.gather(|number| {
            let random = &mut self.tracer.random;
            let (dx, dy) = (random.unit() - 0.5, random.unit() - 0.5);
            let deflected = ray(x + dx, y + dy).map(|ray| lens.deflect(&ray, number, random));
            self.tracer.look(deflected)
        })
    }
}
