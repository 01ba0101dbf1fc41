//! From the scene graph's pigments, normals and patterns to those that are evaluated; shared nodes are built once.

use std::collections::HashMap;
use std::sync::Arc;

use super::color_map::BlendMap;
use super::normal::NormalScale;
use super::{ColorMap, ImageMap, Normal, Pigment};
use crate::function::Function;
use crate::graph::pattern::Pattern;
use crate::graph::pigment as graph;
use crate::graph::{Shared, Unsupported};
use crate::noise::NoiseGenerator;
use crate::pattern::{PatternKind, WaveSources, Waveform};

/// Builds the textures of one scene. Nodes are known by address: the graph must outlive the builder.
pub struct Builder {
    /// For patterns that name none.
    pub(crate) noise_generator: NoiseGenerator,
    /// For `ripples` and `waves`.
    pub(crate) wave_sources: WaveSources,
    pigments: HashMap<usize, Pigment>,
    pub(crate) functions: HashMap<usize, Option<Function>>,
    pub(super) normals: HashMap<(usize, NormalScale), Normal>,
    /// Whether anything is mapped by surface coordinates.
    pub uses_uv: bool,
    /// What was left out.
    pub unsupported: Vec<Unsupported>,
}

impl Default for Builder {
    fn default() -> Builder {
        Builder::new(2, 10)
    }
}

impl Builder {
    /// For a scene's `noise_generator` and `number_of_waves`.
    pub fn new(noise_generator: i64, number_of_waves: usize) -> Builder {
        Builder {
            noise_generator: NoiseGenerator::from_number(noise_generator),
            wave_sources: WaveSources::new(number_of_waves),
            pigments: HashMap::new(),
            functions: HashMap::new(),
            normals: HashMap::new(),
            uses_uv: false,
            unsupported: Vec::new(),
        }
    }

    /// Notes something left out, once.
    pub(crate) fn leave_out(&mut self, feature: &str) {
        let item = Unsupported { feature: feature.to_owned(), source: String::new() };
        if !self.unsupported.contains(&item) {
            self.unsupported.push(item);
        }
    }

    /// A map whose colours are mixed as they are, whatever its `blend_mode`.
    pub(crate) fn color_map(&mut self, map: &graph::ColorMap) -> ColorMap {
        if map.blend_mode != 0 {
            self.leave_out("blend_mode of a colour map");
        }
        ColorMap::from(map)
    }

    /// A pigment of the graph, built when first met.
    pub fn pigment(&mut self, node: &Shared<graph::Pigment>) -> Pigment {
        if let Some(known) = self.pigments.get(&node.address()) {
            return known.clone();
        }
        let built = self.build_pigment(node);
        self.pigments.insert(node.address(), built.clone());
        built
    }

    /// A pigment that no one shares.
    pub fn build_pigment(&mut self, node: &graph::Pigment) -> Pigment {
        if let Some(graph::PigmentBlend::UserDefined(defined)) = &node.blend {
            let functions = defined.functions.iter().map(|f| self.function(f.as_ref()?)).collect();
            let modifiers = self.modifiers(&node.modifiers, &Waveform::default());
            return Pigment::UserDefined(Arc::new((modifiers, functions)));
        }
        if let Some(Pattern::ImageMap(map)) = &node.pattern {
            let modifiers = self.modifiers(&node.modifiers, &Waveform::default());
            return Pigment::Image(Arc::new((modifiers, ImageMap::new(map))));
        }
        let Some(kind) = &node.pattern else { return Pigment::Solid(node.color) };
        let Some(pattern) = self.pattern(kind, &node.modifiers) else { return Pigment::Solid(node.color) };
        match &node.blend {
            None => Pigment::with_default_map(pattern),
            Some(graph::PigmentBlend::Colors(map)) => {
                Pigment::Colors(Arc::new((pattern, self.color_map(map))))
            }
            Some(graph::PigmentBlend::Pigments(map)) => {
                let entries = map.entries.iter().map(|(v, p)| (*v, self.pigment(p))).collect();
                if matches!(pattern.kind, PatternKind::Average) {
                    return Pigment::Average(Arc::new((pattern.modifiers, entries)));
                }
                Pigment::Pigments(Arc::new((pattern, BlendMap::new(entries))))
            }
            Some(graph::PigmentBlend::List(list)) => {
                let pigments = list.pigments.iter().map(|p| self.pigment(p)).collect();
                Pigment::blocks(pattern, pigments)
            }
            Some(graph::PigmentBlend::UserDefined(_)) => Pigment::Solid(node.color),
        }
    }
}
