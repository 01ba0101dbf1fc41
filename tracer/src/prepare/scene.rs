//! What is rendered: numbered parts that never change.

use super::Quality;
use crate::atmosphere::{Atmosphere, Sky};
use crate::camera::Camera;
use crate::color::Rgb;
use crate::geometry::{Geometry, NodeId};
use crate::graph::Interior;
use crate::light::Light;
use crate::math::Vec3;
use crate::media::Media;
use crate::noise::NoiseGenerator;
use crate::photon;
use crate::radiosity;
use crate::shade::{BodyId, Interiors, Layering, Spot, Texture, TextureId};
use crate::subsurface;

/// A scene ready for rendering.
#[derive(Debug)]
pub struct Scene {
    /// What rays hit.
    pub geometry: Geometry,
    /// All textures.
    pub textures: Vec<Texture>,
    /// The texture of each number that geometry uses; the last is the scene's default.
    pub(super) dresses: Vec<Dress>,
    /// What fills objects.
    pub interiors: Vec<Interior>,
    /// The media of each of them.
    pub media: Vec<Box<[Media]>>,
    /// Whether any has one.
    pub has_media: bool,
    /// The atmosphere's media.
    pub air: Vec<Media>,
    /// All lights.
    pub lights: Vec<Light>,
    /// Which lights shine outside all light groups, then on each group.
    pub(super) light_sets: Vec<Vec<u32>>,
    /// From where the picture is taken.
    pub camera: Camera,
    /// What is behind everything.
    pub sky: Sky,
    /// What is between things.
    pub atmosphere: Atmosphere,
    /// What is left out.
    pub quality: Quality,
    /// Whether any texture asks for surface coordinates.
    pub uses_uv: bool,
    /// How photons are shot, if they are.
    pub photons: Option<photon::Settings>,
    /// How light between surfaces is gathered, if it is.
    pub radiosity: Option<radiosity::Settings>,
    /// How light under surfaces is sampled, if it is.
    pub subsurface: Option<subsurface::Settings>,
    /// How layers cover each other.
    pub layering: Layering,
    /// Longest chain of rays.
    pub max_trace_level: u32,
    /// Rays of less weight are not shot.
    pub adc_bailout: f64,
    /// Wavelengths of the three channels, for thin films.
    pub irid_wavelength: Rgb,
    /// For turbulence outside of patterns.
    pub noise_generator: NoiseGenerator,
}

/// A texture as objects wear it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dress {
    pub texture: TextureId,
    /// Nothing is seen through it, anywhere.
    pub opaque: bool,
    /// The share of light that passes, if it is the same everywhere.
    pub passes: Option<Rgb>,
}

impl Scene {
    /// The texture of a number that geometry uses; none is the scene's default.
    #[inline]
    pub fn dress(&self, worn: Option<u32>) -> TextureId {
        self.dress_of(worn).texture
    }

    fn dress_of(&self, worn: Option<u32>) -> &Dress {
        &self.dresses[worn.map_or(self.dresses.len() - 1, |w| w as usize)]
    }

    /// Whether nothing is ever seen through a node, so that shadow rays may stop there.
    #[inline]
    pub fn is_opaque(&self, node: NodeId) -> bool {
        let looks = self.geometry.looks(node);
        !looks.several_textures
            && self.dress_of(looks.texture).opaque
            && looks.interior_texture.is_none_or(|worn| self.dress_of(Some(worn)).opaque)
    }

    /// The share of a lamp's light that passes a surface, if neither point nor angle nor depth matter.
    #[inline]
    pub fn plain_filter(&self, node: NodeId, body: BodyId) -> Option<Rgb> {
        let looks = self.geometry.looks(node);
        if looks.several_textures || looks.interior_texture.is_some() {
            return None;
        }
        let plain = self.interior(body).is_none_or(|i| i.fade_power == 0.0 && i.caustics == 0.0);
        self.dress_of(looks.texture).passes.filter(|_| plain)
    }

    /// The lights that shine on objects of a light group.
    #[inline]
    pub fn lights_for(&self, group: Option<u32>) -> &[u32] {
        &self.light_sets[group.map_or(0, |g| g as usize + 1)]
    }

