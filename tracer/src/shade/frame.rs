//! The space that a texture is asked in: the world, moved and warped by the textures around it.

use crate::math::{Transform, Vec3};
use crate::pattern::Modifiers;
use crate::warp::Warp;

/// A point in the space of a texture, and the way from the world to it.
#[derive(Clone, Copy)]
pub struct Frame<'a> {
    /// The point as patterns see it.
    pub point: Vec3,
    step: Option<(&'a Frame<'a>, Step<'a>)>,
}

#[derive(Clone, Copy)]
enum Step<'a> {
    Placed(&'a Transform),
    Warped(&'a Modifiers),
}

impl<'a> Frame<'a> {
    /// The world, or whatever the outermost texture is asked in.
    pub fn outermost(point: Vec3) -> Frame<'a> {
        Frame { point, step: None }
    }

    /// The frame inside a transform.
    pub fn placed(&'a self, space: &'a Transform) -> Frame<'a> {
        Frame { point: space.inverse_point(self.point), step: Some((self, Step::Placed(space))) }
    }

    /// The frame inside a pattern's modifiers, which took the point to `point`.
    pub fn warped(&'a self, modifiers: &'a Modifiers, point: Vec3) -> Frame<'a> {
        Frame { point, step: Some((self, Step::Warped(modifiers))) }
    }

    /// A unit normal of the world as it stands here. Of the warps only transforms turn it.
    pub fn normal_from_world(&self, normal: Vec3) -> Vec3 {
        let Some((outer, step)) = self.step else {
            return normal;
        };
        let mut normal = outer.normal_from_world(normal);
        step.transforms(|space| normal = space.inverse_normal(normal));
        normal.normalized()
    }

    /// The way back.
    pub fn normal_to_world(&self, normal: Vec3) -> Vec3 {
        let Some((outer, step)) = self.step else {
            return normal;
        };
        let mut normal = normal;
        step.transforms_inside_out(|space| normal = space.normal(normal));
        outer.normal_to_world(normal.normalized())
    }
}

impl Step<'_> {
    /// The transforms from the outermost to the innermost.
    fn transforms(&self, mut visit: impl FnMut(&Transform)) {
        match self {
            Step::Placed(space) => visit(space),
            Step::Warped(modifiers) => modifiers.warps.iter().rev().for_each(|warp| {
                if let Warp::Transform(space) = warp {
                    visit(space);
                }
            }),
        }
    }

    fn transforms_inside_out(&self, mut visit: impl FnMut(&Transform)) {
        match self {
            Step::Placed(space) => visit(space),
            Step::Warped(modifiers) => modifiers.warps.iter().for_each(|warp| {
                if let Warp::Transform(space) = warp {
                    visit(space);
                }
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

    #[test]
    fn normals_come_back() {
        let space =
            Transform::from_matrix([1.0, 2.0, 0.0, 0.0, 1.0, 3.0, 1.0, 0.0, 1.0, 5.0, 6.0, 7.0]).unwrap();
        let modifiers = Modifiers { warps: vec![Warp::Transform(Box::new(space))], ..Modifiers::default() };
        let world = Frame::outermost(Vec3::ZERO);
        let placed = world.placed(&space);
        let warped = placed.warped(&modifiers, Vec3::ZERO);
        let normal = vec3(0.6, 0.0, 0.8);
        assert!((warped.normal_to_world(warped.normal_from_world(normal)) - normal).length() < 1e-12);
    }
}
