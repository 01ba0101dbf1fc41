//! SDL: `media { method 1|2|3 samples I, I aa_threshold F aa_level I confidence F variance F jitter F }`.

use super::stretches::Stretch;
use super::{Influence, Way};
use crate::color::Rgb;
use crate::media::Sampling;
use crate::shade::Tracer;

/// A sample with its place in the stretch, 0 to 1.
#[derive(Clone, Copy)]
struct Knot {
    at: f64,
    influence: Influence,
}

impl Tracer<'_> {
    /// Methods 1 and 2: the mean of samples at random or evenly placed; more where they vary too much.
    pub(super) fn sample_evenly(&mut self, way: &Way, stretch: &Stretch, sampling: &Sampling) -> Influence {
        let (least, most) = sampling.samples;
        let (mut sum, mut squares) = (Influence::NONE, Rgb::BLACK);
        let mut count = 0;
        while count < least || (count < most && varies(&sum, squares, count, sampling)) {
            let at = if sampling.method == 2 && count < least {
                (count as f64 + 0.5 + self.jitter(sampling)) / least as f64
            } else {
                self.random.unit()
            };
            let sample = self.sample(way, stretch, at, true);
            sum.add_scaled(&sample, 1.0);
            squares += sample.light.mul_each(sample.light);
            count += 1;
        }
        let share = 1.0 / count as f64;
        Influence { light: sum.light * share, depth: sum.depth * share }
    }

    /// Method 3: a row of samples, with more between those that differ. The row ends short of the far end.
    pub(super) fn sample_adaptively(
        &mut self,
        way: &Way,
        stretch: &Stretch,
        sampling: &Sampling,
        aa_threshold: f64,
    ) -> Influence {
        let count = (sampling.samples.0 / 2 + 2).max(3);
        let share = 1.0 / (count - 1) as f64;
        let mut whole = Influence::NONE;
        let mut before = self.knot(way, stretch, 0.0);
        for i in 1..count {
            let at = (i as f64 + self.jitter(sampling)) / count as f64;
            let next = self.knot(way, stretch, at);
            let level = sampling.aa_level - 1;
            let between = self.between(way, stretch, &before, &next, level, sampling, aa_threshold);
            whole.add_behind(&between, share);
            before = next;
        }
        whole
    }

    /// The mean between two samples, with one more in the middle and, as far as `level` allows, in each half.
    #[allow(clippy::too_many_arguments)] // the ends, and what stays the same
    fn between(
        &mut self,
        way: &Way,
        stretch: &Stretch,
        start: &Knot,
        end: &Knot,
        level: usize,
        sampling: &Sampling,
        aa_threshold: f64,
    ) -> Influence {
        let at = (start.at + end.at) / 2.0 + self.jitter(sampling) * (end.at - start.at);
        let middle = self.knot(way, stretch, at);
        let mut mean = Influence::NONE;
        for (outer, half) in [(start, [start, &middle]), (end, [&middle, end])] {
            let differs = difference(half[0].influence.light, half[1].influence.light) > aa_threshold;
            if level > 0 && differs {
                let finer = self.between(way, stretch, half[0], half[1], level - 1, sampling, aa_threshold);
                mean.add_scaled(&finer, 0.5);
            } else {
                mean.add_scaled(&outer.influence, 1.0 / 3.0);
                mean.add_scaled(&middle.influence, 1.0 / 6.0);
            }
        }
        mean
    }

    fn knot(&mut self, way: &Way, stretch: &Stretch, at: f64) -> Knot {
        Knot { at, influence: self.sample(way, stretch, at, false) }
    }

    /// A random shift, in steps between samples.
    fn jitter(&mut self, sampling: &Sampling) -> f64 {
        if sampling.jitter == 0.0 {
            0.0
        } else {
            sampling.jitter * (self.random.unit() - 0.5)
        }
    }
}

/// Sum of the channels' differences.
fn difference(a: Rgb, b: Rgb) -> f64 {
    (a.r - b.r).abs() + (a.g - b.g).abs() + (a.b - b.b).abs()
}

/// Whether the mean's variance is above what `variance` and `confidence` allow after `count` samples.
fn varies(sum: &Influence, squares: Rgb, count: usize, sampling: &Sampling) -> bool {
    let n = count as f64;
    let mean = sum.light * (1.0 / n);
    let variance = (squares * (1.0 / n) + mean.mul_each(mean) * -1.0) * (1.0 / n);
    variance.max_element() >= sampling.variance / chi_square(n, sampling.confidence) * n
}

/// The value that a chi-square variable of `n` degrees exceeds with this probability (Wilson and Hilferty).
fn chi_square(n: f64, probability: f64) -> f64 {
    // Winitzki's approximation of the inverse error function.
    let y = 1.0 - 2.0 * probability.clamp(1e-6, 1.0 - 1e-6);
    let log = (1.0 - y * y).ln();
    let first = 2.0 / (std::f64::consts::PI * 0.147) + log / 2.0;
    let z = (((first * first - log / 0.147).sqrt() - first).sqrt()).copysign(y) * std::f64::consts::SQRT_2;
    let spread = 2.0 / (9.0 * n);
    (n * (1.0 - spread + z * spread.sqrt()).powi(3)).max(1e-6)
}

#[cfg(test)]
mod tests {
    use super::chi_square;

    #[test]
    fn chi_square_equals_tables() {
        for (n, probability, value) in [(10.0, 0.9, 4.865), (10.0, 0.1, 15.987), (30.0, 0.5, 29.336)] {
            assert!((chi_square(n, probability) - value).abs() < 0.03, "{n} {probability}");
        }
    }
}
