//! Axis-aligned boxes.

use super::{Transform, Vec3};

/// The points between two corners; infinite in a direction where a corner is infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates.
    pub min: Vec3,
    /// Largest coordinates.
    pub max: Vec3,
}

impl Bounds {
    /// Holds nothing; the neutral element of `union`.
    pub const EMPTY: Bounds = Bounds { min: Vec3::splat(f64::INFINITY), max: Vec3::splat(f64::NEG_INFINITY) };
    /// Holds everything.
    pub const INFINITE: Bounds =
        Bounds { min: Vec3::splat(f64::NEG_INFINITY), max: Vec3::splat(f64::INFINITY) };

    /// The smallest box around the given points.
    pub fn around(points: impl IntoIterator<Item = Vec3>) -> Bounds {
        points.into_iter().fold(Bounds::EMPTY, |b, p| Bounds { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The smallest box around both.
    pub fn union(&self, o: &Bounds) -> Bounds {
        Bounds { min: self.min.min(o.min), max: self.max.max(o.max) }
    }

    /// What both share (possibly empty).
    pub fn intersection(&self, o: &Bounds) -> Bounds {
        Bounds { min: self.min.max(o.min), max: self.max.min(o.max) }
    }

    /// Whether nothing is inside.
    pub fn is_empty(&self) -> bool {
        self.min.x > self.max.x || self.min.y > self.max.y || self.min.z > self.max.z
    }

    /// Whether every side is finite.
    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// Whether `p` lies inside or on the border.
    pub fn contains(&self, p: Vec3) -> bool {
        (0..3).all(|a| self.min[a] <= p[a] && p[a] <= self.max[a])
    }

    /// The box with all sides moved outward.
    pub fn widened(&self, margin: f64) -> Bounds {
        Bounds { min: self.min - Vec3::splat(margin), max: self.max + Vec3::splat(margin) }
    }

    /// The eight corners.
    pub fn corners(&self) -> [Vec3; 8] {
        std::array::from_fn(|i| {
            let pick =
                |bit: usize, axis: usize| if i >> bit & 1 == 0 { self.min[axis] } else { self.max[axis] };
            Vec3 { x: pick(0, 0), y: pick(1, 1), z: pick(2, 2) }
        })
    }

    /// The box around the transformed box; an infinite box stays wholly infinite.
    pub fn transformed(&self, t: &Transform) -> Bounds {
        if self.is_empty() {
            return *self;
        }
        if t.is_identity() {
            return *self;
        }
        if !self.is_finite() {
            return Bounds::INFINITE;
        }
        Bounds::around(self.corners().map(|c| t.point(c)))
    }
}
