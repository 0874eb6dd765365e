//! What is known of the corners of one surface.

use alloc::vec::Vec;

use super::facets::Node;

/// A table from corners to values, such as numbers, each at the first free place after the one that it is given: there
/// are no others between neighbours of a grid, and no corner is taken out.
#[derive(Debug, Default)]
pub(in crate::mesh) struct Index<T> {
    /// A power of two of places, at least twice as many as corners.
    places: Vec<Option<(Node, T)>>,
    count: usize,
}

impl<T: Copy> Index<T> {
    /// The value of a corner.
    pub(in crate::mesh) fn get(&self, node: Node) -> Option<T> {
        if self.places.is_empty() { None } else { self.places[self.place(node)].map(|(_, value)| value) }
    }

    /// Gives a corner that is not there yet a value.
    pub(in crate::mesh) fn insert(&mut self, node: Node, value: T) {
        if 2 * (self.count + 1) > self.places.len() {
            let more = (2 * self.places.len()).max(64);
            let old = core::mem::replace(&mut self.places, alloc::vec![None; more]);
            for entry in old.into_iter().flatten() {
                let place = self.place(entry.0);
                self.places[place] = Some(entry);
            }
        }
        let place = self.place(node);
        self.places[place] = Some((node, value));
        self.count += 1;
    }

    /// The place of a corner, or the free one that is to be its.
    fn place(&self, node: Node) -> usize {
        let last = self.places.len() - 1;
        let key = u64::from(node[0]) << 32 | u64::from(node[1]);
        // The high bits of a product with an odd number depend on all bits of the key.
        let product = (key ^ key >> 29).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let mut place = (product >> 32) as usize & last;
        while self.places[place].is_some_and(|(other, _)| other != node) {
            place = (place + 1) & last;
        }
        place
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_corner_keeps_its_number() {
        let nodes: Vec<Node> = (0..100).flat_map(|i| (0..100).map(move |j| [i << 14, j * 315])).collect();
        let mut index = Index::default();
        assert_eq!(index.get([0, 0]), None);
        for (number, &node) in nodes.iter().enumerate() {
            assert_eq!(index.get(node), None);
            index.insert(node, number as u32);
        }
        for (number, &node) in nodes.iter().enumerate() {
            assert_eq!(index.get(node), Some(number as u32));
        }
        assert_eq!(index.get([1, 1]), None);
    }
}
