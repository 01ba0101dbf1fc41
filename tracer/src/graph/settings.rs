//! SDL: `global_settings { ... }` and what the caller decides: mirror of `minipov.tracer.settings`.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::values::keywords;
use crate::color::Rgb;

keywords!(
    /// The procedure that finds the nearest hit.
    Accelerator { Linear = "linear", Spheres = "spheres", Hierarchy = "hierarchy", Grid = "grid", Octree = "octree" }
);

/// `radiosity { ... }` of `global_settings`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Radiosity {
    pub adc_bailout: f64,
    pub always_sample: bool,
    pub brightness: f64,
    pub count: (usize, usize),
    pub error_bound: f64,
    pub gray_threshold: f64,
    pub low_error_factor: f64,
    pub max_sample: f64,
    pub maximum_reuse: f64,
    pub minimum_reuse: f64,
    pub nearest_count: (usize, usize),
    pub normal: bool,
    pub media: bool,
    pub subsurface: bool,
    pub brilliance: bool,
    pub pretrace_start: f64,
    pub pretrace_end: f64,
    pub recursion_limit: u32,
}

/// `photons { ... }` of `global_settings`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Photons {
    pub spacing: Option<f64>,
    pub count: Option<usize>,
    pub gather: (usize, usize),
    pub media: (usize, f64),
    pub jitter: f64,
    pub max_trace_level: Option<u32>,
    pub adc_bailout: Option<f64>,
    pub autostop: f64,
    pub expand_thresholds: (f64, usize),
    pub radius: (Option<f64>, f64, Option<f64>, f64),
    pub save_file: Option<String>,
    pub load_file: Option<String>,
}

/// `subsurface { ... }` of `global_settings`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct SubsurfaceSettings {
    pub samples: (usize, usize),
    pub radiosity: bool,
}

/// `global_settings { ... }`; gamma is not the core's business.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct GlobalSettings {
    pub adc_bailout: f64,
    pub ambient_light: Rgb,
    pub irid_wavelength: Rgb,
    pub max_trace_level: u32,
    pub mm_per_unit: f64,
    pub noise_generator: u8,
    pub number_of_waves: u32,
    pub radiosity: Option<Radiosity>,
    pub photons: Option<Photons>,
    pub subsurface: Option<SubsurfaceSettings>,
}

/// `+A threshold +AM method +R depth +J jitter +AG gamma`.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct Antialiasing {
    pub method: u8,
    pub threshold: f64,
    pub depth: u32,
    pub jitter: f64,
    pub gamma: f64,
}

/// What the caller decides; rows and columns are 0-based, ends exclusive.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
pub struct RenderSettings {
    pub width: usize,
    pub height: usize,
    pub rows: Option<(usize, usize)>,
    pub columns: Option<(usize, usize)>,
    pub antialiasing: Option<Antialiasing>,
    pub quality: u8,
    pub threads: usize,
    pub alpha: bool,
    pub accelerator: Accelerator,
}
