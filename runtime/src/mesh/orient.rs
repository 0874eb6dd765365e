//! Which surfaces have to be turned over so that all triangles turn the same way.

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
    let mut neighbours: Vec<Vec<(usize, bool)>> = alloc::vec![Vec::new(); count];
    if count < 2 {
        return neighbours;
    }
    // The sides of the triangles, by their ends, so that those along each other are next to each other.
    let mut sides: Vec<([u32; 2], usize, bool)> = Vec::with_capacity(3 * mesh.triangles.len());
    for &triangle in &mesh.triangles {
        let surface = mesh.vertices[triangle[0] as usize].surface as usize;
        let Some([a, b, c]) = mesh.corners(triangle) else { continue };
        let all = [[a, b], [b, c], [c, a]];
        sides.extend(all.map(|[from, to]| ([from.min(to), from.max(to)], surface, from < to)));
    }
    sides.sort_unstable();
    for along in sides.chunk_by(|a, b| a.0 == b.0) {
        let (_, first, forward) = along[0];
        for &(_, surface, direction) in along.iter().filter(|side| side.1 != first) {
            let same = forward == direction;
            neighbours[surface].push((first, same));
            neighbours[first].push((surface, same));
        }
    }
    neighbours
}
