//! A plain or layered texture at one point: its own light, lamps, mirror, and what shines through.

use super::frame::Frame;
use super::interiors::BodyId;
use super::photon_light::collects;
use super::reflect::Mirrored;
use super::shadow::Place;
use super::texture::Layer;
use super::{Path, Radiance, Tracer};
use crate::color::{Rgb, Rgbft};
use crate::geometry::{Hit, Looks, NodeId};
use crate::math::Vec3;
use crate::pattern::SurfaceContext;
use crate::prepare::Scene;
use crate::texture::Pigment;

/// What is fixed at a hit, whatever the texture.
#[derive(Clone, Copy)]
pub struct Spot<'a> {
    /// The ray that came here.
    pub path: &'a Path,
    /// How far it went.
    pub distance: f64,
    /// Where it hit.
    pub point: Vec3,
    /// Unit normal on the ray's side.
    pub normal: Vec3,
    /// The point and normals as patterns see them.
    pub context: SurfaceContext,
    /// The object at the top that was hit.
    pub object: NodeId,
    /// What the object wears.
    pub looks: &'a Looks,
    /// Whether the ray hits the surface from behind.
    pub from_inside: bool,
    /// What fills the object.
    pub body: BodyId,
}

impl<'a> Spot<'a> {
    /// Looks at a hit.
    pub fn new(scene: &'a Scene, path: &'a Path, hit: &Hit) -> Spot<'a> {
        let surface = scene.geometry.surface(&path.ray, hit);
        let from_inside = surface.normal.dot(path.ray.direction) > 0.0;
        let normal = if from_inside { -surface.normal } else { surface.normal };
        Spot {
            path,
            distance: hit.crossing.t,
            point: surface.point,
            normal,
            context: SurfaceContext {
                ray_direction: path.ray.direction,
                geometric_normal: normal,
                normal,
                point: surface.point,
                uv: if scene.uses_uv { scene.geometry.uv(hit, surface.point) } else { [0.0; 2] },
            },
            object: hit.object,
            looks: scene.geometry.looks(hit.node),
            from_inside,
            body: scene.body_of(hit.node),
        }
    }

    /// Where the outermost texture is asked.
    pub fn frame(&self) -> Frame<'static> {
        Frame::outermost(if self.looks.uv_mapping { self.context.uv_point() } else { self.point })
    }

    /// Where lamps are asked for light.
    pub(super) fn place(&self) -> Place<'_> {
        Place { point: self.point, interiors: &self.path.interiors, collects_photons: collects(self) }
    }

    /// The texture of this side.
    pub fn worn(&self) -> Option<u32> {
        self.looks.interior_texture.filter(|_| self.from_inside).or(self.looks.texture)
    }
}

