//! SDL: the primitives: mirror of `minipov.tracer.shapes`, which documents the fields.
#![allow(missing_docs)] // the fields are documented where they are mirrored from

use super::values::keywords;
use super::{Function, Shared, Texture, Vec2, Vec4};
use crate::math::{Transform, Vec3};

keywords!(
    /// How a curve joins its points.
    SplineKind {
        Linear = "linear_spline",
        Quadratic = "quadratic_spline",
        Cubic = "cubic_spline",
        Bezier = "bezier_spline",
        B = "b_spline",
    }
);

keywords!(
    /// What of a self-intersecting torus counts as its inside.
    Spindle { Difference = "difference", Intersection = "intersection", Merge = "merge", Union = "union" }
);

keywords!(
    /// Whether a prism keeps its size along its height.
    Sweep { Linear = "linear_sweep", Conic = "conic_sweep" }
);

keywords!(
    /// Number system of a julia fractal.
    Algebra { Quaternion = "quaternion", Hypercomplex = "hypercomplex" }
);

/// Each dataclass as a struct of the same name and fields.
macro_rules! mirrors {
    ($($name:ident { $($field:ident: $type:ty),* $(,)? })*) => {$(
        #[derive(Clone, Debug)]
        #[cfg_attr(feature = "python", derive(pyo3::FromPyObject))]
        pub struct $name {
            $(pub $field: $type),*
        }
    )*};
}

mirrors! {
    Sphere { center: Vec3, radius: f64 }
    Box { corner1: Vec3, corner2: Vec3 }
    Cylinder { base: Vec3, cap: Vec3, radius: f64, open: bool }
    Cone { base: Vec3, base_radius: f64, cap: Vec3, cap_radius: f64, open: bool }
    Plane { normal: Vec3, distance: f64 }
    Disc { center: Vec3, normal: Vec3, radius: f64, hole_radius: f64 }
    Torus { major_radius: f64, minor_radius: f64, spindle: Option<Spindle>, sturm: bool }
    Quadric { squares: Vec3, mixed: Vec3, linear: Vec3, constant: f64 }
    Poly { order: usize, coefficients: Vec<f64>, sturm: bool }
    Polygon { points: Vec<Vec3> }
    Triangle { a: Vec3, b: Vec3, c: Vec3 }
    SmoothTriangle { a: Vec3, normal_a: Vec3, b: Vec3, normal_b: Vec3, c: Vec3, normal_c: Vec3 }
    BicubicPatch {
        points: Vec<Vec3>,
        r#type: i32,
        flatness: f64,
        u_steps: i32,
        v_steps: i32,
        uv_vectors: [Vec2; 4],
    }
    BlobComponent {
        center: Vec3,
        radius: f64,
        strength: f64,
        end: Option<Vec3>,
        transform: Transform,
        texture: Option<Shared<Texture>>,
    }
    Blob { components: Vec<BlobComponent>, threshold: f64, sturm: bool, hierarchy: bool }
    Isosurface {
        function: Shared<Function>,
        contained_by: Container,
        threshold: f64,
        accuracy: f64,
        max_gradient: f64,
        evaluate: Option<Vec3>,
        open: bool,
        max_trace: i32,
        all_intersections: bool,
        polarity: bool,
    }
    Parametric {
        functions: [Shared<Function>; 3],
        low: Vec2,
        high: Vec2,
        contained_by: Container,
        max_gradient: f64,
        accuracy: f64,
        precompute: Option<(i32, bool, bool, bool)>,
    }
    JuliaFractal {
        parameter: Vec4,
        algebra: Algebra,
        function: String,
        exponent: Vec2,
        max_iteration: i32,
        precision: f64,
        slice_normal: Vec4,
        slice_distance: f64,
    }
    Lathe { spline: SplineKind, points: Vec<Vec2>, sturm: bool }
    Lemon { base: Vec3, base_radius: f64, cap: Vec3, cap_radius: f64, inner_radius: f64, open: bool }
    Ovus {
        bottom_radius: f64,
        top_radius: f64,
        radius: Option<f64>,
        distance: Option<f64>,
        precision: f64,
    }
    Prism {
        spline: SplineKind,
        sweep: Sweep,
        height1: f64,
        height2: f64,
        points: Vec<Vec2>,
        open: bool,
        sturm: bool,
    }
    SphereSweep { spline: SplineKind, spheres: Vec<(Vec3, f64)>, tolerance: f64 }
    Superellipsoid { e: f64, n: f64 }
    Sor { points: Vec<Vec2>, open: bool, sturm: bool }
    Text { font: Vec<u8>, text: String, thickness: f64, offset: Vec3 }
}

