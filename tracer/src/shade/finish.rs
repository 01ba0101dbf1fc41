//! SDL: `finish { ... }` made ready for shading: normalised factors, and flags that let terms be skipped.

use crate::color::Rgb;
use crate::graph::finish as graph;
use crate::subsurface::Translucent;

/// How a surface answers light. Albedo factors are already applied, so every term is a plain factor.
#[derive(Clone, Debug)]
pub struct Finish {
    /// `ambient` times the scene's `ambient_light`.
    pub ambient: Rgb,
    /// Light of its own.
    pub emission: Rgb,
    /// Factor of diffuse light, and of light from behind.
    pub diffuse: [f64; 2],
    /// Exponent of the cosine in diffuse light.
    pub brilliance: f64,
    /// Depth of random darkening.
    pub crand: f64,
    /// Factor and exponent of Phong's highlight.
    pub phong: (f64, f64),
    /// Factor and exponent of Blinn's highlight.
    pub specular: (f64, f64),
    /// How much highlights take the pigment's colour.
    pub metallic: f64,
    /// The mirror, if any.
    pub reflection: Option<Reflection>,
    /// Whether what is reflected is missing in what is transmitted.
    pub conserve_energy: bool,
    /// Thin film: amount, thickness, turbulence.
    pub irid: Option<graph::Iridescence>,
    /// Light of lamps that enters the surface, in place of their diffuse light.
    pub subsurface: Option<Translucent>,
    /// Whether any lamp can light this surface.
    pub lit: bool,
    /// Whether light from behind counts.
    pub lit_from_behind: bool,
}

/// `reflection { ... }` that is not black.
#[derive(Clone, Debug)]
pub struct Reflection {
    /// Head-on and grazing.
    pub range: [Rgb; 2],
    /// Fresnel's law instead of a power of the angle.
    pub fresnel: bool,
    /// Exponent of the angle's influence.
    pub falloff: f64,
    /// The power that reflected light is raised to: one over `reflection_exponent` or `exponent` (probed).
    pub exponent: f64,
    /// How much the mirror takes the pigment's colour.
    pub metallic: f64,
}

impl Finish {
    /// Applies `albedo` (the hemispherical reflectance of each lobe, as probed) the scene's ambient light, and its scale
    /// where light may enter surfaces.
    pub fn new(f: &graph::Finish, ambient_light: Rgb, mm_per_unit: Option<f64>) -> Finish {
        let brilliance_factor = if f.diffuse_albedo { (f.brilliance + 1.0) / 2.0 } else { 1.0 };
        let phong_factor = if f.phong_albedo { (f.phong_size + 1.0) / 2.0 } else { 1.0 };
        let exponent = if f.roughness == 0.0 { 0.0 } else { 1.0 / f.roughness };
        let specular_factor =
            if f.specular_albedo { (exponent + 2.0) / (4.0 * (2.0 - (-exponent / 2.0).exp2())) } else { 1.0 };
        let black = f.reflection.maximum == Rgb::BLACK && f.reflection.minimum == Rgb::BLACK;
        let subsurface =
            mm_per_unit.and_then(|mm| Some(Translucent::new(f.subsurface.as_ref()?, f.diffuse, mm)));
        let scatters = subsurface.is_none();
        let lit_from_behind = scatters && f.diffuse_back != 0.0;
        Finish {
            ambient: f.ambient.mul_each(ambient_light),
            emission: f.emission,
            diffuse: [f.diffuse * brilliance_factor, f.diffuse_back * brilliance_factor],
            brilliance: f.brilliance,
            crand: f.crand,
            phong: (f.phong * phong_factor, f.phong_size),
            specular: (f.specular * specular_factor, exponent),
            metallic: f.metallic,
            reflection: (!black).then(|| Reflection {
                range: [f.reflection.minimum, f.reflection.maximum],
                fresnel: f.reflection.fresnel,
                falloff: f.reflection.falloff,
                exponent: 1.0 / f.reflection.exponent,
                metallic: f.reflection.metallic,
            }),
            conserve_energy: f.conserve_energy,
            irid: f.irid.clone().filter(|i| i.amount != 0.0),
            lit: (scatters && f.diffuse != 0.0) || lit_from_behind || f.phong != 0.0 || f.specular != 0.0,
            lit_from_behind,
            subsurface,
        }
    }
}
