//! SDL: `camera { mesh_camera { rays distribution max_distance mesh {...} ... smooth } location V direction V }`.
//!
//! Rays start on the faces of meshes and go along their normals. Only the z of `location` and `direction` counts: by
//! how much the start is moved along the normal, and whether the ray goes the other way.

use super::face_map::FaceMap;
use super::Size;
use crate::graph::camera as graph;
use crate::graph::shapes::Mesh;
use crate::graph::{Object, Shape};
use crate::math::{Ray, Transform, Vec3};

/// The faces of a mesh camera, in the order of the scene.
#[derive(Clone, Debug)]
pub struct FaceRays {
    meshes: Vec<Placed>,
    distribution: Distribution,
    /// Rays for each point of the picture.
    pub rays_per_pixel: usize,
    /// How far the start is moved along the normal.
    offset: f64,
    /// -1 where the ray goes against the normal.
    sense: f64,
    /// Farther things are not seen.
    pub reach: f64,
}

/// Which face a point of the picture belongs to.
#[derive(Clone, Debug)]
enum Distribution {
    /// Each ray of a pixel has a mesh of its own.
    MeshPerRay,
    /// The meshes are one long list of faces.
    OneList,
    /// The meshes stand side by side in the picture.
    SideBySide,
    /// The picture is the first mesh's map of surface coordinates.
    Map { smooth: bool, map: FaceMap },
}

/// One triangle, in the space of its mesh.
#[derive(Clone, Debug)]
pub struct Face {
    corners: [Vec3; 3],
    normal: Vec3,
    /// Those of the corners of a smooth face.
    normals: [Vec3; 3],
    /// The surface coordinates of the corners.
    pub uvs: [[f64; 2]; 3],
}

/// A mesh in its place.
#[derive(Clone, Debug)]
struct Placed {
    faces: Vec<Face>,
    place: Transform,
}

impl FaceRays {
    /// Prepares a camera's meshes.
    pub fn new(mesh: &graph::MeshCamera, camera: &graph::Camera) -> FaceRays {
        let meshes: Vec<Placed> = mesh.meshes.iter().map(Placed::new).collect();
        FaceRays {
            distribution: match mesh.distribution {
                0 => Distribution::MeshPerRay,
                1 => Distribution::OneList,
                2 => Distribution::SideBySide,
                _ => Distribution::Map {
                    smooth: mesh.smooth,
                    map: FaceMap::new(meshes.first().map_or(&[], |mesh| &mesh.faces)),
                },
            },
            meshes,
            // One list gives each pixel the same face for all its rays.
            rays_per_pixel: if mesh.distribution == 1 { 1 } else { mesh.rays_per_pixel },
            offset: camera.location.z,
            sense: if camera.direction.z < 0.0 { -1.0 } else { 1.0 },
            reach: mesh.max_distance.filter(|&distance| distance > 0.0).unwrap_or(f64::INFINITY),
        }
    }

    /// A ray through a point of the picture, in pixels from the left and from the top; `None` where no face is.
    pub fn ray(&self, x: f64, y: f64, size: Size, number: usize) -> Option<Ray> {
        // As in POV-Ray, the faces are counted from below the first row of pixels.
        let x = x.min(size.width as f64 - 1.0).max(0.0);
        let y = (y - 1.0).min(size.height as f64 - 1.0).max(0.0);
        let (column, row) = (x as usize, y as usize);
        let (mesh, point, normal) = match &self.distribution {
            Distribution::MeshPerRay => self.middle(number % self.meshes.len(), row * size.width + column)?,
            Distribution::OneList => {
                let mut index = row * size.width + column;
                let mesh = self.meshes.iter().position(|mesh| {
                    let found = index < mesh.faces.len();
                    index -= if found { 0 } else { mesh.faces.len() };
                    found
                });
                self.middle(mesh?, index)?
            }
            Distribution::SideBySide => {
                let width = size.width / self.meshes.len();
                let mesh = (x * self.meshes.len() as f64 / size.width as f64) as usize;
                self.middle(mesh, row * width + column)?
            }
            Distribution::Map { smooth, map } => {
                let place = [(x - 0.5) / size.width as f64, 1.0 - (y + 0.5) / size.height as f64];
                let mesh = self.meshes.first()?;
                let (face, shares) = map.find(&mesh.faces, place)?;
                let normal = if *smooth { blend(&face.normals, shares) } else { face.normal };
                (mesh, blend(&face.corners, shares), normal)
            }
        };
        let origin = mesh.place.point(point + normal * self.offset);
        Some(Ray { origin, direction: mesh.place.normal(normal) * self.sense })
    }

    /// The mesh, the middle of one of its faces, and the normal there.
    fn middle(&self, mesh: usize, index: usize) -> Option<(&Placed, Vec3, Vec3)> {
        let mesh = self.meshes.get(mesh)?;
        let face = mesh.faces.get(index)?;
        Some((mesh, blend(&face.corners, [1.0 / 3.0; 3]), face.normal))
    }
}

fn blend(corners: &[Vec3; 3], [a, b, c]: [f64; 3]) -> Vec3 {
    corners[0] * a + corners[1] * b + corners[2] * c
}

impl Placed {
    fn new(object: &Object) -> Placed {
        let faces = match &object.shape {
            Shape::Mesh(mesh) => (0..mesh.faces.len()).map(|number| Face::new(mesh, number)).collect(),
            _ => Vec::new(),
        };
        Placed { faces, place: object.transform }
    }
}

impl Face {
    /// A face of a mesh, which POV-Ray keeps in single precision.
    fn new(mesh: &Mesh, number: usize) -> Face {
        let single = |v: f64| f64::from(v as f32);
        let [a, b, c] = mesh.faces[number].map(|i| mesh.vertices[i as usize].map(single));
        let normal = (c - a).cross(b - a).normalized().map(single);
        let own = |rows: &[[i32; 3]]| {
            let row = rows.get(number).filter(|row| row.iter().all(|&i| i >= 0))?;
            Some(row.map(|i| i as usize))
        };
        Face {
            corners: [a, b, c],
            normal,
            normals: own(&mesh.normal_faces)
                .map_or([normal; 3], |row| row.map(|i| mesh.normals[i].normalized().map(single))),
            uvs: own(&mesh.uv_faces).map_or([[0.0; 2]; 3], |row| row.map(|i| mesh.uvs[i])),
        }
    }
}
