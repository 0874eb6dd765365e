//! Bytes that are read or written one after the other.

use alloc::vec::Vec;
use core::mem;

use crate::Damaged;

/// The most bytes of a module: far more than the engine has.
const MOST: usize = 1 << 26;

/// A module on its way: what is left of it, or what there is of it so far.
pub(crate) struct Tape {
    bytes: Vec<u8>,
    at: usize,
}

impl Tape {
    pub(crate) fn new(bytes: Vec<u8>) -> Tape {
        Tape { bytes, at: 0 }
    }

    pub(crate) fn next(&mut self) -> Result<u8, Damaged> {
        let byte = self.bytes.get(self.at).ok_or(Damaged)?;
        self.at += 1;
        Ok(*byte)
    }

    /// An unsigned number of variable length, below 2^32.
    pub(crate) fn number(&mut self) -> Result<u32, Damaged> {
        let mut value = 0;
        for shift in (0..35).step_by(7) {
            let byte = self.next()?;
            value |= u64::from(byte & 127) << shift;
            if byte < 128 {
                return u32::try_from(value).map_err(|_| Damaged);
            }
        }
        Err(Damaged)
    }

    /// The number that comes next, which stays on the tape.
    pub(crate) fn next_number(&mut self) -> Result<u32, Damaged> {
        let at = self.at;
        let number = self.number();
        self.at = at;
        number
    }

    /// Whether these bytes come next.
    pub(crate) fn begins_with(&self, bytes: &[u8]) -> bool {
        self.bytes.get(self.at..).is_some_and(|rest| rest.starts_with(bytes))
    }

    pub(crate) fn ended(&self) -> bool {
        self.at >= self.bytes.len()
    }

    pub(crate) fn put(&mut self, byte: u8) {
        self.bytes.push(byte);
    }

    pub(crate) fn put_number(&mut self, mut value: u32) {
        while value > 127 {
            self.put(value as u8 | 128);
            value >>= 7;
        }
        self.put(value as u8);
    }

    /// Another tape with its length before it.
    pub(crate) fn put_all(&mut self, other: &Tape) -> Result<(), Damaged> {
        if other.bytes.len() + self.bytes.len() > MOST {
            return Err(Damaged);
        }
        self.put_number(other.bytes.len() as u32);
        self.bytes.extend(&other.bytes);
        Ok(())
    }

    /// Fails where more is written than any module has.
    pub(crate) fn check(&self) -> Result<(), Damaged> {
        if self.bytes.len() > MOST { Err(Damaged) } else { Ok(()) }
    }

    /// What is written so far, which leaves the tape.
    pub(crate) fn take(&mut self) -> Vec<u8> {
        mem::take(&mut self.bytes)
    }

    pub(crate) fn clear(&mut self) {
        self.bytes.clear();
    }
}
