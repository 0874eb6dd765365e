//! A WebAssembly module from its first byte to its last, each in the contexts that tell most of it: the instructions
//! before it, the variables used last, what came after the last passage like this one.
//! <https://webassembly.github.io/spec/core/binary>

use alloc::vec;
use alloc::vec::Vec;
use core::mem;

use crate::Damaged;
use crate::kinds::{
    ABSENT, DATA, DECLARED, JUMP, KIND, LONG, NEW, OFFSET, OFFSET_MORE, OPERATION, REST, VARIABLE,
};
use crate::memory;
use crate::mixing::{Bytes, CONTEXTS};
use crate::repetition::{Repetition, both};
use crate::stack::Stack;
use crate::tape::Tape;

// Sections.
const TYPE_SECTION: u32 = 1;
const FUNCTION_SECTION: u32 = 3;
const CODE_SECTION: u32 = 10;
const DATA_SECTION: u32 = 11;
/// A function that is missing: no variables, and a trap. It comes in a later part.
const MISSING: [u8; 3] = [0, 0x00, 0x0b];
/// What stands between two parts of a module, in the place of a section's number.
pub const PART: u8 = 255;

/// Goes through a module: takes it from the tape and gives its bytes to the coder, or the other way round.
pub(crate) struct Walk<B> {
    bytes: B,
    pub(crate) tape: Tape,
    pub(crate) repetition: Repetition,
    /// Operations before, the last one first.
    pub(crate) operations: [u32; 6],
    /// The same with what belongs to them.
    pub(crate) seen: [u32; 3],
    variables: [u32; 2],
    pub(crate) call: u32,
    pub(crate) function: u32,
    /// Functions that are missing, and how many of them came in later parts.
    missing: Vec<u32>,
    came: usize,
    /// Which of the last functions were missing, the last one lowest.
    lacks: u32,
    depth: u32,
    stack: Stack,
    /// Further contexts of an instruction, and of what of it has been coded.
    around: [u32; AROUND],
    /// The last offset from what each address is made of.
    places: Vec<u32>,
    /// The last offset.
    offset: u32,
    /// The variable that was used after each.
    next: Vec<u32>,
    /// The first variable that is no parameter, and of which neither it nor any behind it was used.
    unused: u32,
}

/// Contexts of an instruction besides three of its own and those of repetitions.
const AROUND: usize = CONTEXTS - 5;

/// Variables and addresses that are told apart.
const TABLE: usize = 1 << 10;

fn push<const N: usize>(all: &mut [u32; N], value: u32) {
    all.copy_within(0..N - 1, 1);
    all[0] = value;
}

impl<B: Bytes> Walk<B> {
    pub(crate) fn new(bytes: B, tape: Tape) -> Walk<B> {
        Walk {
            bytes,
            tape,
            repetition: Repetition::new(),
            operations: [0; 6],
            seen: [0; 3],
            variables: [0; 2],
            call: 0,
            function: 0,
            missing: Vec::new(),
            came: 0,
            lacks: 0,
            depth: 0,
            stack: Stack::default(),
            around: [0; AROUND],
            places: vec![0; TABLE],
            offset: 0,
            next: vec![0; TABLE],
            unused: 0,
        }
    }

    pub(crate) fn into_bytes(self) -> B {
        self.bytes
    }

    /// A byte in the contexts that are given, those around it, and those of repetitions.
    pub(crate) fn byte(&mut self, kind: usize, [a, b, c]: [u32; 3], known: u8) -> u8 {
        let [d, e, f, g, h, i] = self.around;
        let [j, k] = self.repetition.expected();
        let contexts = [a, b, c, d, e, f, g, h, i, j, k];
        self.bytes.byte(kind, contexts, self.repetition.sure(), self.operations[0] as u8, known)
    }

    /// Notes a byte of an instruction for those that belong to it.
    pub(crate) fn after(&mut self, byte: u8) {
        self.around = self.around.map(|c| both(c, u32::from(byte)));
    }

    /// A byte that goes over as it is.
    fn moved(&mut self, kind: usize, contexts: [u32; 3]) -> Result<u8, Damaged> {
        let known = if B::READS { 0 } else { self.tape.next()? };
        let byte = self.byte(kind, contexts, known);
        if B::READS {
            self.tape.put(byte);
        }
        self.repetition.push(u32::from(byte));
        Ok(byte)
    }

