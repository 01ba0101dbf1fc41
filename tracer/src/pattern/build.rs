//! From the scene graph's patterns to those that are evaluated.

use std::sync::Arc;

use super::{
    Brick, Crackle, DensityFile, Facets, Fractal, ImagePattern, Modifiers, Pattern, PatternKind, Slope,
    Tiling, TurbulenceModifier, Wave, Waveform,
};
use crate::geometry::Questioned;
use crate::graph::pattern as graph;
use crate::graph::pattern::{SimpleKind, WaveKind};
use crate::graph::texture::MaterialMap;
use crate::image::ImageMapping;
use crate::noise::NoiseGenerator;
use crate::texture::Builder;
use crate::warp::Warp;

/// As precise as POV-Ray keeps the parameters of some patterns.
fn single(v: f64) -> f64 {
    f64::from(v as f32)
}

fn image_pattern(node: &crate::graph::image::ImageMapping) -> Box<ImagePattern> {
    Box::new(ImagePattern { mapping: ImageMapping::from(node), used: node.used })
}

impl Builder {
    /// A pattern with its modifiers; None for one that cannot be evaluated yet, which is noted.
    pub fn pattern(&mut self, node: &graph::Pattern, modifiers: &graph::PatternModifiers) -> Option<Pattern> {
        let kind = self.pattern_kind(node)?;
        let modifiers = self.modifiers(modifiers, &kind.own_waveform());
        Some(Pattern { kind, modifiers })
    }

    /// The modifiers of a pattern that has `own` for what is not said.
    pub(crate) fn modifiers(&mut self, node: &graph::PatternModifiers, own: &Waveform) -> Modifiers {
        let wave = match node.wave {
            None => own.wave,
            Some(WaveKind::Ramp) => Wave::Ramp,
            Some(WaveKind::Triangle) => Wave::Triangle,
            Some(WaveKind::Sine) => Wave::Sine,
            Some(WaveKind::Scallop) => Wave::Scallop,
            Some(WaveKind::Cubic) => Wave::Cubic,
            Some(WaveKind::Poly) => Wave::Poly(node.poly_exponent),
        };
        self.uses_uv |= node.uv_mapping;
        Modifiers {
            warps: node.warps.iter().map(Warp::from).collect(),
            turbulence: node.turbulence.as_ref().map(TurbulenceModifier::from),
            waveform: Waveform::new(node.frequency.unwrap_or(own.frequency), node.phase, wave),
            noise_generator: node.noise_generator.map_or(self.noise_generator, NoiseGenerator::from_number),
            uv_mapping: node.uv_mapping,
        }
    }

    /// The numbers of a `material_map` as a block pattern.
    pub fn material_pattern(&mut self, node: &MaterialMap) -> Pattern {
        let kind = PatternKind::Material(Box::new(ImageMapping::from(&node.mapping)));
        let modifiers = self.modifiers(&node.modifiers, &kind.own_waveform());
        Pattern { kind, modifiers }
    }

