//! Lights: those of the scene, of unions and of light groups; the objects that some look like.

use std::sync::Arc;

use crate::accel::AcceleratorKind;
use crate::geometry::Geometry;
use crate::graph::light::{LightKind, LightSource};
use crate::graph::scene::Scene;
use crate::graph::{Modifiers, Object, Shared, Unsupported};
use crate::light::{Area, Beam, Fade, Light};
use crate::math::Transform;
use crate::texture::Builder;

/// The objects that lights of the scene look like; they throw no shadow.
pub fn visible(scene: &Scene) -> impl Iterator<Item = Object> + '_ {
    scene.lights.iter().filter_map(|light| light.looks_like.clone()).map(|mut object| {
        let modifiers = Modifiers { no_shadow: true, ..(*object.modifiers).clone() };
        object.modifiers = Shared::new(modifiers);
        object
    })
}

/// All lights, and which of them shine outside all groups, then on each group.
pub fn prepare(
    scene: &Scene,
    geometry: &Geometry,
    kind: AcceleratorKind,
    patterns: &mut Builder,
    unsupported: &mut Vec<Unsupported>,
) -> (Vec<Light>, Vec<Vec<u32>>) {
    let mut lights = Vec::new();
    let mut add = |source: &LightSource, space: Option<&Transform>| {
        let mut light = light(source, space);
        if let Some(object) = &source.projected_through {
            let object = object.clone().placed(space.copied().unwrap_or(Transform::IDENTITY));
            let (window, missing) = crate::geometry::prepare(&[object], kind, patterns);
            light.projected_through = Some(Arc::new(window));
            unsupported.extend(missing);
        }
        lights.push(light);
        lights.len() as u32 - 1
    };
    let mut global: Vec<u32> = scene.lights.iter().map(|source| add(source, None)).collect();
    global.extend(geometry.lights.iter().map(|w| add(&w.item, w.space.as_deref())));
    let mut sets = vec![global];
    for group in &geometry.light_groups {
        // The lights of a group around this one do not shine here; the outermost group says whether the scene's do.
        let mut outermost = group;
        while let Some(parent) = outermost.parent {
            outermost = &geometry.light_groups[parent];
        }
        let mut set = if outermost.global_lights { sets[0].clone() } else { Vec::new() };
        set.extend(group.lights.iter().map(|w| add(&w.item, w.space.as_deref())));
        sets.push(set);
    }
    (lights, sets)
}

fn light(source: &LightSource, space: Option<&Transform>) -> Light {
    let identity = Transform::IDENTITY;
    let space = space.unwrap_or(&identity);
    let location = space.point(source.location);
    let axis = (space.point(source.point_at) - location).normalized();
    let (radius, falloff, tightness) = (source.radius, source.falloff, source.tightness);
    let beam = match source.kind {
        LightKind::Point => Beam::Point,
        LightKind::Spotlight => {
            let cos = |degrees: f64| degrees.to_radians().cos();
            Beam::Spot { axis, radius: cos(radius), falloff: cos(falloff), tightness }
        }
        LightKind::Cylinder => Beam::Cylinder { axis, radius, falloff, tightness },
    };
    let fade = if source.fade_power == 0.0 {
        Fade::None
    } else if source.pure_power {
        Fade::Power(source.fade_power)
    } else if source.fade_distance == 0.0 {
        Fade::None
    } else {
        Fade::Distance(source.fade_distance, source.fade_power)
    };
    Light {
        location,
        color: source.color,
        beam,
        towards_parallel: (source.parallel || source.kind == LightKind::Cylinder).then_some(-axis),
        shadowless: source.shadowless,
        area: source.area.as_ref().map(|area| Area {
            axes: [space.direction(area.axis1), space.direction(area.axis2)],
            size: [area.size1, area.size2],
            adaptive: area.adaptive.unwrap_or(100),
            jitter: area.jitter,
            circular: area.circular,
            orient: area.orient,
            illumination: area.area_illumination,
        }),
        fade,
        projected_through: None,
        photons: source.photons.clone(),
        media_interaction: source.media_interaction,
        media_attenuation: source.media_attenuation && source.media_interaction,
    }
}
