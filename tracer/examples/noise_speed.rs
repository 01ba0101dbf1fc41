//! How long noise and the patterns made of it take: `cargo run --profile quick --example noise_speed`.

use std::hint::black_box;
use std::time::Instant;

use minipov_tracer::math::{vec3, Vec3};
use minipov_tracer::noise::{vector_noise, NoiseGenerator, Octaves};
use minipov_tracer::pattern::{Crackle, Pattern, PatternKind, SurfaceContext};

const POINTS: usize = 20_000;
/// The best of so many rounds counts, since others may use the machine.
const ROUNDS: usize = 40;

/// Prints the time of a call, over neighbouring points as rays meet them.
fn measure(name: &str, mut value: impl FnMut(Vec3) -> f64) {
    let place = |i: usize| {
        let (row, column) = ((i / 500) as f64, (i % 500) as f64);
        vec3(0.013 * column - 3.0, 0.017 * row - 2.0, 0.3 + 0.001 * column)
    };
    let (mut sum, mut each) = (0.0, f64::INFINITY);
    for _ in 0..ROUNDS {
        let started = Instant::now();
        sum = (0..POINTS).map(|i| value(black_box(place(i)))).sum();
        each = each.min(started.elapsed().as_nanos() as f64 / POINTS as f64);
    }
    println!("{name:24} {each:8.1} ns  (mean {:.6})", sum / POINTS as f64);
}

fn main() {
    for generator in [NoiseGenerator::Original, NoiseGenerator::RangeCorrected, NoiseGenerator::Perlin] {
        measure(&format!("noise {generator:?}"), |p| generator.noise(p));
    }
    measure("vector noise", |p| vector_noise(p).x);
    let octaves = Octaves::default();
    measure("turbulence", |p| octaves.vector(p).x);
    for (name, kind) in [
        ("granite", PatternKind::Granite),
        ("wrinkles", PatternKind::Wrinkles),
        ("agate", PatternKind::Agate { agate_turb: 1.0 }),
        ("cells", PatternKind::Cells),
        ("crackle", PatternKind::Crackle(Crackle::default())),
        ("crackle solid", PatternKind::Crackle(Crackle { solid: true, ..Crackle::default() })),
    ] {
        let pattern = Pattern::plain(kind);
        measure(name, |p| pattern.value(p, &SurfaceContext::NONE));
    }
}
