//! Indices of control points on a simplex, and their one order.

/// The index `(i, j, k)` of a control point of a triangular patch.
pub type TriangleIndex = SimplexIndex<3>;

/// The index `(i, j, k, l)` of a control point on a tetrahedron.
pub type TetrahedronIndex = SimplexIndex<4>;

/// The index of a control point on a simplex: one whole number for each corner; their sum is the order `n`.
///
/// Everywhere, control points, functions and coefficients stand in lexicographic order of their indices. On a triangle
/// of order 2 that is
///
/// ```text
/// (0,0,2) (0,1,1) (0,2,0) (1,0,1) (1,1,0) (2,0,0)
/// ```
///
/// so that the control points of the corners are the last one, `(n,0,0)`; the one at position `n`, `(0,n,0)`; and the
/// first one, `(0,0,n)`.
///
/// ```
/// use basis_runtime::TriangleIndex;
///
/// let index = TriangleIndex::new([1, 0, 1]);
/// assert_eq!(index.position(), 3);
/// assert_eq!(TriangleIndex::at(2, 3), Some(index));
/// assert_eq!(TriangleIndex::at(2, 6), None);
/// assert_eq!(TriangleIndex::count(2), 6);
/// assert!(TriangleIndex::all(8).enumerate().all(|(position, index)| index.position() == position));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SimplexIndex<const K: usize> {
    components: [usize; K],
}

impl<const K: usize> SimplexIndex<K> {
    /// The index with these components.
    #[inline]
    pub const fn new(components: [usize; K]) -> Self {
        const { assert!(K > 0, "a simplex has at least one corner") };
        Self { components }
    }

    /// The index at a position of the lexicographic order; `None` when there are not that many of this order.
    pub const fn at(order: usize, position: usize) -> Option<Self> {
        if position >= Self::count(order) {
            return None;
        }
        let mut components = [0; K];
        let (mut order, mut position, mut place) = (order, position, 0);
        while place + 1 < K {
            if place + 2 == K {
                // Each block is a single index.
                components[place] = position;
                order -= position;
                break;
            }
            // The largest component before which there are not more than `position` indices.
            let corners = K - place;
            let all = wide_lattice_size(corners, order);
            let (mut low, mut high) = (0, order);
            // Where they are too many to be counted, those with the component 0 are more than any position.
            while all < u128::MAX && low < high {
                let middle = high - (high - low) / 2;
                if all - wide_lattice_size(corners, order - middle) <= position as u128 {
                    low = middle;
                } else {
                    high = middle - 1;
                }
            }
            if all < u128::MAX {
                position -= (all - wide_lattice_size(corners, order - low)) as usize;
            }
            components[place] = low;
            order -= low;
            place += 1;
        }
        components[K - 1] = order;
        Some(Self { components })
    }

    /// The position in the lexicographic order; `usize::MAX` where it is not a `usize`.
    pub const fn position(self) -> usize {
        let (mut order, mut position, mut place) = (self.order(), 0_usize, 0);
        while place + 1 < K {
            // Before this one come all whose component here is smaller.
            let corners = K - place;
            let all = wide_lattice_size(corners, order);
            let rest = order.saturating_sub(self.components[place]);
            if rest < order {
                let before = all - wide_lattice_size(corners, rest);
                if all == u128::MAX || before >= (usize::MAX - position) as u128 {
                    return usize::MAX;
                }
                position += before as usize;
            }
            order = rest;
            place += 1;
        }
        position
    }

    /// The order `n`, the sum of the components; at most `usize::MAX`.
    #[inline]
    pub const fn order(self) -> usize {
        let (mut sum, mut place) = (0, 0);
        while place < K {
            sum = self.components[place].saturating_add(sum);
            place += 1;
        }
        sum
    }

    /// The components.
    #[inline]
    pub const fn components(self) -> [usize; K] {
        self.components
    }

    /// How many indices of this order there are, `binomial(n + K - 1, K - 1)`; at most `usize::MAX`.
    #[inline]
    pub const fn count(order: usize) -> usize {
        lattice_size(K, order)
    }

    /// All indices of this order, in lexicographic order.
    pub fn all(order: usize) -> impl Iterator<Item = Self> {
        let mut first = [0; K];
        first[K - 1] = order;
        let mut next = Some(Self { components: first });
        core::iter::from_fn(move || {
            let current = next?;
            next = current.next();
            Some(current)
        })
    }

    /// The next index of the same order.
    fn next(self) -> Option<Self> {
        let mut components = self.components;
        // One unit moves left from the last place that has any, the rest goes to the end.
        let from = (1..K).rev().find(|&place| components[place] > 0)?;
        let rest = components[from] - 1;
        components[from] = 0;
        components[from - 1] += 1;
        components[K - 1] = rest;
        Some(Self { components })
    }

    /// The index with one more in a place.
    pub(crate) const fn up(mut self, place: usize) -> Self {
        self.components[place] += 1;
        self
    }
}

/// `binomial(n + K - 1, K - 1)`, the number of indices with `K` components and the sum `n`; at most `usize::MAX`.
pub(crate) const fn lattice_size(corners: usize, order: usize) -> usize {
    let size = wide_lattice_size(corners, order);
    if size < usize::MAX as u128 { size as usize } else { usize::MAX }
}

/// The same, at most `u128::MAX`; that only if `binomial(n + K - 2, K - 2)` is no `usize`.
const fn wide_lattice_size(corners: usize, order: usize) -> u128 {
    let (mut size, mut k) = (1_u128, 1);
    while k < corners {
        // No partial product is greater than the next one.
        size = match size.checked_mul(order as u128 + k as u128) {
            Some(product) => product / k as u128,
            None => return u128::MAX,
        };
        k += 1;
    }
    size
}
