//! How layers of a texture cover each other, which has changed with the language's version (probed).

use crate::color::Rgbft;

/// What a scene's version says about layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layering {
    /// Before 3.7: `filter` takes from a layer's own light by the pigment's brightest channel only.
    Brightest,
    /// Since 3.7: a layer's own light is what neither filter nor transmit lets pass.
    Opacity,
}

impl Layering {
    /// The law of a version.
    pub fn of_version(version: f64) -> Layering {
        if version < 3.7 {
            Layering::Brightest
        } else {
            Layering::Opacity
        }
    }

    /// The share of a layer's own light that is seen.
    #[inline]
    pub fn opacity(self, color: &Rgbft) -> f64 {
        match self {
            Layering::Opacity => color.opacity(),
            Layering::Brightest => 1.0 - color.filter * color.rgb.max_element() - color.transmit,
        }
    }
}
