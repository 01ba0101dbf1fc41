//! Builds the patterns of the golden files from the little SDL that their names are written in.

use minipov_tracer::math::{vec3, Transform, Vec3};
use minipov_tracer::noise::{NoiseGenerator, Octaves};
use minipov_tracer::pattern::{
    Brick, Crackle, Pattern, PatternKind, TurbulenceModifier, Wave, WaveSources, Waveform,
};
use minipov_tracer::warp::Warp;

/// The words of a case, read from the left.
pub struct Words<'a>(pub &'a str);

impl<'a> Words<'a> {
    fn skip(&mut self) {
        self.0 = self.0.trim_start_matches([' ', ',']);
    }

    /// The keyword that comes next, taken if it is one.
    pub fn word(&mut self) -> Option<&'a str> {
        self.skip();
        let end = self.0.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(self.0.len());
        if !self.0.starts_with(|c: char| c.is_ascii_alphabetic()) {
            return None;
        }
        let (word, rest) = self.0.split_at(end);
        self.0 = rest;
        Some(word)
    }

    pub fn take(&mut self, expected: &str) -> bool {
        self.skip();
        let rest = self.0.strip_prefix(expected);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }

    /// The keyword and true, if it is the next word.
    fn option(&mut self, expected: &str) -> bool {
        let before = self.0;
        let found = self.word() == Some(expected);
        if !found {
            self.0 = before;
        }
        found
    }

    pub fn number(&mut self) -> f64 {
        self.skip();
        let end = self.0.find(|c: char| !c.is_ascii_digit() && c != '.' && c != '-').unwrap_or(self.0.len());
        let (number, rest) = self.0.split_at(end);
        self.0 = rest;
        number.parse().unwrap_or_else(|_| panic!("a number at {number:?} before {rest:?}"))
    }

    pub fn vector(&mut self) -> Vec3 {
        if self.take("<") {
            let v = vec3(self.number(), self.number(), self.number());
            assert!(self.take(">"));
            return v;
        }
        let axis = |w: &str| match w {
            "x" => Vec3::X,
            "y" => Vec3::Y,
            _ => Vec3::Z,
        };
        if let Some(word) = self.word() {
            return axis(word);
        }
        let factor = self.number();
        if self.take("*") {
            return axis(self.word().expect("an axis")) * factor;
        }
        Vec3::splat(factor)
    }
}

/// As precise as POV-Ray keeps the parameters of some patterns.
fn single(v: f64) -> f64 {
    f64::from(v as f32)
}

fn rotation(degrees: Vec3) -> Transform {
    let [(cx, sx), (cy, sy), (cz, sz)] = [0, 1, 2].map(|a| {
        let r = degrees[a].to_radians();
        (r.cos(), r.sin())
    });
    let linear = |m: [f64; 9]| {
        let mut all = [0.0; 12];
        all[..9].copy_from_slice(&m);
        Transform::from_matrix(all).expect("a rotation")
    };
    linear([1.0, 0.0, 0.0, 0.0, cx, sx, 0.0, -sx, cx])
        .then(&linear([cy, 0.0, -sy, 0.0, 1.0, 0.0, sy, 0.0, cy]))
        .then(&linear([cz, sz, 0.0, -sz, cz, 0.0, 0.0, 0.0, 1.0]))
}

