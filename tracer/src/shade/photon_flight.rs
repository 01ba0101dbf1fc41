//! Photons followed from a light through mirrors and lenses to where they fall. See [`crate::photon`].

use super::dispersion::Band;
use super::frame::Frame;
use super::layers::Spot;
use super::reflect::mirror_direction;
use super::refract::{onward, refracted};
use super::{Interiors, Layer, Path, Texture, TextureId, Tracer, NEAREST};
use crate::accel::RayKind;
use crate::color::Rgb;
use crate::geometry::{Hit, NodeId};
use crate::math::{Ray, Vec3};
use crate::photon::{Aim, Allowed, Photon, Shot};

/// How a photon has come to where it is.
#[derive(Clone, Copy)]
struct Flown {
    /// What it stands for: light times area, or times solid angle.
    flux: Rgb,
    /// What of it counts, of 1 at the start, when it is asked whether it is worth following: filters count by their
    /// brightness, mirrors by the square of their strongest channel (probed).
    weight: f64,
    /// The length of its way.
    travelled: f64,
    /// How many surfaces it has met.
    level: u32,
}

impl Flown {
    fn with(self, flux: Rgb) -> Flown {
        Flown { flux, ..self }
    }

    fn share(self, flux: Rgb, weight: f64) -> Flown {
        Flown { flux, weight: self.weight * weight, ..self }
    }

    fn next(self) -> Flown {
        Flown { level: self.level + 1, ..self }
    }
}

/// What is the same for all parts of one photon.
struct Flight<'a> {
    /// The light that it comes from.
    light: u32,
    /// What counts less than this is dropped.
    faint: f64,
    /// The longest chain.
    limit: u32,
    /// The distance between photons, or the angle; that of parallel light does not grow with distance.
    apart: f64,
    /// Where photons are left on surfaces.
    fallen: &'a mut Vec<Photon>,
    /// Where they are left in media.
    floating: &'a mut Vec<Photon>,
}

