//! SDL: `normal { bump_map { png "a.png" use_index bump_size F } }`: normals from the brightness of a picture.

use super::ImageMapping;
use crate::graph::image::ImageUse;
use crate::math::{vec3, Vec3};

/// Normals steeper than this have no level direction of their own.
const LEVEL: f64 = 1e-18;

impl ImageMapping {
    /// The normal `n` at `p`, perturbed; of any length. Heights come from the pixel at `p` and from the two diagonally
    /// below it.
    pub fn bump(&self, p: Vec3, n: Vec3, used: ImageUse, amount: f64) -> Vec3 {
        let Some([column, row]) = self.locate(p) else { return n };
        let height = |across: f64, up: f64| {
            let place = [self.on_picture(0, column + across), self.on_picture(1, row + up)];
            let indexed = used == ImageUse::Index && self.has_palette();
            amount * if indexed { self.index(place) } else { self.texel(place).rgb.gray() }
        };
        let (here, left, right) = (height(0.0, 0.0), height(-1.0, -1.0), height(1.0, -1.0));
        let turn = vec3(0.5 * (right - left), here - 0.5 * (left + right), 1.0).normalized();
        // A level direction across the surface, and the one up the slope.
        let level = vec3(-n.z, 0.0, n.x);
        let across = if level.length_squared() < LEVEL { Vec3::X } else { level.normalized() };
        let up = across.cross(n).normalized();
        n * turn.z - across * turn.x - up * turn.y
    }

    /// A column (axis 0) or row next to the picture, brought back into it from the other side.
    fn on_picture(&self, axis: usize, place: f64) -> f64 {
        let size = [self.image.width, self.image.height][axis] as f64;
        place.rem_euclid(size)
    }
}
