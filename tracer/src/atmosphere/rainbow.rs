//! SDL: `rainbow { direction V angle F width F distance F color_map {...} jitter F up V arc_angle F falloff_angle F }`.

use crate::color::{Rgb, Rgbft};
use crate::graph::atmosphere as graph;
use crate::math::{Ray, Vec3};
use crate::render::Random;
use crate::texture::ColorMap;

/// A bow around the direction that its light travels in.
#[derive(Clone, Debug)]
pub struct Rainbow {
    /// Away from the light.
    axis: Vec3,
    up: Vec3,
    right: Vec3,
    /// The angle with the axis where the colours begin, and over which they go.
    start: f64,
    width: f64,
    jitter: f64,
    colors: ColorMap,
    /// What lies this far behind it is seen by 1/e.
    distance: f64,
    /// The angle with `up`, to both sides, where the bow begins to fade, and where it ends.
    falloff: f64,
    arc: f64,
}

/// What a bow does to light from behind it.
pub(super) struct Bow {
    /// The share that comes through, by channel.
    pub left: Rgb,
    /// The share of the background's transparency that stays.
    pub transmit: f64,
    /// Light of its own.
    pub own: Rgb,
}

impl Rainbow {
    /// A bow, unless there is nothing to be seen of it.
    pub fn new(bow: &graph::Rainbow) -> Option<Rainbow> {
        let colors = bow.color_map.as_ref().filter(|_| bow.width != 0.0 && bow.distance != 0.0)?;
        let axis = bow.direction.normalized();
        let right = axis.cross(bow.up).normalized();
        Some(Rainbow {
            axis,
            up: right.cross(axis).normalized(),
            right,
            start: (bow.angle - bow.width / 2.0).to_radians(),
            width: bow.width.to_radians(),
            jitter: bow.jitter,
            colors: ColorMap::from(colors),
            distance: bow.distance,
            falloff: (bow.falloff_angle / 2.0).to_radians(),
            arc: (bow.arc_angle / 2.0).to_radians(),
        })
    }

    /// What happens to light from `distance` along the ray, where the bow stands.
    pub(super) fn look(&self, ray: &Ray, distance: f64, random: &mut Random) -> Option<Bow> {
        let aside = self.angle_with_up(ray.direction);
        let cos = self.axis.dot(ray.direction);
        if aside > self.arc || cos < 0.0 {
            return None;
        }
        let mut place = (cos.min(1.0).acos() - self.start) / self.width;
        if self.jitter > 0.0 {
            place += (2.0 * random.unit() - 1.0) * self.jitter;
        }
        if !(0.0..1.0).contains(&place) {
            return None;
        }
        let Rgbft { rgb, filter, transmit } = self.colors.color(place);
        let least = transmit + (1.0 - transmit) * self.fading(aside);
        let left = (-distance / self.distance).exp().max(least);
        let own = 1.0 - left;
        let tint = rgb.map(|c| 1.0 + filter * own * (c - 1.0));
        Some(Bow { left: tint * left, transmit: left * transmit, own: rgb * own })
    }

    /// The angle, seen along the axis, between a direction and `up`.
    fn angle_with_up(&self, direction: Vec3) -> f64 {
        direction.dot(self.right).abs().atan2(direction.dot(self.up))
    }

    /// How much the bow has faded towards its end: 0 not at all.
    fn fading(&self, aside: f64) -> f64 {
        if self.arc <= self.falloff || aside <= self.falloff {
            return 0.0;
        }
        let share = (aside - self.falloff) / (self.arc - self.falloff);
        (3.0 - 2.0 * share) * share * share
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::rgb;
    use crate::math::vec3;

    fn bow(distance: f64, arc_angle: f64, transmit: f64) -> Rainbow {
        let color = Rgbft { rgb: rgb(1.0, 0.5, 0.0), filter: 0.0, transmit };
        let color_map = graph::ColorMap { entries: vec![(0.0, color)], blend_mode: 0, blend_gamma: 2.5 };
        Rainbow::new(&graph::Rainbow {
            direction: vec3(0.0, 0.0, 2.0),
            angle: 20.0,
            width: 10.0,
            color_map: Some(color_map),
            distance,
            jitter: 0.0,
            up: vec3(0.0, 1.0, 1.0),
            arc_angle,
            falloff_angle: 0.0,
        })
        .unwrap()
    }

    fn towards(angle: f64, aside: f64) -> Ray {
        let (sin, cos) = f64::to_radians(angle).sin_cos();
        let (x, y) = f64::to_radians(aside).sin_cos();
        Ray { origin: Vec3::ZERO, direction: vec3(sin * x, sin * y, cos) }
    }

    #[test]
    fn it_stands_between_two_angles() {
        let bow = bow(10.0, f64::INFINITY, 0.0);
        let seen = |angle| bow.look(&towards(angle, 0.0), f64::INFINITY, &mut Random::seeded(0, 0, 0));
        assert!(seen(14.9).is_none() && seen(25.1).is_none());
        let seen = seen(16.0).unwrap();
        assert_eq!((seen.left, seen.own), (Rgb::BLACK, rgb(1.0, 0.5, 0.0)));
    }

    #[test]
    fn it_ends_aside_and_covers_with_distance() {
        let seen = |arc, aside, distance| {
            bow(10.0, arc, 0.3)
                .look(&towards(20.0, aside), distance, &mut Random::seeded(0, 0, 0))
                .map(|b| b.left.r)
        };
        assert_eq!(seen(100.0, 51.0, 5.0), None);
        assert_eq!(seen(f64::INFINITY, 170.0, f64::INFINITY), Some(0.3));
        assert!((seen(f64::INFINITY, 170.0, 5.0).unwrap() - (-0.5f64).exp()).abs() < 1e-12);
        // Half of the way to the end, half has faded.
        assert!((seen(100.0, 25.0, f64::INFINITY).unwrap() - 0.65).abs() < 1e-12);
    }
}
