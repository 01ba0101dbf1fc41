//! SDL: `rgb <r,g,b>`, `rgbft <r,g,b,filter,transmit>`: linear colour with two kinds of transparency.

use std::ops::{Add, AddAssign, Mul};

/// Linear red, green, blue; unbounded above, may be negative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb {
    /// Red.
    pub r: f64,
    /// Green.
    pub g: f64,
    /// Blue.
    pub b: f64,
}

/// A pigment's colour: light passing through is multiplied by the colour (`filter`) or left alone (`transmit`).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgbft {
    /// The colour.
    pub rgb: Rgb,
    /// Share of light filtered through the colour.
    pub filter: f64,
    /// Share of light let through unchanged.
    pub transmit: f64,
}

/// Shorthand constructor.
pub const fn rgb(r: f64, g: f64, b: f64) -> Rgb {
    Rgb { r, g, b }
}

impl Rgb {
    /// No light.
    pub const BLACK: Rgb = rgb(0.0, 0.0, 0.0);
    /// All ones.
    pub const WHITE: Rgb = rgb(1.0, 1.0, 1.0);

    /// POV-Ray's grey value: 0.297 r + 0.589 g + 0.114 b (probed).
    pub fn gray(self) -> f64 {
        0.297 * self.r + 0.589 * self.g + 0.114 * self.b
    }

    /// Component-wise product.
    pub fn mul_each(self, o: Rgb) -> Rgb {
        rgb(self.r * o.r, self.g * o.g, self.b * o.b)
    }

    /// Each component through `f`.
    pub fn map(self, f: impl Fn(f64) -> f64) -> Rgb {
        rgb(f(self.r), f(self.g), f(self.b))
    }

    /// The largest component.
    pub fn max_element(self) -> f64 {
        self.r.max(self.g).max(self.b)
    }
}

impl Rgbft {
    /// The share of light that neither filter nor transmit lets pass.
    pub fn opacity(&self) -> f64 {
        1.0 - self.filter - self.transmit
    }

    /// The share of light that passes.
    pub fn passing(&self) -> Rgb {
        self.rgb * self.filter + Rgb::WHITE * self.transmit
    }

    /// `a * (1 - t) + b * t` on all five components.
    pub fn lerp(a: &Rgbft, b: &Rgbft, t: f64) -> Rgbft {
        Rgbft {
            rgb: a.rgb * (1.0 - t) + b.rgb * t,
            filter: a.filter * (1.0 - t) + b.filter * t,
            transmit: a.transmit * (1.0 - t) + b.transmit * t,
        }
    }
}

impl From<[f64; 5]> for Rgbft {
    fn from([r, g, b, filter, transmit]: [f64; 5]) -> Rgbft {
        Rgbft { rgb: rgb(r, g, b), filter, transmit }
    }
}

impl From<[f64; 3]> for Rgb {
    fn from([r, g, b]: [f64; 3]) -> Rgb {
        rgb(r, g, b)
    }
}

impl Add for Rgb {
    type Output = Rgb;
    fn add(self, o: Rgb) -> Rgb {
        rgb(self.r + o.r, self.g + o.g, self.b + o.b)
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, o: Rgb) {
        *self = *self + o;
    }
}

impl Mul<f64> for Rgb {
    type Output = Rgb;
    fn mul(self, s: f64) -> Rgb {
        rgb(self.r * s, self.g * s, self.b * s)
    }
}
