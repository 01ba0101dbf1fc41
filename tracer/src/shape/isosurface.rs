//! SDL: `isosurface { function { x*x + y*y + z*z - 1 } contained_by { box { -2, 2 } } max_gradient 4 }`.
//!
//! Along a ray the function is halved and halved again wherever, by `max_gradient`, it may fall below the threshold,
//! until a piece is shorter than `accuracy`: the end of the first such piece that is below is the hit. So a gradient that
//! is too small leaves the same holes as in POV-Ray.

use super::container::Container;
use super::{Crossing, Primitive};
use crate::accel::Counters;
use crate::function::Function;
use crate::graph::shapes as graph;
use crate::math::{vec3, Bounds, Ray, Vec3};

/// The part number of the surface itself; the container's parts come after it.
const SURFACE: u32 = 0;
/// After a hit the search goes on this many accuracies behind it.
const STEP_BEHIND: f64 = 5.0;
/// A ray that starts where the function is this many accuracies times gradients from 0 starts on the surface.
const ON_SURFACE: f64 = 4.0;
/// `evaluate` measures the gradient at so many places along each axis.
const MEASURED: u32 = 24;
/// Shorter pieces are not halved, whatever the accuracy.
const SHORTEST: f64 = 1e-12;
/// A ray takes no more samples than this: a gradient without bounds would halve a large container for ever.
const PATIENCE: u32 = 1 << 19;

/// Where a function has the value of the threshold.
#[derive(Clone, Debug)]
pub struct Isosurface {
    function: Function,
    container: Container,
    threshold: f64,
    accuracy: f64,
    max_gradient: f64,
    open: bool,
    max_trace: usize,
    /// 1, or -1 where `polarity` says that larger values are inside.
    polarity: f64,
}

impl Isosurface {
    /// With its function compiled.
    pub fn new(node: &graph::Isosurface, function: Function) -> Isosurface {
        let mut surface = Isosurface {
            function,
            container: Container::from(&node.contained_by),
            threshold: node.threshold,
            accuracy: node.accuracy,
            max_gradient: node.max_gradient,
            open: node.open,
            max_trace: node.max_trace.max(1) as usize,
            polarity: if node.polarity { -1.0 } else { 1.0 },
        };
        // POV-Ray learns the gradient from ray to ray; here it is measured once, so that no order of rays matters.
        if let Some(Vec3 { x: least, y: overestimation, .. }) = node.evaluate {
            surface.max_gradient = least.max(surface.steepest_measured() * overestimation.max(1.0));
        }
        surface
    }

    /// The largest gradient on a grid in the container.
    fn steepest_measured(&self) -> f64 {
        let Bounds { min, max } = self.container.bounds();
        let cell = (max - min) / f64::from(MEASURED);
        let step = self.accuracy.max(SHORTEST);
        let mut steepest = 0.0_f64;
        for i in 0..MEASURED.pow(3) {
            let index = vec3(
                f64::from(i % MEASURED),
                f64::from(i / MEASURED % MEASURED),
                f64::from(i / MEASURED / MEASURED),
            );
            let point = min + cell.mul_each(index + Vec3::splat(0.5));
            let gradient = self.rise(point, step) / step;
            if self.container.inside(point) && gradient.is_finite() {
                steepest = steepest.max(gradient.length());
            }
        }
        steepest
    }

    /// By how much the height rises over a step along each axis.
    fn rise(&self, point: Vec3, step: f64) -> Vec3 {
        let here = self.height(point);
        let rise = |axis: Vec3| self.height(point + axis * step) - here;
        vec3(rise(Vec3::X), rise(Vec3::Y), rise(Vec3::Z))
    }

    /// The function above its threshold: negative inside.
    #[inline]
    fn height(&self, p: Vec3) -> f64 {
        (self.function.at(p) - self.threshold) * self.polarity
    }
}

/// A place on the ray and the height there.
#[derive(Clone, Copy)]
struct Sample {
    t: f64,
    height: f64,
}

/// A search along one ray. The shape's own lengths may differ from the ray's, which accuracy is measured by.
struct Search<'a> {
    surface: &'a Isosurface,
    ray: Ray,
    /// 1, or -1 while the ray is inside.
    sign: f64,
    /// What the height can fall along one unit of the ray.
    steepest: f64,
    /// Hits beyond it do not matter.
    limit: f64,
    /// How many more samples are worth taking.
    patience: u32,
}

