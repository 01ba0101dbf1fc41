//! SDL: `scattering { 5, C eccentricity 0.3 }`: how much light is thrown where.

/// The constants are POV-Ray's (probed), which make all kinds about equally bright.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Phase {
    /// 1: every direction alike.
    Isotropic,
    /// 2: forward, as haze does.
    MieHaze,
    /// 3: forward, as thick fog does.
    MieMurky,
    /// 4: forward and back, as tiny particles do.
    Rayleigh,
    /// 5: forward where the eccentricity is positive, back where it is negative.
    HenyeyGreenstein(f64),
}

impl Phase {
    /// The kind of a number.
    pub fn new(kind: u8, eccentricity: f64) -> Phase {
        match kind {
            2 => Phase::MieHaze,
            3 => Phase::MieMurky,
            4 => Phase::Rayleigh,
            5 => Phase::HenyeyGreenstein(eccentricity),
            _ => Phase::Isotropic,
        }
    }

    /// The factor on light; `cos` is 1 where the ray looks towards the lamp.
    #[inline]
    pub fn factor(self, cos: f64) -> f64 {
        let forward = (1.0 + cos) / 2.0;
        match self {
            Phase::Isotropic => 1.0,
            Phase::MieHaze => 0.576655375 * (1.0 + 9.0 * forward.powi(8)),
            Phase::MieMurky => 0.495714547 * (1.0 + 50.0 * forward.powi(32)),
            Phase::Rayleigh => 0.799372013 * (1.0 + cos * cos),
            Phase::HenyeyGreenstein(g) => (1.0 - g * g) / (1.0 + g * g - 2.0 * g * cos).powf(1.5),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Phase;

    /// What POV-Ray 3.7 gives for a lamp behind, at right angles and (nearly) ahead of the ray.
    #[test]
    fn factors_equal_povrays() {
        let rows = [
            (1, 0.0, [1.0, 1.0, 1.0]),
            (2, 0.0, [0.5766, 0.5969, 3.557]),
            (3, 0.0, [0.4957, 0.4957, 3.191]),
            (4, 0.0, [1.5988, 0.7993, 1.3989]),
            (5, 0.4, [0.3061, 0.6723, 2.6306]),
            (5, -0.3, [2.6531, 0.7996, 0.4456]),
        ];
        for (kind, eccentricity, expected) in rows {
            let phase = Phase::new(kind, eccentricity);
            let ahead = 150f64.to_radians();
            for (cos, value) in [-1.0, 0.0, -ahead.cos()].into_iter().zip(expected) {
                assert!((phase.factor(cos) - value).abs() < 1e-3, "{kind} {cos}");
            }
        }
    }
}