impl Tracer<'_> {
    /// Light of layers seen one through the other.
    pub(super) fn layers_light(
        &mut self,
        spot: &Spot,
        frame: &Frame,
        layers: &[Layer],
        weight: f64,
    ) -> Radiance {
        let scene = self.scene;
        if scene.quality.unlit {
            return self.unlit(spot, frame, layers);
        }
        let mut seen = Radiance::BLACK;
        // What of the light from below gets through the layers so far.
        let mut filter = Rgb::WHITE;
        let mut through = 1.0;
        let mut top_normal = spot.normal;
        let first_mirror = self.mirrors.len();
        let Some(top) = layers.first().map(|layer| &layer.finish) else {
            return seen;
        };
        for (number, layer) in layers.iter().enumerate() {
            if through < scene.adc_bailout {
                break;
            }
            let finish = &layer.finish;
            let normal = layer.perturbed(spot, frame);
            if number == 0 {
                top_normal = normal;
            }
            let color = layer.color(spot, frame, normal);
            let opacity = scene.layering.opacity(&color);
            let mut own = color.rgb.mul_each(finish.ambient + finish.emission) * opacity;
            if finish.lit {
                own += self.lamp_light(spot, finish, normal, color.rgb, opacity);
            }
            if let (Some(stuff), Some(settings)) = (&finish.subsurface, scene.subsurface) {
                // Transparency does not lessen it (probed).
                own += self.subsurface_light(spot, stuff, settings, normal, color.rgb, weight * through);
            }
            if self.photons.is_some() && finish.lit {
                own += self.photon_light(spot, finish, normal, color.rgb, opacity);
            }
            if finish.diffuse[0] != 0.0 && self.indirect.is_some() {
                let share = finish.diffuse[0] * opacity;
                let light = self.indirect_light(spot, normal, weight * through * share * color.rgb.gray());
                own += light.mul_each(color.rgb) * share;
            }
            seen.rgb += own.mul_each(filter);
            let mut passes = color.passing();
            if let Some(mirror) = &finish.reflection {
                let share = self.reflectivity(spot, mirror, normal, color.rgb);
                let weight = weight * through * mirror.strength(share);
                self.mirrors.push(Mirrored {
                    normal,
                    share,
                    weight,
                    exponent: mirror.exponent,
                    layer: number,
                });
                if finish.conserve_energy {
                    passes = passes.mul_each(share.map(|s| (1.0 - s).max(0.0)));
                }
            }
            filter = filter.mul_each(passes);
            through = filter.map(f64::abs).max_element().min(1.0);
        }
        let totally = through > scene.adc_bailout
            && self.seen_through(spot, top_normal, filter, weight * through, top, &mut seen);
        for i in first_mirror..self.mirrors.len() {
            let mirrored = self.mirrors[i];
            // Total reflection takes the place of mirrors that lie the same way.
            if !(totally && mirrored.normal == top_normal) {
                seen.rgb += self.mirrored(spot, &mirrored, &layers[mirrored.layer].finish);
            }
        }
        self.mirrors.truncate(first_mirror);
        seen
    }

    /// At the lowest qualities: the plain colour of the lowest layer that is seen through those above.
    fn unlit(&self, spot: &Spot, frame: &Frame, layers: &[Layer]) -> Radiance {
        let mut filter = Rgb::WHITE;
        let mut rgb = Rgb::BLACK;
        for layer in layers {
            let color = layer.color(spot, frame, spot.normal);
            rgb = color.rgb;
            filter = filter.mul_each(color.passing());
            if filter.max_element() < self.scene.adc_bailout {
                break;
            }
        }
        Radiance { rgb, transmit: 0.0 }
    }

    /// The share of light that passes layers.
    pub(super) fn layers_filter(&mut self, spot: &Spot, frame: &Frame, layers: &[Layer]) -> Rgb {
        let caustics = self.scene.interior(spot.body).map_or(0.0, |interior| interior.caustics);
        layers.iter().fold(Rgb::WHITE, |filter, layer| {
            let passes = filter.mul_each(layer.color(spot, frame, spot.normal).passing());
            if caustics == 0.0 {
                return passes;
            }
            // `caustics F`: light gathers where it goes straight through a surface; every layer adds to it (probed).
            let cos = layer.perturbed(spot, frame).dot(spot.path.ray.direction).abs();
            passes * (1.0 + cos.powf(caustics))
        })
    }
}

impl Layer {
    /// The world's normal after this layer's bumps.
    #[inline]
    pub(super) fn perturbed(&self, spot: &Spot, frame: &Frame) -> Vec3 {
        match &self.normal {
            None => spot.normal,
            Some(bumps) => {
                let normal = frame.normal_from_world(spot.normal);
                frame.normal_to_world(bumps.perturb(frame.point, normal, &spot.context))
            }
        }
    }

    /// The colour of the pigment, which may look at the normal.
    #[inline]
    pub(super) fn color(&self, spot: &Spot, frame: &Frame, normal: Vec3) -> Rgbft {
        match &self.pigment {
            Pigment::Solid(color) => *color,
            pigment => pigment.color(frame.point, &SurfaceContext { normal, ..spot.context }),
        }
    }
}
