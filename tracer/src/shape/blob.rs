//! SDL: `blob { threshold 0.6 sphere { <0,0,0>, 1, 1 } cylinder { <0,0,0>, <1,0,0>, 0.5, 1 } }`.
//!
//! A component adds strength (1 - d²/r²)² where d < r, with d the distance from a point or from a line with round ends;
//! the surface is where the sum reaches the threshold. Along a ray each part of a component is a quartic over an
//! interval; between the ends of all intervals the sum is one quartic.

use super::{frame, Crossing, Primitive};
use crate::accel::{Accelerator, AcceleratorKind, Counters, Query};
use crate::graph;
use crate::math::polynomial::{quadratic, roots_within};
use crate::math::{vec3, Bounds, Ray, Transform, Vec3};

/// Nearer crossings are not seen, in the blob's own measure: small blobs throw no shadows on themselves.
const NEAREST: f64 = 0.01;

/// Which points an element concerns.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Extent {
    /// All around the origin.
    Ball,
    /// Around the z axis from 0 to `length`.
    Tube { length: f64 },
    /// Around the origin, below z = 0.
    Lower,
    /// Around z = `length`, above it.
    Upper { length: f64 },
}

/// A part of a component, in a frame with the centre at the origin and the axis along z.
#[derive(Clone, Debug)]
struct Element {
    to_blob: Transform,
    extent: Extent,
    radius: f64,
    strength: f64,
    component: u32,
}

/// Balls and sausages that flow into each other.
#[derive(Debug)]
pub struct Blob {
    elements: Vec<Element>,
    tree: Accelerator,
    threshold: f64,
    bounds: Bounds,
    components: usize,
}

impl Element {
    fn bounds(&self) -> Bounds {
        let r = self.radius;
        let local = match self.extent {
            Extent::Ball => Bounds { min: Vec3::splat(-r), max: Vec3::splat(r) },
            Extent::Tube { length } => Bounds { min: vec3(-r, -r, 0.0), max: vec3(r, r, length) },
            Extent::Lower => Bounds { min: Vec3::splat(-r), max: vec3(r, r, 0.0) },
            Extent::Upper { length } => Bounds { min: vec3(-r, -r, length), max: vec3(r, r, length + r) },
        };
        local.transformed(&self.to_blob)
    }

    /// The squared distance over the squared radius: where the element counts, and along what.
    fn measure(&self, p: Vec3) -> Option<(f64, Vec3)> {
        let from_center = match self.extent {
            Extent::Ball => Some(p),
            Extent::Tube { length } => (p.z >= 0.0 && p.z <= length).then(|| vec3(p.x, p.y, 0.0)),
            Extent::Lower => (p.z < 0.0).then_some(p),
            Extent::Upper { length } => (p.z > length).then(|| vec3(p.x, p.y, p.z - length)),
        }?;
        let share = from_center.length_squared() / (self.radius * self.radius);
        (share < 1.0).then_some((share, from_center))
    }

    /// Its field at a point of the blob's space.
    fn field(&self, p: Vec3) -> f64 {
        self.measure(self.to_blob.inverse_point(p))
            .map_or(0.0, |(share, _)| self.strength * (1.0 - share).powi(2))
    }

    /// Slope of its field, times -1/4.
    fn slope(&self, p: Vec3) -> Vec3 {
        match self.measure(self.to_blob.inverse_point(p)) {
            Some((share, from_center)) => {
                let steepness = self.strength * (1.0 - share) / (self.radius * self.radius);
                self.to_blob.normal(from_center * steepness)
            }
            None => Vec3::ZERO,
        }
    }

    /// Where along a ray of the blob's space it counts, and the squared distance there: c + 2 b t + a t².
    fn interval(&self, ray: &Ray) -> Option<([f64; 2], [f64; 3])> {
        let Ray { origin: mut o, direction: mut d } = self.to_blob.inverse_ray(ray);
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        // Cut by a half-space: distance + slope t > 0.
        let mut keep = |distance: f64, slope: f64| {
            let t = -distance / slope;
            if slope > 0.0 {
                low = low.max(t);
            } else if slope < 0.0 {
                high = high.min(t);
            } else if distance < 0.0 {
                high = f64::NEG_INFINITY;
            }
        };
        match self.extent {
            Extent::Ball => {}
            Extent::Tube { length } => {
                keep(o.z, d.z);
                keep(length - o.z, -d.z);
                (o.z, d.z) = (0.0, 0.0);
            }
            Extent::Lower => keep(-o.z, -d.z),
            Extent::Upper { length } => {
                keep(o.z - length, d.z);
                o.z -= length;
            }
        }
        let r = self.radius;
        let square = [o.length_squared(), o.dot(d), d.length_squared()];
        if square[2] > 1e-20 {
            let ends = quadratic(square[2], square[1], square[0] - r * r);
            let [near, far] = ends[..] else { return None };
            (low, high) = (low.max(near), high.min(far));
        } else if square[0] > r * r {
            return None;
        }
        (low < high).then_some(([low, high], square))
    }
}

