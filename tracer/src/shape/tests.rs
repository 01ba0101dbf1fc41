//! What must hold for every primitive: its box holds all hits, normals lead outward, inside changes at each hit, a
//! hit is not hit again, and a moved object is hit where the unmoved one is by the ray moved back.

use crate::accel::{AcceleratorKind, Counters, RayKind};
use crate::geometry::{prepare, Answer, Geometry, Hit};
use crate::graph::shapes::{Spindle, SplineKind, Sweep};
use crate::graph::{self, shapes, Object};
use crate::math::{vec3, Ray, Transform, Vec3};
use crate::testing::Random;
use crate::texture::Builder;

const FAR: f64 = 1e7;

/// How much of the contract a sample keeps.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// Encloses a volume; normals lead outward.
    Solid,
    /// Encloses a volume; normals lead where the order of its points or POV-Ray's habit wants them.
    Unsided,
    /// Has a surface only.
    Patch,
}

fn samples() -> Vec<(Object, Kind)> {
    use Kind::{Patch, Solid, Unsided};
    let cube = |vertices: Vec<Vec3>| shapes::Mesh {
        vertices,
        faces: vec![
            [0, 1, 2],
            [1, 3, 2],
            [4, 6, 5],
            [5, 6, 7],
            [0, 4, 1],
            [1, 4, 5],
            [2, 3, 6],
            [3, 7, 6],
            [0, 2, 4],
            [2, 6, 4],
            [1, 5, 3],
            [3, 5, 7],
        ],
        inside_vector: Some(vec3(0.3, 0.5, 0.77)),
        ..shapes::Mesh::default()
    };
    let corners = (0..8).map(|i| vec3((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2 & 1) as f64)).collect();
    let ring =
        |r: f64| (0..5).map(move |i| vec3(r * (i as f64 * 1.257).cos(), r * (i as f64 * 1.257).sin(), 0.5));
    let star: Vec<Vec3> =
        ring(1.0).chain(ring(1.0).take(1)).chain(ring(0.4)).chain(ring(0.4).take(1)).collect();
    let quartic = {
        // (x² + y² + z²)² - 1 = 0 stands at these places of the list of 35.
        let mut c = vec![0.0; 35];
        for (place, value) in [(0, 1.0), (20, 1.0), (30, 1.0), (4, 2.0), (7, 2.0), (23, 2.0), (34, -1.0)] {
            c[place] = value;
        }
        c
    };
    let (a, b, c) = (vec3(-1.0, 0.0, 0.2), vec3(1.0, -0.5, 0.0), vec3(0.0, 1.0, 0.5));
    let up = vec3(0.1, 0.2, 1.0);
    let lump = |center, end, strength| shapes::BlobComponent {
        center,
        radius: 0.9,
        strength,
        end,
        transform: Transform::IDENTITY,
        texture: None,
    };
    let lumps = vec![lump(a, None, 1.0), lump(b, Some(c), 0.8), lump(b * 0.5, None, -0.5)];
    let prism = |spline, sweep, points: &[[f64; 2]]| -> graph::Shape {
        let points = points.to_vec();
        shapes::Prism { spline, sweep, height1: 0.4, height2: 1.1, points, open: false, sturm: false }.into()
    };
    let lathe = |spline, points: &[[f64; 2]]| -> graph::Shape {
        shapes::Lathe { spline, points: points.to_vec(), sturm: false }.into()
    };
    // Control point, three corners, the first corner again.
    let round = [[0.0, 1.0], [-1.0, 0.0], [0.5, -1.0], [0.7, 0.8], [-1.0, 0.0]];
    // From the axis to the axis, with a control point at each end.
    let vase = [[0.2, -0.4], [0.0, -0.6], [0.9, -0.3], [0.7, 0.5], [0.0, 0.7], [-0.2, 0.6]];
    let torus = |major_radius, minor_radius, spindle| -> graph::Shape {
        shapes::Torus { major_radius, minor_radius, spindle, sturm: false }.into()
    };
    let sweep = |spline| -> graph::Shape {
        let spheres = vec![(a, 0.3), (b, 0.5), (c, 0.2), (up, 0.4), (a * 0.5, 0.1)];
        shapes::SphereSweep { spline, spheres, tolerance: 1e-6 }.into()
    };
    let list: Vec<(graph::Shape, Kind)> = vec![
        (shapes::Sphere { center: vec3(0.2, 0.1, 0.0), radius: 0.9 }.into(), Solid),
        (shapes::Box { corner1: vec3(-0.5, -1.0, -0.7), corner2: vec3(0.5, 0.4, 0.3) }.into(), Solid),
        (shapes::Cylinder { base: a, cap: c, radius: 0.4, open: false }.into(), Solid),
        (shapes::Cylinder { base: a, cap: c, radius: 0.4, open: true }.into(), Patch),
        (shapes::Cone { base: a, base_radius: 0.7, cap: c, cap_radius: 0.0, open: false }.into(), Solid),
        (shapes::Cone { base: b, base_radius: 0.2, cap: a, cap_radius: 0.6, open: false }.into(), Solid),
        (shapes::Plane { normal: up, distance: 0.3 }.into(), Solid),
        (shapes::Disc { center: c, normal: up, radius: 1.0, hole_radius: 0.3 }.into(), Patch),
        (shapes::Torus { major_radius: 0.8, minor_radius: 0.3, spindle: None, sturm: false }.into(), Solid),
        (
            shapes::Quadric {
                squares: vec3(1.0, 2.0, 1.5),
                mixed: vec3(0.1, 0.2, -0.3),
                linear: vec3(0.2, 0.0, 0.1),
                constant: -1.0,
            }
            .into(),
            Solid,
        ),
        (shapes::Poly { order: 4, coefficients: quartic, sturm: false }.into(), Solid),
        (shapes::Triangle { a, b, c }.into(), Patch),
        (
            shapes::SmoothTriangle { a, normal_a: up, b, normal_b: up, c, normal_c: vec3(0.3, -0.2, 1.0) }
                .into(),
            Patch,
        ),
        (shapes::Polygon { points: star }.into(), Patch),
        (cube(corners).into(), Solid),
        (
            prism(SplineKind::Linear, Sweep::Linear, &[[-1.0, -0.5], [0.8, -0.7], [0.3, 0.9], [-1.0, -0.5]]),
            Unsided,
        ),
        (
            prism(SplineKind::Linear, Sweep::Conic, &[[-1.0, -0.5], [0.3, 0.9], [0.8, -0.7], [-1.0, -0.5]]),
            Unsided,
        ),
        (prism(SplineKind::Quadratic, Sweep::Linear, &[&round[..1], &round[1..]].concat()), Unsided),
        (prism(SplineKind::Cubic, Sweep::Linear, &[&round[..], &round[2..3]].concat()), Unsided),
        (prism(SplineKind::Cubic, Sweep::Conic, &[&round[..], &round[2..3]].concat()), Unsided),
        (lathe(SplineKind::Linear, &vase[1..5]), Unsided),
        (lathe(SplineKind::Quadratic, &vase[..5]), Unsided),
        (lathe(SplineKind::Cubic, &vase), Unsided),
        (
            shapes::Sor {
                points: vec![[0.2, -1.2], [0.5, -0.9], [0.9, 0.0], [0.3, 0.6], [0.6, 0.9], [0.7, 1.1]],
                open: false,
                sturm: false,
            }
            .into(),
            Solid,
        ),
        (shapes::Blob { components: lumps, threshold: 0.4, sturm: false, hierarchy: true }.into(), Solid),
        (
            shapes::HeightField {
                heights: (0..42).map(|i| 0.5 + 0.4 * (f64::from(i) * 1.3).sin()).collect(),
                rows: 6,
                columns: 7,
                water_level: 0.0,
                smooth: true,
            }
            .into(),
            Patch,
        ),
        (
            shapes::Ovus {
                bottom_radius: 0.6,
                top_radius: 0.4,
                radius: None,
                distance: None,
                precision: 1e-4,
            }
            .into(),
            Solid,
        ),
        (
            shapes::Lemon {
                base: a,
                base_radius: 0.2,
                cap: c,
                cap_radius: 0.3,
                inner_radius: 2.0,
                open: false,
            }
            .into(),
            Solid,
        ),
        (
            shapes::Lemon {
                base: a,
                base_radius: 0.6,
                cap: c,
                cap_radius: 0.7,
                inner_radius: 1.1,
                open: false,
            }
            .into(),
            Solid,
        ),
        (torus(0.5, 0.8, Some(Spindle::Merge)), Solid),
        (torus(0.5, 0.8, Some(Spindle::Intersection)), Solid),
        (torus(0.5, 0.8, Some(Spindle::Difference)), Solid),
        (sweep(SplineKind::Linear), Solid),
        (sweep(SplineKind::B), Solid),
        (sweep(SplineKind::Cubic), Solid),
        (
            shapes::BicubicPatch {
                points: (0..16)
                    .map(|i| {
                        let (u, v) = (f64::from(i / 4), f64::from(i % 4));
                        vec3(u * 0.6 - 0.9, (u * 2.0 + v).sin() * 0.6, v * 0.6 - 0.9)
                    })
                    .collect(),
                r#type: 1,
                flatness: 0.0,
                u_steps: 3,
                v_steps: 2,
                uv_vectors: [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
            }
            .into(),
            Patch,
        ),
        (shapes::Superellipsoid { e: 0.3, n: 0.7 }.into(), Solid),
        (shapes::Superellipsoid { e: 1.0, n: 1.0 }.into(), Solid),
        (shapes::Superellipsoid { e: 2.5, n: 0.5 }.into(), Solid),
    ];
    list.into_iter().map(|(shape, kind)| (Object::new(shape), kind)).collect()
}

fn ready(object: &Object) -> Geometry {
    let (geometry, unsupported) =
        prepare(std::slice::from_ref(object), AcceleratorKind::Octree, &mut Builder::default());
    assert!(unsupported.is_empty(), "{unsupported:?}");
    geometry
}

fn all_hits(geometry: &Geometry, ray: &Ray, from: f64) -> Vec<Hit> {
    let mut hits = Vec::new();
    geometry.any(ray, from, FAR, RayKind::Shadow, &mut Counters::default(), |hit| {
        hits.push(*hit);
        Answer::Continue
    });
    hits.sort_by(|a, b| a.crossing.t.total_cmp(&b.crossing.t));
    hits
}

fn some_ray(random: &mut Random) -> Ray {
    let origin = random.vector(2.5);
    Ray { origin, direction: (random.vector(1.0) - origin * random.unit()).normalized() }
}

#[test]
fn contract_of_primitives() {
    let turned =
        Transform::from_matrix([0.8, 0.6, 0.0, -0.9, 1.2, 0.1, 0.0, 0.1, 0.7, 0.3, -0.2, 0.1]).unwrap();
    let mut random = Random::new(11);
    for (plain, kind) in samples() {
        let name = plain.shape.name();
        let unmoved = ready(&plain);
        let mut total = 0;
        for object in [plain.clone(), plain.clone().placed(turned)] {
            let geometry = ready(&object);
            let top = geometry.top().next().unwrap();
            let bounds = geometry.node(top).extent.surface.widened(1e-9);
            for _ in 0..1500 {
                let ray = some_ray(&mut random);
                let hits = all_hits(&geometry, &ray, 1e-4);
                total += hits.len();
                if object.transform == turned {
                    let back = all_hits(&unmoved, &turned.inverse_ray(&ray), 1e-4);
                    assert_eq!(back.len(), hits.len(), "{name} moved: {ray:?}");
                    for (h, b) in hits.iter().zip(&back) {
                        assert!((h.crossing.t - b.crossing.t).abs() < 1e-6, "{name} moved");
                    }
                }
                let mut inside = geometry.inside(ray.origin, top);
                for hit in &hits {
                    let surface = geometry.surface(&ray, hit);
                    assert!(bounds.contains(surface.point), "{name}: {:?} outside {bounds:?}", surface.point);
                    assert!((surface.normal.length() - 1.0).abs() < 1e-9, "{name}: normal");
                    let leaving = surface.geometric_normal.dot(ray.direction);
                    if kind == Kind::Solid && leaving.abs() > 1e-3 {
                        assert_eq!(
                            leaving > 0.0,
                            inside,
                            "{name}: normal against the surface at {hit:?} {ray:?}"
                        );
                    }
                    if leaving.abs() > 0.05 {
                        let on = Ray { origin: surface.point, direction: ray.direction };
                        let again = all_hits(&geometry, &on, 1e-4).first().map_or(FAR, |h| h.crossing.t);
                        let next = hits.iter().map(|h| h.crossing.t - hit.crossing.t).find(|&t| t > 1e-4);
                        assert!((again - next.unwrap_or(FAR)).abs() < 1e-5, "{name}: hit again");
                    }
                    inside = !inside;
                }
                if kind != Kind::Patch {
                    let beyond = ray.at(hits.last().map_or(0.0, |h| h.crossing.t) + 0.01);
                    assert_eq!(geometry.inside(beyond, top), inside, "{name}: parity of {hits:?} on {ray:?}");
                } else if hits.len() == 1 && !["Disc", "Cylinder", "HeightField"].contains(&name) {
                    assert!(!geometry.inside(ray.at(hits[0].crossing.t * 0.9), top));
                }
            }
        }
        assert!(total > 300, "{name}: {total} hits only");
    }
}
