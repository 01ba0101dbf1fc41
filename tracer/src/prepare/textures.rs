//! Textures: every graph node once, in one list.

use std::collections::HashMap;

use super::scene::Dress;
use super::Quality;
use crate::color::Rgb;
use crate::geometry::Geometry;
use crate::graph::scene::Scene;
use crate::graph::texture as graph;
use crate::graph::Shared;
use crate::pattern::PatternKind;
use crate::shade::{Finish, Layer, Texture, TextureId};
use crate::texture::{self, BlendMap, Pigment};

/// All textures, and those that geometry knows by number, the scene's default last.
pub fn prepare(
    scene: &Scene,
    geometry: &Geometry,
    quality: &Quality,
    patterns: &mut texture::Builder,
) -> (Vec<Texture>, Vec<Dress>) {
    // Gathered light takes the place of ambient light, but not in old scenes (probed).
    let gathers = scene.settings.radiosity.is_some() && quality.volumes && scene.version >= 3.7;
    let ambient_light = if gathers { Rgb::BLACK } else { scene.settings.ambient_light };
    let translucent = scene.settings.subsurface.is_some() && quality.volumes;
    let mm_per_unit = translucent.then_some(scene.settings.mm_per_unit);
    let mut builder = Builder {
        ambient_light,
        mm_per_unit,
        quality,
        patterns,
        textures: Vec::new(),
        known: HashMap::new(),
    };
    let mut dresses: Vec<Dress> = Vec::new();
    for worn in &geometry.textures {
        let texture = builder.add(&worn.item);
        let (opaque, passes) = (builder.is_opaque(texture), builder.passes(texture));
        let texture = match worn.space.as_deref() {
            Some(space) => builder.push(Texture::Placed(Box::new(*space), texture)),
            None => texture,
        };
        dresses.push(Dress { texture, opaque, passes });
    }
    let texture = builder.add(&scene.default_texture);
    let (opaque, passes) = (builder.is_opaque(texture), builder.passes(texture));
    dresses.push(Dress { texture, opaque, passes });
    (builder.textures, dresses)
}

struct Builder<'a> {
    ambient_light: Rgb,
    /// None where no light enters surfaces.
    mm_per_unit: Option<f64>,
    quality: &'a Quality,
    patterns: &'a mut texture::Builder,
    textures: Vec<Texture>,
    known: HashMap<usize, TextureId>,
}

impl Builder<'_> {
    fn push(&mut self, texture: Texture) -> TextureId {
        self.textures.push(texture);
        self.textures.len() as TextureId - 1
    }

    /// A graph node's texture, made when first met.
    fn add(&mut self, texture: &Shared<graph::Texture>) -> TextureId {
        if let Some(&id) = self.known.get(&texture.address()) {
            return id;
        }
        let made = match &**texture {
            graph::Texture::Plain(plain) => Texture::Layers(Box::new([self.layer(plain)])),
            graph::Texture::Layered(layered) => {
                Texture::Layers(layered.layers.iter().rev().map(|layer| self.layer(layer)).collect())
            }
            graph::Texture::Pattern(patterned) => self.patterned(patterned),
            graph::Texture::MaterialMap(map) => {
                let textures = map.textures.iter().map(|t| self.add(t)).collect();
                Texture::Blocks(Box::new((self.patterns.material_pattern(map), textures)))
            }
        };
        let id = self.push(made);
        self.known.insert(texture.address(), id);
        id
    }

    /// Textures that a pattern chooses from or mixes.
    fn patterned(&mut self, node: &graph::PatternTexture) -> Texture {
        let pattern = self.patterns.pattern(&node.pattern, &node.modifiers);
        match &node.blend {
            graph::TextureBlend::Map(map) => {
                let entries: Vec<_> = map.entries.iter().map(|(v, t)| (*v, self.add(t))).collect();
                match pattern {
                    // What the pattern would choose from is known, but not how: the first stands for all.
                    None => self.textures[entries[0].1 as usize].clone(),
                    Some(p) if matches!(p.kind, PatternKind::Average) => {
                        Texture::Average(Box::new((p.modifiers, entries)))
                    }
                    Some(p) => Texture::Map(Box::new((p, BlendMap::new(entries)))),
                }
            }
            graph::TextureBlend::List(list) => {
                let textures: Vec<_> = list.textures.iter().map(|t| self.add(t)).collect();
                match pattern {
                    None => self.textures[textures[0] as usize].clone(),
                    Some(p) if p.picks() => Texture::Blocks(Box::new((p, textures))),
                    Some(p) => Texture::Map(Box::new((p, BlendMap::numbered(textures)))),
                }
            }
        }
    }

    fn layer(&mut self, plain: &graph::PlainTexture) -> Layer {
        let anisotropic = plain.finish.subsurface.as_ref().is_some_and(|s| s.anisotropy != Rgb::BLACK);
        for (said, word) in [
            (plain.finish.fresnel != 0.0, "fresnel of a finish"),
            (plain.finish.use_alpha, "use_alpha of a finish"),
            (anisotropic, "anisotropy of subsurface"),
        ] {
            if said {
                self.patterns.leave_out(word);
            }
        }
        let quick = plain.pigment.quick_color.filter(|_| self.quality.quick_colors);
        Layer {
            pigment: quick.map_or_else(|| self.patterns.pigment(&plain.pigment), Pigment::Solid),
            normal: plain
                .normal
                .as_ref()
                .filter(|_| self.quality.normals)
                .map(|node| self.patterns.normal(node)),
            finish: Finish::new(&plain.finish, self.ambient_light, self.mm_per_unit),
        }
    }

    /// The share of light that passes layers of plain colours.
    fn passes(&self, id: TextureId) -> Option<Rgb> {
        let Texture::Layers(layers) = &self.textures[id as usize] else { return None };
        layers.iter().try_fold(Rgb::WHITE, |filter, layer| match &layer.pigment {
            Pigment::Solid(color) => Some(filter.mul_each(color.passing())),
            _ => None,
        })
    }

    /// Whether nothing is ever seen through a texture: some layer is opaque everywhere.
    fn is_opaque(&self, id: TextureId) -> bool {
        match &self.textures[id as usize] {
            Texture::Layers(layers) => layers.iter().any(|layer| layer.pigment.is_opaque()),
            Texture::Placed(_, inner) => self.is_opaque(*inner),
            Texture::Map(map) => map.1.entries().iter().all(|e| self.is_opaque(e.1)),
            Texture::Blocks(blocks) => blocks.1.iter().all(|&id| self.is_opaque(id)),
            Texture::Average(average) => average.1.iter().all(|e| self.is_opaque(e.1)),
        }
    }
}
