//! Which surfaces have to be turned over so that all triangles turn the same way.

use alloc::vec::Vec;

use super::weld::Seam;

/// Components of connected surfaces, and which surfaces of each are turned over.
pub(super) struct Orientation {
    /// The component of each surface.
    pub(super) component: Vec<usize>,
    /// Whether the surface is turned over.
    pub(super) flipped: Vec<bool>,
}

/// Spreads the orientation of the first surface of each component over its seams. Where that is impossible, as on a Möbius
/// strip, some seam is left between different orientations.
pub(super) fn orient(count: usize, seams: &[Seam]) -> Orientation {
    let mut neighbours: Vec<Vec<(usize, bool)>> = alloc::vec![Vec::new(); count];
    for seam in seams {
        let [a, b] = seam.sides;
        let same = a.edge.surface_on_the_right() ^ b.edge.surface_on_the_right() ^ seam.reversed;
        neighbours[a.surface].push((b.surface, !same));
        neighbours[b.surface].push((a.surface, !same));
    }
    let mut component = alloc::vec![usize::MAX; count];
    let mut flipped = alloc::vec![false; count];
    for start in 0..count {
        if component[start] != usize::MAX {
            continue;
        }
        component[start] = start;
        let mut open = alloc::vec![start];
        while let Some(surface) = open.pop() {
            for &(next, flip) in &neighbours[surface] {
                if component[next] == usize::MAX {
                    component[next] = start;
                    flipped[next] = flipped[surface] ^ flip;
                    open.push(next);
                }
            }
        }
    }
    Orientation { component, flipped }
}
