//! The arithmetic coder: decisions with their probabilities as a number in [0, 1), of which each decision keeps a part.

use alloc::vec::Vec;

use crate::Damaged;
use crate::mixing::Coder;

/// Below this the range has a byte that is settled.
const SETTLED: u32 = 1 << 24;

/// Reads decisions.
pub(crate) struct Reader {
    input: Vec<u8>,
    at: usize,
    range: u32,
    code: u32,
}

impl Reader {
    pub(crate) fn new(input: Vec<u8>) -> Reader {
        let mut reader = Reader { input, at: 0, range: u32::MAX, code: 0 };
        for _ in 0..4 {
            reader.shift();
        }
        reader
    }

    fn shift(&mut self) {
        self.code = self.code << 8 | u32::from(self.input.get(self.at).copied().unwrap_or(0));
        self.at += 1;
    }
}

impl Coder for Reader {
    const READS: bool = true;

    fn decide(&mut self, p: u32, _: bool) -> bool {
        let bound = (self.range >> 16) * p;
        let bit = self.code < bound;
        if bit {
            self.range = bound;
        } else {
            self.range -= bound;
            self.code -= bound;
        }
        while self.range < SETTLED {
            self.range <<= 8;
            self.shift();
        }
        bit
    }

    /// The writer ends with four bytes more than a reader may need.
    fn check(&self) -> Result<(), Damaged> {
        if self.at > self.input.len() + 4 { Err(Damaged) } else { Ok(()) }
    }
}

/// Writes decisions.
pub(crate) struct Writer {
    output: Vec<u8>,
    low: u32,
    range: u32,
}

impl Writer {
    pub(crate) fn new() -> Writer {
        Writer { output: Vec::new(), low: 0, range: u32::MAX }
    }

    fn shift(&mut self) {
        self.output.push((self.low >> 24) as u8);
        self.low <<= 8;
    }

    pub(crate) fn finish(mut self) -> Vec<u8> {
        for _ in 0..4 {
            self.shift();
        }
        self.output
    }
}

impl Coder for Writer {
    const READS: bool = false;

    fn decide(&mut self, p: u32, known: bool) -> bool {
        let bound = (self.range >> 16) * p;
        if known {
            self.range = bound;
        } else {
            let (low, carry) = self.low.overflowing_add(bound);
            self.low = low;
            self.range -= bound;
            if carry {
                // What is written is below one: some byte takes the carry.
                for byte in self.output.iter_mut().rev() {
                    *byte = byte.wrapping_add(1);
                    if *byte > 0 {
                        break;
                    }
                }
            }
        }
        while self.range < SETTLED {
            self.range <<= 8;
            self.shift();
        }
        known
    }

    fn check(&self) -> Result<(), Damaged> {
        Ok(())
    }
}
