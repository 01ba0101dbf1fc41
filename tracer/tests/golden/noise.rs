//! Noise and turbulence against POV-Ray's values.

use super::data;
use minipov_tracer::math::Vec3;
use minipov_tracer::noise::{NoiseGenerator, Octaves};

#[test]
fn noise_equals_povrays() {
    data::parse(include_str!("../golden_values/noise.txt")).check(1e-11, |case| {
        let words: Vec<_> = case.split(' ').collect();
        let octaves = match words[1] {
            "octave" => Octaves::new(1, 0.5, 2.0),
            "odd" => Octaves::new(9, 0.8, 1.7),
            _ => Octaves::default(),
        };
        let component = words.get(2).map(|c| "xyz".find(c).expect("an axis"));
        let generator = NoiseGenerator::from_number(words[1].parse().unwrap_or(0));
        move |p: Vec3| match component {
            Some(c) => octaves.vector(p)[c],
            None => generator.noise(p),
        }
    });
}
