//! SDL: `light_source { ... }`: where light comes from and how much of it arrives; shadows are [`shadow`]'s work.

mod area;
mod beam;

pub use area::Area;
pub use beam::Beam;

use std::sync::Arc;

use crate::color::Rgb;
use crate::geometry::Geometry;
use crate::graph::light::LightPhotons;
use crate::math::Vec3;

/// A light made ready for sampling.
#[derive(Clone, Debug)]
pub struct Light {
    /// Where it stands; the centre of an area.
    pub location: Vec3,
    /// Its colour before fading.
    pub color: Rgb,
    /// How the beam is bounded.
    pub beam: Beam,
    /// Unit direction from the scene towards a `parallel` light, and the light's plane through its location.
    pub towards_parallel: Option<Vec3>,
    /// No shadows and no highlights.
    pub shadowless: bool,
    /// Points that cast soft shadows.
    pub area: Option<Area>,
    /// How light thins out with distance.
    pub fade: Fade,
    /// An object that light must pass; what lies between it and the light throws no shadow.
    pub projected_through: Option<Arc<Geometry>>,
    /// What becomes of its photons.
    pub photons: Option<LightPhotons>,
    /// Whether media see the light.
    pub media_interaction: bool,
    /// Whether media dim the light.
    pub media_attenuation: bool,
}

/// `fade_distance F fade_power F`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fade {
    /// The same at any distance.
    None,
    /// 2 / (1 + (d / distance)^power).
    Distance(f64, f64),
    /// 3.8: d^-power.
    Power(f64),
}

/// Light arriving at a point if nothing is in its way.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    /// Unit direction from the point to the light.
    pub direction: Vec3,
    /// How far the light is along it.
    pub distance: f64,
    /// Colour after the beam's edge and fading.
    pub color: Rgb,
}

impl Light {
    /// Where its photons start on their way to a target: all points of its area if it says so.
    pub fn photon_points(&self, target: Vec3) -> Vec<Vec3> {
        match &self.area {
            Some(area) if self.photons.as_ref().is_some_and(|p| p.area_light) => {
                let axes = area.axes_towards((self.location - target).normalized());
                let [width, height] = area.size;
                let cells = (0..width).flat_map(|u| (0..height).map(move |v| (u, v)));
                cells.map(|cell| self.location + area.displacement(&axes, cell, [0.0, 0.0])).collect()
            }
            _ => vec![self.location],
        }
    }

    /// What arrives at `point`.
    #[inline]
    pub fn arrival(&self, point: Vec3) -> Arrival {
        self.arrival_from(self.location, point)
    }

    /// What arrives at `point` when the light stands at `location`, a point of its area.
    pub fn arrival_from(&self, location: Vec3, point: Vec3) -> Arrival {
        let to_light = location - point;
        let (direction, distance) = match self.towards_parallel {
            Some(towards) => (towards, to_light.dot(towards)),
            None => {
                let distance = to_light.length();
                (if distance > 0.0 { to_light / distance } else { to_light }, distance)
            }
        };
        let strength = self.beam.strength(point, location, direction) * self.fade.factor(distance);
        Arrival { direction, distance, color: self.color * strength }
    }
}

impl Fade {
    /// The factor at a distance.
    #[inline]
    pub fn factor(self, distance: f64) -> f64 {
        match self {
            Fade::None => 1.0,
            Fade::Distance(scale, power) => 2.0 / (1.0 + (distance / scale).powf(power)),
            Fade::Power(power) => distance.powf(-power),
        }
    }
}
