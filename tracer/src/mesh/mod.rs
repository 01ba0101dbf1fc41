//! SDL: `mesh { triangle {...} ... inside_vector V }`, `mesh2 { vertex_vectors {...} face_indices {...} }`.
//!
//! The triangles stand in an octree of their own, in its order, each as a corner and two edges. Copies of a mesh share
//! all this and differ in their place only.

use crate::accel::{Counters, Octree, Query};
use crate::graph;
use crate::math::{Bounds, Ray, Vec3};
use crate::shape::{interpolated_normal, Crossing, Facet, Primitive};

const NEAREST: f64 = 1e-6;
/// How many triangles a leaf holds.
const LEAF_SIZE: usize = 2;

/// A mesh ready to be hit. A crossing's part is the number of the face.
#[derive(Debug)]
pub struct Mesh {
    octree: Octree,
    facets: Vec<Facet>,
    /// The face that each facet comes from.
    faces: Vec<u32>,
    bounds: Bounds,
    inside_vector: Option<Vec3>,
    normals: Vec<Vec3>,
    normal_faces: Vec<[i32; 3]>,
    uvs: Vec<[f64; 2]>,
    uv_faces: Vec<[i32; 3]>,
    face_textures: Vec<[i32; 3]>,
    /// Normals of the faces, by face.
    flat_normals: Vec<Vec3>,
}

impl Mesh {
    /// Builds the tree over all triangles that have an area.
    pub fn new(mesh: &graph::shapes::Mesh) -> Mesh {
        let corners = |face: &[u32; 3]| face.map(|i| mesh.vertices[i as usize]);
        let all: Vec<Facet> = mesh
            .faces
            .iter()
            .map(|face| {
                let [a, b, c] = corners(face);
                Facet::new(a, b, c)
            })
            .collect();
        let flat_normals: Vec<Vec3> = all.iter().map(Facet::normal).collect();
        let kept: Vec<u32> =
            (0..all.len() as u32).filter(|&i| flat_normals[i as usize].length_squared() > 0.0).collect();
        let boxes: Vec<Bounds> = kept.iter().map(|&i| all[i as usize].bounds()).collect();
        let mut octree = Octree::build(&boxes, LEAF_SIZE);
        let faces: Vec<u32> = octree.order().iter().map(|&i| kept[i as usize]).collect();
        octree.renumber();
        Mesh {
            facets: faces.iter().map(|&i| all[i as usize]).collect(),
            bounds: boxes.iter().fold(Bounds::EMPTY, |sum, b| sum.union(b)),
            octree,
            faces,
            inside_vector: mesh.inside_vector,
            normals: mesh.normals.iter().map(|n| n.normalized()).collect(),
            normal_faces: mesh.normal_faces.clone(),
            uvs: mesh.uvs.clone(),
            uv_faces: mesh.uv_faces.clone(),
            face_textures: mesh.face_textures.clone(),
            flat_normals,
        }
    }

    /// The texture at each corner of the face hit, as indices into the mesh's list, with its share.
    pub fn texture_shares(&self, crossing: &Crossing) -> Option<[(i32, f64); 3]> {
        let [a, b, c] = *self.face_textures.get(crossing.part as usize)?;
        Some([(a, 1.0 - crossing.u - crossing.v), (b, crossing.u), (c, crossing.v)])
    }
}

/// A row of a list of faces, unless it says that there is nothing.
fn row(rows: &[[i32; 3]], face: u32) -> Option<[usize; 3]> {
    let row = rows.get(face as usize)?;
    row.iter().all(|&i| i >= 0).then(|| row.map(|i| i as usize))
}

impl Primitive for Mesh {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    #[inline]
    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        let from = from.max(NEAREST);
        self.octree.along(&Query::new(*ray), limit, counters, |item, limit, _| {
            match self.facets[item as usize].crossing(ray, self.faces[item as usize]) {
                Some(crossing) if crossing.t > from && crossing.t <= limit => offer(crossing, limit),
                _ => limit,
            }
        })
    }

    /// An odd number of faces lies in the direction of `inside_vector`.
    fn inside(&self, point: Vec3) -> bool {
        let Some(direction) = self.inside_vector else { return false };
        if !self.bounds.contains(point) {
            return false;
        }
        let mut faces = 0;
        let ray = Ray { origin: point, direction };
        self.intersect(&ray, 0.0, f64::INFINITY, &mut Counters::default(), &mut |_, limit| {
            faces += 1;
            limit
        });
        faces % 2 == 1
    }

    fn normal(&self, point: Vec3, crossing: &Crossing) -> Vec3 {
        match row(&self.normal_faces, crossing.part) {
            Some(corners) => interpolated_normal(corners.map(|i| self.normals[i]), crossing),
            None => self.geometric_normal(point, crossing),
        }
    }

    fn geometric_normal(&self, _: Vec3, crossing: &Crossing) -> Vec3 {
        self.flat_normals[crossing.part as usize]
    }

    fn uv(&self, _: Vec3, crossing: &Crossing) -> Option<[f64; 2]> {
        let Some(corners) = row(&self.uv_faces, crossing.part) else { return Some([0.0; 2]) };
        let [a, b, c] = corners.map(|i| self.uvs[i]);
        let mix = |k: usize| a[k] * (1.0 - crossing.u - crossing.v) + b[k] * crossing.u + c[k] * crossing.v;
        Some([mix(0), mix(1)])
    }

    fn solid(&self) -> bool {
        self.inside_vector.is_some()
    }
}
