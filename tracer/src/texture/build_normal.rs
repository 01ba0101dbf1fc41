//! From the scene graph's normals to those that are evaluated.

use std::sync::Arc;

use super::bumps::{BumpKind, Bumps};
use super::color_map::BlendMap;
use super::normal::{Gradient, Normal, NormalScale};
use super::slope_map::SlopeMap;
use super::Builder;
use crate::graph::normal as graph;
use crate::graph::Shared;
use crate::pattern::{Pattern, PatternKind};

/// POV-Ray keeps the numbers of normals in single precision.
fn single(v: f64) -> f64 {
    f64::from(v as f32)
}

impl Builder {
    /// A normal of the graph, built when first met; one that cannot be evaluated leaves surfaces smooth, and is noted.
    pub fn normal(&mut self, node: &Shared<graph::Normal>) -> Normal {
        self.normal_within(node, NormalScale::Grows)
    }

    /// `no_bump_scale` of a normal holds for those in it.
    fn normal_within(&mut self, node: &Shared<graph::Normal>, outer: NormalScale) -> Normal {
        let scale = if node.no_bump_scale { NormalScale::Stays } else { outer };
        let key = (node.address(), scale);
        if let Some(known) = self.normals.get(&key) {
            return known.clone();
        }
        let built = self.build_normal(node, scale).unwrap_or(Normal::Smooth);
        self.normals.insert(key, built.clone());
        built
    }

    fn build_normal(&mut self, node: &graph::Normal, scale: NormalScale) -> Option<Normal> {
        let pattern = self.pattern(node.pattern.as_ref()?, &node.modifiers)?;
        let slopes = match &node.blend {
            Some(graph::NormalBlend::Normals(map)) => {
                let entries = map.entries.iter().map(|(v, n)| (*v, self.normal_within(n, scale))).collect();
                return Some(match pattern.kind {
                    PatternKind::Average => Normal::Average(Arc::new((pattern.modifiers, entries, scale))),
                    _ => Normal::Normals(Arc::new((pattern, BlendMap::new(entries), scale))),
                });
            }
            Some(graph::NormalBlend::List(list)) => {
                let one = |n: &Option<_>| n.as_ref().map_or(Normal::Smooth, |n| self.normal_within(n, scale));
                let normals = list.normals.iter().map(one).collect();
                return Some(if pattern.picks() {
                    Normal::Blocks(Arc::new((pattern, normals, scale)))
                } else {
                    Normal::Normals(Arc::new((pattern, BlendMap::numbered(normals), scale)))
                });
            }
            Some(graph::NormalBlend::Slopes(map)) => Some(SlopeMap::new(map.entries.clone())),
            None => None,
        };
        let amount = single(node.amount);
        Some(match bump_kind(&pattern) {
            Some(kind) => Normal::Bumps(Arc::new((pattern.modifiers, Bumps { amount, kind }, scale))),
            None => {
                let gradient = Gradient { amount, accuracy: single(node.accuracy), slopes };
                Normal::Gradient(Arc::new((pattern, gradient, scale)))
            }
        })
    }
}

/// How a pattern turns normals, if it has a formula of its own.
fn bump_kind(pattern: &Pattern) -> Option<BumpKind> {
    let modifiers = &pattern.modifiers;
    Some(match &pattern.kind {
        PatternKind::Bumps => BumpKind::Bumps,
        PatternKind::Dents => BumpKind::Dents(modifiers.noise_generator),
        PatternKind::Wrinkles => BumpKind::Wrinkles,
        PatternKind::Ripples(sources) => BumpKind::Ripples(sources.clone(), modifiers.waveform),
        PatternKind::Waves(sources) => BumpKind::Waves(sources.clone(), modifiers.waveform),
        &PatternKind::Quilted { control0, control1 } => BumpKind::Quilted { control0, control1 },
        PatternKind::BumpMap(image) => BumpKind::BumpMap(image.clone()),
        PatternKind::Facets(facets) => BumpKind::Facets(*facets),
        _ => return None,
    })
}
