//! SDL: `tiling I`: a tiling of the xz plane by polygons.
//!
//! With N kinds of tiles, kind k has the values from k/N, where it is flat, up to (k+1)/N at its sides.

mod layouts;

use layouts::{Layout, Place, LAYOUTS, WIDE_BEVEL, WIDE_SIDES};

use crate::math::Vec3;

/// A side of a tile as a line: a point is `offset - normal * point` inside of it, in widths of its bevel.
#[derive(Clone, Copy, Debug)]
struct Side {
    normal: [f64; 2],
    offset: f64,
}

#[derive(Clone, Debug)]
struct Tile {
    kind: f64,
    sides: Vec<Side>,
}

impl Tile {
    /// How far a point is inside, in widths of the bevel; negative outside.
    #[inline]
    fn depth(&self, [x, z]: [f64; 2]) -> f64 {
        let inside = self.sides.iter().map(|side| side.offset - side.normal[0] * x - side.normal[1] * z);
        inside.fold(f64::INFINITY, f64::min)
    }
}

/// A tiling, ready to be asked.
#[derive(Clone, Debug)]
pub struct Tiling {
    kinds: f64,
    lattice: [[f64; 2]; 2],
    /// Every tile that reaches into the lattice's cell at the origin.
    tiles: Vec<Tile>,
}

impl Tiling {
    /// The tiling of that number; None for one that is not known.
    pub fn new(number: u8) -> Option<Tiling> {
        LAYOUTS.iter().find(|layout| layout.number == number).map(Tiling::from)
    }

    /// The value at a point.
    pub(super) fn value(&self, p: Vec3) -> f64 {
        let point = into_cell(self.lattice, [p.x, p.z]);
        let mut best = (f64::NEG_INFINITY, 0.0);
        for tile in &self.tiles {
            let depth = tile.depth(point);
            if depth > best.0 {
                best = (depth, tile.kind);
                if depth >= 0.0 {
                    break;
                }
            }
        }
        let (depth, kind) = best;
        (kind + 1.0 - depth.clamp(0.0, 1.0)) / self.kinds
    }
}

impl From<&Layout> for Tiling {
    fn from(layout: &Layout) -> Tiling {
        let place = |[a, b, c, d]: Place| {
            let on_axis = |whole: i8, roots: i8| (f64::from(whole) + f64::from(roots) * layout.root) / 4.0;
            [on_axis(a, b), on_axis(c, d)]
        };
        let lattice = layout.lattice.map(place);
        let mut tiles = Vec::new();
        for &(kind, corners) in layout.tiles {
            let corners: Vec<[f64; 2]> = corners.iter().copied().map(place).collect();
            let (low, high) = cell_range(lattice, &corners);
            for i in (-high[0].floor() as i32)..=(1.0 - low[0]).floor() as i32 {
                for j in (-high[1].floor() as i32)..=(1.0 - low[1]).floor() as i32 {
                    let moved: Vec<_> = corners.iter().map(|c| moved(lattice, *c, i, j)).collect();
                    let bevels = (0..).map(|side| bevel(layout, kind, side));
                    tiles.push(Tile { kind: f64::from(kind), sides: sides(&moved, bevels) });
                }
            }
        }
        Tiling { kinds: f64::from(layout.kinds), lattice, tiles }
    }
}

/// How far from a side its tile becomes flat.
fn bevel(layout: &Layout, kind: u8, side: usize) -> f64 {
    if WIDE_SIDES.contains(&(layout.number, kind, side)) {
        WIDE_BEVEL
    } else {
        layout.bevel
    }
}

/// The coordinates of a point counted in steps of the lattice.
fn in_steps([a, b]: [[f64; 2]; 2], [x, z]: [f64; 2]) -> [f64; 2] {
    let area = a[0] * b[1] - a[1] * b[0];
    [(x * b[1] - z * b[0]) / area, (a[0] * z - a[1] * x) / area]
}

/// The same place of the lattice's cell at the origin.
fn into_cell(lattice: [[f64; 2]; 2], point: [f64; 2]) -> [f64; 2] {
    let [i, j] = in_steps(lattice, point).map(f64::floor);
    let [a, b] = lattice;
    [point[0] - i * a[0] - j * b[0], point[1] - i * a[1] - j * b[1]]
}

fn moved([a, b]: [[f64; 2]; 2], [x, z]: [f64; 2], i: i32, j: i32) -> [f64; 2] {
    let (i, j) = (f64::from(i), f64::from(j));
    [x + i * a[0] + j * b[0], z + i * a[1] + j * b[1]]
}

/// The lowest and highest coordinates of corners, counted in steps of the lattice.
fn cell_range(lattice: [[f64; 2]; 2], corners: &[[f64; 2]]) -> ([f64; 2], [f64; 2]) {
    let range = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    corners.iter().fold(range, |(low, high), corner| {
        let [i, j] = in_steps(lattice, *corner);
        ([low[0].min(i), low[1].min(j)], [high[0].max(i), high[1].max(j)])
    })
}

/// The sides of a polygon whose corners stand counterclockwise.
fn sides(corners: &[[f64; 2]], bevels: impl Iterator<Item = f64>) -> Vec<Side> {
    let next = corners.iter().cycle().skip(1);
    let side = |((from, to), bevel): ((&[f64; 2], &[f64; 2]), f64)| {
        let (dx, dz) = (to[0] - from[0], to[1] - from[1]);
        let scale = dx.hypot(dz) * bevel;
        let normal = [dz / scale, -dx / scale];
        Side { normal, offset: normal[0] * from[0] + normal[1] * from[1] }
    };
    corners.iter().zip(next).zip(bevels).map(side).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::vec3;

    #[test]
    fn the_tiles_of_a_layout_fill_its_cell_once() {
        for layout in LAYOUTS {
            let tiling = Tiling::from(layout);
            let [a, b] = tiling.lattice;
            for i in 0..400 {
                let (s, t) = (f64::from(i % 20) / 20.0 + 0.0213, f64::from(i / 20) / 20.0 + 0.0187);
                let point = [s * a[0] + t * b[0], s * a[1] + t * b[1]];
                let around = tiling.tiles.iter().filter(|tile| tile.depth(point) > 0.0).count();
                assert_eq!(around, 1, "tiling {} at {point:?}", layout.number);
            }
        }
    }

    #[test]
    fn a_square_rises_from_its_middle_to_its_sides() {
        let tiling = Tiling::new(1).unwrap();
        let at = |x: f64, z: f64| tiling.value(vec3(x, 5.0, z));
        assert!((at(0.5, 0.5) - 0.0).abs() < 1e-12);
        assert!((at(-2.25, 7.5) - 0.5).abs() < 1e-12);
        assert!((at(0.5, 0.1) - 0.8).abs() < 1e-12);
    }

    #[test]
    fn an_unknown_number_is_no_tiling() {
        assert!(Tiling::new(28).is_none());
    }
}
