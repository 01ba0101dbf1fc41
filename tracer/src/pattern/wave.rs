//! SDL: `frequency F phase F ramp_wave | triangle_wave | sine_wave | scallop_wave | cubic_wave | poly_wave F`.

use std::f64::consts::{PI, TAU};

/// The wrap-around of a value times frequency plus phase: slightly above 1, so that a value of 1 stays 1.
const PERIOD: f64 = 1.00001;

/// How one period of a value runs from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Wave {
    /// Straight up.
    #[default]
    Ramp,
    /// Up and down again.
    Triangle,
    /// A sine, from one half up.
    Sine,
    /// Half a sine.
    Scallop,
    /// An s-curve.
    Cubic,
    /// A power with this exponent.
    Poly(f64),
}

/// `2v` up to one half, then back down; repeats.
pub fn triangle(v: f64) -> f64 {
    let offset = v - v.floor();
    2.0 * if offset >= 0.5 { 1.0 - offset } else { offset }
}

/// The part after the point of a value above 1.
pub(super) fn folded(v: f64) -> f64 {
    if v > 1.0 {
        v % 1.0
    } else {
        v
    }
}

/// A sine with period 1.
pub fn cycloidal(v: f64) -> f64 {
    ((v - v.floor()) * TAU).sin()
}

impl Wave {
    /// Shapes a value in 0..=1.
    #[inline]
    pub fn shape(self, v: f64) -> f64 {
        match self {
            Wave::Ramp => v,
            Wave::Triangle => triangle(v),
            Wave::Sine => 0.5 * (1.0 + cycloidal(v)),
            Wave::Scallop => (v * PI).sin().abs(),
            Wave::Cubic => v * v * (3.0 - 2.0 * v),
            Wave::Poly(exponent) => v.powf(exponent),
        }
    }
}

/// Frequency, phase and wave of one pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Waveform {
    /// Factor of the value; 0 means that neither it nor the phase is applied.
    pub frequency: f64,
    /// Added after the frequency.
    pub phase: f64,
    /// Shape of a period.
    pub wave: Wave,
}

impl Default for Waveform {
    fn default() -> Waveform {
        Waveform::plain(Wave::Ramp)
    }
}

impl Waveform {
    /// Leaves values as they are, even those above 1.
    pub const UNCHANGED: Waveform = Waveform { frequency: 0.0, phase: 0.0, wave: Wave::Ramp };

    /// Frequency 1, phase 0.
    pub fn plain(wave: Wave) -> Waveform {
        Waveform { frequency: 1.0, phase: 0.0, wave }
    }

    /// POV-Ray keeps the numbers in single precision, and so the values come out.
    pub fn new(frequency: f64, phase: f64, wave: Wave) -> Waveform {
        let single = |v: f64| f64::from(v as f32);
        let wave = if let Wave::Poly(e) = wave { Wave::Poly(single(e)) } else { wave };
        Waveform { frequency: single(frequency), phase: single(phase), wave }
    }

    /// The shaped value of a raw one.
    #[inline]
    pub fn shape(&self, raw: f64) -> f64 {
        let mut v = raw;
        if self.frequency != 0.0 {
            v = (v * self.frequency + self.phase) % PERIOD;
        }
        if v < 0.0 {
            v -= v.floor();
        }
        self.wave.shape(v)
    }
}
