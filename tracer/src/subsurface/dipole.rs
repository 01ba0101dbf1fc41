//! Light that is scattered many times under a surface, as from a lamp below and a negative one above.

use std::f64::consts::PI;

/// Halvings of the interval that the albedo is sought in.
const HALVINGS: usize = 40;

/// A homogeneous stuff in one channel.
#[derive(Clone, Copy, Debug)]
pub struct Dipole {
    /// The share of scattered light in what is scattered and absorbed.
    pub albedo: f64,
    /// How often light is scattered or absorbed per unit of length.
    pub extinction: f64,
    /// How fast scattered light falls off with distance.
    transport: f64,
    /// Depth and height of the two lamps.
    lamps: [f64; 2],
}

impl Dipole {
    /// The stuff that throws back the share `reflectance` of diffuse light.
    pub fn new(reflectance: f64, scattering: f64, ior: f64) -> Dipole {
        let inner = inner_reflection(ior);
        let albedo = albedo(reflectance, inner);
        let extinction = scattering / albedo;
        let depth = extinction.recip();
        Dipole {
            albedo,
            extinction,
            transport: (3.0 * (1.0 - albedo)).sqrt() * extinction,
            lamps: [depth, depth * (1.0 + 4.0 / 3.0 * inner)],
        }
    }

    /// Whether there is anything to scatter light and anything to let it through.
    pub fn is_sound(&self) -> bool {
        self.albedo > 0.0 && self.extinction.is_finite() && self.extinction > 0.0
    }

    /// The share of light that entered at a point and leaves per unit of area at `distance` from it.
    pub fn spread(&self, distance: f64) -> f64 {
        let lamp = |height: f64| {
            let way = distance.hypot(height);
            height * (self.transport + way.recip()) * (-self.transport * way).exp() / (way * way)
        };
        self.albedo / (4.0 * PI) * self.lamps.map(lamp).iter().sum::<f64>()
    }
}

/// The albedo that makes a half-space throw back the share `reflectance`.
fn albedo(reflectance: f64, inner: f64) -> f64 {
    let thrown_back = |albedo: f64| {
        let s = (3.0 * (1.0 - albedo)).sqrt();
        albedo / 2.0 * (1.0 + (-4.0 / 3.0 * inner * s).exp()) * (-s).exp()
    };
    let (mut low, mut high) = (0.0, 1.0);
    if reflectance <= 0.0 {
        return 0.0;
    }
    // More than all cannot come back: nothing does (probed).
    if reflectance > 1.0 {
        return f64::NAN;
    }
    for _ in 0..HALVINGS {
        let middle = (low + high) / 2.0;
        if thrown_back(middle) < reflectance {
            low = middle;
        } else {
            high = middle;
        }
    }
    (low + high) / 2.0
}

/// How the boundary throws diffuse light back inside, as it shifts the upper lamp. POV-Ray looks at the boundary from
/// the other side than the paper (probed).
fn inner_reflection(ior: f64) -> f64 {
    let eta = ior.recip();
    let mean = if eta < 1.0 {
        -0.4399 + 0.7099 / eta - 0.3319 / eta.powi(2) + 0.0636 / eta.powi(3)
    } else {
        -1.440 / eta.powi(2) + 0.710 / eta + 0.668 + 0.0636 * eta
    };
    (1.0 + mean) / (1.0 - mean)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_half_space_throws_back_its_colour() {
        for (reflectance, ior) in [(0.95, 1.3), (0.4, 1.5), (0.06, 1.0)] {
            let dipole = Dipole::new(reflectance, 10.0, ior);
            let step = 2e-3;
            let sum: f64 = (0..60_000)
                .map(|i| {
                    let r = (f64::from(i) + 0.5) * step;
                    dipole.spread(r) * 2.0 * PI * r * step
                })
                .sum();
            assert!((sum - reflectance).abs() < 0.01, "{reflectance}: {sum}");
        }
    }

    /// Of a half-space lit up to an edge, the brightness from the edge into the shadow as POV-Ray 3.7 shows it.
    #[test]
    fn light_goes_as_far_as_in_povray() {
        for (reflectance, translucency, beyond, expected) in
            [(0.95, 1.0, 0.275, 0.1573), (0.4, 2.0, 0.275, 0.1328), (0.1, 4.0, 0.125, 0.2442)]
        {
            let dipole = Dipole::new(reflectance, 10.0 / translucency, 1.3);
            // Of light that entered at distance r, the share that left farther than `beyond` to one side.
            let step = 1e-3;
            let sum: f64 = (0..20_000)
                .map(|i| {
                    let r = beyond + (f64::from(i) + 0.5) * step;
                    dipole.spread(r) * 2.0 * r * (beyond / r).acos() * step
                })
                .sum();
            assert!((sum / reflectance - expected).abs() < 0.003, "{}: {expected}", sum / reflectance);
        }
    }
}
