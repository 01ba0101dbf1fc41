//! Placed geometry: what rays are shot at. Immutable, index-based, made once by [`prepare`].
//!
//! Every object of the scene that can be hit is a [`Node`]: a primitive in its place, or a CSG over other nodes.
//! Unions are taken apart, transforms multiplied out, looks inherited. [`Geometry::nearest`] and [`Geometry::any`]
//! find hits; [`Geometry::surface`] says what is there, once, for the hit that counts.

mod containing;
mod extents;
mod looks;
mod node;
mod place;
mod prepare;
mod question;
mod search;
mod surface;
#[cfg(test)]
mod tests;

pub use looks::{Body, Looks, Worn};
pub use node::{Node, NodeId, Solid};
pub use prepare::prepare;
pub use question::Questioned;
pub use search::{Answer, Hit};
pub use surface::Surface;

use crate::accel::Accelerator;
use crate::graph::{Interior, LightSource, Texture};

/// The objects of a scene, ready for rays.
#[derive(Debug)]
pub struct Geometry {
    pub(crate) nodes: Vec<Node>,
    pub(crate) looks: Vec<Looks>,
    /// The objects at the top, in file order: first those in `tree`, by its item numbers.
    pub(crate) finite: Vec<NodeId>,
    pub(crate) infinite: Vec<NodeId>,
    pub(crate) tree: Accelerator,
    /// Every texture that a node wears with the space it stands in; `Looks` holds indices.
    pub textures: Vec<Worn<Texture>>,
    /// Every interior that a node has.
    pub interiors: Vec<Worn<Interior>>,
    /// What is bounded by surfaces; `Looks::body` holds an index.
    pub bodies: Vec<Body>,
    /// Lights found inside unions and CSG, in file order.
    pub lights: Vec<Worn<LightSource>>,
    /// The light groups; `Looks::light_group` holds an index.
    pub light_groups: Vec<LightGroup>,
}

/// Lights that shine only on the objects of their group.
#[derive(Clone, Debug)]
pub struct LightGroup {
    /// The group's own lights.
    pub lights: Vec<Worn<LightSource>>,
    /// Whether the scene's other lights shine here as well.
    pub global_lights: bool,
    /// The group around this one.
    pub parent: Option<usize>,
}

impl Geometry {
    /// What a node wears and how it behaves.
    pub fn looks(&self, node: NodeId) -> &Looks {
        &self.looks[node as usize]
    }

    /// Whether any node's texture is mapped by surface coordinates.
    pub fn uses_uv(&self) -> bool {
        self.looks.iter().any(|looks| looks.uv_mapping)
    }

    /// A node.
    pub fn node(&self, node: NodeId) -> &Node {
        &self.nodes[node as usize]
    }

    /// The objects at the top after taking unions apart: primitives and CSG.
    pub fn top(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.infinite.iter().chain(&self.finite).copied()
    }
}