impl Tracer<'_> {
    /// Follows one photon to all places where it falls.
    pub fn shoot(
        &mut self,
        aim: &Aim,
        shot: &Shot,
        around: &Interiors,
        fallen: &mut Vec<Photon>,
        floating: &mut Vec<Photon>,
    ) {
        let Some(settings) = &self.scene.photons else { return };
        let mut path = Path { ray: shot.ray, interiors: *around, kind: RayKind::Photon, band: None };
        let Some((hit, passed)) = self.first_hit(&mut path, aim.target) else { return };
        let light = &self.scene.lights[aim.light as usize];
        let point = path.ray.at(hit.crossing.t);
        let beam = light.beam.strength(point, aim.origin, -shot.ray.direction);
        let flux = light.color.mul_each(passed) * (beam * shot.spread * aim.share);
        let faint = settings.adc_bailout;
        let (limit, apart) = (settings.max_trace_level, shot.spread.sqrt());
        let mut flight = Flight { light: aim.light, faint, limit, apart, fallen, floating };
        let flown = Flown { flux, weight: 1.0, travelled: (point - shot.ray.origin).length(), level: 1 };
        self.carry_on(&path, &hit, flown, &mut flight);
    }

    /// The target, if a photon reaches it, and what media leave of its light; what lets photons pass is not in the way.
    fn first_hit(&mut self, path: &mut Path, target: NodeId) -> Option<(Hit, Rgb)> {
        let scene = self.scene;
        let mut passed = Rgb::WHITE;
        loop {
            let hit =
                scene.geometry.nearest(&path.ray, NEAREST, f64::INFINITY, path.kind, &mut self.counters)?;
            passed = passed.mul_each(self.loss_in_bodies(path, hit.crossing.t));
            if hit.object == target {
                return Some((hit, passed));
            }
            let looks = scene.geometry.looks(hit.node);
            if !(looks.no_shadow || looks.photons.as_ref().is_some_and(|p| p.pass_through)) {
                return None;
            }
            path.ray.origin = path.ray.at(hit.crossing.t);
            let body = scene.body_of(hit.node);
            if !path.interiors.leave(body) {
                path.interiors.enter(body);
            }
        }
    }

    /// A photon on its way after a mirror or lens.
    fn fly(&mut self, path: &Path, flown: Flown, flight: &mut Flight) {
        if flown.flux == Rgb::BLACK || flown.weight <= flight.faint || flown.level > flight.limit {
            return;
        }
        let geometry = &self.scene.geometry;
        let hit = geometry.nearest(&path.ray, NEAREST, f64::INFINITY, path.kind, &mut self.counters);
        let Some(hit) = hit else { return };
        let flux = self.through_media(path, hit.crossing.t, flown, flight);
        let flown = Flown { flux, travelled: flown.travelled + hit.crossing.t, ..flown };
        if geometry.looks(hit.node).photons.as_ref().is_none_or(|p| p.collect) {
            let (point, direction) = (path.ray.at(hit.crossing.t), path.ray.direction);
            let flux = flown.flux * self.weight_after(flight.light, flown.travelled);
            flight.fallen.push(Photon::new(point, direction, flux));
        }
        self.carry_on(path, &hit, flown, flight);
    }

    /// Leaves a photon's light in the media on its way; gives what is left of it.
    fn through_media(&mut self, path: &Path, distance: f64, flown: Flown, flight: &mut Flight) -> Rgb {
        let scene = self.scene;
        let (most, factor) = scene.photons.as_ref().map_or((0, 1.0), |settings| settings.media);
        if most == 0 || !scene.collects_in_media(&path.interiors) || !scene.is_hollow(&path.interiors) {
            return flown.flux.mul_each(self.loss_in_bodies(path, distance));
        }
        let reach = if scene.lights[flight.light as usize].towards_parallel.is_some() {
            1.0
        } else {
            flown.travelled
        };
        let wanted = (distance / (flight.apart * reach * factor)).ceil();
        let steps = if wanted >= 1.0 { (wanted as usize).min(most) } else { 1 };
        let length = distance / steps as f64;
        let mut depth = Rgb::BLACK;
        for step in 0..steps {
            let at = (step as f64 + self.random.unit()) * length;
            let point = path.ray.at(at);
            let (mut extinction, mut scattering) = (Rgb::BLACK, Rgb::BLACK);
            for media in path.interiors.iter().flat_map(|body| scene.media_of(body)) {
                let density = media.density(point);
                extinction += density.mul_each(media.extinction);
                scattering += density.mul_each(media.scattering);
            }
            if scattering != Rgb::BLACK {
                let weight = self.weight_after(flight.light, flown.travelled + at);
                // Light is lost at the end of the way only (probed).
                let flux = flown.flux * (weight * length);
                flight.floating.push(Photon::new(point, path.ray.direction, flux));
            }
            depth += extinction * length;
        }
        flown.flux.mul_each(depth.map(|d| (-d).exp()))
    }

    /// What light of a lamp counts after a way of some length, mirrors and lenses or not (probed): it fades, and a
    /// solid angle stands for an area.
    fn weight_after(&self, light: u32, travelled: f64) -> f64 {
        let light = &self.scene.lights[light as usize];
        let area = if light.towards_parallel.is_some() { 1.0 } else { travelled * travelled };
        light.fade.factor(travelled) * area
    }

    /// What a surface does to a photon.
    fn carry_on(&mut self, path: &Path, hit: &Hit, flown: Flown, flight: &mut Flight) {
        let scene = self.scene;
        let spot = Spot::new(scene, path, hit);
        let allowed = Allowed::new(scene.lights[flight.light as usize].photons.as_ref(), spot.looks);
        if allowed.any() {
            let flown = flown.with(flown.flux.mul_each(scene.view_attenuation(&spot)));
            self.through_texture(&spot, &spot.frame(), scene.dress(spot.worn()), flown, allowed, flight);
        }
    }

    fn through_texture(
        &mut self,
        spot: &Spot,
        frame: &Frame,
        texture: TextureId,
        flown: Flown,
        allowed: Allowed,
        flight: &mut Flight,
    ) {
        let texture = &self.scene.textures[texture as usize];
        if let Texture::Layers(layers) = texture {
            return self.through_layers(spot, frame, layers, flown, allowed, flight);
        }
        let (shares, frame) = texture.shares(spot, frame);
        for (inner, share) in shares {
            self.through_texture(
                spot,
                &frame,
                inner,
                flown.share(flown.flux * share, share),
                allowed,
                flight,
            );
        }
    }

    fn through_layers(
        &mut self,
        spot: &Spot,
        frame: &Frame,
        layers: &[Layer],
        flown: Flown,
        allowed: Allowed,
        flight: &mut Flight,
    ) {
        let (mut left, mut weight) = (flown.flux, 1.0);
        let mut top_normal = spot.normal;
        for (number, layer) in layers.iter().enumerate() {
            let normal = layer.perturbed(spot, frame);
            if number == 0 {
                top_normal = normal;
            }
            let color = layer.color(spot, frame, normal);
            let mut passes = color.passing();
            if let Some(mirror) = &layer.finish.reflection {
                let share = self.reflectivity(spot, mirror, normal, color.rgb);
                if allowed.reflection {
                    let counts = weight * mirror.strength(share) * share.max_element();
                    self.mirror_photon(spot, normal, flown.share(left.mul_each(share), counts), flight);
                }
                if layer.finish.conserve_energy {
                    passes = passes.mul_each(share.map(|s| (1.0 - s).max(0.0)));
                }
            }
            left = left.mul_each(passes);
            weight *= passes.gray();
        }
        if allowed.refraction {
            self.refract_photon(spot, top_normal, flown.share(left, weight), flown.flux, flight);
        }
    }

    fn mirror_photon(&mut self, spot: &Spot, normal: Vec3, flown: Flown, flight: &mut Flight) {
        let direction = mirror_direction(spot.path.ray.direction, normal, spot.normal);
        let path = Path { ray: Ray { origin: spot.point, direction }, ..*spot.path };
        self.fly(&path, flown.next(), flight);
    }

    /// What goes on of a photon that brought light `whole`. Dispersion parts it by colour.
    fn refract_photon(&mut self, spot: &Spot, normal: Vec3, flown: Flown, whole: Rgb, flight: &mut Flight) {
        let ratio = 1.0 / self.relative_ior(spot);
        match (self.dispersion(spot), spot.path.band) {
            (None, _) => self.bend_photon(spot, normal, ratio, flown, whole, flight),
            (Some(dispersion), Some(band)) => {
                self.bend_photon(spot, normal, band.bends(ratio, dispersion), flown, whole, flight);
            }
            (Some(dispersion), None) => {
                let count = self.scene.dispersion_samples(spot.body);
                for band in Band::all(count) {
                    let path = Path { band: Some(band), ..*spot.path };
                    let hue = band.hue() * (1.0 / count as f64);
                    let (part, whole) = (flown.with(flown.flux.mul_each(hue)), whole.mul_each(hue));
                    let spot = Spot { path: &path, ..*spot };
                    self.bend_photon(&spot, normal, band.bends(ratio, dispersion), part, whole, flight);
                }
            }
        }
    }

    /// What is mirrored inside loses nothing to the surface (probed).
    fn bend_photon(
        &mut self,
        spot: &Spot,
        normal: Vec3,
        ratio: f64,
        flown: Flown,
        whole: Rgb,
        flight: &mut Flight,
    ) {
        match refracted(spot.path.ray.direction, normal, ratio) {
            Some(direction) => self.fly(&onward(spot, direction), flown.next(), flight),
            None => self.mirror_photon(spot, normal, flown.with(whole), flight),
        }
    }
}
