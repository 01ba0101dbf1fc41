//! Which face of a mesh has given surface coordinates.

use super::faces::Face;

/// Cells of the unit square, each with the faces that reach into it, in the order of the mesh.
#[derive(Clone, Debug)]
pub struct FaceMap {
    side: usize,
    cells: Vec<Vec<u32>>,
}

/// Most cells along each axis.
const MOST_CELLS: usize = 256;

impl FaceMap {
    /// Sorts the faces of a mesh into cells.
    pub fn new(faces: &[Face]) -> FaceMap {
        let side = ((faces.len() as f64).sqrt() as usize).clamp(1, MOST_CELLS);
        let mut map = FaceMap { side, cells: vec![Vec::new(); side * side] };
        for (number, face) in faces.iter().enumerate() {
            let reach = |axis: usize| {
                let ends = face.uvs.iter().map(|uv| uv[axis]);
                let least = ends.clone().fold(f64::INFINITY, f64::min);
                map.cell(least)..=map.cell(ends.fold(f64::NEG_INFINITY, f64::max))
            };
            let (columns, rows) = (reach(0), reach(1));
            for row in rows {
                for column in columns.clone() {
                    map.cells[row * side + column].push(number as u32);
                }
            }
        }
        map
    }

    /// The first face with a point of these coordinates, and the share of each corner there.
    pub fn find<'f>(&self, faces: &'f [Face], place: [f64; 2]) -> Option<(&'f Face, [f64; 3])> {
        let cell = self.cell(place[1]) * self.side + self.cell(place[0]);
        self.cells[cell].iter().find_map(|&number| {
            let face = &faces[number as usize];
            Some((face, shares(&face.uvs, place)?))
        })
    }

    fn cell(&self, coordinate: f64) -> usize {
        ((coordinate * self.side as f64).max(0.0) as usize).min(self.side - 1)
    }
}

/// The shares of a triangle's corners in a point of it: of what each corner's opposite side spans with the point.
fn shares([a, b, c]: &[[f64; 2]; 3], place: [f64; 2]) -> Option<[f64; 3]> {
    let span = |from: [f64; 2], p: &[f64; 2], q: &[f64; 2]| {
        (p[0] - from[0]) * (q[1] - from[1]) - (q[0] - from[0]) * (p[1] - from[1])
    };
    let area = span(*a, b, c);
    let all = [span(place, b, c), span(place, c, a), span(place, a, b)].map(|part| part / area);
    all.iter().all(|share| *share >= 0.0).then_some(all)
}
