//! The colours of a pattern that is given no map of its own.

use super::color_map::{BlendMap, ColorMap};
use crate::color::{rgb, Rgb, Rgbft};
use crate::pattern::PatternKind;

const RED: Rgb = rgb(1.0, 0.0, 0.0);
const GREEN: Rgb = rgb(0.0, 1.0, 0.0);
const BLUE: Rgb = rgb(0.0, 0.0, 1.0);
const YELLOW: Rgb = rgb(1.0, 1.0, 0.0);
const CYAN: Rgb = rgb(0.0, 1.0, 1.0);
const MAGENTA: Rgb = rgb(1.0, 0.0, 1.0);
const GRAY: Rgb = rgb(0.5, 0.5, 0.5);
const BRICK_RED: Rgb = rgb(0.6, 0.15, 0.15);

const AGATE: [(f64, Rgb); 6] = [
    (0.0, rgb(1.0, 1.0, 1.0)),
    (0.5, rgb(0.95, 0.75, 0.5)),
    (0.5, rgb(0.9, 0.7, 0.5)),
    (0.6, rgb(0.9, 0.7, 0.4)),
    (0.6, rgb(1.0, 0.7, 0.4)),
    (1.0, rgb(0.6, 0.3, 0.0)),
];
const BOZO: [(f64, Rgb); 6] =
    [(0.4, Rgb::WHITE), (0.4, GREEN), (0.6, GREEN), (0.6, BLUE), (0.8, BLUE), (0.8, RED)];
const MANDEL: [(f64, Rgb); 5] =
    [(0.001, Rgb::BLACK), (0.001, CYAN), (0.012, YELLOW), (0.015, MAGENTA), (0.1, CYAN)];
const MARBLE: [(f64, Rgb); 3] = [(0.0, rgb(0.9, 0.8, 0.8)), (0.9, rgb(0.9, 0.08, 0.08)), (0.9, Rgb::BLACK)];
const RADIAL: [(f64, Rgb); 4] = [(0.0, CYAN), (0.333, YELLOW), (0.666, MAGENTA), (1.0, CYAN)];
const WOOD: [(f64, Rgb); 2] = [(0.6, rgb(0.666, 0.312, 0.2)), (0.6, rgb(0.4, 0.1333, 0.066))];
const GRAYS: [(f64, Rgb); 2] = [(0.0, Rgb::BLACK), (1.0, Rgb::WHITE)];

fn opaque(rgb: Rgb) -> Rgbft {
    Rgbft { rgb, ..Rgbft::default() }
}

/// The map of a continuous pattern.
pub fn color_map(kind: &PatternKind) -> ColorMap {
    let entries: &[(f64, Rgb)] = match kind {
        PatternKind::Agate { .. } => &AGATE,
        PatternKind::Bozo => &BOZO,
        PatternKind::Fractal(fractal) if fractal.is_plain_mandel() => &MANDEL,
        PatternKind::Marble => &MARBLE,
        PatternKind::Radial => &RADIAL,
        PatternKind::Wood => &WOOD,
        _ => &GRAYS,
    };
    BlendMap::new(entries.iter().map(|&(v, c)| (v, opaque(c))).collect())
}

/// The colours of a block pattern, one per kind of block.
pub fn block_colors(kind: &PatternKind) -> Vec<Rgbft> {
    let colors: &[Rgb] = match kind {
        PatternKind::Brick(_) => &[GRAY, BRICK_RED],
        PatternKind::Hexagon => &[BLUE, GREEN, RED],
        PatternKind::Square => &[RED, GREEN, BLUE, YELLOW],
        PatternKind::Cubic | PatternKind::Triangular => &[RED, GREEN, BLUE, YELLOW, CYAN, MAGENTA],
        _ => &[BLUE, GREEN],
    };
    colors.iter().map(|&c| opaque(c)).collect()
}
