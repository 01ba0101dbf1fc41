//! SDL: `sor { 7, <1,-1>, <1,0>, <2,1>, ... open }`: the square of the radius is a cubic of the height in each piece.

use super::sphere::longitude;
use super::{Crossing, Primitive};
use crate::accel::Counters;
use crate::math::polynomial::{roots_within, value};
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Nearer crossings are not seen, as in POV-Ray; in the surface's own measure.
const NEAREST: f64 = 1e-4;
const BASE: u32 = u32::MAX;
const CAP: u32 = u32::MAX - 1;

/// One piece between two heights.
#[derive(Clone, Debug)]
struct Piece {
    low: f64,
    high: f64,
    /// Radius squared over the height above `low`, by rising power.
    square: [f64; 4],
}

/// A surface of revolution. A crossing's part is the number of the piece.
#[derive(Clone, Debug)]
pub struct Sor {
    pieces: Vec<Piece>,
    open: bool,
    bounds: Bounds,
}

impl Sor {
    /// From points (radius, height); the first and last give slopes only. None without a piece.
    pub fn new(points: &[[f64; 2]], open: bool) -> Option<Sor> {
        let slope = |p: [f64; 2], q: [f64; 2]| if q[1] == p[1] { 0.0 } else { (q[0] - p[0]) / (q[1] - p[1]) };
        let pieces: Vec<Piece> = points
            .windows(4)
            .map(|p| {
                // The cubic with the radii squared and their slopes at both ends.
                let (low, high) = (p[1][1], p[2][1]);
                let h = high - low;
                let (f0, f1) = (p[1][0] * p[1][0], p[2][0] * p[2][0]);
                let (g0, g1) = (2.0 * p[1][0] * slope(p[0], p[2]), 2.0 * p[2][0] * slope(p[1], p[3]));
                let rise = (f1 - f0) / h;
                Piece {
                    low,
                    high,
                    square: [f0, g0, (3.0 * rise - 2.0 * g0 - g1) / h, (g0 + g1 - 2.0 * rise) / (h * h)],
                }
            })
            .filter(|piece| piece.high > piece.low)
            .collect();
        let (first, last) = (pieces.first()?, pieces.last()?);
        let widest = pieces.iter().fold(0.0f64, |reach, p| {
            let h = p.high - p.low;
            let slope = [p.square[1], 2.0 * p.square[2], 3.0 * p.square[3]];
            let inner =
                roots_within::<4>(&slope, 0.0, h).iter().map(|&y| value(&p.square, y)).fold(0.0, f64::max);
            reach.max(p.square[0]).max(value(&p.square, h)).max(inner)
        });
        let r = widest.sqrt();
        let bounds = Bounds { min: vec3(-r, first.low, -r), max: vec3(r, last.high, r) };
        Some(Sor { open, bounds, pieces })
    }

    /// Height, squared radius of base and cap.
    fn ends(&self) -> [(f64, f64, u32); 2] {
        let (first, last) = (&self.pieces[0], &self.pieces[self.pieces.len() - 1]);
        [(first.low, first.square[0], BASE), (last.high, value(&last.square, last.high - last.low), CAP)]
    }
}

impl Primitive for Sor {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        mut limit: f64,
        _counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let scale = ray.direction.length();
        let d = ray.direction / scale;
        let from = from.max(NEAREST / scale);
        let start = (self.bounds.min + self.bounds.max - ray.origin * 2.0).dot(d) / 2.0;
        let o = ray.origin + d * start;
        let reach = (self.bounds.max - self.bounds.min).length();
        let (near, far) = ((from * scale - start).max(-reach), (limit * scale - start).min(reach));
        for (i, piece) in self.pieces.iter().enumerate() {
            let (mut enter, mut leave) = (near, far);
            let y = o.y - piece.low;
            if d.y != 0.0 {
                let (a, b) = (-y / d.y, (piece.high - piece.low - y) / d.y);
                (enter, leave) = (enter.max(a.min(b)), leave.min(a.max(b)));
            } else if y < 0.0 || o.y > piece.high {
                continue;
            }
            if enter > leave {
                continue;
            }
            // x² + z² less the squared radius at height y + t d.y.
            let [_, g, h, k] = piece.square;
            let cubic = [
                o.x * o.x + o.z * o.z - value(&piece.square, y),
                2.0 * (o.x * d.x + o.z * d.z) - d.y * (g + y * (2.0 * h + 3.0 * k * y)),
                d.x * d.x + d.z * d.z - d.y * d.y * (h + 3.0 * k * y),
                -k * d.y * d.y * d.y,
            ];
            for &t in roots_within::<5>(&cubic, enter, leave).iter() {
                let t = (t + start) / scale;
                if t > from && t <= limit {
                    limit = offer(Crossing::on(t, i as u32), limit);
                }
            }
        }
        if !self.open && d.y != 0.0 {
            for (y, square, part) in self.ends() {
                let t = ((y - o.y) / d.y + start) / scale;
                let p = ray.at(t);
                if t > from && t <= limit && p.x * p.x + p.z * p.z <= square {
                    limit = offer(Crossing::on(t, part), limit);
                }
            }
        }
        limit
    }

    fn inside(&self, p: Vec3) -> bool {
        let square = p.x * p.x + p.z * p.z;
        let holds = |piece: &Piece| p.y >= piece.low && p.y <= piece.high;
        self.pieces
            .iter()
            .find(|piece| holds(piece))
            .is_some_and(|piece| square <= value(&piece.square, p.y - piece.low))
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        match crossing.part {
            BASE => -Vec3::Y,
            CAP => Vec3::Y,
            part => {
                let piece = &self.pieces[part as usize];
                let [_, g, h, k] = piece.square;
                let y = p.y - piece.low;
                vec3(p.x, -0.5 * (g + y * (2.0 * h + 3.0 * k * y)), p.z)
            }
        }
    }

    /// On a cap v goes on inward by the share of the radius.
    fn uv(&self, p: Vec3, crossing: &Crossing) -> Option<[f64; 2]> {
        let [(_, base, _), (_, cap, _)] = self.ends();
        let inward = |square: f64| 1.0 - p.x.hypot(p.z) / square.sqrt();
        let v = match crossing.part {
            BASE => -inward(base),
            CAP => 1.0 + inward(cap),
            part => {
                let piece = &self.pieces[part as usize];
                (f64::from(part) + (p.y - piece.low) / (piece.high - piece.low)) / self.pieces.len() as f64
            }
        };
        Some([longitude(p), v])
    }
}
