//! SDL: `texture { ... }`: which textures are seen at a hit, and how their light is mixed.

use super::layers::Spot;
use super::{Finish, Path, Radiance, Tracer};
use crate::color::{Rgb, Rgbft};
use crate::geometry::Hit;
use crate::math::{Transform, Vec3};

/// Exponent of the cosine per unit of `caustics` (probed).
const CAUSTIC_SHARPNESS: f64 = 45.0;

/// Index of a texture in the scene.
pub type TextureId = u32;

/// One pigment, normal and finish.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Its colour.
    pub pigment: Rgbft,
    /// Its answer to light.
    pub finish: Finish,
}

/// A texture ready for shading.
#[derive(Clone, Debug)]
pub enum Texture {
    /// Layers, the topmost first.
    Layers(Box<[Layer]>),
    /// A texture that stands in a space of its own.
    Placed(Box<Transform>, TextureId),
}

/// A point in the space of a texture, and how it got there.
#[derive(Clone, Copy)]
pub struct Frame<'a> {
    /// The point as patterns see it.
    pub point: Vec3,
    /// The step that led here, after those of the frame around.
    step: Option<(&'a Frame<'a>, &'a Transform)>,
}

impl<'a> Frame<'a> {
    /// The world's.
    pub fn world(point: Vec3) -> Frame<'a> {
        Frame { point, step: None }
    }

    fn placed(&'a self, space: &'a Transform) -> Frame<'a> {
        Frame { point: space.inverse_point(self.point), step: Some((self, space)) }
    }
}

impl Tracer<'_> {
    /// Light leaving a surface towards the start of the ray.
    pub(super) fn surface_light(&mut self, path: &Path, hit: &Hit, weight: f64) -> Radiance {
        let scene = self.scene;
        let spot = Spot::new(scene, path, hit);
        let looks = scene.geometry.looks(hit.node);
        let frame = Frame::world(spot.point);
        if !looks.several_textures {
            let worn = looks.interior_texture.filter(|_| spot.from_inside).or(looks.texture);
            return self.texture_light(&spot, &frame, scene.dress(worn), weight);
        }
        let mut weights = std::mem::take(&mut self.weights);
        scene.geometry.texture_weights(hit, spot.point, &mut weights);
        let mut seen = Radiance::BLACK;
        for &(worn, share) in &weights {
            if share >= scene.adc_bailout {
                seen.add_scaled(&self.texture_light(&spot, &frame, scene.dress(worn), weight), share);
            }
        }
        self.weights = weights;
        seen
    }

    /// Light of one texture.
    fn texture_light(&mut self, spot: &Spot, frame: &Frame, texture: TextureId, weight: f64) -> Radiance {
        let scene = self.scene;
        match &scene.textures[texture as usize] {
            Texture::Layers(layers) => self.layers_light(spot, frame, layers, weight),
            Texture::Placed(space, inner) => self.texture_light(spot, &frame.placed(space), *inner, weight),
        }
    }
}

impl Tracer<'_> {
    /// The share of light that passes a surface, for shadows.
    pub(super) fn surface_filter(&mut self, path: &Path, hit: &Hit) -> Rgb {
        let scene = self.scene;
        let spot = Spot::new(scene, path, hit);
        let looks = scene.geometry.looks(hit.node);
        let frame = Frame::world(spot.point);
        let worn = looks.interior_texture.filter(|_| spot.from_inside).or(looks.texture);
        let filter = self.texture_filter(&spot, &frame, scene.dress(worn));
        filter.mul_each(scene.shadow_attenuation(&spot)) * self.caustic(&spot)
    }

    /// `caustics F`: light gathers where it goes straight through a surface.
    fn caustic(&self, spot: &Spot) -> f64 {
        match self.scene.interior(spot.body) {
            Some(interior) if interior.caustics != 0.0 => {
                let cos = spot.normal.dot(spot.path.ray.direction).abs();
                1.0 + cos.powf(CAUSTIC_SHARPNESS * interior.caustics)
            }
            _ => 1.0,
        }
    }

    fn texture_filter(&mut self, spot: &Spot, frame: &Frame, texture: TextureId) -> Rgb {
        let scene = self.scene;
        match &scene.textures[texture as usize] {
            Texture::Layers(layers) => self.layers_filter(spot, frame, layers),
            Texture::Placed(space, inner) => self.texture_filter(spot, &frame.placed(space), *inner),
        }
    }
}
