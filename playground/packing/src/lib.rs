//! The engine for the page in few bytes, and back: WebAssembly, coded instruction by instruction.
//!
//! [`pack`] is for the build of the page, [`unpack`] is in the page. In both one walk goes through the module, with
//! the same contexts: what it takes from the module and gives to the coder when it packs goes back when it unpacks.

#![cfg_attr(target_family = "wasm", no_std)] // what the library adds would be most of what the page loads to unpack

extern crate alloc;

mod coder;
mod constants;
mod kinds;
mod memory;
mod mixing;
mod module;
#[cfg(target_family = "wasm")]
mod page;
mod refining;
mod repetition;
mod stack;
mod tape;
mod tree;

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use coder::{Reader, Writer};
use kinds::{KINDS, SHAPES};
use mixing::{Bytes, CONTEXTS, Mixer};
pub use module::PART;
use module::Walk;
use tape::Tape;

/// What is packed is damaged, or ends too early; or what is to be packed is no module as the compiler of the engine
/// writes it, without vectors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Damaged;

impl fmt::Display for Damaged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the packed engine is damaged")
    }
}

impl core::error::Error for Damaged {}

/// How often each byte of each kind comes.
struct Census(Vec<[u32; 256]>);

impl Bytes for Census {
    const READS: bool = false;

    fn byte(&mut self, kind: usize, _: [u32; CONTEXTS], _: usize, _: u8, known: u8) -> u8 {
        self.0[kind][usize::from(known)] += 1;
        known
    }
}

/// A module in few bytes, in one part or in several with [`PART`] between them.
///
/// # Errors
///
/// Where the module has instructions that the compiler of the engine does not write.
pub fn pack(module: &[u8]) -> Result<Vec<u8>, Damaged> {
    let mut walk = Walk::new(Census(vec![[0; 256]; SHAPES]), Tape::new(module.to_vec()));
    walk.module()?;
    let lengths: Vec<_> = walk.into_bytes().0.iter().map(tree::lengths).collect();
    let mut mixer = Mixer::new(Writer::new());
    mixer.shapes(Some(&lengths))?;
    let mut walk = Walk::new(mixer, Tape::new(module.to_vec()));
    walk.module()?;
    Ok(walk.into_bytes().into_coder().finish())
}

/// The module that was packed.
///
/// # Errors
///
/// Where the bytes are damaged, unless they are another module.
pub fn unpack(packed: &[u8]) -> Result<Vec<u8>, Damaged> {
    let mut parts = Parts::new(packed.to_vec())?;
    let mut module = Vec::new();
    while let Some(part) = parts.next()? {
        if !module.is_empty() {
            module.push(PART);
        }
        module.extend(part);
    }
    Ok(module)
}

/// The parts of the module that was packed, one after the other: the first one is there long before the last one is.
pub struct Parts {
    walk: Walk<Mixer<Reader>>,
    more: bool,
}

impl Parts {
    /// # Errors
    ///
    /// Where the bytes are damaged at their beginning.
    pub fn new(packed: Vec<u8>) -> Result<Parts, Damaged> {
        let mut mixer = Mixer::new(Reader::new(packed));
        mixer.shapes(None)?;
        let mut walk = Walk::new(mixer, Tape::new(Vec::new()));
        walk.header()?;
        Ok(Parts { walk, more: true })
    }

    /// The next part, of which the first one begins with the header of the module; `None` after the last one.
    ///
    /// # Errors
    ///
    /// Where the bytes are damaged.
    #[allow(clippy::should_implement_trait)] // an iterator would go on after an error
    pub fn next(&mut self) -> Result<Option<Vec<u8>>, Damaged> {
        if !self.more {
            return Ok(None);
        }
        self.more = self.walk.part()?;
        Ok(Some(self.walk.tape.take()))
    }
}
