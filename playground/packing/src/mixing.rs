//! Bytes one after the other, each coded by what is expected of it.
//!
//! Several contexts give a probability for every binary decision. They are mixed in the logistic domain by weights that
//! learn as they go, each the sum of four that are chosen in different ways, and an arithmetic coder writes what remains.
//! The scheme is that of the PAQ family, <https://mattmahoney.net/dc/dce.html#Section_43>.

use alloc::vec;
use alloc::vec::Vec;

use crate::Damaged;
use crate::kinds::{DATA, KINDS, SHAPES};
use crate::refining::Refining;
use crate::repetition::SURE;
use crate::tree::{self, Step, Tree};

/// Contexts of a byte.
pub(crate) const CONTEXTS: usize = 11;
/// As many numbers as contexts, and further ones that fill a vector of the processor.
const WIDTH: usize = CONTEXTS.next_multiple_of(4);

/// Slots for what was seen in contexts, in blocks of 1 kB, one for all decisions of a byte in a context. The first part has `FIRST`
/// of them; with four times as many it would take a third longer, most of which is waiting for memory. The others have `BLOCKS`, and
/// are smaller by a fiftieth for it.
const FIRST: usize = 8 << 10;
const BLOCKS: usize = 64 << 10;
const BLOCK: usize = 256;
const SLOTS: usize = BLOCKS * BLOCK;
/// Of a slot, which has a probability of 16 bits, 10 bits of the context that it belongs to, and a count up to its limit.
const OWNER: u32 = 0xffc0;
const COUNT: u32 = 0x3f;
/// One half, never seen.
const FRESH: u32 = 0x8000_0000;
/// The more has been counted, the less a decision moves the probability. Contexts that tell of one place forget soon; what comes
/// after many places, or after a repetition, is what it was.
const SOON: u32 = 7;
const LATE: u32 = 62;
const LIMITS: [u32; WIDTH] = [LATE, SOON, LATE, LATE, SOON, SOON, SOON, SOON, SOON, LATE, SOON, SOON];
/// A slot that was seen more often than this is not given to another context at once.
const OFTEN: u32 = 5;
/// How far weights move at first and in the end. With each decision, `SETTLE` of what is between is left behind.
const LEARN: f32 = 0.006;
const LEARN_LAST: f32 = 0.001;
const SETTLE: f32 = 1.0 / 500_000.0;
/// Weights at first.
const WEIGHT: f32 = 0.1;

/// The logistic function is tabled between -`SPAN` and `SPAN`.
const SPAN: f32 = 12.0;
const TABLE: usize = 4096;

/// A weight for each context.
type Weights = [f32; WIDTH];

/// What bytes are read from, written to or counted by.
pub(crate) trait Bytes {
    /// Whether bytes are read rather than known.
    const READS: bool;

    /// A byte of a kind in contexts, with how sure repetitions are, and what came before: the one that is read, or
    /// `known`.
    fn byte(&mut self, kind: usize, contexts: [u32; CONTEXTS], sure: usize, before: u8, known: u8) -> u8;

    /// More room for what is seen, after the first part.
    fn grow(&mut self) {}

    /// Fails where more was read than there was.
    fn check(&self) -> Result<(), Damaged> {
        Ok(())
    }
}

/// The coder's side of decisions.
pub(crate) trait Coder {
    const READS: bool;
    /// One decision that is true with the probability `p`/65536: the one that is read, or `known`.
    fn decide(&mut self, p: u32, known: bool) -> bool;
    fn check(&self) -> Result<(), Damaged>;
}

/// The model of bytes before a coder.
pub(crate) struct Mixer<C> {
    coder: C,
    trees: Vec<Tree>,
    /// Each different from `FRESH` in the bits that are set, so that memory is fresh as it comes.
    slots: Vec<u32>,
    /// How many blocks are in use.
    blocks: usize,
    refining: Refining,
    learn: f32,
    by_node: Vec<Weights>,
    by_sure: Vec<Weights>,
    by_before: Vec<Weights>,
    /// By in how many contexts the decision was never seen.
    by_fresh: Vec<Weights>,
    stretch: Vec<f32>,
    squash: Vec<f32>,
}

