//! The stack of operands, as far as it tells what comes next: how many values are on it in the block, and where they are from.

use alloc::vec::Vec;

use crate::repetition::both;

/// How many values something takes from the stack, and how many it leaves.
pub(crate) type Effect = (usize, usize);

/// The most values that are noted of those that a call leaves.
const MOST: usize = 8;

/// What an operation does that is no block, call or jump.
fn effect(op: u8) -> Effect {
    match op {
        0x0d | 0x1a | 0x21 | 0x24 => (1, 0), // br_if, drop, local.set, global.set
        0x1b => (3, 1),                      // select
        0x20 | 0x23 | 0x3f | 0x41..=0x44 => (0, 1),
        // local.tee, loads, memory.grow, and operations on one number
        0x22
        | 0x28..=0x35
        | 0x40
        | 0x45
        | 0x50
        | 0x67..=0x69
        | 0x79..=0x7b
        | 0x8b..=0x91
        | 0x99..=0x9f
        | 0xa7..=0xc4 => (1, 1),
        0x36..=0x3e => (2, 0), // stores
        0x46..=0xa6 => (2, 1),
        _ => (0, 0),
    }
}

/// An unsigned number of variable length.
fn number(bytes: &mut impl Iterator<Item = u8>) -> Option<usize> {
    let mut value = 0;
    for shift in (0..28).step_by(7) {
        let byte = bytes.next()?;
        value |= usize::from(byte & 127) << shift;
        if byte < 128 {
            return Some(value);
        }
    }
    None
}

#[derive(Default)]
pub(crate) struct Stack {
    /// For each value a number for what made it.
    values: Vec<u32>,
    /// Where the values of each open block begin, and how many it leaves.
    blocks: Vec<(usize, usize)>,
    types: Vec<Effect>,
    /// The type of each function.
    functions: Vec<usize>,
}

impl Stack {
    /// Notes a section of types. `None` where it ends too early; what there is then counts.
    pub(crate) fn types(&mut self, section: &[u8]) -> Option<()> {
        let mut bytes = section.iter().copied();
        for _ in 0..number(&mut bytes)? {
            bytes.next()?;
            let mut counts = [0; 2];
            for count in &mut counts {
                *count = number(&mut bytes)?;
                for _ in 0..*count {
                    bytes.next()?;
                }
            }
            self.types.push(counts.into());
        }
        Some(())
    }

    /// Notes a section that gives functions their types.
    pub(crate) fn functions(&mut self, section: &[u8]) -> Option<()> {
        let mut bytes = section.iter().copied();
        for _ in 0..number(&mut bytes)? {
            self.functions.push(number(&mut bytes)?);
        }
        Some(())
    }

    /// The number of the type of a function.
    pub(crate) fn kind(&self, function: u32) -> usize {
        self.functions.get(function as usize).copied().unwrap_or_default()
    }

    /// How many parameters a function has.
    pub(crate) fn parameters(&self, function: u32) -> u32 {
        self.functions.get(function as usize).map_or(0, |&index| self.type_of(index).0 as u32)
    }

    /// A function begins.
    pub(crate) fn clear(&mut self) {
        self.values.clear();
        self.blocks.clear();
    }

    fn floor(&self) -> usize {
        self.blocks.last().map_or(0, |&(floor, _)| floor)
    }

    /// How many values there are in the block.
    pub(crate) fn height(&self) -> usize {
        self.values.len() - self.floor()
    }

    /// What made the two values on top, the topmost first; 0 where there is none in the block.
    pub(crate) fn top(&self) -> [u32; 2] {
        let mut values = self.values[self.floor()..].iter().rev();
        [0; 2].map(|_| values.next().copied().unwrap_or(0))
    }

    fn change(&mut self, (takes, leaves): Effect, value: u32) {
        self.values.truncate(self.values.len() - takes.min(self.height()));
        self.values.extend((0..leaves.min(MOST)).map(|_| value));
    }

    /// After a jump: nothing follows in the block.
    fn drop_block(&mut self) {
        self.values.truncate(self.floor());
    }

    fn type_of(&self, index: usize) -> Effect {
        self.types.get(index).copied().unwrap_or_default()
    }

    /// An instruction, with a number `value` for it, what it names, and the type that it has.
    pub(crate) fn instruction(&mut self, op: u8, value: u32, named: u32, kind: u32) {
        match op {
            0x02..=0x04 => {
                self.change((usize::from(op == 0x04), 0), 0); // the condition of `if`
                self.blocks.push((self.values.len(), usize::from(kind != 0x40)));
            }
            0x00 | 0x05 | 0x0c | 0x0e | 0x0f => self.drop_block(),
            0x0b => {
                self.drop_block();
                let leaves = self.blocks.pop().map_or(0, |(_, leaves)| leaves);
                self.change((0, leaves), value);
            }
            0x10 => {
                let callee = self.functions.get(named as usize).copied();
                let effect = callee.map_or((0, 0), |index| self.type_of(index));
                self.change(effect, value);
            }
            0x11 => {
                let (takes, leaves) = self.type_of(kind as usize);
                self.change((takes + 1, leaves), value);
            }
            0x22 => self.change((1, 1), both(0x20, named)), // as if the variable were read
            0xfc => self.change(if named > 7 { (3, 0) } else { (1, 1) }, value),
            _ => self.change(effect(op), value),
        }
    }
}
