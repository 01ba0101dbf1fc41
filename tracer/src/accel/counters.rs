//! `--statistics`: what was counted while tracing, one set per thread, merged once at the end.

use crate::shape::{KINDS, SHAPE_NAMES};

/// Why a ray is shot. Objects can be hidden from some kinds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(usize)]
pub enum RayKind {
    /// From the camera, also through transparent objects.
    Camera,
    /// Mirrored somewhere before.
    Reflected,
    /// Towards a light.
    Shadow,
    /// Gathering indirect light.
    Radiosity,
    /// Carrying a photon.
    Photon,
    /// A question of the scene itself: `trace()`.
    Question,
}

impl RayKind {
    /// How many kinds there are.
    pub const COUNT: usize = 6;
}

/// Numbers of rays and of tests.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Counters {
    /// Rays by [`RayKind`].
    pub rays: [u64; RayKind::COUNT],
    /// Cells of the search structures opened.
    pub cells: u64,
    /// Boxes tested.
    pub boxes: u64,
    /// Primitives tested, by kind of shape.
    pub tests: [u64; KINDS],
    /// Points tested for being inside a solid.
    pub inside: u64,
}

impl Counters {
    /// Adds another thread's numbers.
    pub fn merge(&mut self, other: &Counters) {
        let add = |to: &mut [u64], from: &[u64]| to.iter_mut().zip(from).for_each(|(a, b)| *a += b);
        add(&mut self.rays, &other.rays);
        add(&mut self.tests, &other.tests);
        self.cells += other.cells;
        self.boxes += other.boxes;
        self.inside += other.inside;
    }

    /// Tests by name of the shape, without the zeros.
    pub fn tests_by_shape(&self) -> impl Iterator<Item = (&'static str, u64)> + '_ {
        SHAPE_NAMES.iter().copied().zip(self.tests.iter().copied()).filter(|&(_, n)| n > 0)
    }
}