impl Search<'_> {
    #[inline]
    fn sample(&self, t: f64) -> Sample {
        Sample { t, height: self.sign * self.surface.height(self.ray.at(t)) }
    }

    /// The first place from `a` to `b` where the height falls below 0. `fall` is what it can fall in between.
    fn first_below(&mut self, a: Sample, b: Sample, fall: f64, length: f64) -> Option<f64> {
        if length < self.surface.accuracy.max(SHORTEST) {
            return (b.height < 0.0).then_some(b.t);
        }
        let reaches = a.height + b.height - fall < 0.0;
        if !reaches || a.t > self.limit || self.patience == 0 {
            return None;
        }
        self.patience -= 1;
        let (fall, length) = (fall * 0.5, length * 0.5);
        let middle = self.sample(a.t + length);
        self.first_below(a, middle, fall, length).or_else(|| self.first_below(middle, b, fall, length))
    }

    /// The first root between two places.
    fn root(&mut self, from: f64, to: f64) -> Option<f64> {
        let mut a = self.sample(from);
        // An open surface is seen from inside too.
        if self.surface.open && a.height < 0.0 {
            self.sign = -self.sign;
            a.height = -a.height;
        }
        let b = self.sample(to);
        self.first_below(a, b, self.steepest * (to - from), to - from)
    }
}

impl Primitive for Isosurface {
    fn bounds(&self) -> Bounds {
        self.container.bounds()
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        mut limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let Some([enter, leave]) = self.container.span(ray) else { return limit };
        if leave.t <= from || enter.t > limit {
            return limit;
        }
        let (mut start, end) = (enter.t.max(0.0), leave.t);
        if end - start < self.accuracy {
            return limit;
        }
        let steepest = self.max_gradient * ray.direction.length();
        let mut search = Search { surface: self, ray: *ray, sign: 1.0, steepest, limit, patience: PATIENCE };
        let mut give = |crossing: Crossing, limit: &mut f64| {
            if crossing.t > from && crossing.t <= *limit {
                *limit = offer(crossing, *limit);
            }
        };
        let on_container = |c: Crossing| Crossing { part: c.part + SURFACE + 1, ..c };
        let first = search.sample(start);
        // A ray that left the container's face may seem to start just before it.
        let from_inside = enter.t <= self.accuracy;
        if !from_inside {
            // The search goes on as from outside: it finds the surface at once, just behind the container.
            if !self.open && first.height < 0.0 {
                give(on_container(enter), &mut limit);
            }
        } else if first.height.abs() < self.max_gradient * self.accuracy * ON_SURFACE
            || (!self.open && first.height < 0.0)
        {
            start = self.accuracy * STEP_BEHIND;
            if end - start < self.accuracy {
                return limit;
            }
            if search.sample(start).height < 0.0 {
                search.sign = -1.0;
            }
        }
        for _ in 0..self.max_trace {
            search.limit = limit;
            let Some(root) = search.root(start, end) else { break };
            give(Crossing::on(root, SURFACE), &mut limit);
            start = root + self.accuracy * STEP_BEHIND;
            if end - start < self.accuracy || start > limit {
                break;
            }
            search.sign = -search.sign;
        }
        if from_inside && !self.open && self.height(ray.at(end)) < 0.0 {
            give(on_container(leave), &mut limit);
        }
        limit
    }

    fn inside(&self, point: Vec3) -> bool {
        self.container.inside(point) && self.height(point) <= 0.0
    }

    /// There may be more than `max_trace`.
    fn tells_all(&self) -> bool {
        false
    }

    /// By differences over `accuracy`.
    fn normal(&self, point: Vec3, crossing: &Crossing) -> Vec3 {
        if crossing.part != SURFACE {
            return self
                .container
                .normal(point, &Crossing { part: crossing.part - SURFACE - 1, ..*crossing });
        }
        let normal = self.rise(point, self.accuracy);
        if normal == Vec3::ZERO || !normal.is_finite() {
            return Vec3::X;
        }
        normal
    }
}
