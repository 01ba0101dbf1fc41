//! The ray tracing core of minipov: a prepared scene in, linear colour out.

#[cfg(feature = "python")]
mod python;
