//! SDL: `global_settings { radiosity { count 35 error_bound 1.8 ... } }`: light that surfaces throw at each other.
//!
//! At some points light is gathered from a hemisphere of rays; points near by take a mean of what was gathered around
//! them (Ward, Rubinstein and Clear, "A ray tracing solution for diffuse interreflection", 1988). The [`Cache`] holds
//! what was gathered; passes over a coarse picture fill it before the picture proper is rendered.

mod cache;
mod directions;
mod settings;

pub use cache::{Cache, Gathered, Mean};
pub use directions::hemisphere;
pub use settings::Settings;

/// What one thread knows of the light between surfaces.
#[derive(Debug)]
pub struct Indirect<'s> {
    /// What earlier passes gathered, which never changes during a pass.
    pub shared: &'s Cache,
    /// What this thread gathered in the current tile: the picture does not depend on the order of tiles.
    pub own: Cache,
    /// How different a point may be that reuses light.
    pub error_bound: f64,
    /// Whether any light near by is good enough.
    pub take_any: bool,
    /// How many gathering rays lead to the current one.
    pub bounces: u32,
}

impl<'s> Indirect<'s> {
    /// For a pass that may use what is in `shared`.
    pub fn new(shared: &'s Cache, error_bound: f64, take_any: bool) -> Indirect<'s> {
        Indirect { shared, own: Cache::default(), error_bound, take_any, bounces: 0 }
    }
}
