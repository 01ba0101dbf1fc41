//! SDL: `image_map { png "a.png" filter 1, 0.5 transmit all 0.2 }`: a picture as a pigment.

use crate::color::{Rgb, Rgbft};
use crate::graph::pattern as graph;
use crate::image::ImageMapping;
use crate::math::Vec3;

/// A picture whose colours let light through.
#[derive(Clone, Debug)]
pub struct ImageMap {
    mapping: ImageMapping,
    filter: Passing,
    transmit: Passing,
}

/// How much light passes, by palette entry or everywhere.
#[derive(Clone, Debug)]
enum Passing {
    All(f64),
    Palette(Vec<f64>),
}

/// What is seen beside a picture that is shown once.
const OUTSIDE: Rgbft = Rgbft { rgb: Rgb::WHITE, filter: 0.0, transmit: 1.0 };

impl ImageMap {
    /// A picture with the `filter` and `transmit` items that belong to it, in source order.
    pub fn new(node: &graph::ImageMap) -> ImageMap {
        let palette = node.mapping.image.index.as_ref().map(|_| node.mapping.image.palette_size);
        ImageMap {
            mapping: ImageMapping::from(&node.mapping),
            filter: Passing::new(&node.filter, palette),
            transmit: Passing::new(&node.transmit, palette),
        }
    }

    /// Whether nothing is seen through it anywhere.
    pub fn is_opaque(&self) -> bool {
        self.mapping.is_opaque() && self.filter.is_nothing() && self.transmit.is_nothing()
    }

    /// The colour at `p`.
    pub fn color(&self, p: Vec3) -> Rgbft {
        let Some(place) = self.mapping.locate(p) else { return OUTSIDE };
        let texel = self.mapping.texel(place);
        let passing = |passing: &Passing| match passing {
            Passing::All(share) => *share,
            Passing::Palette(shares) => {
                self.mapping.by_palette(place, |i| shares.get(i).copied().unwrap_or(0.0))
            }
        };
        Rgbft {
            rgb: texel.rgb,
            filter: passing(&self.filter),
            transmit: passing(&self.transmit) + texel.transparency,
        }
    }
}

impl Passing {
    fn new(items: &[(Option<usize>, f64)], palette: Option<usize>) -> Passing {
        let single = |v: f64| f64::from(v as f32);
        let Some(size) = palette.filter(|_| items.iter().any(|item| item.0.is_some())) else {
            return Passing::All(
                items.iter().rev().find(|item| item.0.is_none()).map_or(0.0, |item| single(item.1)),
            );
        };
        let mut shares = vec![0.0; size];
        for &(index, share) in items {
            match index {
                None => shares.fill(single(share)),
                Some(index) if index < size => shares[index] = single(share),
                Some(_) => (),
            }
        }
        Passing::Palette(shares)
    }

    fn is_nothing(&self) -> bool {
        match self {
            Passing::All(share) => *share == 0.0,
            Passing::Palette(shares) => shares.iter().all(|&share| share == 0.0),
        }
    }
}
