//! SDL: `pigment { PATTERN color_map {...} | pigment_map {...} | list }`: a colour at every point.

use std::sync::Arc;

use super::color_map::{BlendMap, ColorMap};
use super::{default_map, ImageMap};
use crate::color::Rgbft;
use crate::function::Function;
use crate::math::Vec3;
use crate::pattern::{Modifiers, Pattern, SurfaceContext};

/// A pigment; shared ones are cheap to clone.
#[derive(Clone, Debug)]
pub enum Pigment {
    /// One colour everywhere.
    Solid(Rgbft),
    /// The pattern's value looks up a colour.
    Colors(Arc<(Pattern, ColorMap)>),
    /// The pattern's value mixes two pigments.
    Pigments(Arc<(Pattern, BlendMap<Pigment>)>),
    /// A picture.
    Image(Arc<(Modifiers, ImageMap)>),
    /// The pattern's number picks a pigment.
    Blocks(Arc<(Pattern, Vec<Pigment>)>),
    /// `average`: the weighted mean of pigments.
    Average(Arc<(Modifiers, Vec<(f64, Pigment)>)>),
    /// `user_defined`: a function for each component, or one that gives them all.
    UserDefined(Arc<(Modifiers, Vec<Option<Function>>)>),
}

impl Pigment {
    /// A pattern with the map that it has by default.
    pub fn with_default_map(pattern: Pattern) -> Pigment {
        if pattern.kind.is_blocks() {
            Pigment::blocks(pattern, Vec::new())
        } else {
            let map = default_map::color_map(&pattern.kind);
            Pigment::Colors(Arc::new((pattern, map)))
        }
    }

    /// Whether nothing is seen through it anywhere.
    pub fn is_opaque(&self) -> bool {
        let opaque = |color: &Rgbft| color.filter == 0.0 && color.transmit == 0.0;
        match self {
            Pigment::Solid(color) => opaque(color),
            Pigment::Colors(node) => node.1.entries().iter().all(|e| opaque(&e.1)),
            Pigment::Pigments(node) => node.1.entries().iter().all(|e| e.1.is_opaque()),
            Pigment::Image(node) => node.1.is_opaque(),
            Pigment::Blocks(node) => node.1.iter().all(Pigment::is_opaque),
            Pigment::Average(node) => node.1.iter().all(|e| e.1.is_opaque()),
            Pigment::UserDefined(node) => {
                let clear = node.1.iter().skip(3).any(Option::is_some);
                !clear && node.1.iter().flatten().all(|function| function.size() < 4)
            }
        }
    }

    /// A block pattern with the first of its pigments. To a list of colours its default colours are added, to one of
    /// patterned pigments plain black.
    pub fn blocks(pattern: Pattern, mut pigments: Vec<Pigment>) -> Pigment {
        let of_colors = pigments.iter().all(|p| matches!(p, Pigment::Solid(_)));
        let missing = |color| Pigment::Solid(if of_colors { color } else { Rgbft::default() });
        let defaults = default_map::block_colors(&pattern.kind).into_iter().map(missing);
        pigments.extend(defaults.skip(pigments.len()));
        if pattern.picks() {
            Pigment::Blocks(Arc::new((pattern, pigments)))
        } else {
            Pigment::Pigments(Arc::new((pattern, BlendMap::numbered(pigments))))
        }
    }

    /// The colour at `p`.
    pub fn color(&self, p: Vec3, surface: &SurfaceContext) -> Rgbft {
        match self {
            Pigment::Solid(color) => *color,
            Pigment::Colors(node) => {
                let (pattern, map) = &**node;
                map.color(pattern.value(p, surface))
            }
            Pigment::Pigments(node) => {
                let (pattern, map) = &**node;
                let (value, inner) = pattern.value_and_place(p, surface);
                let (a, b, t) = map.around(value);
                if t == 0.0 {
                    return a.color(inner, surface);
                }
                Rgbft::lerp(&a.color(inner, surface), &b.color(inner, surface), t)
            }
            Pigment::Image(node) => node.1.color(node.0.locate(p, surface, false)),
            Pigment::Blocks(node) => {
                let (pattern, pigments) = &**node;
                let (value, inner) = pattern.block_and_place(p, surface);
                pigments[value % pigments.len()].color(inner, surface)
            }
            Pigment::Average(node) => {
                let (modifiers, entries) = &**node;
                let inner = modifiers.locate(p, surface, false);
                average(entries.iter().map(|(weight, pigment)| (*weight, pigment.color(inner, surface))))
            }
            Pigment::UserDefined(node) => {
                let (modifiers, functions) = &**node;
                user_defined(functions, modifiers.locate(p, surface, false))
            }
        }
    }
}

/// A colour whose components functions give.
fn user_defined(functions: &[Option<Function>], p: Vec3) -> Rgbft {
    if let [Some(all), rest @ ..] = functions {
        if all.size() > 1 && rest.iter().all(Option::is_none) {
            return Rgbft::from(all.components(&[p.x, p.y, p.z]));
        }
    }
    Rgbft::from(std::array::from_fn(|i| functions.get(i).and_then(Option::as_ref).map_or(0.0, |f| f.at(p))))
}

/// The weighted mean of colours.
fn average(colors: impl Iterator<Item = (f64, Rgbft)>) -> Rgbft {
    let mut sum = Rgbft::default();
    let mut total = 0.0;
    for (weight, color) in colors {
        sum.rgb += color.rgb * weight;
        sum.filter += color.filter * weight;
        sum.transmit += color.transmit * weight;
        total += weight;
    }
    Rgbft { rgb: sum.rgb * (1.0 / total), filter: sum.filter / total, transmit: sum.transmit / total }
}