    /// The body that a node bounds.
    #[inline]
    pub fn body_of(&self, node: NodeId) -> BodyId {
        self.geometry.looks(node).body.expect("every prepared object bounds a body")
    }

    /// What fills a body, if the scene says anything about it.
    #[inline]
    pub fn interior(&self, id: BodyId) -> Option<&Interior> {
        let interior = self.geometry.bodies[id as usize].interior;
        interior.map(|interior| &self.interiors[interior as usize])
    }

    /// Whether fog and media reach where a ray is: everything around it is hollow.
    #[inline]
    pub fn is_hollow(&self, around: &Interiors) -> bool {
        around.iter().all(|body| self.geometry.bodies[body as usize].hollow)
    }

    /// The media that fill a body.
    #[inline]
    pub fn media_of(&self, id: BodyId) -> &[Media] {
        self.geometry.bodies[id as usize].interior.map_or(&[], |interior| &self.media[interior as usize])
    }

    /// Whether any medium of the bodies around collects photons.
    pub fn collects_in_media(&self, around: &Interiors) -> bool {
        around.iter().flat_map(|body| self.media_of(body)).any(|media| media.collect)
    }

    /// Whether the atmosphere's media and fogs dim a lamp's light.
    pub fn air_dims(&self, light: &Light) -> bool {
        light.media_attenuation
            && light.media_interaction
            && !(self.air.is_empty() && self.atmosphere.is_clear())
    }

    /// Whether media or fog may dim a lamp's light between surfaces.
    pub fn is_murky(&self, around: &Interiors, light: &Light) -> bool {
        self.air_dims(light) || (self.has_media && around.iter().any(|body| !self.media_of(body).is_empty()))
    }

    /// Optical density; that of open space is 1.
    #[inline]
    pub fn ior_of(&self, id: Option<BodyId>) -> f64 {
        id.and_then(|id| self.interior(id)).map_or(1.0, |interior| interior.ior)
    }

    /// Ratio of the densities for violet and red.
    #[inline]
    pub fn dispersion_of(&self, id: Option<BodyId>) -> f64 {
        id.and_then(|id| self.interior(id)).map_or(1.0, |interior| interior.dispersion)
    }

    /// Into how many bands the surface of a body parts light.
    pub fn dispersion_samples(&self, id: BodyId) -> usize {
        self.interior(id).map_or(7, |interior| interior.dispersion_samples.max(2))
    }

    /// What `fade_distance` leaves of light that goes through a surface, seen from inside the object.
    #[inline]
    pub fn view_attenuation(&self, spot: &Spot) -> Rgb {
        match self.interior(spot.body) {
            Some(i) if i.fade_distance > 0.0 && spot.path.interiors.contains(spot.body) => {
                fading(i, spot.distance)
            }
            _ => Rgb::WHITE,
        }
    }

    /// What `refraction F` of an old finish leaves of light from behind a surface, though not of a lamp's.
    #[inline]
    pub fn refraction(&self, id: BodyId) -> f64 {
        self.interior(id).map_or(1.0, |interior| interior.refraction)
    }

    /// `view_attenuation` for light of a lamp, which an absent `fade_power` leaves alone.
    pub fn shadow_attenuation(&self, spot: &Spot) -> Rgb {
        match self.interior(spot.body) {
            Some(i) if i.fade_power > 0.0 => self.view_attenuation(spot),
            _ => Rgb::WHITE,
        }
    }

    /// Tells the camera which objects it stands in.
    pub(super) fn place_camera(&mut self) {
        if self.camera.interiors.is_some() {
            self.camera.interiors = Some(self.interiors_around(self.camera.location()));
        }
    }

    /// The objects that a place is in.
    pub fn interiors_around(&self, place: Vec3) -> Interiors {
        let mut interiors = Interiors::NONE;
        self.geometry.containing(place).into_iter().for_each(|node| interiors.enter(self.body_of(node)));
        interiors
    }
}

/// What is left of light after `distance` inside.
fn fading(interior: &Interior, distance: f64) -> Rgb {
    let depth = distance / interior.fade_distance;
    if interior.fade_power >= 1000.0 {
        return interior.fade_color.map(|color| (-(1.0 - color) * depth).exp());
    }
    let left = 1.0 / (1.0 + depth.powf(interior.fade_power));
    interior.fade_color.map(|color| color + (1.0 - color) * left)
}