fn kind(words: &mut Words) -> PatternKind {
    match words.word().expect("a pattern") {
        "agate" => {
            PatternKind::Agate { agate_turb: if words.option("agate_turb") { single(words.number()) } else { 1.0 } }
        }
        "aoi" => PatternKind::Aoi,
        "boxed" => PatternKind::Boxed,
        "bozo" | "spotted" | "bumps" => PatternKind::Bozo,
        "brick" => {
            let mut brick = Brick::default();
            if words.option("brick_size") {
                brick.brick_size = words.vector();
            }
            if words.option("mortar") {
                brick.mortar = words.number();
            }
            PatternKind::Brick(brick)
        }
        "cells" => PatternKind::Cells,
        "checker" => PatternKind::Checker,
        "crackle" => {
            let mut crackle = Crackle::default();
            loop {
                if words.option("form") {
                    crackle.form = words.vector();
                } else if words.option("metric") {
                    crackle.metric = words.number();
                } else if words.option("offset") {
                    crackle.offset = words.number();
                } else if words.option("solid") {
                    crackle.solid = true;
                } else {
                    break PatternKind::Crackle(crackle);
                }
            }
        }
        "cubic" => PatternKind::Cubic,
        "cylindrical" => PatternKind::Cylindrical,
        "dents" => PatternKind::Dents,
        "gradient" => PatternKind::Gradient(words.vector().normalized()),
        "granite" => PatternKind::Granite,
        "hexagon" => PatternKind::Hexagon,
        "leopard" => PatternKind::Leopard,
        "marble" => PatternKind::Marble,
        "onion" => PatternKind::Onion,
        "planar" => PatternKind::Planar,
        "quilted" => {
            let mut control = |name| if words.option(name) { single(words.number()) } else { 1.0 };
            PatternKind::Quilted { control0: control("control0"), control1: control("control1") }
        }
        "radial" => PatternKind::Radial,
        "ripples" => PatternKind::Ripples(WaveSources::new(10)),
        "spherical" => PatternKind::Spherical,
        "spiral1" => PatternKind::Spiral1 { arms: words.number() },
        "spiral2" => PatternKind::Spiral2 { arms: words.number() },
        "waves" => PatternKind::Waves(WaveSources::new(10)),
        "wood" => PatternKind::Wood,
        "wrinkles" => PatternKind::Wrinkles,
        other => panic!("no pattern {other}"),
    }
}

fn turbulence(words: &mut Words) -> TurbulenceModifier {
    let amount = words.vector();
    let octaves = if words.option("octaves") { words.number() } else { 6.0 };
    let omega = if words.option("omega") { words.number() } else { 0.5 };
    let lambda = if words.option("lambda") { words.number() } else { 2.0 };
    TurbulenceModifier { amount, octaves: Octaves::new(octaves as i64, omega, lambda) }
}

fn warp(words: &mut Words) -> Warp {
    match words.word().expect("a warp") {
        "turbulence" => Warp::Turbulence(turbulence(words)),
        other => panic!("no warp {other}"),
    }
}

/// The pattern that a case's name describes.
pub fn pattern(case: &str) -> Pattern {
    let mut words = Words(case);
    let mut pattern = Pattern::plain(kind(&mut words));
    let Waveform { mut frequency, mut phase, mut wave } = pattern.modifiers.waveform;
    let modifiers = &mut pattern.modifiers;
    while let Some(word) = words.word() {
        let transform = match word {
            "scale" => {
                let s = words.vector();
                Transform::from_matrix([s.x, 0.0, 0.0, 0.0, s.y, 0.0, 0.0, 0.0, s.z, 0.0, 0.0, 0.0])
            }
            "rotate" => Some(rotation(words.vector())),
            "translate" => Some(Transform::translate(words.vector())),
            "matrix" => {
                assert!(words.take("<"));
                let m = std::array::from_fn(|_| words.number());
                assert!(words.take(">"));
                Transform::from_matrix(m)
            }
            _ => None,
        };
        match word {
            "warp" => {
                assert!(words.take("{"));
                modifiers.warps.push(warp(&mut words));
                assert!(words.take("}"));
            }
            "turbulence" => modifiers.turbulence = Some(turbulence(&mut words)),
            "noise_generator" => {
                modifiers.noise_generator = NoiseGenerator::from_number(words.number() as i64)
            }
            "frequency" => frequency = words.number(),
            "phase" => phase = words.number(),
            "triangle_wave" => wave = Wave::Triangle,
            "sine_wave" => wave = Wave::Sine,
            "scallop_wave" => wave = Wave::Scallop,
            "cubic_wave" => wave = Wave::Cubic,
            "poly_wave" => wave = Wave::Poly(words.number()),
            other => modifiers
                .warps
                .push(Warp::Transform(Box::new(transform.unwrap_or_else(|| panic!("no modifier {other}"))))),
        }
    }
    modifiers.waveform = Waveform::new(frequency, phase, wave);
    pattern
}
