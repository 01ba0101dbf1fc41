//! SDL: `camera { aperture F blur_samples I, I focal_point V confidence F variance F bokeh { pigment {...} } }`.
//!
//! Rays start from points of a disc half as wide as the aperture, and meet where things are sharp. A pixel gets rays
//! until the variance of their mean is, with the confidence asked for, below the limit.

use statrs::distribution::{ChiSquared, ContinuousCDF};

use crate::graph::camera as graph;
use crate::math::{Ray, Vec3};
use crate::pattern::SurfaceContext;
use crate::render::Random;
use crate::shade::Radiance;
use crate::texture::Pigment;

/// Rays between two looks at the variance.
const BATCH: usize = 4;
/// Half the side of the square that all lens points lie in, in apertures' radii.
const HALF: f64 = 0.5;

/// A camera's lens.
#[derive(Clone, Debug)]
pub struct Lens {
    /// Where the rays start, relative to the middle.
    points: Vec<[f64; 2]>,
    /// How far points are shifted at random: the whole range.
    jitter: f64,
    /// The axes of the lens; their length is half the aperture.
    axes: [Vec3; 2],
    /// Where the middle of the lens is, for orthographic cameras too.
    location: Vec3,
    /// Distance of the sharp plane, in lengths of the ray's direction.
    focal_distance: f64,
    minimum: usize,
    /// The largest variance that is good enough, by number of rays less one.
    thresholds: Vec<f64>,
}

/// Sums over the rays of one pixel.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    first: [f64; 4],
    second: [f64; 4],
}

impl Lens {
    /// Prepares a lens for a camera that looks along `direction`.
    pub fn new(blur: &graph::FocalBlur, camera: &graph::Camera, bokeh: Option<&Pigment>) -> Lens {
        let count = blur.blur_samples.1.max(1);
        let (points, jitter) = match bokeh {
            Some(pigment) => (bright_points(pigment, count), 1.0 / (count as f64).sqrt()),
            None => disc_points(count),
        };
        Lens {
            points,
            jitter,
            axes: [camera.right, camera.up].map(|axis| axis.normalized() * (blur.aperture / 2.0)),
            location: camera.location,
            focal_distance: blur.focal_distance / camera.direction.length(),
            minimum: blur.blur_samples.0.min(count),
            thresholds: thresholds(blur, count),
        }
    }

    /// The mean of as many rays as it takes; `shoot` follows one that is deflected by the number given to it.
    pub fn gather(&self, mut shoot: impl FnMut(usize) -> Radiance) -> Radiance {
        let mut sums = Sums::default();
        for number in 0..self.points.len() {
            sums.add(&shoot(number));
            let count = number + 1;
            if self.may_stop(count) && sums.variance_below(self.thresholds[number], count) {
                return sums.mean(count);
            }
        }
        sums.mean(self.points.len())
    }

    /// Whether the variance is looked at after `count` rays.
    fn may_stop(&self, count: usize) -> bool {
        let whole = match count {
            0..19 => count == 4 && self.points.len() < 7 || count == 7 || count == 13,
            _ => (count - 19) % BATCH == 0,
        };
        whole && count >= self.minimum
    }

    /// Moves the start of a ray to a point of the lens; what lies in the sharp plane stays where it is seen.
    pub fn deflect(&self, ray: &Ray, number: usize, random: &mut Random) -> Ray {
        let [x, y] = self.points[number].map(|p| p + (random.unit() - 0.5) * self.jitter);
        let shift = self.axes[0] * x + self.axes[1] * y;
        Ray { origin: self.location + shift, direction: ray.direction * self.focal_distance - shift }
    }
}

impl Sums {
    fn add(&mut self, seen: &Radiance) {
        let values = [seen.rgb.r, seen.rgb.g, seen.rgb.b, seen.transmit];
        for (i, value) in values.into_iter().enumerate() {
            self.first[i] += value;
            self.second[i] += value * value;
        }
    }

    /// Whether the variance of the mean is small in every channel.
    fn variance_below(&self, limit: f64, count: usize) -> bool {
        let n = count as f64;
        let pairs = self.first.iter().zip(&self.second);
        pairs.into_iter().all(|(first, second)| (second / n - (first / n).powi(2)) / n < limit)
    }

    fn mean(&self, count: usize) -> Radiance {
        let [r, g, b, transmit] = self.first.map(|sum| sum / count as f64);
        Radiance { rgb: crate::color::rgb(r, g, b), transmit }
    }
}

/// For 1 to `count` rays, the sample variance that a chi-squared test accepts.
fn thresholds(blur: &graph::FocalBlur, count: usize) -> Vec<f64> {
    if count < 2 {
        return vec![0.0; count];
    }
    let confidence = blur.confidence.clamp(1e-6, 1.0 - 1e-6);
    let quantile = |freedom: usize| {
        ChiSquared::new(freedom as f64).map_or(freedom as f64, |chi| chi.inverse_cdf(1.0 - confidence))
    };
    let scale = blur.variance / quantile(count - 1);
    (1..=count).map(|n| scale * quantile(n)).collect()
}

