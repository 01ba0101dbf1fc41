//! Whole scenes: the accelerators agree, CSG agrees with what is inside.

use super::{prepare, Geometry, Hit};
use crate::accel::{AcceleratorKind, Counters, RayKind};
use crate::graph::objects::{Intersection, Merge, Union};
use crate::graph::shapes::{Box, Plane, Sphere};
use crate::graph::{Modifiers, Object};
use crate::math::{vec3, Ray, Transform, Vec3};
use crate::testing::Random;
use crate::texture::Builder;

const FAR: f64 = 1e7;

fn nearest(geometry: &Geometry, ray: &Ray) -> Option<Hit> {
    geometry.nearest(ray, 1e-4, FAR, RayKind::Camera, &mut Counters::default())
}

fn geometry(objects: &[Object], kind: AcceleratorKind) -> Geometry {
    let (geometry, unsupported) = prepare(objects, kind, &mut Builder::default());
    assert!(unsupported.is_empty(), "{unsupported:?}");
    geometry
}

fn inverse(object: Object) -> Object {
    object.modified(Modifiers { inverse: true, ..Modifiers::default() })
}

fn difference(children: Vec<Object>) -> Object {
    let children = children.into_iter().enumerate().map(|(i, o)| if i == 0 { o } else { inverse(o) });
    Object::new(Intersection { children: children.collect(), lights: vec![], cutaway_textures: false })
}

fn some_object(random: &mut Random) -> Object {
    let (at, size) = (random.vector(10.0), random.vector(1.0));
    let object = if random.unit() < 0.5 {
        Object::new(Sphere { center: at, radius: size.length() })
    } else {
        Object::new(Box { corner1: at, corner2: at + size })
    };
    let turn = Transform::from_matrix([0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 1.3, 0.1, 0.2, 0.3]);
    if random.unit() < 0.3 {
        object.placed(turn.unwrap())
    } else {
        object
    }
}

fn some_ray(random: &mut Random) -> Ray {
    let mut direction = random.vector(1.0);
    if random.unit() < 0.2 {
        direction.x = 0.0;
    }
    Ray { origin: random.vector(15.0), direction: direction.normalized() }
}

#[test]
fn accelerators_agree_to_the_bit() {
    let mut random = Random::new(1);
    for count in [1, 3, 9, 60, 700] {
        let mut objects: Vec<Object> = (0..count).map(|_| some_object(&mut random)).collect();
        objects.push(Object::new(Plane { normal: vec3(0.1, 1.0, 0.0), distance: -8.0 }));
        let holes = objects.iter().take(40).cloned();
        let block = Object::new(Box { corner1: Vec3::splat(-6.0), corner2: Vec3::splat(6.0) });
        objects.push(difference(std::iter::once(block).chain(holes).collect()));
        let [linear, octree] =
            [AcceleratorKind::Linear, AcceleratorKind::Octree].map(|k| geometry(&objects, k));
        for _ in 0..300 {
            let ray = some_ray(&mut random);
            assert_eq!(nearest(&linear, &ray), nearest(&octree, &ray));
            assert_eq!(linear.containing(ray.origin), octree.containing(ray.origin));
        }
    }
}

/// Inside changes at each hit on the surface of a CSG, and only there.
#[test]
fn csg_surfaces_part_inside_from_outside() {
    let mut random = Random::new(2);
    let ball = |x: f64, r: f64| Object::new(Sphere { center: vec3(x, 0.0, 0.0), radius: r });
    let block = || Object::new(Box { corner1: Vec3::splat(-1.0), corner2: Vec3::splat(1.0) });
    let group = |children: Vec<Object>| Object::new(Union { children, lights: vec![], split_union: true });
    let merge = |children: Vec<Object>| Object::new(Merge { children, lights: vec![] });
    let wholes = [
        difference(vec![block(), ball(0.0, 1.2)]),
        difference(vec![block(), group(vec![ball(0.7, 0.6), ball(0.2, 0.5), ball(-2.0, 1.5)])]),
        merge(vec![ball(0.0, 1.0), ball(0.6, 1.0), ball(1.2, 1.0), block()]),
        difference(vec![
            merge(vec![block(), ball(1.0, 0.8)]),
            difference(vec![ball(0.0, 1.0), ball(0.5, 0.5)]),
        ]),
        inverse(difference(vec![block(), ball(0.4, 0.9)])),
    ];
    for whole in wholes {
        let g = geometry(std::slice::from_ref(&whole), AcceleratorKind::Octree);
        let top = g.top().next().unwrap();
        let mut crossings = 0;
        for _ in 0..2000 {
            let ray = Ray { origin: random.vector(2.5), direction: random.vector(1.0).normalized() };
            let mut hits = Vec::new();
            g.any(&ray, 0.0, FAR, RayKind::Shadow, &mut Counters::default(), |hit| {
                hits.push(hit.crossing.t);
                super::Answer::Continue
            });
            hits.sort_by(f64::total_cmp);
            let mut inside = g.inside(ray.origin, top);
            let mut before = 0.0;
            for t in hits.iter().copied().chain([hits.last().copied().unwrap_or(0.0) + 2.0]) {
                assert_eq!(g.inside(ray.at((before + t) / 2.0), top), inside, "{ray:?} {hits:?}");
                inside = !inside;
                before = t;
                crossings += 1;
            }
        }
        assert!(crossings > 1000);
    }
}