/// An end of an element's interval along a ray.
struct Event {
    t: f64,
    /// Added to the sum of quartics from here on.
    change: [f64; 5],
    /// Whether an element begins (1) or ends (-1) here.
    step: i32,
}

impl Blob {
    /// From the components; none of strength zero.
    pub fn new(blob: &graph::shapes::Blob) -> Blob {
        let mut elements = Vec::new();
        for (i, component) in blob.components.iter().enumerate() {
            let mut add = |frame: Transform, extent: Extent| {
                elements.push(Element {
                    to_blob: frame.then(&component.transform),
                    extent,
                    radius: component.radius,
                    strength: component.strength,
                    component: i as u32,
                });
            };
            let end = component.end.and_then(|end| Some((end, frame(component.center, end)?)));
            match end {
                None => add(Transform::translate(component.center), Extent::Ball),
                Some((end, frame)) => {
                    let length = (end - component.center).length();
                    add(frame, Extent::Tube { length });
                    add(frame, Extent::Lower);
                    add(frame, Extent::Upper { length });
                }
            }
        }
        let boxes: Vec<Bounds> = elements.iter().map(Element::bounds).collect();
        Blob {
            tree: Accelerator::build(AcceleratorKind::Octree, &boxes),
            // Nothing outside the components that add; those that take away do not reach farther.
            bounds: elements
                .iter()
                .zip(&boxes)
                .filter(|(e, _)| e.strength > 0.0)
                .fold(Bounds::EMPTY, |sum, (_, b)| sum.union(b)),
            elements,
            threshold: blob.threshold,
            components: blob.components.len(),
        }
    }

    fn each_near(&self, p: Vec3, mut visit: impl FnMut(&Element)) {
        self.tree.around(p, |item| {
            visit(&self.elements[item as usize]);
            false
        });
    }

    /// The share of each component in the field at a point.
    pub fn component_shares(&self, p: Vec3) -> Vec<(u32, f64)> {
        let mut fields = vec![0.0; self.components];
        self.each_near(p, |e| fields[e.component as usize] += e.field(p).abs());
        let sum: f64 = fields.iter().sum();
        let shares = fields.iter().enumerate().map(|(i, f)| (i as u32, f / sum));
        shares.filter(|&(_, share)| share > 0.0).collect()
    }

    /// Where the ray first enters an element, and the ends of all intervals from there, in order.
    fn events(&self, ray: &Ray, counters: &mut Counters) -> (f64, Vec<Event>) {
        let mut hit: Vec<&Element> = Vec::new();
        let mut start = f64::INFINITY;
        self.tree.along(&Query::new(*ray), f64::INFINITY, counters, |item, limit, _| {
            let element = &self.elements[item as usize];
            if let Some(([low, _], _)) = element.interval(ray) {
                start = start.min(low);
                hit.push(element);
            }
            limit
        });
        // Counted from there, for precision.
        let moved = Ray { origin: ray.at(start), direction: ray.direction };
        let mut events: Vec<Event> = Vec::with_capacity(2 * hit.len());
        for element in hit {
            if let Some(([low, high], [c, b, a])) = element.interval(&moved) {
                // strength (1 - (c + 2 b t + a t²) / r²)²
                let r = element.radius * element.radius;
                let (p, q, s) = (1.0 - c / r, -2.0 * b / r, -a / r);
                let k = element.strength;
                let quartic =
                    [k * p * p, 2.0 * k * p * q, k * (q * q + 2.0 * p * s), 2.0 * k * q * s, k * s * s];
                events.push(Event { t: low, change: quartic, step: 1 });
                events.push(Event { t: high, change: quartic.map(|c| -c), step: -1 });
            }
        }
        events.sort_unstable_by(|a, b| a.t.total_cmp(&b.t));
        (start, events)
    }
}

impl Primitive for Blob {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        mut limit: f64,
        counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let from = from.max(NEAREST / ray.direction.length());
        let (start, events) = self.events(ray, counters);
        let mut sum = [-self.threshold, 0.0, 0.0, 0.0, 0.0];
        let mut active = 0;
        for (i, event) in events.iter().enumerate() {
            active += event.step;
            if active == 0 {
                sum = [-self.threshold, 0.0, 0.0, 0.0, 0.0];
                continue;
            }
            for (s, c) in sum.iter_mut().zip(&event.change) {
                *s += c;
            }
            let (low, high) = (event.t, events[i + 1].t);
            if high + start <= from || low >= high {
                continue;
            }
            if low + start > limit {
                break;
            }
            for &t in roots_within::<5>(&sum, low.max(from - start), high).iter() {
                let t = t + start;
                if t > from && t <= limit {
                    limit = offer(Crossing::at(t), limit);
                }
            }
        }
        limit
    }

    fn inside(&self, p: Vec3) -> bool {
        let mut field = 0.0;
        self.each_near(p, |e| field += e.field(p));
        field > self.threshold
    }

    fn normal(&self, p: Vec3, _: &Crossing) -> Vec3 {
        let mut slope = Vec3::ZERO;
        self.each_near(p, |e| slope += e.slope(p));
        if slope.length_squared() == 0.0 {
            Vec3::X
        } else {
            slope
        }
    }
}
