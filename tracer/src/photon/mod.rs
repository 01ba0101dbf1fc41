//! SDL: `global_settings { photons { count 20000 } }`: light that mirrors and lenses throw on other things.
//!
//! Photons are shot from each light at the objects that are a `target`; what those mirror or refract is followed until
//! it falls on something that collects it (Jensen, "Realistic Image Synthesis Using Photon Mapping", 2001). The
//! picture is rendered with the [`PhotonMap`] in hand.

mod map;
mod settings;
mod shoot;

pub use map::{Photon, PhotonMap};
pub use settings::{Allowed, Gathering, Settings};
pub use shoot::{rings, Aim, Shot};
