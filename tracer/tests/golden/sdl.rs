//! Builds the patterns of the golden files from the little SDL that their names are written in.

use std::sync::Arc;

use minipov_tracer::color::Rgbft;
use minipov_tracer::math::{vec3, Transform, Vec3};
use minipov_tracer::noise::{NoiseGenerator, Octaves};
use minipov_tracer::pattern::{
    Brick, Crackle, Pattern, PatternKind, TurbulenceModifier, Wave, WaveSources, Waveform,
};
use minipov_tracer::texture::{BlendMap, Pigment};
use minipov_tracer::warp::{BlackHole, Mapping, Projection, Repeat, Warp};

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
        "agate" => PatternKind::Agate {
            agate_turb: if words.option("agate_turb") { single(words.number()) } else { 1.0 },
        },
        "aoi" => PatternKind::Aoi,
        "boxed" => PatternKind::Boxed,
        "bozo" => PatternKind::Bozo,
        "bumps" => PatternKind::Bumps,
        "spotted" => PatternKind::Spotted,
        "average" => PatternKind::Average,
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
        "square" => PatternKind::Square,
        "triangular" => PatternKind::Triangular,
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
        "repeat" => {
            let v = words.vector();
            let axis = (0..3).find(|&a| v[a] != 0.0).expect("an axis");
            let mut repeat = Repeat::new(axis, v[axis], Vec3::ZERO, [false; 3]);
            loop {
                if words.option("offset") {
                    repeat.offset = words.vector();
                } else if words.option("flip") {
                    let f = words.vector();
                    repeat.flip = [f.x, f.y, f.z].map(|c| c != 0.0);
                } else {
                    break Warp::Repeat(repeat);
                }
            }
        }
        "black_hole" => {
            let (center, radius) = (words.vector(), words.number());
            let (strength, falloff, inverse, repeat, turbulence) = (1.0, 2.0, false, None, Vec3::ZERO);
            let mut hole = BlackHole { center, radius, strength, falloff, inverse, repeat, turbulence };
            loop {
                match words.option("inverse") {
                    true => hole.inverse = true,
                    _ if words.option("strength") => hole.strength = words.number(),
                    _ if words.option("falloff") => hole.falloff = words.number(),
                    _ if words.option("repeat") => hole.repeat = Some(words.vector()),
                    _ if words.option("turbulence") => hole.turbulence = words.vector(),
                    _ => break Warp::BlackHole(Box::new(hole)),
                }
            }
        }
        "planar" => {
            let (orientation, distance) =
                if words.0.starts_with('}') { (Vec3::Z, 0.0) } else { (words.vector(), words.number()) };
            Warp::Mapping(Box::new(Mapping::new(Projection::Planar(distance), orientation, 0.0)))
        }
        "cubic" => Warp::Cubic,
        name => {
            let (mut orientation, mut dist_exp, mut major_radius) = (Vec3::Z, 0.0, 1.0);
            loop {
                match words.option("orientation") {
                    true => orientation = words.vector(),
                    _ if words.option("dist_exp") => dist_exp = words.number(),
                    _ if words.option("major_radius") => major_radius = words.number(),
                    _ => break,
                }
            }
            let projection = match name {
                "cylindrical" => Projection::Cylindrical,
                "spherical" => Projection::Spherical,
                "toroidal" => Projection::Toroidal(major_radius),
                other => panic!("no warp {other}"),
            };
            Warp::Mapping(Box::new(Mapping::new(projection, orientation, dist_exp)))
        }
    }
}

/// The pattern that a case's name describes.
pub fn pattern(case: &str) -> Pattern {
    let mut words = Words(case);
    let mut pattern = Pattern::plain(kind(&mut words));
    modifiers(&mut words, &mut pattern);
    pattern
}

fn color(words: &mut Words) -> Option<Rgbft> {
    let splat = |words: &mut Words| <[f64; 3]>::from(words.vector());
    let [r, g, b, filter, transmit] = if words.option("rgbft") {
        assert!(words.take("<"));
        let c = std::array::from_fn(|_| words.number());
        assert!(words.take(">"));
        c
    } else if words.option("rgb") {
        let [r, g, b] = splat(words);
        [r, g, b, 0.0, 0.0]
    } else {
        return None;
    };
    Some(Rgbft::from([r, g, b, filter, transmit]))
}

fn entries<T>(words: &mut Words, item: impl Fn(&mut Words) -> T) -> Vec<(f64, T)> {
    let mut entries = Vec::new();
    assert!(words.take("{"));
    while words.take("[") {
        entries.push((words.number(), item(words)));
        assert!(words.take("]"));
    }
    assert!(words.take("}"));
    entries
}

/// A colour or a pattern with its map and modifiers.
pub fn pigment(words: &mut Words) -> Pigment {
    if let Some(color) = color(words) {
        return Pigment::Solid(color);
    }
    let mut pattern = Pattern::plain(kind(words));
    let mut colors = None;
    let mut pigments = None;
    let mut blocks = Vec::new();
    if words.option("color_map") {
        colors = Some(entries(words, |w| color(w).expect("a colour")));
    } else if words.option("pigment_map") {
        pigments = Some(entries(words, pigment));
    }
    loop {
        if let Some(color) = color(words) {
            blocks.push(Pigment::Solid(color));
        } else if words.option("pigment") {
            assert!(words.take("{"));
            blocks.push(pigment(words));
            assert!(words.take("}"));
        } else {
            break;
        }
    }
    modifiers(words, &mut pattern);
    match (colors, pigments) {
        (Some(colors), _) => Pigment::Colors(Arc::new((pattern, BlendMap::new(colors)))),
        (_, Some(pigments)) if matches!(pattern.kind, PatternKind::Average) => {
            Pigment::Average(Arc::new((pattern.modifiers, pigments)))
        }
        (_, Some(pigments)) => Pigment::Pigments(Arc::new((pattern, BlendMap::new(pigments)))),
        _ if !blocks.is_empty() => Pigment::blocks(pattern, blocks),
        _ => Pigment::with_default_map(pattern),
    }
}

fn modifiers(words: &mut Words, pattern: &mut Pattern) {
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
                modifiers.warps.push(warp(words));
                assert!(words.take("}"));
            }
            "brick_size" | "mortar" => {
                let PatternKind::Brick(brick) = &mut pattern.kind else { panic!("no bricks") };
                match word {
                    "mortar" => brick.mortar = words.number(),
                    _ => brick.brick_size = words.vector(),
                }
            }
            "turbulence" => modifiers.turbulence = Some(turbulence(words)),
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
}
