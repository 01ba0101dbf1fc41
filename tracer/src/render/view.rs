//! The picture's plane: light through any point of it.

use super::Random;
use crate::camera::Size;
use crate::shade::{Radiance, Tracer};

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
        let size = self.size;
        let Some(lens) = &camera.lens else {
            let rays = (0..camera.rays_per_pixel()).filter_map(|number| camera.ray(x, y, size, number));
            return self.tracer.look_along(rays);
        };
        // Focal blur spreads its rays over the pixel, too.
        lens.gather(|number| {
            let random = &mut self.tracer.random;
            let (dx, dy) = (random.unit() - 0.5, random.unit() - 0.5);
            let deflected = camera.ray(x + dx, y + dy, size, 0).map(|ray| lens.deflect(&ray, number, random));
            self.tracer.look_along(deflected)
        })
    }
}
