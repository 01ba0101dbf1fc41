//! SDL: `text { ttf "timrom.ttf" "Hello" 0.1, 0 }`: letters along x, their figures in (x, y), extruded along z.
//!
//! A letter is a [`Prism`] over the curves of its outline as they are, lines and parabolas; equal letters share one.

use std::collections::HashMap;
use std::sync::Arc;

use ttf_parser::kern::{Format, Subtable};
use ttf_parser::{cmap, Face, GlyphId, OutlineBuilder, PlatformId};

use super::curve::Segment;
use super::prism::BASE;
use super::{Crossing, Primitive, Prism};
use crate::accel::{Accelerator, AcceleratorKind, Counters, Query};
use crate::math::{vec3, Bounds, Ray, Vec3};

/// Where a symbol font keeps the characters 0 to 255.
const SYMBOLS: u32 = 0xf000;

/// A row of letters.
#[derive(Debug)]
pub struct Text {
    letters: Vec<Letter>,
    tree: Accelerator,
    bounds: Bounds,
}

/// A letter and where its origin stands.
#[derive(Debug)]
struct Letter {
    prism: Arc<Prism>,
    at: Vec3,
}

/// The prism stands upright: its y is the text's z.
fn upright(v: Vec3) -> Vec3 {
    vec3(v.x, v.z, v.y)
}

impl Letter {
    fn bounds(&self) -> Bounds {
        let bounds = self.prism.bounds();
        Bounds { min: upright(bounds.min) + self.at, max: upright(bounds.max) + self.at }
    }

    fn local(&self, point: Vec3) -> Vec3 {
        upright(point - self.at)
    }
}

impl Text {
    /// Sets the letters one after the other. `offset` is added to the way from each to the next, but for its z, as in
    /// POV-Ray.
    pub fn new(font: &[u8], text: &str, thickness: f64, offset: Vec3) -> Result<Text, String> {
        let face = Face::parse(font, 0).map_err(|error| format!("text: the font is unusable: {error}"))?;
        let em = 1.0 / f64::from(face.units_per_em());
        let mut prisms: HashMap<GlyphId, Arc<Prism>> = HashMap::new();
        let mut letters = Vec::new();
        let mut at = Vec3::ZERO;
        let mut before: Option<GlyphId> = None;
        for character in text.chars() {
            let glyph = glyph_of(&face, character);
            // The first letter begins at 0; its own margin on the left is not kept.
            let margin = || face.glyph_hor_side_bearing(glyph).map_or(0, |bearing| -bearing);
            at.x += f64::from(before.map_or_else(margin, |b| kerning(&face, b, glyph))) * em;
            let prism = prisms.entry(glyph).or_insert_with(|| {
                let mut outline = Outline::new(em);
                face.outline_glyph(glyph, &mut outline);
                Arc::new(Prism::new(outline.segments, [0.0, thickness], false, false))
            });
            if !prism.bounds().is_empty() {
                letters.push(Letter { prism: prism.clone(), at });
            }
            at += vec3(offset.x, offset.y, 0.0);
            at += Vec3::X * (f64::from(face.glyph_hor_advance(glyph).unwrap_or(0)) * em);
            before = Some(glyph);
        }
        let boxes: Vec<Bounds> = letters.iter().map(Letter::bounds).collect();
        Ok(Text {
            tree: Accelerator::build(AcceleratorKind::Octree, &boxes),
            bounds: boxes.iter().fold(Bounds::EMPTY, |sum, b| sum.union(b)),
            letters,
        })
    }

    /// The letter that a crossing is on, and the crossing as the letter made it.
    fn letter(&self, crossing: &Crossing) -> (&Letter, Crossing) {
        (&self.letters[crossing.v as usize], Crossing { v: 0.0, ..*crossing })
    }
}

