//! What an object wears and how it behaves, after inheritance from the unions and CSG around it.

use std::sync::Arc;

use super::NodeId;
use crate::graph::{PhotonBehaviour, Shared};
use crate::math::Transform;

/// Something worn, and the space that it stands in (none: the world).
#[derive(Debug)]
pub struct Worn<T> {
    /// The thing itself.
    pub item: Shared<T>,
    /// From its space to the world.
    pub space: Option<Arc<Transform>>,
}

impl<T> Clone for Worn<T> {
    fn clone(&self) -> Self {
        Worn { item: self.item.clone(), space: self.space.clone() }
    }
}

impl<T> Worn<T> {
    /// The same thing in the same place.
    pub fn same(&self, other: &Worn<T>) -> bool {
        self.item.address() == other.item.address() && self.space == other.space
    }
}

/// A filled space.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// Its interior, if the scene gives one.
    pub interior: Option<u32>,
    /// Lets media and fog pass.
    pub hollow: bool,
}

/// Looks and behaviour of one node. Textures and interiors are indices into the lists of the `Geometry`.
#[derive(Clone, Debug, Default)]
pub struct Looks {
    /// None: the scene's default texture.
    pub texture: Option<u32>,
    /// For the side that rays from inside see.
    pub interior_texture: Option<u32>,
    /// Which filled space the object bounds: an index into the bodies of the `Geometry`. Children of one union or CSG
    /// without interiors of their own share theirs; two objects never do. Only the default has none.
    pub body: Option<u32>,
    /// What fills the object.
    pub interior: Option<u32>,
    /// Lets media and fog pass.
    pub hollow: bool,
    /// Throws no shadow.
    pub no_shadow: bool,
    /// Not seen by camera rays.
    pub no_image: bool,
    /// Not seen in mirrors.
    pub no_reflection: bool,
    /// Not seen by radiosity's rays.
    pub no_radiosity: bool,
    /// Lit from both sides.
    pub double_illuminate: bool,
    /// The object's texture is mapped by surface coordinates.
    pub uv_mapping: bool,
    /// Whether `Geometry::texture_weights` must be asked which textures are seen: meshes and blobs with several.
    pub several_textures: bool,
    /// The textures of the parts of a mesh or blob, in the order of its own list.
    pub part_textures: Arc<[Option<u32>]>,
    /// Neither the node nor anything around it has a texture.
    pub untextured: bool,
    /// The CSG whose `cutaway_textures` dresses this node, which has no texture of its own.
    pub cutaway: Option<NodeId>,
    /// How it treats photons.
    pub photons: Option<PhotonBehaviour>,
    /// `radiosity { importance F }`.
    pub radiosity_importance: Option<f64>,
    /// The light group that it stands in.
    pub light_group: Option<u32>,
    /// Where the scene made it.
    pub source: Arc<str>,
}

impl Looks {
    /// The texture of a part; that of the whole where the part has none.
    pub fn part_texture(&self, part: i32) -> Option<u32> {
        usize::try_from(part).ok().and_then(|i| *self.part_textures.get(i)?).or(self.texture)
    }
}
