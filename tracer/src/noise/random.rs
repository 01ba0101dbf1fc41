//! The linear congruential generator behind POV-Ray's tables and `rand()`.

/// A 32-bit state; the same numbers as POV-Ray's `seed(n)` streams.
#[derive(Clone, Debug)]
pub struct Lcg(pub u32);

impl Lcg {
    const MULTIPLIER: u32 = 1_812_433_253;
    const INCREMENT: u32 = 12_345;

    /// The next full state.
    pub const fn next_state(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(Self::MULTIPLIER).wrapping_add(Self::INCREMENT);
        self.0
    }

    /// The next 15-bit integer, which POV-Ray's tables are shuffled with.
    pub const fn next_15_bits(&mut self) -> u32 {
        self.next_state() >> 16 & 0x7fff
    }

    /// The next number of `rand()`, in 0..=1.
    pub const fn next_unit(&mut self) -> f64 {
        self.next_state() as f64 / u32::MAX as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rand_streams_equal_povrays() {
        let stream = |seed| {
            let mut g = Lcg(seed);
            [g.next_unit(), g.next_unit()].map(|v| (v * 1e6).round() / 1e6)
        };
        assert_eq!(stream(0), [0.000003, 0.466564]);
        assert_eq!(stream(42), [0.723583, 0.329979]);
    }
}