/// The glyph of a character: by its Unicode, else as in a Macintosh font, else as in a symbol font.
fn glyph_of(face: &Face, character: char) -> GlyphId {
    let code = character as u32;
    let tables = face.tables().cmap.iter().flat_map(|cmap| cmap.subtables);
    let by_unicode = || face.glyph_index(character);
    let by_old_code = |table: cmap::Subtable| match table.platform_id {
        PlatformId::Macintosh => table.glyph_index(code),
        _ => table.glyph_index(SYMBOLS + code),
    };
    by_unicode().or_else(|| tables.into_iter().find_map(by_old_code)).unwrap_or(GlyphId(0))
}

/// By how many units a letter moves towards the one before it. Old fonts do not keep their pairs in order.
fn kerning(face: &Face, before: GlyphId, glyph: GlyphId) -> i16 {
    let tables = face.tables().kern.iter().flat_map(|kern| kern.subtables);
    let of_table = |table: Subtable| match table.format {
        Format::Format0(list) => {
            list.pairs.into_iter().find(|p| p.left() == before && p.right() == glyph).map(|p| p.value)
        }
        _ => table.glyphs_kerning(before, glyph),
    };
    tables.filter(|t| t.horizontal && !t.variable).filter_map(of_table).sum()
}

/// Collects the curves of a glyph, in ems.
struct Outline {
    em: f64,
    start: [f64; 2],
    last: [f64; 2],
    segments: Vec<Segment>,
}

impl Outline {
    fn new(em: f64) -> Outline {
        Outline { em, start: [0.0; 2], last: [0.0; 2], segments: Vec::new() }
    }

    fn point(&self, x: f32, y: f32) -> [f64; 2] {
        [f64::from(x) * self.em, f64::from(y) * self.em]
    }

    fn add(&mut self, end: [f64; 2], curve: impl Fn(usize) -> [f64; 4]) {
        if end != self.last || curve(0)[2] != 0.0 || curve(1)[2] != 0.0 {
            self.segments.push(Segment { a: curve(0), b: curve(1) });
        }
        self.last = end;
    }

    fn line(&mut self, end: [f64; 2]) {
        let start = self.last;
        self.add(end, |k| [start[k], end[k] - start[k], 0.0, 0.0]);
    }
}

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.start = self.point(x, y);
        self.last = self.start;
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.line(self.point(x, y));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (p, q, r) = (self.last, self.point(x1, y1), self.point(x, y));
        self.add(r, |k| [p[k], 2.0 * (q[k] - p[k]), p[k] - 2.0 * q[k] + r[k], 0.0]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (p, q, r, s) = (self.last, self.point(x1, y1), self.point(x2, y2), self.point(x, y));
        self.add(s, |k| {
            [p[k], 3.0 * (q[k] - p[k]), 3.0 * (p[k] - 2.0 * q[k] + r[k]), s[k] - p[k] + 3.0 * (q[k] - r[k])]
        });
    }

    fn close(&mut self) {
        self.line(self.start);
    }
}

impl Primitive for Text {
    fn bounds(&self) -> Bounds {
        self.bounds
    }

    fn intersect(
        &self,
        ray: &Ray,
        from: f64,
        limit: f64,
        counters: &mut Counters,
        offer: &mut impl FnMut(Crossing, f64) -> f64,
    ) -> f64 {
        self.tree.along(&Query::new(*ray), limit, counters, |item, limit, counters| {
            let letter = &self.letters[item as usize];
            let local = Ray { origin: letter.local(ray.origin), direction: upright(ray.direction) };
            // Prisms leave `v` free for the number of the letter.
            letter.prism.intersect(&local, from, limit, counters, &mut |crossing: Crossing, limit| {
                offer(Crossing { v: f64::from(item), ..crossing }, limit)
            })
        })
    }

    fn inside(&self, point: Vec3) -> bool {
        self.tree.around(point, |item| {
            let letter = &self.letters[item as usize];
            letter.prism.inside(letter.local(point))
        })
    }

    fn normal(&self, point: Vec3, crossing: &Crossing) -> Vec3 {
        if crossing.part == BASE {
            return -Vec3::Z;
        }
        let (letter, crossing) = self.letter(crossing);
        upright(letter.prism.normal(letter.local(point), &crossing))
    }
}
