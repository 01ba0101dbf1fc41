//! SDL: `media { ... }` in interiors and at the top: what becomes of light on its way through volumes.
//!
//! A ray is cut in parts ([`stretches`]); in each the medium is sampled ([`sampling`], by the method asked for), and
//! the parts are put together from the eye on.

mod sample;
mod sampling;
mod stretches;

pub(super) use stretches::Stretch;

use super::{Interiors, Path, Radiance, Tracer};
use crate::color::Rgb;
use crate::light::Light;
use crate::math::Ray;
use crate::media::Media;
use crate::prepare::Scene;

/// Rays that hit nothing go through this much of the atmosphere.
const FARTHEST: f64 = 1e7;

/// Which media a ray goes through.
#[derive(Clone, Copy)]
pub(super) enum Matter<'a> {
    /// Those of the objects around it.
    Bodies(&'a Interiors),
    /// The atmosphere's.
    Air,
}

impl<'a> Matter<'a> {
    /// All media, one after the other.
    fn media<'s>(self, scene: &'s Scene) -> impl Iterator<Item = &'s Media> + use<'s, 'a> {
        let (bodies, air) = match self {
            Matter::Bodies(interiors) => (Some(interiors), &[][..]),
            Matter::Air => (None, &scene.air[..]),
        };
        bodies.into_iter().flat_map(|i| i.iter()).flat_map(|id| scene.media_of(id)).chain(air)
    }
}

/// A way through media.
pub(super) struct Way<'a> {
    matter: Matter<'a>,
    ray: &'a Ray,
    interiors: &'a Interiors,
    /// The light group of the object that is looked at.
    light_group: Option<u32>,
    /// Only what is lost counts: the way to a lamp.
    shadow: bool,
}

/// What a part of the way does to light: what it adds and what optical depth it has.
#[derive(Clone, Copy, Debug)]
struct Influence {
    light: Rgb,
    depth: Rgb,
}

impl Influence {
    const NONE: Influence = Influence { light: Rgb::BLACK, depth: Rgb::BLACK };

    /// Adds a share of what lies behind.
    fn add_behind(&mut self, behind: &Influence, share: f64) {
        self.light += behind.light.mul_each(passing(self.depth)) * share;
        self.depth += behind.depth * share;
    }

    fn add_scaled(&mut self, other: &Influence, share: f64) {
        self.light += other.light * share;
        self.depth += other.depth * share;
    }
}

/// The light that an optical depth leaves.
fn passing(depth: Rgb) -> Rgb {
    depth.map(|d| (-d).exp())
}

impl Tracer<'_> {
    /// Changes light that comes from `distance` along a ray by the media of the objects that the ray is in.
    pub(super) fn dim_by_bodies(
        &mut self,
        path: &Path,
        distance: f64,
        light_group: Option<u32>,
        seen: &mut Radiance,
    ) {
        let scene = self.scene;
        if !scene.has_media || path.interiors.is_empty() || !self.sees_volumes() {
            return;
        }
        let matter = Matter::Bodies(&path.interiors);
        if matter.media(scene).next().is_some() && scene.is_hollow(&path.interiors) {
            self.dim_by(matter, path, distance, light_group, seen);
        }
    }

    /// The same by the atmosphere's media.
    pub(super) fn dim_by_air(
        &mut self,
        path: &Path,
        distance: f64,
        light_group: Option<u32>,
        seen: &mut Radiance,
    ) {
        if self.sees_volumes() {
            self.dim_by(Matter::Air, path, distance.min(FARTHEST), light_group, seen);
        }
    }

    fn dim_by(
        &mut self,
        matter: Matter,
        path: &Path,
        distance: f64,
        light_group: Option<u32>,
        seen: &mut Radiance,
    ) {
        let way = Way { matter, ray: &path.ray, interiors: &path.interiors, light_group, shadow: false };
        let influence = self.influence(&way, distance);
        let left = passing(influence.depth);
        seen.rgb = seen.rgb.mul_each(left) + influence.light;
        seen.transmit *= left.gray();
    }

    /// What media and fog leave of a lamp's light over a part of its way that ends at a surface. In solid objects the
    /// atmosphere's media are there, fog is not (probed).
    pub(super) fn media_filter(&mut self, path: &Path, distance: f64, light: &Light) -> Rgb {
        let scene = self.scene;
        if !self.sees_volumes() {
            return Rgb::WHITE;
        }
        let mut left = self.loss_in_bodies(path, distance);
        if scene.air_dims(light) {
            left = left.mul_each(self.loss(path, Matter::Air, distance));
            if scene.is_hollow(&path.interiors) {
                left = left.mul_each(scene.atmosphere.filter(&path.ray, distance));
            }
        }
        left
    }

    /// What the atmosphere's media and fog leave of a lamp's light over the last part of its way.
    pub(super) fn air_filter(&mut self, path: &Path, distance: f64, light: &Light) -> Rgb {
        let scene = self.scene;
        if self.sees_volumes() && scene.air_dims(light) && scene.is_hollow(&path.interiors) {
            let fog = scene.atmosphere.filter(&path.ray, distance);
            fog.mul_each(self.loss(path, Matter::Air, distance))
        } else {
            Rgb::WHITE
        }
    }

    /// What the media of the objects around leave of light.
    pub(super) fn loss_in_bodies(&mut self, path: &Path, distance: f64) -> Rgb {
        if self.scene.has_media && self.scene.is_hollow(&path.interiors) {
            self.loss(path, Matter::Bodies(&path.interiors), distance)
        } else {
            Rgb::WHITE
        }
    }

    /// What media leave of light.
    fn loss(&mut self, path: &Path, matter: Matter, distance: f64) -> Rgb {
        let scene = self.scene;
        if matter.media(scene).all(|media| media.extinction == Rgb::BLACK) {
            return Rgb::WHITE;
        }
        let constant = matter.media(scene).try_fold(Rgb::BLACK, |sum, media| {
            Some(sum + media.constant_density()?.mul_each(media.extinction))
        });
        let depth = match constant {
            Some(extinction) => extinction * distance,
            None => {
                let (ray, interiors) = (&path.ray, &path.interiors);
                let way = Way { matter, ray, interiors, light_group: None, shadow: true };
                self.influence(&way, distance).depth
            }
        };
        passing(depth)
    }

    /// What a whole way does.
    fn influence(&mut self, way: &Way, distance: f64) -> Influence {
        // The media of a ray are sampled together, as the one with the most intervals asks for.
        let scene = self.scene;
        let mut media = way.matter.media(scene);
        let Some(mut leader) = media.next() else {
            return Influence::NONE;
        };
        let mut aa_threshold = leader.sampling.aa_threshold;
        for media in media {
            if media.sampling.intervals > leader.sampling.intervals {
                leader = media;
            }
            aa_threshold = aa_threshold.min(media.sampling.aa_threshold);
        }
        let sampling = &leader.sampling;
        let first = self.stretches.len();
        self.cut(way, distance, sampling);
        let last = self.stretches.len();
        let mut whole = Influence::NONE;
        for i in first..last {
            let stretch = self.stretches[i];
            let part = match sampling.method {
                3 => self.sample_adaptively(way, &stretch, sampling, aa_threshold),
                _ => self.sample_evenly(way, &stretch, sampling),
            };
            whole.add_behind(&part, 1.0);
        }
        self.stretches.truncate(first);
        whole
    }
}
