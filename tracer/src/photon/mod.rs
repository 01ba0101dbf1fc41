//! SDL: `global_settings { photons { count 20000 } }`: light that mirrors and lenses throw on other things.
//!
//! Photons are shot from each light at the objects that are a `target`; what those mirror or refract is followed until
//! it falls on something that collects it, and left in the media on its way if `media` asks for it (Jensen, "Realistic
//! Image Synthesis Using Photon Mapping", 2001). The picture is rendered with the [`PhotonMaps`] in hand.

mod map;
mod settings;
mod shoot;

pub use map::{Photon, PhotonMap, PhotonMaps};
pub use settings::{Allowed, Gathering, Settings};
pub use shoot::{rings, Aim, Shot};
