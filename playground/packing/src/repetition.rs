//! What came after the last passages that are like the one before this place.

use alloc::vec;
use alloc::vec::Vec;

/// Values are shifted in a hash by this number of bits each, so that 32 bits are shifted out after 7 values and after 16.
/// The longer passage is mostly another instance of the same function, the shorter one the last that does the same.
const SHIFTS: [u32; 2] = [5, 2];
/// log2 of the number of passages that are known of each length.
const BITS: u32 = 19;
/// After this number of values unlike in a passage another one is looked for.
const MISSES: u32 = 5;
/// Steps of how sure a passage is, and how sure two are, as a number below this.
const STEPS: usize = 17;
pub(crate) const SURE: usize = STEPS * STEPS;

/// One number of two.
pub(crate) fn both(a: u32, b: u32) -> u32 {
    let h = a.wrapping_add(0x7f4a_7c15).wrapping_mul(0x9e37_79b1)
        ^ b.wrapping_add(0x1656_67b1).wrapping_mul(0x85eb_ca77);
    (h ^ (h >> 16)).wrapping_mul(0x2545_f491)
}

/// A passage that is followed.
struct Passage {
    shift: u32,
    /// Where the passages with each hash ended last; 0 is nowhere.
    last: Vec<u32>,
    /// Where the value that is expected lies; 0 is nowhere.
    from: usize,
    length: u32,
    misses: u32,
    /// Of the values before; those further back are shifted out.
    hash: u32,
}

impl Passage {
    fn new(shift: u32) -> Passage {
        Passage { shift, last: vec![0; 1 << BITS], from: 0, length: 0, misses: 0, hash: 0 }
    }

    fn push(&mut self, past: &[u32], value: u32) {
        if self.from > 0 {
            if past[self.from] == value {
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
        self.hash =
            self.hash.wrapping_mul(0x2f0b_4c47 << self.shift).wrapping_add(value.wrapping_mul(0x9e37_79b1));
    }

    fn look(&mut self, count: usize) {
        let last = &mut self.last[(self.hash >> (32 - BITS)) as usize];
        let check = self.hash & 0x3ff;
        let end = *last;
        *last = (count as u32) << 10 | check;
        if end > 0 && end & 0x3ff == check && (self.from == 0 || (self.length < 16 && self.misses > 0)) {
            self.misses = 0;
            (self.from, self.length) = ((end >> 10) as usize, 32 / self.shift);
        }
    }

    fn expected(&self, past: &[u32]) -> u32 {
        if self.from == 0 {
            return 0;
        }
        let sure = self.length.min(15) + u32::from(self.length > 31) + u32::from(self.length > 400);
        both(past[self.from], sure + 32 * self.misses)
    }

    fn sure(&self) -> usize {
        if self.from == 0 { 0 } else { 1 + (self.length as usize / 2).min(STEPS - 2) }
    }
}

/// The last passages like this one of either length.
pub(crate) struct Repetition {
    past: Vec<u32>,
    passages: [Passage; 2],
}

impl Repetition {
    pub(crate) fn new() -> Repetition {
        Repetition { past: Vec::new(), passages: SHIFTS.map(Passage::new) }
    }

    pub(crate) fn push(&mut self, value: u32) {
        for passage in &mut self.passages {
            passage.push(&self.past, value);
        }
        self.past.push(value);
    }

    /// Looks for other passages where those that were followed ended or fail.
    pub(crate) fn look(&mut self) {
        for passage in &mut self.passages {
            passage.look(self.past.len());
        }
    }

    /// What is expected after each, with how sure it is.
    pub(crate) fn expected(&self) -> [u32; 2] {
        [0, 1].map(|k| self.passages[k].expected(&self.past))
    }

    /// How sure both are, as a number below `SURE`.
    pub(crate) fn sure(&self) -> usize {
        self.passages.iter().fold(0, |all, passage| all * STEPS + passage.sure())
    }
}