/// Points of the disc, and the range of their random shifts, as measured: a square, hexagons, or a scattered sequence.
fn disc_points(count: usize) -> (Vec<[f64; 2]>, f64) {
    let rings = match count {
        4 => return (vec![[-0.25, 0.25], [0.25, 0.25], [-0.25, -0.25], [0.25, -0.25]], 0.5),
        7 => 1,
        19 => 2,
        37 => 3,
        _ => {
            let inside = |p: &[f64; 2]| p[0].hypot(p[1]) <= HALF;
            return (scattered().filter(inside).take(count).collect(), 1.0 / (count as f64).sqrt());
        }
    };
    let spacing = 1.0 / 3.0f64.sqrt() / f64::from(rings + 1);
    let mut points = Vec::new();
    for row in -rings..=rings {
        for column in -rings..=rings {
            // Steps along three axes at 60 degrees, of which the third follows from the others.
            let steps = [row, column, -row - column].map(i32::abs);
            let ring = steps[0].max(steps[1]).max(steps[2]);
            if ring <= rings {
                let (row, column) = (f64::from(row), f64::from(column));
                let place = [(column + row / 2.0) * spacing, row * 0.75f64.sqrt() * spacing];
                points.push((turn(ring, rings, steps.contains(&0)), place));
            }
        }
    }
    points.sort_by_key(|&(turn, _)| turn);
    let points = points.into_iter().map(|(_, place)| place).collect();
    (points, spacing)
}

/// When a point of a hexagon is used: the middle and the corners first, then those in between, the rest last.
fn turn(ring: i32, rings: i32, corner: bool) -> i32 {
    match (ring, corner) {
        (0, _) => 0,
        (_, true) if ring == rings => 1,
        (1, _) => 2,
        (2, false) => 3,
        _ => 4,
    }
}

/// Points where a bokeh pigment is bright, the more the brighter.
fn bright_points(pigment: &Pigment, count: usize) -> Vec<[f64; 2]> {
    /// A pigment that is black all over is given up after this many points for each that is wanted.
    const PATIENCE: usize = 1000;
    let mut random = Random::seeded(count as u64, 0, 2);
    let bright = |&[x, y]: &[f64; 2]| {
        let point = Vec3 { x: x + HALF, y: y + HALF, z: 0.0 };
        pigment.color(point, &SurfaceContext::NONE).rgb.gray() > random.unit()
    };
    let mut points: Vec<_> = scattered().take(count * PATIENCE).filter(bright).take(count).collect();
    if points.is_empty() {
        points.push([0.0; 2]);
    }
    points
}

/// An endless sequence that fills the square evenly: Halton's, to bases 2 and 3.
fn scattered() -> impl Iterator<Item = [f64; 2]> {
    let mirrored = |mut n: u64, base: u64| {
        let (mut digit, mut sum) = (1.0, 0.0);
        while n > 0 {
            digit /= base as f64;
            sum += digit * (n % base) as f64;
            n /= base;
        }
        sum
    };
    (1u64..).map(move |n| [mirrored(n, 2) - HALF, mirrored(n, 3) - HALF])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_is_as_measured() {
        // Mean square of x on the lens, jitter included.
        for (count, measured) in [(4, 0.0827), (7, 0.0430), (19, 0.0499), (37, 0.0541), (1000, 0.0625)] {
            let (points, jitter) = disc_points(count);
            assert_eq!(points.len(), count);
            let mean = points.iter().map(|p| p[0] * p[0]).sum::<f64>() / count as f64;
            let with_jitter = mean + jitter * jitter / 12.0;
            assert!((with_jitter - measured).abs() < 1e-3, "{count}: {with_jitter}");
        }
    }

    #[test]
    fn gathers_until_sure() {
        let blur = graph::FocalBlur {
            aperture: 1.0,
            blur_samples: (4, 100),
            focal_distance: 1.0,
            confidence: 0.9,
            variance: 1e-4,
            bokeh: None,
        };
        let lens = |variance| {
            let blur = graph::FocalBlur { variance, ..blur.clone() };
            let points = disc_points(100);
            Lens {
                thresholds: thresholds(&blur, 100),
                points: points.0,
                jitter: points.1,
                axes: [Vec3::X, Vec3::Y],
                location: Vec3::ZERO,
                focal_distance: 1.0,
                minimum: 4,
            }
        };
        let rays = |variance: f64| {
            let mut count = 0;
            lens(variance).gather(|number| {
                count += 1;
                Radiance { rgb: crate::color::Rgb::WHITE * (number % 2) as f64, transmit: 0.0 }
            });
            count
        };
        assert_eq!(rays(10.0), 7);
        assert!((8..100).contains(&rays(1e-2)));
        assert_eq!(rays(0.0), 100);
    }
}