    /// A number of variable length, of which bytes after the first one are of the kind `more`. Only its lower 32 bits
    /// are known.
    fn leb(&mut self, kind: usize, more: usize, mut contexts: [u32; 3]) -> Result<u32, Damaged> {
        let mut value = 0;
        for k in 0..10 {
            let byte = self.moved(if k == 0 { kind } else { more }, contexts)?;
            value |= u64::from(byte & 127) << (7 * k);
            if byte < 128 {
                return Ok(value as u32);
            }
            contexts = contexts.map(|c| both(c, u32::from(byte)));
            self.after(byte);
        }
        Err(Damaged)
    }

    /// A number by itself.
    fn plain(&mut self, known: u32) -> u32 {
        let bytes = known.to_be_bytes();
        u32::from_be_bytes([0, 1, 2, 3].map(|k| self.byte(REST, [k as u32; 3], bytes[k])))
    }

    /// The whole module, all of its parts.
    pub(crate) fn module(&mut self) -> Result<(), Damaged> {
        self.header()?;
        while self.part()? {}
        Ok(())
    }

    /// What a module begins with.
    pub(crate) fn header(&mut self) -> Result<(), Damaged> {
        self.plain_bytes(REST, 8).map(drop)
    }

    /// The sections of a part; whether another part follows.
    pub(crate) fn part(&mut self) -> Result<bool, Damaged> {
        loop {
            // A zero stands after the last section.
            let ended = B::READS || self.tape.ended();
            let known = if ended { 0 } else { u32::from(self.tape.next()?) };
            let id = self.plain(known);
            self.bytes.check()?;
            if id == 0 {
                return Ok(false);
            }
            if id == u32::from(PART) {
                self.bytes.grow();
                return Ok(true);
            }
            let length = if B::READS { 0 } else { self.tape.number()? };
            if B::READS {
                self.tape.put(id as u8);
            }
            if id == CODE_SECTION {
                self.code()?;
                continue;
            }
            let length = self.plain(length);
            if B::READS {
                self.tape.put_number(length);
            }
            let section = self.plain_bytes(if id == DATA_SECTION { DATA } else { REST }, length)?;
            // Where they are damaged, contexts are worse, and both sides have the same.
            let _ = match id {
                TYPE_SECTION => self.stack.types(&section),
                FUNCTION_SECTION => self.stack.functions(&section),
                _ => None,
            };
        }
    }

    /// Bytes that are no instructions.
    fn plain_bytes(&mut self, kind: usize, count: u32) -> Result<Vec<u8>, Damaged> {
        let mut bytes = Vec::new();
        let mut before = 0_u64;
        let mut word = 0_u32;
        let mut word_before = 0_u32;
        for k in 0..count {
            let last = before as u32;
            let [shorter, longer] = self.repetition.expected();
            let contexts = [
                last & 0xff,
                last & 0xffff,
                last & 0xff_ffff,
                last,
                both(last, (before >> 32) as u32 & 0xffff),
                both(last >> 24 | (before >> 48) as u32 & 0xff00, k & 3),
                both(word, last & 0xff),
                both(word, word_before),
                both(last >> 8 & 0xffff, 0),
                shorter,
                longer,
            ];
            let known = if B::READS { 0 } else { self.tape.next()? };
            let byte = self.bytes.byte(kind, contexts, self.repetition.sure(), last as u8, known);
            if B::READS {
                self.tape.put(byte);
            }
            bytes.push(byte);
            self.repetition.push(u32::from(byte));
            self.repetition.look();
            before = before << 8 | u64::from(byte);
            let letter = byte.is_ascii_alphabetic() || byte >= 128;
            if !letter && word != 0 {
                word_before = word;
            }
            word = if letter { word.wrapping_add(u32::from(byte)).wrapping_mul(0x2f0b_4c47) } else { 0 };
            self.bytes.check()?;
            self.tape.check()?;
        }
        Ok(bytes)
    }

    /// The code. How long it and its functions are follows from their instructions.
    fn code(&mut self) -> Result<(), Damaged> {
        let known = if B::READS { 0 } else { self.tape.number()? };
        let count = self.plain(known);
        let first = self.function == 0;
        if !B::READS {
            for k in 0..count {
                self.tape.number()?;
                self.next_function(first, k)?;
            }
            return Ok(());
        }
        let module = mem::replace(&mut self.tape, Tape::new(Vec::new()));
        let mut all = Tape::new(Vec::new());
        all.put_number(count);
        for k in 0..count {
            self.tape.clear();
            self.next_function(first, k)?;
            all.put_all(&self.tape)?;
        }
        self.tape = module;
        self.tape.put_all(&all)
    }

