//! From the scene graph's warps to those that are applied.

use super::{BlackHole, Mapping, Projection, Repeat, Warp};
use crate::graph::warp as graph;
use crate::math::Vec3;
use crate::noise::Octaves;
use crate::pattern::TurbulenceModifier;

impl From<&graph::Turbulence> for TurbulenceModifier {
    fn from(t: &graph::Turbulence) -> TurbulenceModifier {
        TurbulenceModifier { amount: t.amount, octaves: Octaves::new(t.octaves, t.omega, t.lambda_) }
    }
}

impl From<&graph::Warp> for Warp {
    fn from(warp: &graph::Warp) -> Warp {
        let mapping = |projection, orientation: Vec3, dist_exp| {
            Warp::Mapping(Box::new(Mapping::new(projection, orientation, dist_exp)))
        };
        match warp {
            graph::Warp::Transform(t) => Warp::Transform(Box::new(*t)),
            graph::Warp::Turbulence(t) => Warp::Turbulence(t.into()),
            graph::Warp::Repeat(r) => Warp::Repeat(Repeat::new(r.axis, r.width, r.offset, r.flip)),
            graph::Warp::BlackHole(b) => {
                let hole = BlackHole {
                    center: b.center,
                    radius: b.radius,
                    strength: b.strength,
                    falloff: b.falloff,
                    inverse: b.inverse,
                    repeat: b.repeat,
                    turbulence: b.turbulence,
                };
                Warp::BlackHole(Box::new(hole.fitted()))
            }
            graph::Warp::Cylindrical(m) => mapping(Projection::Cylindrical, m.orientation, m.dist_exp),
            graph::Warp::Spherical(m) => mapping(Projection::Spherical, m.orientation, m.dist_exp),
            graph::Warp::Toroidal(m) => {
                mapping(Projection::Toroidal(m.major_radius), m.orientation, m.dist_exp)
            }
            graph::Warp::Planar(m) => mapping(Projection::Planar(m.distance), m.normal, 0.0),
            graph::Warp::Cubic(_) => Warp::Cubic,
        }
    }
}
