//! Probabilities, corrected by what came of those like them: how far they were off, by what has been decided of the byte so far and
//! by the instructions before it.

use alloc::vec;
use alloc::vec::Vec;

use crate::KINDS;

/// Sets of corrections: for what was decided of a byte of each kind, and 2^`HASHES` for that in a context.
const NODES: usize = KINDS * 256;
const HASHES: u32 = 12;
/// Logarithms of odds between -`SPAN` and `SPAN`, in steps of 1; beyond, they are as at the ends.
const SPAN: f32 = 8.0;
const STEPS: usize = 2 * SPAN as usize + 1;
/// How far corrections move.
const RATE: f32 = 0.02;

/// Where a decision stands: two corrections by its node and two by its context, and how near the second of each is.
pub(crate) struct Place {
    at: [usize; 2],
    share: f32,
}

pub(crate) struct Refining {
    corrections: Vec<f32>,
}

impl Refining {
    pub(crate) fn new() -> Refining {
        Refining { corrections: vec![0.0; (NODES + (1 << HASHES)) * STEPS] }
    }

    /// The place of a decision at a node below `NODES`, in a context and with the logarithm of its odds.
    pub(crate) fn place(node: usize, context: u32, odds: f32) -> Place {
        let odds = odds.clamp(-SPAN, SPAN - 0.01) + SPAN;
        let step = odds as usize;
        let hash = NODES + ((context ^ node as u32).wrapping_mul(0x9e37_79b1) >> (32 - HASHES)) as usize;
        Place { at: [node, hash].map(|set| set * STEPS + step), share: odds - step as f32 }
    }

    /// What is to be added to the probability.
    pub(crate) fn correction(&self, place: &Place) -> f32 {
        let of =
            |at: usize| self.corrections[at] * (1.0 - place.share) + self.corrections[at + 1] * place.share;
        (of(place.at[0]) + of(place.at[1])) * 0.5
    }

    /// Notes how far the probability was off.
    pub(crate) fn learn(&mut self, place: &Place, error: f32) {
        for at in place.at {
            for (k, share) in [(0, 1.0 - place.share), (1, place.share)] {
                let correction = &mut self.corrections[at + k];
                *correction += (error - *correction) * RATE * share;
            }
        }
    }
}