    /// The next function, in code after the first the next one that was missing. First comes whether it is missing here.
    fn next_function(&mut self, first: bool, k: u32) -> Result<(), Damaged> {
        let mut number = k;
        if !first {
            number = *self.missing.get(self.came).ok_or(Damaged)?;
            self.came += 1;
        }
        self.function = number.wrapping_add(1);
        let kind = self.stack.kind(number) as u32;
        let [few, some, many] = [3, 15, 0xff].map(|mask| self.lacks & mask);
        self.around = [many, both(few, kind), both(some, kind), kind, 0, 0];
        let known = !B::READS && self.tape.begins_with(&MISSING);
        let missing = self.byte(ABSENT, [few & 1, some, self.lacks & 0xffff], u8::from(known)) != 0;
        self.lacks = self.lacks << 1 | u32::from(missing);
        if !missing {
            return self.body(number);
        }
        self.missing.push(number);
        for byte in MISSING {
            if B::READS {
                self.tape.put(byte);
            } else {
                self.tape.next()?;
            }
        }
        self.bytes.check()?;
        self.tape.check()
    }

    /// One function: its variables, and instructions up to the end of the outermost block.
    fn body(&mut self, number: u32) -> Result<(), Damaged> {
        self.unused = self.stack.parameters(number);
        self.places.fill(0);
        self.next.fill(0);
        self.operations = [0; 6];
        self.seen = [0; 3];
        self.stack.clear();
        self.around = [0; AROUND];
        let mut declared = [0; 2];
        let groups = self.declared(&mut declared)?;
        for _ in 0..groups {
            while self.declared(&mut declared)? > 127 {}
            self.declared(&mut declared)?;
        }
        self.depth = 1;
        while self.depth > 0 {
            let seen = self.instruction()?;
            push(&mut self.seen, seen);
            self.repetition.look();
            self.bytes.check()?;
            self.tape.check()?;
        }
        Ok(())
    }

    fn declared(&mut self, before: &mut [u32; 2]) -> Result<u8, Damaged> {
        let near = both(before[0], before[1]);
        let byte = self.moved(DECLARED, [before[0], near, 0])?;
        push(before, u32::from(byte));
        self.bytes.check()?;
        Ok(byte)
    }

