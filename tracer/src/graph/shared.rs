//! Nodes that several parents may hold, and the list of what cannot be rendered.

use std::ops::Deref;
use std::sync::Arc;

/// A node that several parents may hold; one Python object gives one node, so `address` tells equal ones.
#[derive(Debug, Default)]
pub struct Shared<T>(Arc<T>);

impl<T> Shared<T> {
    /// A node of its own.
    pub fn new(node: T) -> Shared<T> {
        Shared(Arc::new(node))
    }

    /// What identifies the node while it lives.
    pub fn address(&self) -> usize {
        Arc::as_ptr(&self.0) as *const () as usize
    }

    #[cfg(feature = "python")]
    pub(super) fn from_arc(node: Arc<T>) -> Shared<T> {
        Shared(node)
    }
}

impl<T> Clone for Shared<T> {
    fn clone(&self) -> Shared<T> {
        Shared(self.0.clone())
    }
}

impl<T> Deref for Shared<T> {
    type Target = T;
    fn deref(&self) -> &T {
        &self.0
    }
}

/// Something that the scene asks for and the core leaves out.
#[derive(Clone, Debug, PartialEq)]
pub struct Unsupported {
    /// What, in SDL's words.
    pub feature: String,
    /// Where the scene asks for it ("file:line"), or empty.
    pub source: String,
}
