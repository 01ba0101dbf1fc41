//! `+Q0` .. `+Q11`: what is left out to be faster.

/// Which effects are rendered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Plain colours of pigments instead of light.
    pub unlit: bool,
    /// `quick_color` instead of the pigment that has one.
    pub quick_colors: bool,
    /// Shadows at all.
    pub shadows: bool,
    /// Soft shadows.
    pub area_lights: bool,
    /// What is behind transparent surfaces.
    pub refraction: bool,
    /// Mirrors.
    pub reflection: bool,
    /// Bumps.
    pub normals: bool,
    /// Media, fog, radiosity.
    pub volumes: bool,
}

impl Quality {
    /// The effects of a quality number.
    pub fn new(number: u8) -> Quality {
        Quality {
            unlit: number <= 1,
            quick_colors: number <= 5,
            shadows: number >= 4,
            area_lights: number >= 5,
            refraction: number >= 6,
            reflection: number >= 8,
            normals: number >= 8,
            volumes: number >= 9,
        }
    }
}
