//! SDL: `normal { PATTERN amount slope_map {...} | normal_map {...} | list accuracy F no_bump_scale }`.

use std::sync::Arc;

use super::bumps::Bumps;
use super::color_map::BlendMap;
use super::slope_map::SlopeMap;
use crate::math::{vec3, Vec3};
use crate::pattern::{Modifiers, Pattern, SurfaceContext};
use crate::warp::Warp;

/// The corners of a regular tetrahedron, where a pattern is sampled for its gradient.
const TETRAHEDRON: [Vec3; 4] = [
    vec3(0.942809041, -0.333333333, 0.0),
    vec3(-0.471404521, -0.333333333, 0.816496581),
    vec3(-0.471404521, -0.333333333, -0.816496581),
    vec3(0.0, 1.0, 0.0),
];
/// The depth of bumps estimated from samples is stated for samples at this distance, with this factor.
const USUAL_ACCURACY: f64 = 0.02;
const DEPTH: f64 = -5.0;

/// A perturbation of the surface normal; shared ones are cheap to clone.
#[derive(Clone, Debug)]
pub enum Normal {
    /// Leaves the normal alone.
    Smooth,
    /// By a formula of the pattern's own.
    Bumps(Arc<(Modifiers, Bumps, NormalScale)>),
    /// Along the gradient of the pattern's value.
    Gradient(Arc<(Pattern, Gradient, NormalScale)>),
    /// The pattern's value mixes two normals.
    Normals(Arc<(Pattern, BlendMap<Normal>, NormalScale)>),
    /// The pattern's number picks a normal.
    Blocks(Arc<(Pattern, Vec<Normal>, NormalScale)>),
    /// `average`: the weighted mean of normals.
    Average(Arc<(Modifiers, Weighted, NormalScale)>),
}

/// Normals with their weights.
type Weighted = Vec<(f64, Normal)>;

/// Bumps estimated from samples.
#[derive(Clone, Debug)]
pub struct Gradient {
    /// How deep, and which way.
    pub amount: f64,
    /// Distance of the samples.
    pub accuracy: f64,
    /// The profile that the pattern's values stand for.
    pub slopes: Option<SlopeMap>,
}

/// Whether bumps grow with their pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NormalScale {
    /// A scaled pattern has the same slopes.
    Grows,
    /// `no_bump_scale`: a scaled pattern has the same depth.
    Stays,
}

impl Normal {
    /// The normal `n` (of length one) at `p`, perturbed; of length one.
    pub fn perturb(&self, p: Vec3, n: Vec3, surface: &SurfaceContext) -> Vec3 {
        self.perturb_any(p, n, surface).normalized()
    }

    /// The same for normals of any length, and giving such.
    fn perturb_any(&self, p: Vec3, n: Vec3, surface: &SurfaceContext) -> Vec3 {
        match self {
            Normal::Smooth => n,
            Normal::Bumps(node) => {
                let (modifiers, bumps, scale) = &**node;
                let place = modifiers.locate(p, surface, false);
                scale.inside(modifiers, n, |inner| bumps.perturb(place, inner))
            }
            Normal::Gradient(node) => {
                let (pattern, gradient, scale) = &**node;
                let place = pattern.place(p, surface);
                scale.inside(&pattern.modifiers, n, |inner| inner + gradient.slope(pattern, place, surface))
            }
            Normal::Normals(node) => {
                let (pattern, map, scale) = &**node;
                let (value, place) = pattern.value_and_place(p, surface);
                let (low, high, t) = map.around(value);
                scale.inside(&pattern.modifiers, n, |inner| {
                    let above = high.perturb_any(place, inner, surface);
                    if t == 0.0 {
                        above
                    } else {
                        low.perturb_any(place, inner, surface) * (1.0 - t) + above * t
                    }
                })
            }
            Normal::Blocks(node) => {
                let (pattern, normals, scale) = &**node;
                let (number, place) = pattern.block_and_place(p, surface);
                let chosen = &normals[number % normals.len()];
                scale.inside(&pattern.modifiers, n, |inner| chosen.perturb_any(place, inner, surface))
            }
            Normal::Average(node) => {
                let (modifiers, entries, scale) = &**node;
                let place = modifiers.locate(p, surface, false);
                scale.inside(modifiers, n, |inner| {
                    let weighted = |(weight, normal): &(f64, Normal)| {
                        normal.perturb_any(place, inner, surface) * *weight
                    };
                    entries.iter().map(weighted).fold(Vec3::ZERO, |sum, v| sum + v)
                })
            }
        }
    }
}

impl Gradient {
    /// What is added to the normal at `place` in the pattern's own space.
    fn slope(&self, pattern: &Pattern, place: Vec3, surface: &SurfaceContext) -> Vec3 {
        let factor = self.amount * DEPTH * (USUAL_ACCURACY / self.accuracy);
        TETRAHEDRON.into_iter().fold(Vec3::ZERO, |sum, corner| {
            let value = pattern.value_in_place(place + corner * self.accuracy, surface);
            let height = self.slopes.as_ref().map_or(value, |slopes| slopes.height(value));
            sum + corner * (height * factor)
        })
    }
}

impl NormalScale {
    /// Applies `change` to a normal in the space of a pattern. Of the warps only transforms turn normals.
    fn inside(self, modifiers: &Modifiers, normal: Vec3, change: impl FnOnce(Vec3) -> Vec3) -> Vec3 {
        let resized = |n: Vec3| if self == NormalScale::Grows { n.normalized() } else { n };
        let inner = modifiers.warps.iter().rev().fold(normal, |n, warp| match warp {
            Warp::Transform(space) => space.inverse_normal(n),
            _ => n,
        });
        let changed = modifiers.warps.iter().fold(resized(change(resized(inner))), |n, warp| match warp {
            Warp::Transform(space) => space.normal(n),
            _ => n,
        });
        resized(changed)
    }
}
