//! The Mersenne Twister MT19937 (Matsumoto and Nishimura 1998) with its reference seed.

const SIZE: usize = 624;
const SHIFT: usize = 397;
const REFERENCE_SEED: u32 = 5489;

/// The stream of 32-bit numbers.
pub struct MersenneTwister {
    state: [u32; SIZE],
    next: usize,
}

impl Default for MersenneTwister {
    fn default() -> MersenneTwister {
        MersenneTwister::new(REFERENCE_SEED)
    }
}

impl MersenneTwister {
    /// Seeded by one number.
    pub fn new(seed: u32) -> MersenneTwister {
        let mut state = [seed; SIZE];
        for i in 1..SIZE {
            let previous = state[i - 1];
            state[i] = (previous ^ previous >> 30).wrapping_mul(1_812_433_253).wrapping_add(i as u32);
        }
        MersenneTwister { state, next: SIZE }
    }

    /// The next number.
    pub fn next_u32(&mut self) -> u32 {
        if self.next == SIZE {
            self.renew();
        }
        let mut y = self.state[self.next];
        self.next += 1;
        y ^= y >> 11;
        y ^= y << 7 & 0x9d2c_5680;
        y ^= y << 15 & 0xefc6_0000;
        y ^ y >> 18
    }

    /// The next number as a fraction, in 0..1.
    pub fn next_unit(&mut self) -> f64 {
        f64::from(self.next_u32()) / 4_294_967_296.0
    }

    fn renew(&mut self) {
        for i in 0..SIZE {
            let joined = self.state[i] & 0x8000_0000 | self.state[(i + 1) % SIZE] & 0x7fff_ffff;
            let twist = if joined & 1 == 1 { 0x9908_b0df } else { 0 };
            self.state[i] = self.state[(i + SHIFT) % SIZE] ^ joined >> 1 ^ twist;
        }
        self.next = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_thousandth_number_is_the_published_one() {
        let mut random = MersenneTwister::default();
        let last = (0..10_000).map(|_| random.next_u32()).last();
        assert_eq!(last, Some(4_123_659_995));
    }
}
