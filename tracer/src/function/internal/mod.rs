//! SDL: `function { internal(N) }`, N = 0..78: what `functions.inc` names `f_sphere`, `f_torus`, `f_ridged_mf`, ...
//!
//! Their formulas were read off POV-Ray's values (`tests/tracer/golden_values.py`), the surfaces' names being those of the
//! literature.

mod bodies;
mod curves;
mod fractals;
mod surfaces;
mod windings;

use crate::math::Vec3;
use crate::noise::NoiseGenerator;

/// A function of a point and some more numbers.
type Formula = fn(Vec3, &[f64]) -> f64;

/// An internal function by its number.
#[derive(Clone, Copy, Debug)]
pub enum Internal {
    /// One with a formula, and how many numbers it takes after the point.
    Formula(Formula, usize),
    /// `f_noise3d`: noise by the scene's generator.
    Noise(NoiseGenerator),
}

/// More numbers after the point than any internal function takes.
const MOST_PARAMETERS: usize = 7;

impl Internal {
    /// Function number `number`; None where there is none.
    pub fn new(number: u32, generator: NoiseGenerator) -> Option<Internal> {
        let (formula, parameters): (Formula, usize) = match number {
            0 => (curves::algbr_cyl1, 5),
            1 => (curves::algbr_cyl2, 5),
            2 => (curves::algbr_cyl3, 5),
            3 => (curves::algbr_cyl4, 5),
            4 => (surfaces::bicorn, 2),
            5 => (surfaces::bifolia, 2),
            6 => (bodies::blob, 5),
            7 => (bodies::blob2, 4),
            8 => (surfaces::boy_surface, 2),
            9 => (windings::comma, 1),
            10 => (bodies::cross_ellipsoids, 4),
            11 => (surfaces::crossed_trough, 1),
            12 => (surfaces::cubic_saddle, 1),
            13 => (surfaces::cushion, 1),
            14 => (surfaces::devils_curve, 1),
            15 => (curves::devils_curve_2d, 6),
            16 => (surfaces::dupin_cyclid, 6),
            17 => (bodies::ellipsoid, 3),
            18 => (surfaces::enneper, 1),
            19 => (bodies::flange_cover, 4),
            20 => (surfaces::folium_surface, 3),
            21 => (curves::folium_surface_2d, 6),
            22 => (surfaces::glob, 1),
            23 => (surfaces::heart, 1),
            25 => (windings::helix1, 7),
            26 => (windings::helix2, 7),
            27 => (bodies::hex_x, 1),
            28 => (bodies::hex_y, 1),
            29 => (fractals::hetero_mf, 6),
            30 => (surfaces::hunt_surface, 1),
            31 => (surfaces::hyperbolic_torus, 3),
            32 => (bodies::isect_ellipsoids, 4),
            33 => (surfaces::kampyle_of_eudoxus, 3),
            34 => (curves::kampyle_of_eudoxus_2d, 6),
            35 => (surfaces::klein_bottle, 1),
            36 => (surfaces::kummer_surface_v1, 1),
            37 => (surfaces::kummer_surface_v2, 4),
            38 => (surfaces::lemniscate_of_gerono, 1),
            39 => (curves::lemniscate_of_gerono_2d, 6),
            40 => (windings::mesh1, 5),
            41 => (surfaces::mitre, 1),
            42 => (surfaces::nodal_cubic, 1),
            43 => (surfaces::cushion, 1),
            44 => (surfaces::ovals_of_cassini, 4),
            45 => (surfaces::paraboloid, 1),
            46 => (surfaces::parabolic_torus, 3),
            47 => (bodies::ph, 0),
            48 => (surfaces::pillow, 1),
            49 => (surfaces::piriform, 1),
            50 => (curves::piriform_2d, 7),
            51 => (bodies::poly4, 5),
            52 => (windings::polytubes, 6),
            53 => (bodies::quantum, 1),
            54 => (surfaces::quartic_paraboloid, 1),
            55 => (surfaces::quartic_saddle, 1),
            56 => (surfaces::quartic_cylinder, 3),
            57 => (bodies::r, 0),
            58 => (fractals::ridge, 6),
            59 => (fractals::ridged_mf, 6),
            60 => (bodies::rounded_box, 4),
            61 => (bodies::sphere, 1),
            62 => (bodies::spikes, 5),
            63 => (bodies::spikes_2d, 4),
            64 => (windings::spiral, 6),
            65 => (surfaces::steiners_roman, 1),
            66 => (surfaces::strophoid, 4),
            67 => (curves::strophoid_2d, 7),
            68 => (bodies::superellipsoid, 2),
            69 => (bodies::th, 0),
            70 => (bodies::torus, 2),
            71 => (surfaces::torus2, 3),
            72 => (surfaces::torus_gumdrop, 1),
            73 => (surfaces::umbrella, 1),
            74 => (surfaces::witch_of_agnesi, 2),
            75 => (curves::witch_of_agnesi_2d, 6),
            76 => return Some(Internal::Noise(generator)),
            78 => (fractals::noise_generator, 1),
            _ => return None,
        };
        Some(Internal::Formula(formula, parameters))
    }

    /// The value at a point; missing parameters are 0.
    #[inline]
    pub fn value(&self, p: Vec3, parameters: &[f64]) -> f64 {
        match *self {
            Internal::Noise(generator) => generator.noise(p),
            Internal::Formula(formula, count) if parameters.len() >= count => formula(p, parameters),
            Internal::Formula(formula, _) => {
                let mut filled = [0.0; MOST_PARAMETERS];
                filled[..parameters.len()].copy_from_slice(parameters);
                formula(p, &filled)
            }
        }
    }
}
