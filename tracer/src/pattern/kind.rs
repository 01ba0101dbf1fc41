//! The patterns by kind, and what each says about itself.

use std::sync::Arc;

use super::image_pattern::material_number;
use super::{blocks, cells, noisy, shells, spirals, surface, wave};
use super::{
    Brick, Crackle, DensityFile, Facets, Fractal, ImagePattern, Modifiers, Slope, SurfaceContext, Tiling,
    Wave, WaveSources, Waveform,
};
use crate::function::Function;
use crate::geometry::Questioned;
use crate::image::ImageMapping;
use crate::math::Vec3;
use crate::texture::Pigment;

/// A pattern's keyword and its own parameters.
#[derive(Clone, Debug)]
#[allow(missing_docs)] // named after their keywords
pub enum PatternKind {
    Agate {
        agate_turb: f64,
    },
    Aoi,
    /// Has no value of its own: its map is a mean.
    Average,
    Boxed,
    Bozo,
    Brick(Brick),
    /// For normals only.
    BumpMap(Box<ImagePattern>),
    Bumps,
    Cells,
    Checker,
    Crackle(Crackle),
    Cubic,
    Cylindrical,
    DensityFile(DensityFile),
    Dents,
    Function(Function),
    /// For normals only.
    Facets(Facets),
    /// The direction, of length one.
    Gradient(Vec3),
    Granite,
    Fractal(Box<Fractal>),
    Hexagon,
    Image(Box<ImagePattern>),
    Leopard,
    Marble,
    /// `material_map`.
    Material(Box<ImageMapping>),
    /// Whether a point is inside an object.
    Object(Arc<Questioned>),
    Onion,
    /// The grey value of a pigment.
    Pigment(Box<Pigment>),
    Planar,
    Quilted {
        control0: f64,
        control1: f64,
    },
    Radial,
    Ripples(WaveSources),
    Slope(Slope),
    Spherical,
    Spotted,
    Spiral1 {
        arms: f64,
    },
    Spiral2 {
        arms: f64,
    },
    Square,
    Tiling(Arc<Tiling>),
    Triangular,
    Waves(WaveSources),
    Wood,
    Wrinkles,
}

impl PatternKind {
    /// The raw value at a point of the pattern's own space.
    #[inline]
    pub fn value(&self, p: Vec3, modifiers: &Modifiers, surface: &SurfaceContext) -> f64 {
        let generator = modifiers.noise_generator;
        match self {
            PatternKind::Agate { agate_turb } => noisy::agate(p, *agate_turb, modifiers),
            PatternKind::Aoi => surface::angle_of_incidence(surface),
            PatternKind::Average | PatternKind::BumpMap(_) | PatternKind::Facets(_) => 0.0,
            PatternKind::Boxed => shells::fading(shells::chebyshev(p)),
            PatternKind::Bozo | PatternKind::Bumps | PatternKind::Spotted => generator.noise(p),
            PatternKind::Brick(brick) => brick.value(p),
            PatternKind::Cells => cells::cells(p),
            PatternKind::Checker => blocks::checker(p),
            PatternKind::Crackle(crackle) => crackle.value(p, generator),
            PatternKind::Cubic => blocks::cubic(p),
            PatternKind::Cylindrical => shells::fading(p.x.hypot(p.z)),
            PatternKind::DensityFile(file) => file.value(p),
            PatternKind::Dents => noisy::dents(p, generator),
            PatternKind::Function(function) => wave::folded(function.at(p)),
            PatternKind::Gradient(direction) => shells::wrapped(p.dot(*direction)),
            PatternKind::Fractal(fractal) => fractal.value(p),
            PatternKind::Granite => noisy::granite(p, generator),
            PatternKind::Hexagon => blocks::hexagon(p),
            PatternKind::Image(image) => image.value(p),
            PatternKind::Leopard => shells::leopard(p),
            PatternKind::Marble => shells::marble(p, modifiers),
            PatternKind::Material(mapping) => material_number(mapping, p),
            PatternKind::Object(object) => f64::from(object.inside(p)),
            PatternKind::Onion => p.length() % 1.0,
            PatternKind::Pigment(pigment) => pigment.color(p, surface).rgb.gray(),
            PatternKind::Planar => shells::fading(p.y.abs()),
            PatternKind::Quilted { control0, control1 } => shells::quilted(p, *control0, *control1),
            PatternKind::Radial => shells::radial(p),
            PatternKind::Ripples(sources) => sources.ripples(p, &modifiers.waveform),
            PatternKind::Slope(slope) => slope.value(p, surface),
            PatternKind::Spherical => shells::fading(p.length()),
            PatternKind::Spiral1 { arms } => spirals::spiral1(p, *arms, modifiers),
            PatternKind::Spiral2 { arms } => spirals::spiral2(p, *arms, modifiers),
            PatternKind::Square => blocks::square(p),
            PatternKind::Tiling(tiling) => tiling.value(p),
            PatternKind::Triangular => blocks::triangular(p),
            PatternKind::Waves(sources) => sources.waves(p, &modifiers.waveform),
            PatternKind::Wood => shells::wood(p, modifiers),
            PatternKind::Wrinkles => noisy::wrinkles(p, generator),
        }
    }

    /// The frequency and the wave used where none is asked for.
    pub fn own_waveform(&self) -> Waveform {
        match self {
            PatternKind::Marble | PatternKind::Wood => Waveform::plain(Wave::Triangle),
            PatternKind::Spiral1 { .. } | PatternKind::Spiral2 { .. } => Waveform::plain(Wave::Triangle),
            PatternKind::Image(_) | PatternKind::Quilted { .. } => Waveform::UNCHANGED,
            _ if self.is_blocks() => Waveform::UNCHANGED,
            _ => Waveform::default(),
        }
    }

    /// Whether the value is the number of a block.
    #[inline]
    pub fn is_blocks(&self) -> bool {
        matches!(
            self,
            PatternKind::Brick(_)
                | PatternKind::Checker
                | PatternKind::Cubic
                | PatternKind::Hexagon
                | PatternKind::Material(_)
                | PatternKind::Object(_)
                | PatternKind::Square
                | PatternKind::Triangular
        )
    }

    /// Whether the classic turbulence is part of the pattern's own formula.
    #[inline]
    pub fn treats_turbulence(&self) -> bool {
        matches!(self, PatternKind::Marble | PatternKind::Wood)
    }
}
