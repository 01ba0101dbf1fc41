//! SDL: `image_map { png "a.png" map_type 1 once interpolate 2 }`: a picture laid out in space.

mod bump_map;
mod interpolation;
mod mapping;

pub(crate) use interpolation::cubic_weights;
pub use interpolation::Interpolation;
pub use mapping::MapType;

use crate::color::Rgb;
use crate::graph::image as graph;
use crate::graph::Shared;
use crate::math::Vec3;

/// A picture with its place in space; copies share the pixels.
#[derive(Clone, Debug)]
pub struct ImageMapping {
    image: Shared<graph::Image>,
    map_type: MapType,
    once: bool,
    interpolation: Interpolation,
    repeat: [f64; 2],
    offset: [f64; 2],
}

/// What a picture shows at a place.
#[derive(Clone, Copy, Debug, Default)]
pub struct Texel {
    /// Its colour.
    pub rgb: Rgb,
    /// How far it is see-through by its alpha channel.
    pub transparency: f64,
}

impl From<&graph::ImageMapping> for ImageMapping {
    fn from(node: &graph::ImageMapping) -> ImageMapping {
        ImageMapping {
            image: node.image.clone(),
            map_type: MapType::from_number(node.map_type),
            once: node.once,
            interpolation: Interpolation::from_number(node.interpolate),
            repeat: node.repeat,
            offset: node.offset,
        }
    }
}

impl ImageMapping {
    /// Whether it covers all of space without a transparent pixel.
    pub fn is_opaque(&self) -> bool {
        let alpha = self.image.alpha.as_deref().unwrap_or(&[]);
        !self.once && alpha.iter().all(|&a| a >= 1.0)
    }

    /// Whether pixels are numbers of palette entries.
    pub fn has_palette(&self) -> bool {
        self.image.index.is_some()
    }

    /// Whether pixels may be transparent: those of a palette, too, where none is.
    pub fn has_transparency(&self) -> bool {
        self.image.alpha.is_some() || self.image.index.is_some()
    }

    /// The place of `p` in the picture: columns from the left, rows from the bottom. None is outside of a
    /// picture that is shown once.
    pub fn locate(&self, p: Vec3) -> Option<[f64; 2]> {
        let place = self.map_type.unit_square(p)?;
        let size = [self.image.width, self.image.height];
        let mut found = [0.0; 2];
        for axis in 0..2 {
            let share = place[axis] * self.repeat[axis] - self.offset[axis];
            if self.once && self.map_type.repeats()[axis] && !(0.0..=1.0).contains(&share) {
                return None;
            }
            found[axis] = wrapped(share) * size[axis] as f64;
        }
        Some(found)
    }

    /// Calls `visit(pixel, weight)` for the pixels seen at a place.
    #[inline]
    fn pixels(&self, [column, row]: [f64; 2], mut visit: impl FnMut(usize, f64)) {
        let (width, height) = (self.image.width, self.image.height);
        self.interpolation.cells(column, row, |column, row, weight| {
            let column = fold(column, width, self.once);
            let from_bottom = fold(row, height, self.once);
            visit((height - 1 - from_bottom) * width + column, weight);
        });
    }

    /// The colour at a place.
    pub fn texel(&self, place: [f64; 2]) -> Texel {
        let mut texel = Texel::default();
        self.pixels(place, |pixel, weight| {
            texel.rgb += Rgb::from(self.image.color[pixel].map(f64::from)) * weight;
            if let Some(alpha) = &self.image.alpha {
                texel.transparency += (1.0 - f64::from(alpha[pixel])) * weight;
            }
        });
        texel
    }

    /// The number of the palette entry at a place; 0 without a palette.
    pub fn index(&self, place: [f64; 2]) -> f64 {
        self.by_palette(place, |index| index as f64)
    }

    /// The mean of a number that belongs to each palette entry.
    pub fn by_palette(&self, place: [f64; 2], number: impl Fn(usize) -> f64) -> f64 {
        let Some(index) = &self.image.index else { return 0.0 };
        let mut sum = 0.0;
        self.pixels(place, |pixel, weight| sum += number(usize::from(index[pixel])) * weight);
        sum
    }
}

/// The fraction, below 1 even where that of a negative number is rounded up.
fn wrapped(v: f64) -> f64 {
    let fraction = v - v.floor();
    if fraction < 1.0 {
        fraction
    } else {
        0.0
    }
}

/// Brings the number of a row or column into the picture: repeated, or the nearest inside.
#[inline]
fn fold(i: i64, size: usize, once: bool) -> usize {
    let size = size as i64;
    (if once { i.clamp(0, size - 1) } else { i.rem_euclid(size) }) as usize
}
