//! SDL: `density { spherical density_map { [0 rgb 0] [1 granite] } }`: a factor at every point.

use std::sync::Arc;

use crate::color::{Rgb, Rgbft};
use crate::graph::interior::{Density, DensityBlend};
use crate::pattern::PatternKind;
use crate::texture::{BlendMap, Builder, Pigment};

impl Builder {
    /// A density looks its colours up as a pigment does; without a map in those that pigments have by default.
    pub(super) fn density(&mut self, node: &Density) -> Pigment {
        let solid = |rgb: Rgb| Rgbft { rgb, ..Rgbft::default() };
        let Some(kind) = &node.pattern else { return Pigment::Solid(solid(node.color)) };
        let Some(pattern) = self.pattern(kind, &node.modifiers) else {
            return Pigment::Solid(solid(node.color));
        };
        match &node.blend {
            None => Pigment::with_default_map(pattern),
            Some(DensityBlend::Colors(map)) => Pigment::Colors(Arc::new((pattern, self.color_map(map)))),
            Some(DensityBlend::Map(map)) => {
                let entries =
                    map.entries.iter().map(|(value, inner)| (*value, self.density(inner))).collect();
                match pattern.kind {
                    PatternKind::Average => Pigment::Average(Arc::new((pattern.modifiers, entries))),
                    _ => Pigment::Pigments(Arc::new((pattern, BlendMap::new(entries)))),
                }
            }
            Some(DensityBlend::List(list)) => {
                let densities = list.densities.iter().map(|inner| self.density(inner)).collect();
                Pigment::blocks(pattern, densities)
            }
        }
    }
}
