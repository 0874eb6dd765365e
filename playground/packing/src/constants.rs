//! Numbers of 32 bits, and which function is called: what is coded otherwise than it lies in the module.

use crate::Damaged;
use crate::kinds::{CALL_HIGH, CALL_LOW, LENGTH, NUMBER};
use crate::mixing::Bytes;
use crate::module::Walk;
use crate::repetition::both;

impl<B: Bytes> Walk<B> {
    /// A number of 32 bits: the number of its bytes, and these from the highest down. A number for it.
    pub(crate) fn constant(&mut self) -> Result<u32, Damaged> {
        let mut bytes = [0_u8; 5];
        let mut length = 0;
        if !B::READS {
            loop {
                let byte = self.tape.next()?;
                *bytes.get_mut(length).ok_or(Damaged)? = byte;
                length += 1;
                if byte < 128 {
                    break;
                }
            }
        }
        let [_, o2, o3, o4, ..] = self.operations;
        let [s1, s2, s3] = self.seen;
        let at2 = both(o2, o3);
        let near = both(s1, both(s2, s3));
        let contexts = [o2, both(at2, o4), near];
        length = usize::from(self.byte(LENGTH, contexts, length as u8));
        if !(1..=5).contains(&length) {
            return Err(Damaged);
        }
        self.after(length as u8);
        let mut before = length as u32;
        for k in (0..length).rev() {
            let contexts = [o2, at2, both(self.function, 1)].map(|c| both(before, c));
            bytes[k] = self.byte(NUMBER + length - 1, contexts, bytes[k]);
            before = both(before, u32::from(bytes[k]));
            self.after(bytes[k]);
        }
        if B::READS {
            bytes[..length].iter().for_each(|&byte| self.tape.put(byte));
        }
        self.repetition.push(before);
        Ok(before)
    }

    /// The number of the function that is called, in two parts.
    pub(crate) fn called(&mut self) -> Result<u32, Damaged> {
        let known = if B::READS { 0 } else { self.tape.number()? };
        let high = u8::try_from(known >> 7).map_err(|_| Damaged)?;
        let [_, o2, o3, ..] = self.operations;
        let c1 = self.call;
        let at2 = both(o2, o3);
        let contexts = [at2, c1, self.function];
        let high = self.byte(CALL_HIGH, contexts, high);
        let contexts = contexts.map(|c| both(u32::from(high), c));
        self.after(high);
        let called = u32::from(high) << 7 | u32::from(self.byte(CALL_LOW, contexts, known as u8 & 127) & 127);
        if B::READS {
            self.tape.put_number(called);
        }
        self.repetition.push(called);
        self.call = called;
        Ok(called)
    }
}
