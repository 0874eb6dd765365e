//! Loads and stores: mostly, places in memory are aligned to 2^k bytes by the size of what lies there. Those with smaller
//! alignments are operations of their own where the engine is packed.

/// The first of them; the others follow.
const LOAD: u8 = 0x28;
/// Alignments of each by its size.
const USUAL: [u8; 23] = [2, 3, 2, 3, 0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 2, 3, 2, 3, 0, 1, 0, 1, 2];
/// The first number that is no operation of WebAssembly.
const OTHER: u8 = 0xc5;

/// The usual alignment, if the operation loads or stores.
pub(crate) fn usual(op: u8) -> Option<u8> {
    USUAL.get(usize::from(op.wrapping_sub(LOAD))).copied()
}

/// Whether it stands for an operation of WebAssembly by itself.
pub(crate) fn known(op: u8) -> bool {
    op < OTHER || op == 0xfc
}

/// The operations with smaller alignments, in the order of their numbers.
fn smaller() -> impl Iterator<Item = (u8, u8)> {
    (LOAD..).zip(USUAL).flat_map(|(op, usual)| (0..usual).map(move |align| (op, align)))
}

/// The number of an operation with an alignment.
pub(crate) fn sign(op: u8, align: u8) -> Option<u8> {
    if usual(op) == Some(align) {
        return Some(op);
    }
    (OTHER..).zip(smaller()).find(|(_, known)| *known == (op, align)).map(|(sign, _)| sign)
}

/// The operation of a number, and its alignment if it has one.
pub(crate) fn operation(sign: u8) -> (u8, Option<u8>) {
    match sign.checked_sub(OTHER).and_then(|k| smaller().nth(usize::from(k))) {
        Some((op, align)) => (op, Some(align)),
        None => (sign, usual(sign)),
    }
}
