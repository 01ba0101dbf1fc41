//! The numbers of `radiosity { ... }`, checked and made ready.

use crate::graph::settings as graph;

/// What rules gathering and reuse.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Whether the picture proper gathers wherever light near by is scarce.
    pub always_sample: bool,
    /// Factor of all gathered light.
    pub brightness: f64,
    /// Rays of a hemisphere.
    pub count: usize,
    /// How different a point may be that reuses light.
    pub error_bound: f64,
    /// Share of its colour that gathered light loses.
    pub gray_threshold: f64,
    /// Factor of `error_bound` in the passes before the picture.
    pub low_error_factor: f64,
    /// No ray brings more than this, if positive.
    pub max_sample: f64,
    /// Largest and smallest radius of reuse, as parts of the distance from the camera.
    pub reuse: [f64; 2],
    /// Whether rays of a hemisphere see media, fog and rainbows.
    pub media: bool,
    /// How many gathered points must be near by.
    pub nearest_count: usize,
    /// Whether bumps turn the hemisphere.
    pub normal: bool,
    /// Width of a pixel of the first and last pass, as parts of the picture's width.
    pub pretrace: [f64; 2],
    /// How often light is thrown on.
    pub recursion_limit: u32,
}

impl From<&graph::Radiosity> for Settings {
    fn from(r: &graph::Radiosity) -> Settings {
        Settings {
            always_sample: r.always_sample,
            brightness: r.brightness,
            count: r.count.0.max(1),
            error_bound: r.error_bound,
            gray_threshold: r.gray_threshold,
            low_error_factor: r.low_error_factor,
            max_sample: r.max_sample,
            reuse: [r.maximum_reuse, r.minimum_reuse],
            media: r.media,
            nearest_count: r.nearest_count.0.max(1),
            normal: r.normal,
            pretrace: [r.pretrace_start, r.pretrace_end],
            recursion_limit: r.recursion_limit,
        }
    }
}

impl Settings {
    /// Rays of a hemisphere for light that is seen by way of `bounces` others: half as many for each (probed).
    pub fn rays(&self, bounces: u32) -> usize {
        (self.count >> bounces.min(30)).max(1)
    }

    /// How different a point may be that reuses light thrown by way of `bounces` others (probed roughly: POV-Ray's grows
    /// with them; in POV-Ray `low_error_factor` changes it much more than here).
    pub fn bound(&self, bounces: u32) -> f64 {
        self.error_bound * f64::from(bounces.saturating_sub(1)).exp2()
    }
}
