//! How layers of a texture cover each other, which has changed with the language's version (probed).

use crate::color::{Rgb, Rgbft};

/// What a scene's version says about layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layering {
    /// Before 3.5: lower layers are seen through `filter` as through `transmit`.
    Plain,
    /// Before 3.7: `filter` takes from a layer's own light by the pigment's brightest channel only.
    Brightest,
    /// Since 3.7: a layer's own light is what neither filter nor transmit lets pass.
    Opacity,
}

impl Layering {
    /// The law of a version.
    pub fn of_version(version: f64) -> Layering {
        match version {
            v if v < 3.5 => Layering::Plain,
            v if v < 3.7 => Layering::Brightest,
            _ => Layering::Opacity,
        }
    }

    /// The share of a layer's own light that is seen.
    #[inline]
    pub fn opacity(self, color: &Rgbft) -> f64 {
        match self {
            Layering::Opacity => color.opacity(),
            _ => 1.0 - color.filter * color.rgb.max_element() - color.transmit,
        }
    }

    /// The share of lower layers' light that is seen through a layer, of which `passes` is the share in general.
    #[inline]
    pub fn seen_below(self, color: &Rgbft, passes: Rgb) -> Rgb {
        match self {
            Layering::Plain => Rgb::WHITE * (color.filter + color.transmit),
            _ => passes,
        }
    }
}
