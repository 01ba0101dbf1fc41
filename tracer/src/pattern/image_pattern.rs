//! SDL: `image_pattern { png "a.png" use_alpha }`, `material_map { ... }`: numbers from a picture.

use crate::graph::image::ImageUse;
use crate::image::ImageMapping;
use crate::math::Vec3;

/// A picture whose grey value, or transparency, is a pattern.
#[derive(Clone, Debug)]
pub struct ImagePattern {
    /// The picture.
    pub mapping: ImageMapping,
    /// What of it counts.
    pub used: ImageUse,
}

/// The number that `material_map` takes from a picture at `p`: that of the palette entry, or the byte of red; 0 beside
/// a picture that is shown once.
pub(super) fn material_number(mapping: &ImageMapping, p: Vec3) -> f64 {
    mapping.locate(p).map_or(0.0, |place| {
        if mapping.has_palette() {
            mapping.index(place).floor()
        } else {
            (mapping.texel(place).rgb.r * 255.0).floor().max(0.0)
        }
    })
}

impl ImagePattern {
    /// The value at `p`; 0 beside a picture that is shown once.
    pub fn value(&self, p: Vec3) -> f64 {
        let Some(place) = self.mapping.locate(p) else { return 0.0 };
        let texel = self.mapping.texel(place);
        match self.used {
            ImageUse::Alpha if self.mapping.has_transparency() => texel.transparency,
            // Without an alpha channel the first of the others is looked at.
            ImageUse::Alpha => texel.rgb.r,
            _ => texel.rgb.gray(),
        }
    }
}
