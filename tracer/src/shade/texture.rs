//! SDL: `texture { ... }`, `texture_map`, texture lists: which textures are seen at a point, and how they are mixed.

use super::frame::Frame;
use super::layers::Spot;
use super::{Finish, Path, Radiance, Tracer};
use crate::color::Rgb;
use crate::geometry::Hit;
use crate::math::Transform;
use crate::pattern::{Modifiers, Pattern};
use crate::texture::{BlendMap, Normal, Pigment};

/// Index of a texture in the scene.
pub type TextureId = u32;

/// One pigment, normal and finish.
#[derive(Clone, Debug)]
pub struct Layer {
    /// Its colour.
    pub pigment: Pigment,
    /// Its bumps.
    pub normal: Option<Normal>,
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
    /// A pattern mixes two neighbours of a map.
    Map(Box<(Pattern, BlendMap<TextureId>)>),
    /// A pattern picks one.
    Blocks(Box<(Pattern, Vec<TextureId>)>),
    /// All of them, by weight.
    Average(Box<(Modifiers, Vec<(f64, TextureId)>)>),
}

/// The textures that a texture shows at a point: at most two, but for averages.
enum Shown<'a> {
    One(TextureId),
    Two([(TextureId, f64); 2]),
    All(&'a [(f64, TextureId)]),
}

impl Texture {
    /// What is shown in place of a texture that is not made of layers, and where it is asked.
    fn shown<'a>(&'a self, spot: &Spot, frame: &'a Frame<'a>) -> (Shown<'a>, Frame<'a>) {
        match self {
            Texture::Layers(_) => unreachable!("layers show themselves"),
            Texture::Placed(space, inner) => (Shown::One(*inner), frame.placed(space)),
            Texture::Map(map) => {
                let (pattern, map) = &**map;
                let (value, point) = pattern.value_and_place(frame.point, &spot.context);
                let (&low, &high, share) = map.around(value);
                let shown = if share == 0.0 {
                    Shown::One(low)
                } else {
                    Shown::Two([(high, share), (low, 1.0 - share)])
                };
                (shown, frame.warped(&pattern.modifiers, point))
            }
            Texture::Blocks(blocks) => {
                let (pattern, textures) = &**blocks;
                let (number, point) = pattern.block_and_place(frame.point, &spot.context);
                // The number just beyond the list means its last (probed); higher ones begin again.
                let index = if number == textures.len() { number - 1 } else { number % textures.len() };
                (Shown::One(textures[index]), frame.warped(&pattern.modifiers, point))
            }
            Texture::Average(average) => {
                let (modifiers, textures) = &**average;
                let point = modifiers.locate(frame.point, &spot.context, false);
                (Shown::All(textures), frame.warped(modifiers, point))
            }
        }
    }

    /// The textures that it shows, with their shares, and where they are asked.
    pub(super) fn shares<'a>(
        &'a self,
        spot: &Spot,
        frame: &'a Frame<'a>,
    ) -> (Vec<(TextureId, f64)>, Frame<'a>) {
        let (shown, frame) = self.shown(spot, frame);
        let shares = match shown {
            Shown::One(inner) => vec![(inner, 1.0)],
            Shown::Two(two) => two.to_vec(),
            Shown::All(all) => {
                let total: f64 = all.iter().map(|e| e.0).sum();
                all.iter().map(|&(share, inner)| (inner, share / total)).collect()
            }
        };
        (shares, frame)
    }
}

impl Tracer<'_> {
    /// Light leaving a surface towards the start of the ray.
    pub(super) fn surface_light(&mut self, path: &Path, hit: &Hit, weight: f64) -> Radiance {
        let scene = self.scene;
        let spot = Spot::new(scene, path, hit);
        let frame = spot.frame();
        if !spot.looks.several_textures {
            return self.texture_light(&spot, &frame, scene.dress(spot.worn()), weight);
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
        let texture = &self.scene.textures[texture as usize];
        if let Texture::Layers(layers) = texture {
            return self.layers_light(spot, frame, layers, weight);
        }
        let (shown, frame) = texture.shown(spot, frame);
        let mut seen = Radiance::BLACK;
        match shown {
            Shown::One(inner) => return self.texture_light(spot, &frame, inner, weight),
            Shown::Two(two) => {
                for (inner, share) in two {
                    seen.add_scaled(&self.texture_light(spot, &frame, inner, weight * share), share);
                }
            }
            Shown::All(all) => {
                let total: f64 = all.iter().map(|e| e.0).sum();
                for &(share, inner) in all {
                    let share = share / total;
                    seen.add_scaled(&self.texture_light(spot, &frame, inner, weight * share), share);
                }
            }
        }
        seen
    }

    /// The share of light that passes a surface, for shadows.
    pub(super) fn surface_filter(&mut self, path: &Path, hit: &Hit) -> Rgb {
        let scene = self.scene;
        if let Some(filter) = scene.plain_filter(hit.node, scene.body_of(hit.node)) {
            return filter;
        }
        let spot = Spot::new(scene, path, hit);
        let frame = spot.frame();
        let filter = if spot.looks.several_textures {
            let mut weights = std::mem::take(&mut self.weights);
            scene.geometry.texture_weights(hit, spot.point, &mut weights);
            let mut filter = Rgb::BLACK;
            for &(worn, share) in &weights {
                filter += self.texture_filter(&spot, &frame, scene.dress(worn)) * share;
            }
            self.weights = weights;
            filter
        } else {
            self.texture_filter(&spot, &frame, scene.dress(spot.worn()))
        };
        filter.mul_each(scene.shadow_attenuation(&spot))
    }

    fn texture_filter(&mut self, spot: &Spot, frame: &Frame, texture: TextureId) -> Rgb {
        let texture = &self.scene.textures[texture as usize];
        if let Texture::Layers(layers) = texture {
            return self.layers_filter(spot, frame, layers);
        }
        let (shown, frame) = texture.shown(spot, frame);
        let mut filter = Rgb::BLACK;
        match shown {
            Shown::One(inner) => return self.texture_filter(spot, &frame, inner),
            Shown::Two(two) => {
                for (inner, share) in two {
                    filter += self.texture_filter(spot, &frame, inner) * share;
                }
            }
            Shown::All(all) => {
                let total: f64 = all.iter().map(|e| e.0).sum();
                for &(share, inner) in all {
                    filter += self.texture_filter(spot, &frame, inner) * (share / total);
                }
            }
        }
        filter
    }
}
