//! From rays to light: what is hit, how it is lit, mirrored and seen through.

mod diffuse;
mod dispersion;
mod finish;
mod frame;
mod highlight;
mod indirect;
mod interiors;
mod layering;
mod layers;
mod media;
mod photon_flight;
mod photon_light;
mod reflect;
mod refract;
mod shadow;
mod soft_shadow;
mod subsurface;
mod texture;

pub use dispersion::Band;
pub use finish::Finish;
pub use interiors::{BodyId, Interiors};
pub use layering::Layering;
pub use layers::Spot;
use media::Stretch;
use reflect::Mirrored;
pub use texture::{Layer, Texture, TextureId};

use std::sync::atomic::{AtomicBool, Ordering};

use crate::accel::{Counters, RayKind};
use crate::color::Rgb;
use crate::geometry::{Hit, NodeId};
use crate::math::Ray;
use crate::photon::PhotonMaps;
use crate::prepare::Scene;
use crate::radiosity::Indirect;
use crate::render::Random;

/// Hits nearer than this are the surface that the ray starts from.
pub const NEAREST: f64 = 1e-4;

/// Rays that go straight on are followed through this many surfaces.
const STRAIGHT: u32 = 2000;

/// Light arriving along a ray, and how much of what lies behind everything shows through (for alpha).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Radiance {
    /// The light.
    pub rgb: Rgb,
    /// 1: nothing but empty background.
    pub transmit: f64,
}

impl Radiance {
    /// Neither light nor transparency.
    pub const BLACK: Radiance = Radiance { rgb: Rgb::BLACK, transmit: 0.0 };

    /// Adds a share of other light.
    pub fn add_scaled(&mut self, other: &Radiance, share: f64) {
        self.rgb += other.rgb * share;
        self.transmit += other.transmit * share;
    }
}

/// A ray with what it has been through.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    /// The ray; its direction has length one.
    pub ray: Ray,
    /// Which objects it is inside of.
    pub interiors: Interiors,
    /// Why it was shot.
    pub kind: RayKind,
    /// The part of the spectrum that it carries, after dispersion.
    pub band: Option<Band>,
}

/// One thread's state while it traces a scene.
pub struct Tracer<'s> {
    /// What is rendered.
    pub scene: &'s Scene,
    /// What was counted.
    pub counters: Counters,
    /// Random numbers of the current pixel.
    pub random: Random,
    /// Number of rays that led to the current one.
    depth: u32,
    /// Number of rays on the way here that only went straight on.
    straight: u32,
    /// Number of objects that let light under their surface and that the current ray was seen through.
    under_surfaces: u32,
    /// The last occluder of each light.
    occluders: Vec<Option<NodeId>>,
    /// Scratch for the transparent surfaces between a point and a lamp.
    crossed: Vec<Hit>,
    /// Scratch for the points of an area light.
    grid: Vec<Option<Rgb>>,
    /// The mirrors of the surfaces that are being shaded, the innermost last.
    mirrors: Vec<Mirrored>,
    /// Parts of the ways through media that are being sampled.
    stretches: Vec<Stretch>,
    /// Scratch for textures seen together at one point.
    weights: Vec<(Option<u32>, f64)>,
    /// Light thrown by mirrors and lenses, where the scene asks for it.
    pub photons: Option<&'s PhotonMaps>,
    /// Light between surfaces, where the scene asks for it.
    pub indirect: Option<Indirect<'s>>,
    /// Set by someone who no longer wants the picture: rays then see nothing, at once.
    cancelled: &'s AtomicBool,
}