    fn pattern_kind(&mut self, node: &graph::Pattern) -> Option<PatternKind> {
        Some(match node {
            graph::Pattern::Simple(simple) => self.simple_kind(simple.name),
            graph::Pattern::Agate(agate) => PatternKind::Agate { agate_turb: single(agate.agate_turb) },
            graph::Pattern::Brick(brick) => {
                PatternKind::Brick(Brick { brick_size: brick.brick_size, mortar: brick.mortar })
            }
            graph::Pattern::Crackle(c) => PatternKind::Crackle(Crackle {
                form: c.form,
                metric: c.metric,
                offset: c.offset,
                solid: c.solid,
                repeat: <[f64; 3]>::from(c.repeat).map(|v| v.max(0.0) as i64),
            }),
            graph::Pattern::Gradient(gradient) => PatternKind::Gradient(gradient.direction.normalized()),
            graph::Pattern::Quilted(quilted) => PatternKind::Quilted {
                control0: single(quilted.control0),
                control1: single(quilted.control1),
            },
            graph::Pattern::Slope(slope) => PatternKind::Slope(Slope {
                direction: slope.direction,
                low: slope.low,
                high: slope.high,
                point_at: slope.point_at,
                altitude: slope.altitude.map(|v| (v, slope.altitude_low, slope.altitude_high)),
            }),
            graph::Pattern::Spiral(spiral) => match spiral.kind {
                1 => PatternKind::Spiral1 { arms: spiral.arms as f64 },
                _ => PatternKind::Spiral2 { arms: spiral.arms as f64 },
            },
            graph::Pattern::DensityFile(file) => PatternKind::DensityFile(DensityFile::new(file)),
            graph::Pattern::Function(pattern) => PatternKind::Function(self.function(&pattern.function)?),
            graph::Pattern::Facets(facets) => PatternKind::Facets(Facets {
                coords: single(facets.coords),
                size: single(facets.size),
                metric: single(facets.metric),
            }),
            graph::Pattern::ImageMap(_) => return self.no_pattern("image_map"),
            graph::Pattern::ImagePattern(pattern) => PatternKind::Image(image_pattern(&pattern.mapping)),
            graph::Pattern::BumpMap(bumps) => PatternKind::BumpMap(image_pattern(&bumps.mapping)),
            graph::Pattern::Fractal(fractal) => PatternKind::Fractal(Box::new(Fractal::from(fractal))),
            graph::Pattern::Object(pattern) => {
                PatternKind::Object(Arc::new(Questioned::new(&pattern.object)))
            }
            graph::Pattern::Pavement(_) => return self.no_pattern("pavement"),
            graph::Pattern::PigmentPattern(inner) => {
                PatternKind::Pigment(Box::new(self.pigment(&inner.pigment)))
            }
            graph::Pattern::Potential(_) => return self.no_pattern("potential"),
            graph::Pattern::Tiling(graph::Tiling { number }) => match Tiling::new(*number) {
                Some(tiling) => PatternKind::Tiling(Arc::new(tiling)),
                None => return self.no_pattern(&format!("tiling {number}")),
            },
        })
    }

    fn no_pattern(&mut self, feature: &str) -> Option<PatternKind> {
        self.leave_out(feature);
        None
    }

    fn simple_kind(&self, kind: SimpleKind) -> PatternKind {
        match kind {
            SimpleKind::Aoi => PatternKind::Aoi,
            SimpleKind::Average => PatternKind::Average,
            SimpleKind::Boxed => PatternKind::Boxed,
            SimpleKind::Bozo => PatternKind::Bozo,
            SimpleKind::Bumps => PatternKind::Bumps,
            SimpleKind::Spotted => PatternKind::Spotted,
            SimpleKind::Cells => PatternKind::Cells,
            SimpleKind::Checker => PatternKind::Checker,
            SimpleKind::Cubic => PatternKind::Cubic,
            SimpleKind::Cylindrical => PatternKind::Cylindrical,
            SimpleKind::Dents => PatternKind::Dents,
            SimpleKind::Granite => PatternKind::Granite,
            SimpleKind::Hexagon => PatternKind::Hexagon,
            SimpleKind::Leopard => PatternKind::Leopard,
            SimpleKind::Marble => PatternKind::Marble,
            SimpleKind::Onion => PatternKind::Onion,
            SimpleKind::Planar => PatternKind::Planar,
            SimpleKind::Radial => PatternKind::Radial,
            SimpleKind::Ripples => PatternKind::Ripples(self.wave_sources.clone()),
            SimpleKind::Spherical => PatternKind::Spherical,
            SimpleKind::Square => PatternKind::Square,
            SimpleKind::Triangular => PatternKind::Triangular,
            SimpleKind::Waves => PatternKind::Waves(self.wave_sources.clone()),
            SimpleKind::Wood => PatternKind::Wood,
            SimpleKind::Wrinkles => PatternKind::Wrinkles,
        }
    }
}
