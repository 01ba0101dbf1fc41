//! SDL: `bozo turbulence 0.5 frequency 2 sine_wave scale 3`: a number at every point of space.
//!
//! A point passes the modifiers' warps, the pattern gives a raw value, the waveform shapes it.

mod blocks;
mod build;
mod cells;
mod crackle;
mod density_file;
mod facets;
mod fractal;
mod image_pattern;
mod kind;
mod modifiers;
mod noisy;
mod ripples;
mod shells;
mod spirals;
mod surface;
mod tiling;
mod wave;

pub use blocks::Brick;
pub(crate) use cells::point_in_cube;
pub use crackle::Crackle;
pub use density_file::DensityFile;
pub use facets::Facets;
pub use fractal::Fractal;
pub use image_pattern::ImagePattern;
pub use kind::PatternKind;
pub use modifiers::{Modifiers, TurbulenceModifier};
pub use ripples::WaveSources;
pub(crate) use shells::quilted_bump;
pub use surface::{Slope, SurfaceContext};
pub use tiling::Tiling;
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
        let modifiers = Modifiers { waveform: kind.own_waveform(), ..Modifiers::default() };
        Pattern { kind, modifiers }
    }

    /// The shaped value at `p`: 0..=1 for most patterns, the number of the block for block patterns.
    #[inline]
    pub fn value(&self, p: Vec3, surface: &SurfaceContext) -> f64 {
        self.value_and_place(p, surface).0
    }

    /// The shaped value, and the point in the pattern's own space, where its inner pigments or normals are asked.
    #[inline]
    pub fn value_and_place(&self, p: Vec3, surface: &SurfaceContext) -> (f64, Vec3) {
        let place = self.place(p, surface);
        (self.value_in_place(place, surface), place)
    }

    /// The point in the pattern's own space.
    #[inline]
    pub fn place(&self, p: Vec3, surface: &SurfaceContext) -> Vec3 {
        self.modifiers.locate(p, surface, self.kind.treats_turbulence())
    }

    /// The shaped value at a point of the pattern's own space.
    #[inline]
    pub fn value_in_place(&self, place: Vec3, surface: &SurfaceContext) -> f64 {
        self.modifiers.waveform.shape(self.kind.value(place, &self.modifiers, surface))
    }

    /// Whether its values are whole numbers that pick from a list; those that a frequency or wave has changed mix the
    /// list's neighbours.
    pub fn picks(&self) -> bool {
        let Waveform { frequency, wave, .. } = self.modifiers.waveform;
        frequency == 0.0 && wave == Wave::Ramp
    }

    /// The number of the block at `p`, and the point in the pattern's own space.
    #[inline]
    pub fn block_and_place(&self, p: Vec3, surface: &SurfaceContext) -> (usize, Vec3) {
        let place = self.modifiers.locate(p, surface, false);
        (self.kind.value(place, &self.modifiers, surface) as usize, place)
    }
}
