//! SDL: `finish { subsurface { translucency C } }`: light that enters a surface and leaves it elsewhere.
//!
//! Jensen, Marschner, Levoy and Hanrahan, "A practical model for subsurface light transport" (2001): light scattered
//! many times as from a [`Dipole`] of one lamp below the surface and one above it, besides light scattered once. The
//! colour says how much light comes back in all, the translucency how far light goes between two scatterings.

mod dipole;
mod sphere;

pub use dipole::Dipole;
pub use sphere::directions;

use crate::color::Rgb;
use crate::graph::finish::Subsurface;

/// A finish that light gets under.
#[derive(Clone, Debug)]
pub struct Translucent {
    /// How often light is scattered per unit of length, by channel.
    scattering: Rgb,
    /// The share of the pigment's colour that comes back.
    diffuse: f64,
}

impl Translucent {
    /// The finish's `diffuse` and translucency, in a scene of so many millimetres per unit.
    pub fn new(subsurface: &Subsurface, diffuse: f64, mm_per_unit: f64) -> Translucent {
        Translucent { scattering: subsurface.translucency.map(|t| mm_per_unit / t), diffuse }
    }

    /// What light meets below a surface of that colour and relative density, by channel.
    pub fn channels(&self, pigment: Rgb, ior: f64) -> [Dipole; 3] {
        let [colors, scattering] = [pigment, self.scattering].map(|c| [c.r, c.g, c.b]);
        std::array::from_fn(|i| Dipole::new(colors[i] * self.diffuse, scattering[i], ior))
    }
}

/// How subsurface light is sampled.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Points where light enters that is scattered many times.
    pub many: usize,
    /// Points where light is scattered once.
    pub once: usize,
}
