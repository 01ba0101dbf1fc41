//! SDL: `photons { ... }`: the pass that shoots photons before the picture is rendered.

use std::f64::consts::PI;

use rayon::prelude::*;

use super::{Job, Random};
use crate::photon::{rings, Aim, Allowed, Photon, PhotonMap, PhotonMaps, Settings};
use crate::shade::Interiors;

/// More photons than this are not shot: they would fill the memory of any machine.
const MOST_PHOTONS: f64 = 2e7;

impl Job {
    /// Shoots all photons. Each ring has random numbers of its own, and rings are joined in order, so the map does not
    /// depend on threads.
    pub(super) fn shoot_photons(&self, settings: &Settings) -> PhotonMaps {
        let aims = self.aims(settings);
        let shots: Vec<(&Aim, usize)> =
            aims.iter().flat_map(|aim| (0..rings(aim)).map(move |ring| (aim, ring))).collect();
        let (fallen, floating): (Vec<Vec<Photon>>, Vec<Vec<Photon>>) = shots
            .par_iter()
            .with_max_len(1)
            .map(|&(aim, ring)| {
                let mut tracer = self.tracer();
                let (mut fallen, mut floating) = (Vec::new(), Vec::new());
                let mut around = Interiors::NONE;
                for node in self.scene.geometry.containing(aim.origin) {
                    around.enter(self.scene.body_of(node));
                }
                for (number, shot) in aim.ring(ring, settings.jitter).iter().enumerate() {
                    tracer.random = Random::seeded(number as u64, ring as u64, u64::from(aim.light) + 8);
                    tracer.shoot(aim, shot, &around, &mut fallen, &mut floating);
                }
                self.count(&mut tracer);
                (fallen, floating)
            })
            .unzip();
        let [surfaces, media] = &settings.gathering;
        PhotonMaps {
            surfaces: PhotonMap::new(fallen.concat(), false, surfaces),
            media: PhotonMap::new(floating.concat(), true, media),
        }
    }

    /// Each light with each target that does something to its photons.
    fn aims(&self, settings: &Settings) -> Vec<Aim> {
        let geometry = &self.scene.geometry;
        let (mut aims, mut expected) = (Vec::new(), 0.0);
        for (number, light) in self.scene.lights.iter().enumerate() {
            for target in geometry.top() {
                let looks = geometry.looks(target);
                let Some(factor) = looks.photons.as_ref().and_then(|p| p.target) else { continue };
                let extent = geometry.node(target).extent.surface;
                let allowed = Allowed::new(light.photons.as_ref(), looks);
                if !allowed.any() || !extent.is_finite() || extent.is_empty() {
                    continue;
                }
                let center = (extent.min + extent.max) * 0.5;
                let radius = (extent.max - extent.min).length() * 0.5;
                let points = light.photon_points(center);
                let share = 1.0 / points.len() as f64;
                let spacing = settings.spacing * factor * share.sqrt().recip();
                if spacing <= 0.0 {
                    continue;
                }
                for origin in points {
                    expected += PI * radius * radius / spacing.powi(2) * allowed.effort();
                    aims.push(Aim {
                        light: number as u32,
                        origin,
                        share,
                        target,
                        center,
                        radius,
                        parallel: light.towards_parallel.map(|towards| -towards),
                        spacing,
                    });
                }
            }
        }
        let wanted = settings.count.map_or(expected, |count| count.max(1) as f64).min(MOST_PHOTONS);
        let factor = (expected / wanted).sqrt();
        aims.iter_mut().for_each(|aim| aim.spacing *= factor);
        aims
    }
}
