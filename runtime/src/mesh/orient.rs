//! Which surfaces have to be turned over so that all triangles turn the same way.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;

use super::Mesh;
use crate::Scalar;

/// Components of connected surfaces, and which surfaces of each are turned over.
pub(super) struct Orientation {
    /// The component of each surface.
    pub(super) component: Vec<usize>,
    /// Whether the surface is turned over.
    pub(super) flipped: Vec<bool>,
}

/// Spreads the orientation of the first surface of each component over the edges that its triangles share with others.
/// Where that is impossible, as on a Möbius strip, some edge is left between different orientations.
pub(super) fn orient<S: Scalar>(count: usize, mesh: &Mesh<S>) -> Orientation {
    let neighbours = neighbours(count, mesh);
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

/// For each surface those with which it shares edges of triangles, and whether both go through them in the same
/// direction.
fn neighbours<S: Scalar>(count: usize, mesh: &Mesh<S>) -> Vec<Vec<(usize, bool)>> {
    let mut first_use: BTreeMap<[u32; 2], (usize, bool)> = BTreeMap::new();
    let mut neighbours: Vec<Vec<(usize, bool)>> = alloc::vec![Vec::new(); count];
    for &triangle in &mesh.triangles {
        let surface = mesh.vertices[triangle[0] as usize].surface as usize;
        let Some([a, b, c]) = mesh.corners(triangle) else { continue };
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let here = (surface, from < to);
            let there = *first_use.entry([from.min(to), from.max(to)]).or_insert(here);
            if there.0 != surface {
                let same = there.1 == here.1;
                neighbours[surface].push((there.0, same));
                neighbours[there.0].push((surface, same));
            }
        }
    }
    neighbours
}
