//! SDL: `bozo turbulence 0.5 frequency 2 sine_wave scale 3`: a number at every point of space.
//!
//! A point passes the modifiers' warps, the pattern gives a raw value, the waveform shapes it.

mod blocks;
mod cells;
mod crackle;
mod kind;
mod modifiers;
mod noisy;
mod ripples;
mod shells;
mod spirals;
mod surface;
mod wave;

pub use blocks::Brick;
pub use crackle::Crackle;
pub use kind::PatternKind;
pub use modifiers::{Modifiers, TurbulenceModifier};
pub use ripples::WaveSources;
pub use surface::{Slope, SurfaceContext};
pub use wave::{Wave, Waveform};

use crate::math::Vec3;

/// A pattern with its modifiers.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// What is evaluated.
    pub kind: PatternKind,
    /// How the point reaches it and how the value is shaped.
    pub modifiers: Modifiers,
}

impl Pattern {
    /// A pattern without modifiers, shaped by its own waveform.
    pub fn plain(kind: PatternKind) -> Pattern {
        let modifiers = Modifiers { waveform: Waveform::plain(kind.own_wave()), ..Modifiers::default() };
        Pattern { kind, modifiers }
    }

    /// The shaped value at `p`: 0..=1 for most patterns, the number of the block for block patterns.
    #[inline]
    pub fn value(&self, p: Vec3, surface: &SurfaceContext) -> f64 {
        let raw = self.raw(p, surface);
        // The numbers of blocks stay as they are, unless a frequency or phase is asked for.
        if self.kind.is_blocks() && self.modifiers.waveform.is_plain() {
            raw
        } else {
            self.modifiers.waveform.shape(raw)
        }
    }

    /// The value before frequency, phase and wave.
    #[inline]
    pub fn raw(&self, p: Vec3, surface: &SurfaceContext) -> f64 {
        let q = self.modifiers.locate(p, surface, self.kind.treats_turbulence());
        self.kind.value(q, &self.modifiers, surface)
    }
}
