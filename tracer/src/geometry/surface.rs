//! What is at a hit.

use super::{Geometry, Hit, NodeId, Solid};
use crate::math::{Ray, Vec3};
use crate::shape::{Primitive, Shape};

/// A point of a surface. Normals have length one and point outward (for an inverse object, inward).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Where.
    pub point: Vec3,
    /// The normal for shading.
    pub normal: Vec3,
    /// The normal of the true surface.
    pub geometric_normal: Vec3,
    /// The primitive.
    pub node: NodeId,
}

impl Geometry {
    /// Point and normals at a hit of `ray`.
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let point = ray.at(hit.crossing.t);
        let node = &self.nodes[hit.node as usize];
        let Solid::Primitive { shape, place } = &node.solid else {
            unreachable!("hits are on primitives");
        };
        let local = place.as_ref().map_or(point, |place| place.inverse_point(point));
        let to_world = |normal: Vec3| {
            let normal = place.as_ref().map_or(normal, |place| place.normal(normal)).normalized();
            if node.inverse {
                -normal
            } else {
                normal
            }
        };
        Surface {
            point,
            normal: to_world(shape.normal(local, &hit.crossing)),
            geometric_normal: to_world(shape.geometric_normal(local, &hit.crossing)),
            node: hit.node,
        }
    }

    /// Surface coordinates for `uv_mapping`; on shapes that have none, x and y of the point.
    pub fn uv(&self, hit: &Hit, point: Vec3) -> [f64; 2] {
        let Solid::Primitive { shape, place } = &self.nodes[hit.node as usize].solid else {
            unreachable!("hits are on primitives");
        };
        let local = place.as_ref().map_or(point, |place| place.inverse_point(point));
        shape.uv(local, &hit.crossing).unwrap_or([point.x, point.y])
    }

    /// The textures seen at a hit with their shares, for nodes whose looks say `several_textures`.
    pub fn texture_weights(&self, hit: &Hit, point: Vec3, weights: &mut Vec<(Option<u32>, f64)>) {
        weights.clear();
        let looks = self.looks(hit.node);
        if let Some(whole) = looks.cutaway {
            self.cut_textures(whole, point, weights);
            let share = (weights.len() as f64).recip();
            weights.iter_mut().for_each(|weight| weight.1 = share);
            if weights.is_empty() {
                weights.push((looks.texture, 1.0));
            }
            return;
        }
        let mesh = match &self.nodes[hit.node as usize].solid {
            Solid::Primitive { shape: Shape::Mesh(mesh), .. } => mesh,
            Solid::Primitive { shape: Shape::Blob(blob), place } => {
                let local = place.as_ref().map_or(point, |place| place.inverse_point(point));
                let shares = blob.component_shares(local);
                return weights
                    .extend(shares.iter().map(|&(i, share)| (looks.part_texture(i as i32), share)));
            }
            _ => return weights.push((looks.texture, 1.0)),
        };
        match mesh.texture_shares(&hit.crossing) {
            // A face of one texture is the rule.
            Some([(a, _), (b, _), (c, _)]) if a == b && b == c => {
                weights.push((looks.part_texture(a), 1.0));
            }
            Some(corners) => weights.extend(corners.map(|(i, share)| (looks.part_texture(i), share))),
            None => weights.push((looks.texture, 1.0)),
        }
    }

    /// The textures of all parts of a CSG that hold a point: what a cutting surface without a texture shows.
    fn cut_textures(&self, whole: NodeId, point: Vec3, weights: &mut Vec<(Option<u32>, f64)>) {
        let Solid::Composite(composite) = &self.nodes[whole as usize].solid else { return };
        for child in composite.children().filter(|&child| self.inside(point, child)) {
            let looks = self.looks(child);
            match &self.nodes[child as usize].solid {
                Solid::Composite(_) => self.cut_textures(child, point, weights),
                Solid::Primitive { .. } if !looks.untextured => weights.push((looks.texture, 1.0)),
                Solid::Primitive { .. } => (),
            }
        }
    }
}
