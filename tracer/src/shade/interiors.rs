//! Which objects a ray is inside of: they decide about refraction, attenuation, media and fog.

/// A body, by its number in the geometry.
pub type BodyId = u32;

/// More nested objects than any scene has; what lies deeper is not tracked.
const DEPTH: usize = 24;

/// The interiors around a ray, outermost first.
#[derive(Clone, Copy, Debug)]
pub struct Interiors {
    ids: [BodyId; DEPTH],
    len: u8,
}

impl Interiors {
    /// Open space.
    pub const NONE: Interiors = Interiors { ids: [0; DEPTH], len: 0 };

    /// Goes into an object.
    pub fn enter(&mut self, id: BodyId) {
        if (self.len as usize) < DEPTH {
            self.ids[self.len as usize] = id;
            self.len += 1;
        }
    }

    /// Leaves an object; whether it was there.
    pub fn leave(&mut self, id: BodyId) -> bool {
        let Some(at) = self.iter().rposition(|known| known == id) else {
            return false;
        };
        self.ids.copy_within(at + 1..self.len as usize, at);
        self.len -= 1;
        true
    }

    /// Whether the ray is inside.
    pub fn contains(&self, id: BodyId) -> bool {
        self.iter().any(|known| known == id)
    }

    /// The interior entered last.
    pub fn innermost(&self) -> Option<BodyId> {
        self.iter().next_back()
    }

    /// From the outermost on.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = BodyId> + ExactSizeIterator + '_ {
        self.ids[..self.len as usize].iter().copied()
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.len as usize
    }

    /// Whether the ray is in open space.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leaving_keeps_the_order() {
        let mut stack = Interiors::NONE;
        [4, 5, 6].into_iter().for_each(|id| stack.enter(id));
        assert!(stack.leave(5) && !stack.leave(9));
        assert_eq!(stack.iter().collect::<Vec<_>>(), [4, 6]);
        assert_eq!(stack.innermost(), Some(6));
    }
}