    /// One instruction; a number for it with what belongs to it.
    fn instruction(&mut self) -> Result<u32, Damaged> {
        let [o1, o2, o3, o4, o5, o6] = self.operations;
        let [s1, s2, s3] = self.seen;
        let [v1, v2] = self.variables;
        let f = self.function;
        let [t1, t2] = self.stack.top();
        let top = both(t1, self.stack.height().min(6) as u32);
        let h2 = both(o1, o2);
        let h3 = both(h2, o3);
        let h4 = both(h3, o4);
        let near = both(s1, s2);
        let far = both(near, s3);
        let contexts = [both(h4, both(o5, o6)), s1, near];
        self.around = [h2, top, far, both(h4, s1), both(f, top), 0];
        let (sign, op) = self.operation(contexts)?;
        let sign = u32::from(sign);
        push(&mut self.operations, sign);
        // What follows is coded in contexts of this operation and those before it.
        let at2 = both(sign, o1);
        let at3 = both(at2, o2);
        let [near_here, far_here] = [near, far].map(|c| both(c, sign));
        self.around = [both(at3, o3), both(sign, top), far_here, 0, 0, 0];
        let mut of = 0;
        let mut kind = 0;
        match op {
            0x20..=0x22 => {
                let place = v1 as usize % TABLE;
                let pair = both(sign, both(v1, v2));
                self.around[3] = both(f, pair);
                self.around[4] = both(self.next[place], both(v1, sign));
                self.around[5] = both(sign, self.unused);
                of = self.variable(op, [pair, both(f, sign), near_here])?;
                self.next[place] = of;
                push(&mut self.variables, of);
            }
            0x28..=0x3e => {
                // Of stores, the value lies above the address.
                let address = if op < 0x36 { t1 } else { t2 };
                let place = address as usize % TABLE;
                let contexts = [both(at2, both(v1, f)), at3, both(sign, both(address, self.places[place]))];
                self.around[3] = both(sign, both(self.offset, address));
                self.around[4] = both(f, both(sign, address));
                of = self.leb(OFFSET, OFFSET_MORE, contexts)?;
                self.places[place] = of;
                self.offset = of;
            }
            0x41 => {
                self.around[3] = both(f, both(o1, t1));
                self.around[4] = both(f, self.offset);
                of = self.constant()?;
            }
            0x10 => {
                self.around[3] = both(f, o1);
                self.around[4] = both(t1, t2);
                of = self.called()?;
            }
            0x0c | 0x0d => of = self.jump(at3)?,
            0x0b => self.depth -= 1,
            0x02..=0x04 => {
                self.depth += 1;
                kind = self.kind(at2, at3)?;
            }
            0x0e => {
                let count = self.jump(at3)?;
                let mut before = 0;
                for k in (0..=count).rev() {
                    before = self.jump(both(sign, both(before, k)))?;
                    self.bytes.check()?;
                    self.tape.check()?;
                }
            }
            0x11 => {
                kind = self.kind(at2, at3)?;
                self.kind(0, 0)?;
            }
            0x42 => {
                self.leb(LONG, LONG, [o1, both(o1, o2), s1])?;
            }
            0x23 | 0x24 | 0x3f | 0x40 => {
                self.kind(at2, at3)?;
            }
            0x43 => self.some(4)?,
            0x44 => self.some(8)?,
            0xfc => {
                of = self.leb(LONG, LONG, [o1; 3])?;
                match of {
                    0..=7 => {}
                    10 => self.some(2)?, // memory.copy
                    11 => self.some(1)?, // memory.fill
                    _ => return Err(Damaged),
                }
            }
            0x00 | 0x01 | 0x05 | 0x0f | 0x1a | 0x1b | 0x45..=0xc4 => {}
            _ => return Err(Damaged),
        }
        let seen = if of == 0 && !(0x20..=0x41).contains(&op) { sign } else { both(sign, of) };
        self.stack.instruction(op, seen, of, kind);
        Ok(seen)
    }

    /// The number of a variable. Those that are set are first asked whether they are new: mostly, they are numbered in
    /// the order in which they are set.
    fn variable(&mut self, op: u8, contexts: [u32; 3]) -> Result<u32, Damaged> {
        let unused = self.unused;
        if op != 0x20 {
            let known = !B::READS && self.tape.next_number()? == unused;
            if self.byte(NEW, contexts, u8::from(known)) != 0 {
                if B::READS {
                    self.tape.put_number(unused);
                } else {
                    self.tape.number()?;
                }
                self.repetition.push(u32::MAX);
                self.unused = unused.saturating_add(1);
                return Ok(unused);
            }
        }
        let variable = self.leb(VARIABLE, VARIABLE, contexts)?;
        self.unused = unused.max(variable.saturating_add(1));
        Ok(variable)
    }

    /// An operation: its number where it is packed, and in the module.
    fn operation(&mut self, contexts: [u32; 3]) -> Result<(u8, u8), Damaged> {
        let mut known = 0;
        if !B::READS {
            known = self.tape.next()?;
            if !memory::known(known) {
                return Err(Damaged);
            }
            if memory::usual(known).is_some() {
                known = memory::sign(known, self.tape.next()?).ok_or(Damaged)?;
            }
        }
        let sign = self.byte(OPERATION, contexts, known);
        self.repetition.push(u32::from(sign));
        let (op, align) = memory::operation(sign);
        if B::READS {
            self.tape.put(op);
            if let Some(align) = align {
                self.tape.put(align);
            }
        }
        Ok((sign, op))
    }

    fn jump(&mut self, far: u32) -> Result<u32, Damaged> {
        let contexts = [far, both(self.depth, self.operations[1]), both(self.function, self.depth)];
        self.leb(JUMP, JUMP, contexts)
    }

    /// What a block leaves, or another number that mostly is the same.
    fn kind(&mut self, near: u32, far: u32) -> Result<u32, Damaged> {
        self.leb(KIND, KIND, [near, far, 0])
    }

    /// Bytes without a pattern.
    fn some(&mut self, count: u32) -> Result<(), Damaged> {
        for k in 0..count {
            self.moved(LONG, [both(k, self.operations[1]); 3])?;
        }
        Ok(())
    }
}
