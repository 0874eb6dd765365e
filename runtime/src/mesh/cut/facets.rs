//! The triangles over one rectangle of parameters.

/// A point of the parameter square.
pub(in crate::mesh) type Node = [u32; 2];

/// A rectangle of the parameter square.
#[derive(Clone, Copy, Debug)]
pub(in crate::mesh) struct Cell {
    pub(in crate::mesh) from: Node,
    pub(in crate::mesh) to: Node,
}

/// The node in the middle of a rectangle.
pub(in crate::mesh) fn middle(cell: Cell) -> Node {
    [0, 1].map(|c| cell.from[c] + (cell.to[c] - cell.from[c]) / 2)
}

/// How a polygon is cut.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::mesh) enum Cut {
    /// With as few triangles as possible.
    Shortest,
    /// With triangles that meet in the middle.
    Middle,
}

/// Cuts the polygon of the corners around a rectangle into triangles, counter-clockwise in the parameters.
///
/// Four corners are cut along the diagonal of the first one if `is_first_shorter`, or else along the other one. With
/// one corner more, on a side, all triangles meet there; with several, or if asked for, in the middle of the rectangle.
pub(in crate::mesh) fn triangles(
    cell: Cell,
    nodes: &[Node],
    cut: Cut,
    is_first_shorter: impl FnOnce() -> bool,
    mut emit: impl FnMut([Node; 3]),
) {
    let fan = |apex: usize, emit: &mut dyn FnMut([Node; 3])| {
        let count = nodes.len();
        for k in apex + 1..apex + count - 1 {
            emit([nodes[apex], nodes[k % count], nodes[(k + 1) % count]]);
        }
    };
    match (nodes.len(), cut) {
        (4, Cut::Shortest) => {
            let apex = usize::from(!is_first_shorter());
            fan(apex, &mut emit);
        }
        (5, Cut::Shortest) => {
            let is_corner = |n: &Node| (0..2).all(|c| n[c] == cell.from[c] || n[c] == cell.to[c]);
            fan(nodes.iter().position(|n| !is_corner(n)).unwrap_or(0), &mut emit);
        }
        (count, _) => {
            let middle = middle(cell);
            for k in 0..count {
                emit([middle, nodes[k], nodes[(k + 1) % count]]);
            }
        }
    }
}
