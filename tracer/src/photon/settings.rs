//! The numbers of `photons { ... }`, checked and made ready.

use crate::geometry::Looks;
use crate::graph::light::LightPhotons;
use crate::graph::settings as graph;

/// What rules shooting and gathering.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Distance between photons on a target.
    pub spacing: f64,
    /// How many photons are shot in all, instead of `spacing`.
    pub count: Option<usize>,
    /// How photons on surfaces are gathered, and how those in media.
    pub gathering: [Gathering; 2],
    /// In how many steps at most a photon leaves light in media, and how long they are in spacings.
    pub media: (usize, f64),
    /// By how much of their distance photons are shifted.
    pub jitter: f64,
    /// Longest chain of mirrors and lenses.
    pub max_trace_level: u32,
    /// Fainter photons are not followed.
    pub adc_bailout: f64,
}

/// `gather I, I radius F, F expand_thresholds F, I`.
#[derive(Clone, Copy, Debug)]
pub struct Gathering {
    /// The fewest and the most photons that a point gathers.
    pub gather: [usize; 2],
    /// Where photons are gathered from around a point; by their density if not given.
    pub radius: Option<f64>,
    /// Factor of the radius.
    pub radius_factor: f64,
    /// By how much light may grow, and how many photons are too few, when light is gathered from farther away.
    pub expand: (f64, usize),
}

impl Settings {
    /// Fills in the scene's own limits.
    pub fn new(p: &graph::Photons, scene: &graph::GlobalSettings) -> Settings {
        let gathering = |radius: Option<f64>, radius_factor| Gathering {
            gather: [p.gather.0, p.gather.1.max(1)],
            radius: radius.filter(|&r| r > 0.0),
            radius_factor,
            expand: p.expand_thresholds,
        };
        Settings {
            spacing: p.spacing.unwrap_or(1.0),
            count: p.count,
            gathering: [gathering(p.radius.0, p.radius.1), gathering(p.radius.2, p.radius.3)],
            media: p.media,
            jitter: p.jitter,
            max_trace_level: p.max_trace_level.unwrap_or(scene.max_trace_level),
            adc_bailout: p.adc_bailout.unwrap_or(scene.adc_bailout),
        }
    }
}

/// What becomes of photons of one light at an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Allowed {
    /// They are mirrored.
    pub reflection: bool,
    /// They go through.
    pub refraction: bool,
}

impl Allowed {
    /// One of light and object must ask for it, none may forbid it.
    pub fn new(light: Option<&LightPhotons>, object: &Looks) -> Allowed {
        let both = |light: Option<bool>, object: Option<bool>| {
            light != Some(false) && object != Some(false) && (light == Some(true) || object == Some(true))
        };
        let photons = object.photons.as_ref();
        Allowed {
            reflection: both(light.and_then(|l| l.reflection), photons.and_then(|p| p.reflection)),
            refraction: both(light.and_then(|l| l.refraction), photons.and_then(|p| p.refraction)),
        }
    }

    /// For how many a photon counts when `count` is shared out: what may split it takes half as much again each way
    /// (probed).
    pub fn effort(self) -> f64 {
        if self.reflection && self.refraction {
            2.25
        } else {
            1.0
        }
    }

    /// Whether any photons leave the object.
    pub fn any(self) -> bool {
        self.reflection || self.refraction
    }
}