/// e^x by powers of a short series, with the same bits on every machine.
fn exp(x: f64) -> f64 {
    let y = x / 4096.0;
    let mut e = 1.0 + y * (1.0 + y / 2.0 * (1.0 + y / 3.0 * (1.0 + y / 4.0)));
    for _ in 0..12 {
        e *= e;
    }
    e
}

impl<C: Coder> Mixer<C> {
    pub(crate) fn new(coder: C) -> Mixer<C> {
        let logistic = |x: f64| 1.0 / (1.0 + exp(-x));
        let squash =
            (0..=TABLE).map(|k| logistic(f64::from(SPAN) * (2.0 * k as f64 / TABLE as f64 - 1.0)) as f32);
        // The inverse, from one probability to the next, by Newton's method.
        let mut x = -9.0;
        let stretch = (0..TABLE).map(|k| {
            let odds = (k as f64 + 0.5) / (TABLE as f64 - 0.5 - k as f64);
            for _ in 0..4 {
                x += odds / exp(x) - 1.0;
            }
            x as f32
        });
        Mixer {
            coder,
            trees: Vec::new(),
            slots: vec![0; SLOTS],
            blocks: FIRST,
            refining: Refining::new(),
            learn: LEARN,
            by_node: vec![[WEIGHT; WIDTH]; KINDS * 256],
            by_sure: vec![[WEIGHT; WIDTH]; KINDS * SURE],
            by_before: vec![[WEIGHT; WIDTH]; KINDS * 256],
            by_fresh: vec![[0.0; WIDTH]; KINDS * (WIDTH + 1)],
            stretch: stretch.collect(),
            squash: squash.collect(),
        }
    }

    /// Reads or writes the lengths of the paths in the trees of all kinds.
    pub(crate) fn shapes(&mut self, known: Option<&[[u8; 256]]>) -> Result<(), Damaged> {
        self.trees = vec![tree::of(&core::array::from_fn(|s| if s < 16 { 4 } else { 0 }))?; KINDS];
        let mut trees = Vec::new();
        for kind in 0..SHAPES {
            let mut lengths = [0; 256];
            let mut before = [0; 2];
            for s in 0..256 {
                let [a, b] = before.map(u32::from);
                let mut contexts = [0; CONTEXTS];
                contexts[..3].copy_from_slice(&[a, a + 16 * b + 256, kind as u32 + 512]);
                lengths[s] = self.byte(SHAPES, contexts, 0, 0, known.map_or(0, |all| all[kind][s]));
                before = [lengths[s], before[0]];
            }
            trees.push(tree::of(&lengths)?);
        }
        trees.push(self.trees[SHAPES].clone());
        self.trees = trees;
        Ok(())
    }

    pub(crate) fn into_coder(self) -> C {
        self.coder
    }
}

impl<C: Coder> Bytes for Mixer<C> {
    const READS: bool = C::READS;