/// The box or sphere that an isosurface or a parametric surface lives in.
#[derive(Clone, Debug)]
pub enum Container {
    Sphere(Sphere),
    Box(Box),
}

from_class_name!(Container { Sphere => Sphere, Box => Box });

/// `mesh` and `mesh2`: the arrays as rows.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    pub vertices: Vec<Vec3>,
    pub faces: Vec<[u32; 3]>,
    pub normals: Vec<Vec3>,
    /// One row per face; rows of -1 where the face is flat. Empty without normals.
    pub normal_faces: Vec<[i32; 3]>,
    pub uvs: Vec<Vec2>,
    /// One row per face, or empty.
    pub uv_faces: Vec<[i32; 3]>,
    pub textures: Vec<Shared<Texture>>,
    /// One row per face, or empty.
    pub face_textures: Vec<[i32; 3]>,
    pub inside_vector: Option<Vec3>,
}

/// `height_field`: `rows` x `columns` heights, row 0 at z = 1.
#[derive(Clone, Debug)]
pub struct HeightField {
    pub heights: Vec<f64>,
    pub rows: usize,
    pub columns: usize,
    pub water_level: f64,
    pub smooth: bool,
}

#[cfg(feature = "python")]
mod conversion {
    use super::{HeightField, Mesh};
    use crate::math::Vec3;
    use numpy::{Element, PyReadonlyArray2, PyUntypedArrayMethods};
    use pyo3::exceptions::PyValueError;
    use pyo3::prelude::*;

    /// The rows of an (n, N) array; nothing for `None`.
    fn rows<T: Element + Copy, const N: usize>(
        object: &Borrowed<'_, '_, PyAny>,
        name: &str,
    ) -> PyResult<Vec<[T; N]>> {
        let Some(array) = object.getattr(name)?.extract::<Option<PyReadonlyArray2<'_, T>>>()? else {
            return Ok(Vec::new());
        };
        let wrong_shape = || PyValueError::new_err(format!("{name}: shape must be (n, {N})"));
        if array.shape()[1] != N {
            return Err(wrong_shape());
        }
        array
            .as_array()
            .rows()
            .into_iter()
            .map(|row| row.iter().copied().collect::<Vec<T>>())
            .map(|r| r.try_into().map_err(|_| wrong_shape()))
            .collect()
    }

    impl<'a, 'py> FromPyObject<'a, 'py> for Mesh {
        type Error = PyErr;
        fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
            let points =
                |name| Ok::<_, PyErr>(rows::<f64, 3>(&object, name)?.into_iter().map(Vec3::from).collect());
            let indices = |name| rows::<i32, 3>(&object, name);
            let mesh = Mesh {
                vertices: points("vertices")?,
                faces: indices("faces")?.into_iter().map(|f| f.map(|i| i as u32)).collect(),
                normals: points("normals")?,
                normal_faces: indices("normal_faces")?,
                uvs: rows::<f64, 2>(&object, "uvs")?,
                uv_faces: indices("uv_faces")?,
                textures: object.getattr("textures")?.extract()?,
                face_textures: indices("face_textures")?,
                inside_vector: object.getattr("inside_vector")?.extract()?,
            };
            mesh.check().map_err(PyValueError::new_err)?;
            Ok(mesh)
        }
    }

    impl<'a, 'py> FromPyObject<'a, 'py> for HeightField {
        type Error = PyErr;
        fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
            let heights: PyReadonlyArray2<'_, f64> = object.getattr("heights")?.extract()?;
            Ok(HeightField {
                rows: heights.shape()[0],
                columns: heights.shape()[1],
                heights: heights.as_array().iter().copied().collect(),
                water_level: object.getattr("water_level")?.extract()?,
                smooth: object.getattr("smooth")?.extract()?,
            })
        }
    }
}

impl Mesh {
    /// Whether every index has something to point at, and every list its length.
    pub fn check(&self) -> Result<(), String> {
        let faces = self.faces.len();
        let lists = [
            ("normal_faces", &self.normal_faces, self.normals.len()),
            ("uv_faces", &self.uv_faces, self.uvs.len()),
            ("face_textures", &self.face_textures, self.textures.len()),
        ];
        if self.faces.iter().flatten().any(|&i| i as usize >= self.vertices.len()) {
            return Err("a face points at no vertex".into());
        }
        for (name, rows, count) in lists {
            if !rows.is_empty() && rows.len() != faces {
                return Err(format!("{name}: {} rows for {faces} faces", rows.len()));
            }
            if rows.iter().flatten().any(|&i| i >= count as i32) {
                return Err(format!("{name}: index too large"));
            }
        }
        Ok(())
    }
}
