//! SDL: `camera { perspective | orthographic | fisheye | ... }`: the laws were probed direction by direction.

use std::f64::consts::PI;

use crate::graph::camera::{Camera, CameraKind};
use crate::math::{Ray, Vec3};

/// The frame of a camera and the law of its rays.
#[derive(Clone, Debug)]
pub struct Projection {
    kind: CameraKind,
    location: Vec3,
    direction: Vec3,
    right: Vec3,
    up: Vec3,
    /// Lengths of `right` and `up`.
    size: [f64; 2],
    /// The three vectors with length one.
    frame: [Vec3; 3],
    /// Horizontal and vertical angle, in radians.
    angle: [f64; 2],
}

/// Width over height from which an omnimax picture's dome is cut at the bottom, not at the sides.
const OMNIMAX_ASPECT: f64 = 1.283458;

impl Projection {
    /// Prepares a camera.
    pub fn new(camera: &Camera) -> Projection {
        let Camera { kind, location, direction, right, up, .. } = *camera;
        Projection {
            kind,
            location,
            direction,
            right,
            up,
            size: [right.length(), up.length()],
            frame: [right.normalized(), up.normalized(), direction.normalized()],
            angle: [camera.angle.to_radians(), camera.vertical_angle.to_radians()],
        }
    }

    /// The camera's place.
    pub fn location(&self) -> Vec3 {
        self.location
    }

    /// Whether all rays start at the camera's place.
    pub fn has_one_origin(&self) -> bool {
        !matches!(self.kind, CameraKind::Orthographic | CameraKind::Cylinder3 | CameraKind::Cylinder4)
    }

    /// Where in the plane of the camera's `normal` the ray through (u, v) asks for bumps: at the coordinates that the
    /// law of its kind works with.
    pub fn bump_place(&self, u: f64, v: f64) -> [f64; 2] {
        let [width, height] = self.size;
        let [horizontal, vertical] = self.angle;
        match self.kind {
            CameraKind::Fisheye => {
                let [turn, radius] = polar(2.0 * u * width, 2.0 * v * height);
                [turn, radius * horizontal / 2.0]
            }
            CameraKind::UltraWideAngle => [u * horizontal, v * horizontal * height / width],
            CameraKind::Omnimax => {
                let [x, y] = self.omnimax_place(u, v);
                let [turn, radius] = polar(x, y);
                [turn, omnimax_lens(radius)]
            }
            CameraKind::Panoramic => [PI * (0.5 - u), PI * v],
            CameraKind::Spherical => [u * horizontal, v * vertical],
            CameraKind::Cylinder1 | CameraKind::Cylinder3 => [u * horizontal, v * height],
            CameraKind::Cylinder2 | CameraKind::Cylinder4 => [u * width, v * horizontal],
            _ => [u, v],
        }
    }

    /// The ray through (u, v), each from -0.5 to 0.5, to the right and up; any length. `None` outside a round picture.
    pub fn ray(&self, u: f64, v: f64) -> Option<Ray> {
        let from = |origin: Vec3, direction: Vec3| Some(Ray { origin, direction });
        let here = |direction: Vec3| from(self.location, direction);
        let [width, height] = self.size;
        let [horizontal, vertical] = self.angle;
        match self.kind {
            CameraKind::Perspective | CameraKind::MeshCamera | CameraKind::UserDefined => {
                here(self.direction + self.right * u + self.up * v)
            }
            CameraKind::Orthographic => from(self.location + self.right * u + self.up * v, self.direction),
            CameraKind::Fisheye => {
                self.dome(2.0 * u * width, 2.0 * v * height, |radius| radius * horizontal / 2.0, |_, _| true)
            }
            CameraKind::Omnimax => {
                let [x, y] = self.omnimax_place(u, v);
                // The dome ends at a plane tilted 45 degrees.
                self.dome(x, y, omnimax_lens, |up, ahead| up >= -ahead)
            }
            CameraKind::UltraWideAngle => {
                let (x, y) = (u * horizontal, v * horizontal * height / width);
                here(self.towards(x.sin(), y.sin(), x.cos() * y.cos()))
            }
            CameraKind::Panoramic => {
                let (x, y) = (PI * u, PI * v);
                here(self.right * x.sin() + self.up * y.tan() + self.direction * x.cos())
            }
            CameraKind::Spherical => {
                let raised = self.direction.rotated(self.frame[0], -v * vertical);
                here(raised.rotated(self.frame[1], u * horizontal))
            }
            CameraKind::Cylinder1 => {
                let x = u * horizontal;
                here(self.towards(x.sin(), v * height, x.cos()))
            }
            CameraKind::Cylinder2 => {
                let y = v * horizontal;
                here(self.towards(u * width, y.sin(), y.cos()))
            }
            CameraKind::Cylinder3 => {
                let x = u * horizontal;
                from(self.location + self.up * v, self.towards(x.sin(), 0.0, x.cos()))
            }
            CameraKind::Cylinder4 => {
                let y = v * horizontal;
                from(self.location + self.right * u, self.towards(0.0, y.sin(), y.cos()))
            }
        }
    }

    /// The place on an omnimax dome's disc.
    fn omnimax_place(&self, u: f64, v: f64) -> [f64; 2] {
        let aspect = self.size[0] / self.size[1];
        let stretch = if aspect > OMNIMAX_ASPECT { aspect / OMNIMAX_ASPECT } else { 1.0 };
        [2.0 * u * stretch, (2.0 * v - 1.0) / aspect.min(OMNIMAX_ASPECT) + 1.0]
    }

    fn towards(&self, right: f64, up: f64, ahead: f64) -> Vec3 {
        self.frame[0] * right + self.frame[1] * up + self.frame[2] * ahead
    }

    /// A round picture: the distance from its centre gives the angle from the axis. Rays that go upwards and ahead by
    /// shares that are not `shown` are left out.
    fn dome(
        &self,
        x: f64,
        y: f64,
        angle: impl Fn(f64) -> f64,
        shown: impl Fn(f64, f64) -> bool,
    ) -> Option<Ray> {
        let radius = x.hypot(y);
        if radius > 1.0 {
            return None;
        }
        let (sin, cos) = angle(radius).sin_cos();
        let across = if radius > 0.0 { sin / radius } else { 0.0 };
        let ray = || Ray { origin: self.location, direction: self.towards(x * across, y * across, cos) };
        shown(y * across, cos).then(ray)
    }
}

/// The angle from the axis that the lens of an omnimax projector shows at a distance from the middle.
fn omnimax_lens(radius: f64) -> f64 {
    1.411269 * radius - 0.09439 * radius.powi(3) + 0.25674 * radius.powi(5)
}

/// The direction of a point from the middle, from -90 to 270 degrees, and its distance.
fn polar(x: f64, y: f64) -> [f64; 2] {
    let radius = x.hypot(y);
    let turn = if radius > 0.0 { (y / radius).asin() } else { 0.0 };
    [if x < 0.0 { PI - turn } else { turn }, radius]
}
