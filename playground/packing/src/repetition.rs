//! What came after the last passage that is like the one before this place.

use alloc::vec;
use alloc::vec::Vec;

/// How many values alike make a passage.
const LIKE: usize = 7;
/// 32 bits are shifted out by it after LIKE values.
const FACTOR: u32 = 0x2f0b_4c47 << 5;
/// log2 of the number of passages that are known.
const BITS: u32 = 18;
/// After this number of values unlike in a passage another one is looked for.
const MISSES: u32 = 8;

pub(crate) struct Repetition {
    past: Vec<u32>,
    /// Where the passages with each hash ended last; 0 is nowhere.
    last: Vec<u32>,
    /// Where the value that is expected lies; 0 is nowhere.
    from: usize,
    length: u32,
    misses: u32,
    /// Of the values before; those LIKE before are shifted out.
    hash: u32,
}

/// One number of two.
pub(crate) fn both(a: u32, b: u32) -> u32 {
    let h = a.wrapping_add(0x7f4a_7c15).wrapping_mul(0x9e37_79b1)
        ^ b.wrapping_add(0x1656_67b1).wrapping_mul(0x85eb_ca77);
    (h ^ (h >> 16)).wrapping_mul(0x2545_f491)
}

impl Repetition {
    pub(crate) fn new() -> Repetition {
        Repetition { past: Vec::new(), last: vec![0; 1 << BITS], from: 0, length: 0, misses: 0, hash: 0 }
    }

    pub(crate) fn push(&mut self, value: u32) {
        if self.from > 0 {
            if self.past[self.from] == value {
                self.length += 1;
                if self.length > 15 {
                    self.misses = 0;
                }
            } else {
                self.length = 0;
                self.misses += 1;
            }
            self.from = if self.misses > MISSES { 0 } else { self.from + 1 };
        }
        self.past.push(value);
        self.hash = self.hash.wrapping_mul(FACTOR).wrapping_add(value.wrapping_mul(0x9e37_79b1));
    }

    /// Looks for another passage where the one that was followed ended or fails.
    pub(crate) fn look(&mut self) {
        let count = self.past.len();
        let last = &mut self.last[(self.hash >> (32 - BITS)) as usize];
        let check = self.hash & 0x3ff;
        let end = *last;
        *last = (count as u32) << 10 | check;
        if end > 0 && end & 0x3ff == check && (self.from == 0 || (self.length < 16 && self.misses > 0)) {
            self.misses = 0;
            (self.from, self.length) = ((end >> 10) as usize, LIKE as u32);
        }
    }

    /// What is expected, with how sure it is.
    pub(crate) fn expected(&self) -> u32 {
        if self.from == 0 {
            return 0;
        }
        let sure = self.length.min(15) + u32::from(self.length > 31) + u32::from(self.length > 400);
        both(self.past[self.from], sure + 32 * self.misses)
    }

    /// How sure it is, in steps below 17.
    pub(crate) fn sure(&self) -> usize {
        if self.from == 0 { 0 } else { 1 + (self.length as usize / 2).min(15) }
    }
}
