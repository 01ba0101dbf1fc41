//! `+Q0` .. `+Q11`: what is left out to be faster.

/// Which effects are rendered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Full ambient light and `quick_color` instead of lamps.
    pub quick_colors: bool,
    /// Shadows at all.
    pub shadows: bool,
    /// Soft shadows.
    pub area_lights: bool,
    /// Mirrors.
    pub reflection: bool,
    /// What is behind transparent surfaces.
    pub refraction: bool,
    /// Media, fog, radiosity.
    pub volumes: bool,
}

impl Quality {
    /// The effects of a quality number.
    pub fn new(number: u8) -> Quality {
        Quality {
            quick_colors: number <= 5,
            shadows: number >= 4,
            area_lights: number >= 5,
            reflection: number >= 8,
            refraction: number >= 8,
            volumes: number >= 9,
        }
    }
}
