//! SDL: `ripples`, `waves`, `number_of_waves I`: sums of concentric waves around random centres.

use std::sync::Arc;

use super::wave::cycloidal;
use super::Waveform;
use crate::math::{vec3, Vec3};
use crate::noise::{vector_noise, Lcg};

/// The frequencies are drawn from here.
const SEED: u32 = -560_851_967_i32 as u32;

/// One centre.
#[derive(Clone, Copy, Debug)]
pub struct WaveSource {
    /// On the unit sphere.
    pub center: Vec3,
    /// Frequency of `waves`.
    pub frequency: f64,
}

/// The centres that all `ripples` and `waves` of a scene share.
#[derive(Clone, Debug)]
pub struct WaveSources(Arc<[WaveSource]>);

impl WaveSources {
    /// For `number_of_waves count`.
    pub fn new(count: usize) -> WaveSources {
        let mut random = Lcg(SEED);
        let source = |i| WaveSource {
            center: vector_noise(vec3(i as f64, 0.0, 0.0)).normalized(),
            frequency: f64::from(random.next_15_bits()) * 0.000030518509476 + 0.01,
        };
        WaveSources((0..count).map(source).collect())
    }

    /// The direction away from each centre, by its share of what is asked for.
    fn directions(&self, p: Vec3, height: impl Fn(f64, f64) -> f64) -> Vec3 {
        let count = self.0.len() as f64;
        let away = |s: &WaveSource| {
            let way = p - s.center;
            let distance = if way == Vec3::ZERO { 1.0 } else { way.length() };
            way * (height(distance, s.frequency) / distance / count)
        };
        self.0.iter().map(away).fold(Vec3::ZERO, |sum, v| sum + v)
    }

    pub(crate) fn ripple_bump(&self, p: Vec3, waveform: &Waveform) -> Vec3 {
        self.directions(p, |distance, _| cycloidal(distance * waveform.frequency + waveform.phase))
    }

    pub(crate) fn wave_bump(&self, p: Vec3, waveform: &Waveform) -> Vec3 {
        self.directions(p, |distance, frequency| {
            cycloidal(distance * frequency * waveform.frequency + waveform.phase) / frequency
        })
    }

    fn sum(&self, p: Vec3, term: impl Fn(f64, f64) -> f64) -> f64 {
        let distance = |s: &WaveSource| match (p - s.center).length() {
            0.0 => 1.0,
            d => d,
        };
        self.0.iter().map(|s| term(distance(s), s.frequency)).sum::<f64>() / self.0.len() as f64
    }

    pub(super) fn ripples(&self, p: Vec3, waveform: &Waveform) -> f64 {
        let wave = |distance, _| cycloidal(distance * waveform.frequency + waveform.phase);
        0.5 * (1.0 + self.sum(p, wave))
    }

    pub(super) fn waves(&self, p: Vec3, waveform: &Waveform) -> f64 {
        let wave = |distance: f64, frequency: f64| {
            cycloidal(distance * frequency * waveform.frequency + waveform.phase) / frequency
        };
        0.2 * (2.5 + self.sum(p, wave))
    }
}
