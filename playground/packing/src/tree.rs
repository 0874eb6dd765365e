//! Trees of decisions for bytes: fewer for those that come often.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Reverse;

use crate::Damaged;

/// Where a decision leads.
#[derive(Clone, Copy)]
pub(crate) enum Step {
    Node(u8),
    Byte(u8),
}

/// The decisions for the bytes of a kind.
#[derive(Clone)]
pub(crate) struct Tree {
    /// Where each decision leads when it is false and when it is true. The first ones lie beside one another.
    pub(crate) next: Vec<[Step; 2]>,
    /// For each byte its decisions, the first one lowest.
    pub(crate) path: [u32; 256],
}

/// The longest path.
const LONGEST: u8 = 15;

/// The tree in which byte s is `lengths[s]` decisions from the root; 0 is a byte that never comes. Without bytes, a tree
/// with one decision.
pub(crate) fn of(lengths: &[u8; 256]) -> Result<Tree, Damaged> {
    let order: Vec<u8> =
        (1..=LONGEST).flat_map(|l| (0..=255).filter(move |&s| lengths[usize::from(s)] == l)).collect();
    let mut tree = Tree { next: Vec::new(), path: [0; 256] };
    if order.is_empty() {
        tree.next.push([Step::Byte(0); 2]);
        return Ok(tree);
    }
    let mut bytes = order.into_iter().peekable();
    // Edges that lead nowhere as yet: node, decision, and the path so far.
    let mut open = vec![(None, 0)];
    for level in 0..=LONGEST {
        let mut deeper = Vec::new();
        for (edge, path) in open {
            let byte = bytes.next_if(|&s| lengths[usize::from(s)] == level);
            let step = match byte {
                Some(byte) => {
                    tree.path[usize::from(byte)] = path;
                    Step::Byte(byte)
                }
                None => {
                    let node = u8::try_from(tree.next.len()).map_err(|_| Damaged)?;
                    tree.next.push([Step::Byte(0); 2]);
                    deeper.extend([(Some((node, 0)), path), (Some((node, 1)), path | 1 << level)]);
                    Step::Node(node)
                }
            };
            if let Some((node, bit)) = edge {
                tree.next[usize::from(node)][bit] = step;
            }
        }
        open = deeper;
    }
    if open.is_empty() && bytes.next().is_none() { Ok(tree) } else { Err(Damaged) }
}

/// How far each byte is from the root of Huffman's tree, at most `LONGEST` decisions.
pub(crate) fn lengths(counts: &[u32; 256]) -> [u8; 256] {
    let mut used: Vec<u8> = (0..=255).filter(|&s| counts[usize::from(s)] > 0).collect();
    // A tree has two bytes at least.
    if let [only] = used[..] {
        used.push(only ^ 1);
    }
    let mut least = 1;
    loop {
        let mut lengths = [0; 256];
        let mut groups: Vec<(u32, Vec<u8>)> =
            used.iter().map(|&s| (counts[usize::from(s)].max(least), vec![s])).collect();
        while groups.len() > 1 {
            groups.sort_by_key(|(count, _)| Reverse(*count));
            let Some(((a, mut one), (b, other))) = groups.pop().zip(groups.pop()) else { break };
            one.extend(other);
            for &s in &one {
                lengths[usize::from(s)] += 1;
            }
            groups.push((a + b, one));
        }
        if lengths.iter().all(|&length| length <= LONGEST) {
            return lengths;
        }
        least *= 2; // bytes that are rare, but less so, are less deep
    }
}