impl<'s> Tracer<'s> {
    /// A tracer that has counted nothing yet.
    pub fn new(scene: &'s Scene, cancelled: &'s AtomicBool) -> Tracer<'s> {
        Tracer {
            scene,
            counters: Counters::default(),
            random: Random::seeded(0, 0, 0),
            depth: 0,
            straight: 0,
            under_surfaces: 0,
            occluders: vec![None; scene.lights.len()],
            crossed: Vec::new(),
            grid: Vec::new(),
            mirrors: Vec::new(),
            stretches: Vec::new(),
            weights: Vec::new(),
            photons: None,
            indirect: None,
            cancelled,
        }
    }

    /// The mean of the light along rays of the camera, whose directions may have any length; nothing is seen along none.
    pub fn look_along(&mut self, rays: impl IntoIterator<Item = Ray>) -> Radiance {
        let (mut sum, mut count) = (Radiance::BLACK, 0.0);
        for ray in rays {
            sum.add_scaled(&self.look(ray), 1.0);
            count += 1.0;
        }
        if count == 0.0 {
            return Radiance { rgb: Rgb::BLACK, transmit: 1.0 };
        }
        let mut mean = Radiance::BLACK;
        mean.add_scaled(&sum, 1.0 / count);
        mean
    }

    /// Light along one of them.
    fn look(&mut self, Ray { origin, direction }: Ray) -> Radiance {
        let camera = &self.scene.camera;
        let interiors = camera.interiors.unwrap_or_else(|| self.scene.interiors_around(origin));
        let ray = Ray { origin, direction: direction.normalized() };
        self.trace(&Path { ray, interiors, kind: RayKind::Camera, band: None }, 1.0)
    }

    /// Light arriving along a ray that counts with `weight` in the pixel.
    pub fn trace(&mut self, path: &Path, weight: f64) -> Radiance {
        self.trace_far(path, weight).0
    }

    /// The same, with the distance to what is seen.
    fn trace_far(&mut self, path: &Path, weight: f64) -> (Radiance, f64) {
        if self.gives_up(weight) {
            return (Radiance::BLACK, f64::INFINITY);
        }
        self.depth += 1;
        let seen = self.follow(path, weight);
        self.depth -= 1;
        seen
    }

    /// The same for a ray that goes straight on through a surface: it does not count as a further one.
    fn trace_on(&mut self, path: &Path, weight: f64) -> Radiance {
        if self.gives_up(weight) || self.straight >= STRAIGHT {
            return Radiance::BLACK;
        }
        self.straight += 1;
        let seen = self.follow(path, weight);
        self.straight -= 1;
        seen.0
    }

    /// Whether a further ray would be too deep or too weak.
    fn gives_up(&self, weight: f64) -> bool {
        self.depth >= self.scene.max_trace_level || weight < self.scene.adc_bailout
    }

    fn follow(&mut self, path: &Path, weight: f64) -> (Radiance, f64) {
        if self.cancelled.load(Ordering::Relaxed) {
            return (Radiance::BLACK, f64::INFINITY);
        }
        let geometry = &self.scene.geometry;
        let from_camera = path.kind == RayKind::Camera && self.depth == 1 && self.straight == 0;
        let reach = if from_camera { self.scene.camera.reach() } else { f64::INFINITY };
        let hit = geometry.nearest(&path.ray, NEAREST, reach, path.kind, &mut self.counters);
        let light_group = hit.and_then(|hit| geometry.looks(hit.node).light_group);
        let (mut seen, distance) = match hit {
            Some(hit) => {
                let mut seen = self.surface_light(path, &hit, weight);
                self.dim_by_bodies(path, hit.crossing.t, light_group, &mut seen);
                (seen, hit.crossing.t)
            }
            None => (self.scene.sky.light(path.ray.direction, path.kind), reach),
        };
        let clear = self.scene.atmosphere.is_clear() && self.scene.air.is_empty();
        if !clear && self.sees_volumes() && self.scene.is_hollow(&path.interiors) {
            // From behind: rainbows, media, fog (probed).
            self.scene.atmosphere.pass_rainbows(&path.ray, distance, &mut self.random, &mut seen);
            self.dim_by_air(path, distance, light_group, &mut seen);
            self.scene.atmosphere.dim(&path.ray, distance, &mut seen);
        }
        (seen, distance)
    }
}

/// The metals' approximation of Fresnel's law, for an angle whose cosine is given: 0 head-on, 1 grazing (probed).
fn metallic_fresnel(cos: f64) -> f64 {
    let x = cos.clamp(-1.0, 1.0).acos().abs() / std::f64::consts::FRAC_PI_2;
    (0.014567225 / (x - 1.12).powi(2) - 0.011612903).clamp(0.0, 1.0)
}

/// A factor that takes on the pigment's colour by `metallic`, less so towards grazing angles.
fn metallic_tint(metallic: f64, cos: f64, pigment: Rgb) -> Rgb {
    let share = metallic * (1.0 - metallic_fresnel(cos));
    pigment.map(|c| 1.0 + share * (c - 1.0))
}
