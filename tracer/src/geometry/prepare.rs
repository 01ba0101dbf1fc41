//! From the scene graph to placed nodes: unions taken apart, transforms multiplied out, looks inherited.
//!
//! `inverse` is handed down to the primitives: what lies outside a union lies outside every child, what lies outside
//! an intersection lies outside some child.

use std::collections::HashMap;
use std::sync::Arc;

use super::extents;
use super::node::{Node, NodeId, Solid};
use super::place::{PlacedShape, Placer};
use super::{Body, Geometry, LightGroup, Looks, Worn};
use crate::accel::{Accelerator, AcceleratorKind, RayKind};
use crate::csg::{Composite, Operation};
use crate::graph::{self, LightSource, Object, Shared, Unsupported};
use crate::math::Transform;
use crate::shape::Shape;
use crate::texture::Builder;

/// Makes the objects of a scene ready for rays. What cannot be rendered is left out and listed.
pub fn prepare(
    objects: &[Object],
    kind: AcceleratorKind,
    patterns: &mut Builder,
) -> (Geometry, Vec<Unsupported>) {
    let mut preparation = Preparation::new(kind, Placer::new(patterns));
    for object in objects {
        preparation.add_top(object, &Surroundings::default());
    }
    preparation.finish()
}

/// What an object finds around itself.
#[derive(Clone, Default)]
struct Surroundings {
    /// From the space around the object to the world.
    space: Option<Arc<Transform>>,
    looks: Looks,
    inverse: bool,
    /// Clipping objects of the unions around, which were taken apart.
    clipped_by: Vec<NodeId>,
}

struct Preparation<'a> {
    kind: AcceleratorKind,
    geometry: Geometry,
    top: Vec<NodeId>,
    placer: Placer<'a>,
    unsupported: Vec<Unsupported>,
    texture_index: HashMap<usize, Vec<u32>>,
    interior_index: HashMap<usize, Vec<u32>>,
}

