//! From a prepared scene to a picture: tiles on several threads.

mod antialias;
mod job;
mod photons;
mod picture;
mod pretrace;
mod random;
mod tile;
mod view;

pub use job::{Job, Progress};
pub use picture::Picture;
pub use random::Random;