    // The loops over WIDTH are such that the compiler makes vectors of them.
    fn byte(&mut self, kind: usize, contexts: [u32; CONTEXTS], sure: usize, before: u8, known: u8) -> u8 {
        let blocks = self.blocks as u32;
        let mut base = [0; WIDTH];
        base[..CONTEXTS].copy_from_slice(&contexts);
        let mut owner = [0; WIDTH];
        for i in 0..WIDTH {
            let h = base[i] ^ ((kind * WIDTH + i + 1) as u32).wrapping_mul(0x3d4d_51cb);
            let h = h.wrapping_mul(0x9e37_79b1);
            let h = (h ^ (h >> 15)).wrapping_mul(0x85eb_ca6b);
            let block = ((h >> 16) * blocks) >> 16;
            base[i] = block * BLOCK as u32 + h % BLOCK as u32;
            owner[i] = h.wrapping_mul(0x2545_f491) >> 16 & OWNER;
        }
        let slots: &mut [u32; SLOTS] = (&mut self.slots[..]).try_into().expect("as many as there are");
        let stretch: &[f32; TABLE] = self.stretch[..].try_into().expect("as many as there are");
        let squash: &[f32; TABLE + 1] = self.squash[..].try_into().expect("as many as there are");
        let logistic = |x: f32| {
            let k = (x + SPAN) * (TABLE as f32 / (2.0 * SPAN));
            squash[(k.clamp(0.0, TABLE as f32) as usize).min(TABLE)]
        };
        let by_sure = self.by_sure.get_mut(kind * SURE + sure).expect("a set of weights");
        let by_before = self.by_before.get_mut(kind * 256 + usize::from(before)).expect("a set of weights");
        let tree = &self.trees[kind];
        let mut left = tree.path[usize::from(known)];
        let mut node = 0;
        loop {
            let by_node = self.by_node.get_mut(kind * 256 + node).expect("a set of weights");
            let mut place = [0; WIDTH];
            let mut slot = [FRESH; WIDTH];
            for i in 0..CONTEXTS {
                place[i] = (base[i] as usize ^ node).min(SLOTS - 1); // within the block: the minimum is for the compiler
                slot[i] = slots[place[i]] ^ FRESH;
            }
            let held = slot;
            let mut count = [0.0; WIDTH];
            let mut fresh = 0;
            for i in 0..WIDTH {
                slot[i] = if slot[i] & OWNER == owner[i] { slot[i] } else { FRESH | owner[i] };
                fresh += u32::from(slot[i] & COUNT == 0);
                count[i] = (slot[i] & COUNT) as f32;
            }
            let mut stretched = [0.0; WIDTH];
            for i in 0..CONTEXTS {
                stretched[i] = stretch[(slot[i] >> 20) as usize];
            }
            for i in 0..WIDTH {
                stretched[i] *= 1.0 + 0.6 / (count[i] + 0.5); // at first it is more certain than its probability says
            }
            let by_fresh =
                self.by_fresh.get_mut(kind * (WIDTH + 1) + fresh as usize).expect("a set of weights");
            let mut sums = [0.0_f32; 4];
            for i in 0..WIDTH {
                sums[i % 4] += (by_node[i] + by_sure[i] + by_before[i] + by_fresh[i]) * stretched[i];
            }
            let odds = (sums[0] + sums[1]) + (sums[2] + sums[3]);
            let expected = logistic(odds);
            // Where bytes are text it would take a tenth more time and save next to nothing.
            let mark = (kind != DATA).then(|| Refining::place(kind * 256 + node, contexts[3], odds));
            let refined = expected + mark.as_ref().map_or(0.0, |mark| self.refining.correction(mark));
            let p = (refined * 65536.0) as u32;
            let bit = self.coder.decide(p.clamp(1, 65535), left & 1 == 1);
            left >>= 1;
            let error = f32::from(u8::from(bit)) - expected;
            if let Some(mark) = &mark {
                self.refining.learn(mark, error);
            }
            let error = error * self.learn;
            self.learn += (LEARN_LAST - self.learn) * SETTLE;
            let change = stretched.map(|x| error * x);
            for set in [by_node, &mut *by_sure, &mut *by_before, by_fresh] {
                for (weight, change) in set.iter_mut().zip(change) {
                    *weight += change;
                }
            }
            let goal = if bit { 65535 } else { 0 };
            for i in 0..WIDTH {
                let rate = (32767.5 / (count[i] + 1.5)) as i32;
                let p = (slot[i] >> 16) as i32;
                let p = p + (((goal - p) * rate) >> 15);
                let more = u32::from(slot[i] & COUNT < LIMITS[i]);
                slot[i] = ((p as u32) << 16 | slot[i] & 0xffff) + more;
                // What was seen often in another context stays for a while.
                let stays = held[i] & OWNER != owner[i] && held[i] & COUNT > OFTEN;
                slot[i] = if stays { held[i] - 1 } else { slot[i] };
            }
            for i in 0..CONTEXTS {
                slots[place[i]] = slot[i] ^ FRESH;
            }
            match tree.next[node][usize::from(bit)] {
                Step::Byte(byte) => return byte,
                Step::Node(next) => node = usize::from(next),
            }
        }
    }

    /// Each block becomes several, which are as it was: where a context belongs among them is known when it is seen again.
    fn grow(&mut self) {
        if self.blocks == BLOCKS {
            return;
        }
        let scale = BLOCKS / self.blocks;
        for block in (0..self.blocks).rev() {
            let from = block * BLOCK..(block + 1) * BLOCK;
            for k in (0..scale).rev() {
                self.slots.copy_within(from.clone(), (block * scale + k) * BLOCK);
            }
        }
        self.blocks = BLOCKS;
    }

    fn check(&self) -> Result<(), Damaged> {
        self.coder.check()
    }
}