impl<'a> Preparation<'a> {
    fn new(kind: AcceleratorKind, placer: Placer<'a>) -> Preparation<'a> {
        Preparation {
            kind,
            geometry: Geometry {
                nodes: Vec::new(),
                looks: Vec::new(),
                finite: Vec::new(),
                infinite: Vec::new(),
                tree: Accelerator::build(kind, &[]),
                textures: Vec::new(),
                interiors: Vec::new(),
                bodies: Vec::new(),
                lights: Vec::new(),
                light_groups: Vec::new(),
            },
            top: Vec::new(),
            placer,
            unsupported: Vec::new(),
            texture_index: HashMap::new(),
            interior_index: HashMap::new(),
        }
    }

    fn finish(mut self) -> (Geometry, Vec<Unsupported>) {
        let nodes = &self.geometry.nodes;
        let surface = |id: &NodeId| nodes[*id as usize].extent.surface;
        // A sphere of negative radius has a box that no ray meets, as in POV-Ray; within a CSG it is like any other.
        let negative = |id: &NodeId| {
            let solid = &nodes[*id as usize].solid;
            matches!(solid, Solid::Primitive { shape: Shape::Sphere(s), place: None } if s.radius < 0.0)
        };
        let top = self.top.iter().copied().filter(|id| !surface(id).is_empty() && !negative(id));
        let (finite, infinite): (Vec<NodeId>, Vec<NodeId>) = top.partition(|id| surface(id).is_finite());
        let boxes: Vec<_> = finite.iter().map(surface).collect();
        self.geometry.tree = Accelerator::build(self.kind, &boxes);
        self.geometry.finite = finite;
        self.geometry.infinite = infinite;
        (self.geometry, self.unsupported)
    }

    /// Adds an object at the top; unions there become their children.
    fn add_top(&mut self, object: &Object, around: &Surroundings) {
        let modifiers = &object.modifiers;
        let whole = modifiers.inverse || !modifiers.bounded_by.is_empty();
        match &object.shape {
            graph::Shape::Union(union) if !whole => {
                let mut within = self.inside_of(object, around, &union.lights);
                within.clipped_by = self.add_clips(object, around);
                union.children.iter().for_each(|child| self.add_top(child, &within));
                visible(&union.lights).for_each(|lamp| self.add_top(lamp, &within));
            }
            graph::Shape::LightGroup(group) if !whole => {
                let mut within = self.inside_of(object, around, &[]);
                within.clipped_by = self.add_clips(object, around);
                within.looks.light_group = Some(self.add_light_group(group, &within));
                group.children.iter().for_each(|child| self.add_top(child, &within));
                visible(&group.lights).for_each(|lamp| self.add_top(lamp, &within));
            }
            _ => {
                if let Some(id) = self.add(object, around) {
                    self.top.push(id);
                }
            }
        }
    }

    /// Adds one node with all below it.
    fn add(&mut self, object: &Object, around: &Surroundings) -> Option<NodeId> {
        use graph::Shape::{Intersection, LightGroup, Merge, Union};
        let inverse = object.modifiers.inverse != around.inverse;
        let any = |inverse, operation| if inverse { Operation::Intersection } else { operation };
        match &object.shape {
            Union(s) => {
                let within = self.inside_of(object, around, &s.lights);
                self.add_composite(any(inverse, Operation::Union), &s.children, object, around, within)
            }
            Merge(s) => {
                let within = self.inside_of(object, around, &s.lights);
                self.add_composite(any(inverse, Operation::Merge), &s.children, object, around, within)
            }
            Intersection(s) => {
                let within = self.inside_of(object, around, &s.lights);
                let operation = if inverse { Operation::Merge } else { Operation::Intersection };
                let id = self.add_composite(operation, &s.children, object, around, within)?;
                if s.cutaway_textures {
                    self.mark_cutaway(id);
                }
                Some(id)
            }
            LightGroup(s) => {
                let mut within = self.inside_of(object, around, &[]);
                within.looks.light_group = Some(self.add_light_group(s, &within));
                self.add_composite(any(inverse, Operation::Union), &s.children, object, around, within)
            }
            _ => self.add_primitive(object, around, inverse),
        }
    }

    fn add_primitive(&mut self, object: &Object, around: &Surroundings, inverse: bool) -> Option<NodeId> {
        let to_world = match &around.space {
            None => object.transform,
            Some(space) => object.transform.then(space),
        };
        let PlacedShape { shape, place } = match self.placer.place(&object.shape, &to_world) {
            Ok(placed) => placed,
            Err(feature) => {
                self.unsupported.push(Unsupported { feature, source: object.source.clone() });
                return None;
            }
        };
        let extent = extents::of_primitive(&shape, place.as_deref(), inverse);
        let patch = !crate::shape::Primitive::solid(&shape);
        let mut looks = self.looks(object, around);
        self.add_part_textures(&object.shape, &to_world, &mut looks);
        Some(self.push(object, around, Solid::Primitive { shape, place }, inverse, patch, extent, looks))
    }

    /// The textures that parts of the shape wear; they stand in the shape's own space.
    fn add_part_textures(&mut self, shape: &graph::Shape, to_world: &Transform, looks: &mut Looks) {
        let space = (!to_world.is_identity()).then(|| Arc::new(*to_world));
        let (list, index) = (&mut self.geometry.textures, &mut self.texture_index);
        let mut add = |item: &Shared<graph::Texture>| find_or_add(list, index, item, &space);
        looks.part_textures = match shape {
            graph::Shape::Mesh(mesh) => mesh.textures.iter().map(|item| Some(add(item))).collect(),
            graph::Shape::Blob(blob) if blob.components.iter().any(|c| c.texture.is_some()) => {
                blob.components.iter().map(|c| c.texture.as_ref().map(&mut add)).collect()
            }
            _ => return,
        };
        looks.several_textures = !looks.part_textures.is_empty();
    }

    fn add_composite(
        &mut self,
        operation: Operation,
        children: &[Object],
        object: &Object,
        around: &Surroundings,
        within: Surroundings,
    ) -> Option<NodeId> {
        let children: Vec<NodeId> = children.iter().filter_map(|child| self.add(child, &within)).collect();
        if children.is_empty() {
            return None;
        }
        let extent = extents::of_composite(operation, &children, &self.geometry.nodes);
        let composite = Composite::new(operation, &children, &self.geometry.nodes, self.kind);
        let solid = Solid::Composite(Box::new(composite));
        Some(self.push(object, around, solid, false, false, extent, within.looks))
    }

    #[allow(clippy::too_many_arguments)] // the parts of a node
    fn push(
        &mut self,
        object: &Object,
        around: &Surroundings,
        solid: Solid,
        inverse: bool,
        patch: bool,
        mut extent: super::node::Extent,
        looks: Looks,
    ) -> NodeId {
        let clipped_by = self.add_clips(object, around);
        let bounded_by = self.add_helpers(&object.modifiers.bounded_by, around);
        for &clip in &clipped_by {
            extents::clip(&mut extent, &self.geometry.nodes[clip as usize].extent);
        }
        let hidden = [
            (RayKind::Camera, looks.no_image),
            (RayKind::Reflected, looks.no_reflection),
            (RayKind::Shadow, looks.no_shadow),
            (RayKind::Radiosity, looks.no_radiosity),
            (RayKind::Photon, looks.no_image),
        ];
        let hidden = hidden.iter().fold(0, |bits, &(kind, hide)| bits | u8::from(hide) << kind as usize);
        self.geometry.nodes.push(Node {
            solid,
            inverse,
            patch,
            hidden,
            clipped_by: clipped_by.into(),
            bounded_by: bounded_by.into(),
            extent,
        });
        self.geometry.looks.push(looks);
        self.geometry.nodes.len() as NodeId - 1
    }

    /// The object's own clipping objects and those of the unions around it.
    fn add_clips(&mut self, object: &Object, around: &Surroundings) -> Vec<NodeId> {
        let mut clips = self.add_helpers(&object.modifiers.clipped_by, around);
        clips.extend(&around.clipped_by);
        clips
    }

    /// Clipping and bounding objects; they stand in the space around the object.
    fn add_helpers(&mut self, objects: &[Object], around: &Surroundings) -> Vec<NodeId> {
        let space = Surroundings { space: around.space.clone(), ..Surroundings::default() };
        objects.iter().filter_map(|object| self.add(object, &space)).collect()
    }

    /// What the children of a union or CSG find around themselves.
    fn inside_of(
        &mut self,
        object: &Object,
        around: &Surroundings,
        lights: &[Shared<LightSource>],
    ) -> Surroundings {
        let space = if object.transform.is_identity() {
            around.space.clone()
        } else {
            let outer = around.space.as_deref().copied().unwrap_or(Transform::IDENTITY);
            Some(Arc::new(object.transform.then(&outer)))
        };
        let lights = lights.iter().map(|item| Worn { item: item.clone(), space: space.clone() });
        let lights: Vec<_> = lights.collect();
        match around.looks.light_group {
            None => self.geometry.lights.extend(lights),
            Some(group) => self.geometry.light_groups[group as usize].lights.extend(lights),
        }
        Surroundings {
            looks: self.looks(object, around),
            inverse: object.modifiers.inverse != around.inverse,
            clipped_by: Vec::new(),
            space,
        }
    }

    fn add_light_group(&mut self, group: &graph::objects::LightGroup, within: &Surroundings) -> u32 {
        let worn = |item: &Shared<LightSource>| Worn { item: item.clone(), space: within.space.clone() };
        self.geometry.light_groups.push(LightGroup {
            lights: group.lights.iter().map(worn).collect(),
            global_lights: group.global_lights,
            parent: within.looks.light_group.map(|g| g as usize),
        });
        self.geometry.light_groups.len() as u32 - 1
    }

    /// An object's own looks, or what it inherits.
    fn looks(&mut self, object: &Object, around: &Surroundings) -> Looks {
        let (own, given) = (&object.modifiers, &around.looks);
        let space = &around.space;
        // Textures on surface coordinates do not move with a union around the object.
        let texture_space = if own.uv_mapping { &None } else { space };
        let texture = |list: &mut Vec<Worn<graph::Texture>>, index: &mut _, item: &Option<Shared<_>>| {
            item.as_ref().map(|item| find_or_add(list, index, item, texture_space))
        };
        let textures = &mut self.geometry.textures;
        let own_texture = texture(textures, &mut self.texture_index, &object.texture);
        let own_interior_texture = texture(textures, &mut self.texture_index, &object.interior_texture);
        let interior = object.interior.as_ref();
        let interior = interior
            .map(|item| find_or_add(&mut self.geometry.interiors, &mut self.interior_index, item, space));
        let hollow = own.hollow.unwrap_or(given.hollow);
        // Each object fills space with something of its own, unless a union or CSG around it fills all its children.
        let body = given.body.filter(|_| interior.is_none()).unwrap_or_else(|| {
            self.geometry.bodies.push(Body { interior, hollow });
            self.geometry.bodies.len() as u32 - 1
        });
        Looks {
            texture: own_texture.or(given.texture),
            interior_texture: own_interior_texture
                .or(given.interior_texture.filter(|_| own_texture.is_none())),
            body: Some(body),
            interior: interior.or(given.interior),
            hollow,
            no_shadow: own.no_shadow || given.no_shadow,
            no_image: own.no_image || given.no_image,
            no_reflection: own.no_reflection || given.no_reflection,
            no_radiosity: own.no_radiosity || given.no_radiosity,
            double_illuminate: own.double_illuminate.unwrap_or(given.double_illuminate),
            uv_mapping: own.uv_mapping || given.uv_mapping,
            several_textures: false,
            part_textures: Arc::default(),
            untextured: own_texture.is_none() && (given.untextured || given.texture.is_none()),
            cutaway: None,
            photons: own.photons.clone().or_else(|| given.photons.clone()),
            radiosity_importance: own.radiosity_importance.or(given.radiosity_importance),
            light_group: given.light_group,
            source: object.source.as_str().into(),
        }
    }

    /// Children without a texture of their own are dressed by the whole.
    fn mark_cutaway(&mut self, whole: NodeId) {
        let Solid::Composite(composite) = &self.geometry.nodes[whole as usize].solid else { return };
        let mut open: Vec<NodeId> = composite.children().collect();
        while let Some(id) = open.pop() {
            let looks = &mut self.geometry.looks[id as usize];
            if looks.untextured && looks.cutaway.is_none() {
                looks.cutaway = Some(whole);
                looks.several_textures = true;
            }
            if let Solid::Composite(composite) = &self.geometry.nodes[id as usize].solid {
                open.extend(composite.children());
            }
        }
    }
}

/// What lights look like.
fn visible(lights: &[Shared<LightSource>]) -> impl Iterator<Item = &Object> {
    lights.iter().filter_map(|light| light.looks_like.as_ref())
}

/// The place of a thing in a list, where equal things in equal spaces stand once.
fn find_or_add<T>(
    list: &mut Vec<Worn<T>>,
    index: &mut HashMap<usize, Vec<u32>>,
    item: &Shared<T>,
    space: &Option<Arc<Transform>>,
) -> u32 {
    let worn = Worn { item: item.clone(), space: space.clone() };
    let known = index.entry(item.address()).or_default();
    if let Some(&id) = known.iter().find(|&&id| list[id as usize].same(&worn)) {
        return id;
    }
    list.push(worn);
    let id = list.len() as u32 - 1;
    known.push(id);
    id
}
