//! Modules come back from their packed form, whatever instructions they have; what is damaged is an error or another
//! module.

use basis_packing::{Damaged, PART, Parts, pack, unpack};

/// Numbers that are the same in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) % n
    }

    /// A number that is small more often than not.
    fn number(&mut self, bits: u64) -> u64 {
        let bits = self.below(bits + 1);
        self.0 >> 3 & ((1 << bits) - 1)
    }
}

fn unsigned(out: &mut Vec<u8>, mut value: u64) {
    while value > 127 {
        out.push(value as u8 | 128);
        value >>= 7;
    }
    out.push(value as u8);
}

fn signed(out: &mut Vec<u8>, mut value: i64) {
    loop {
        let byte = value as u8 & 127;
        value >>= 7;
        if (value, byte & 64) == (0, 0) || (value, byte & 64) == (-1, 64) {
            return out.push(byte);
        }
        out.push(byte | 128);
    }
}

/// Alignments of loads and stores, from 0x28 on, by what is moved.
const WIDEST: [u64; 23] = [2, 3, 2, 3, 0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 2, 3, 2, 3, 0, 1, 0, 1, 2];

/// One instruction of any kind but a block.
fn instruction(out: &mut Vec<u8>, random: &mut Random) {
    match random.below(14) {
        0..4 => {
            out.push(0x20 + random.below(3) as u8);
            unsigned(out, random.number(9));
        }
        4 | 5 => {
            let op = random.below(23);
            out.push(0x28 + op as u8);
            let widest = WIDEST[op as usize];
            unsigned(out, if random.below(3) > 0 { widest } else { random.below(widest + 1) });
            unsigned(out, random.number(20));
        }
        6 => {
            out.push(0x41);
            let sign = if random.below(2) == 0 { 1 } else { -1 };
            signed(out, sign * random.number(31) as i64);
        }
        7 => {
            out.push(0x42);
            signed(out, random.0 as i64 >> random.below(64));
        }
        8 => {
            out.push(0x10);
            unsigned(out, random.number(15));
        }
        9 => out.push(*[0x00, 0x01, 0x0f, 0x1a, 0x1b].get(random.below(5) as usize).unwrap()),
        10 => {
            out.push(0x0c + random.below(2) as u8);
            unsigned(out, random.number(8));
        }
        11 => {
            let count = random.number(5);
            out.push(0x0e);
            unsigned(out, count);
            (0..=count).for_each(|_| unsigned(out, random.number(8)));
        }
        12 => match random.below(7) {
            0 => out.extend([0x43, 1, 2, 3, 200]),
            1 => out.extend([0x44, 1, 2, 3, 4, 5, 6, 7, 255]),
            2 => out.extend([0xfc, 10, 0, 0]),
            3 => out.extend([0xfc, 11, 0]),
            4 => out.extend([0xfc, random.below(8) as u8]),
            5 => out.extend([0x3f + random.below(2) as u8, 0]),
            _ => {
                out.push(0x11);
                unsigned(out, random.number(10));
                out.push(0);
            }
        },
        _ => out.push(0x45 + random.below(0xc4 - 0x45 + 1) as u8),
    }
}

/// Instructions up to the end of a block, with blocks in it.
fn block(out: &mut Vec<u8>, random: &mut Random, depth: u64) {
    for _ in 0..random.below(40) {
        if depth > 0 && random.below(8) == 0 {
            let op = 2 + random.below(3) as u8;
            out.extend([op, [0x40, 0x7f, 0x7e][random.below(3) as usize]]);
            block(out, random, depth - 1);
            if op == 4 && random.below(2) == 0 {
                *out.last_mut().unwrap() = 0x05;
                block(out, random, depth - 1);
            }
        } else {
            instruction(out, random);
        }
    }
    out.push(0x0b);
}

fn section(out: &mut Vec<u8>, id: u8, content: &[u8]) {
    out.push(id);
    unsigned(out, content.len() as u64);
    out.extend(content);
}

/// A module that is well formed, though it may not be valid.
fn module(random: &mut Random) -> Vec<u8> {
    let mut out = b"\0asm\x01\0\0\0".to_vec();
    // Functions of some types, and more calls than there are functions.
    section(&mut out, 1, &[3, 0x60, 0, 0, 0x60, 2, 0x7f, 0x7e, 1, 0x7f, 0x60, 1, 0x7f, 2, 0x7f, 0x7f]);
    let types: Vec<u8> = (0..20).map(|_| random.below(4) as u8).collect();
    section(&mut out, 3, &[&[20], &types[..]].concat());
    let mut code = Vec::new();
    let functions: Vec<Vec<u8>> = (0..random.below(20))
        .map(|_| {
            let mut body = Vec::new();
            let groups = random.below(4);
            unsigned(&mut body, groups);
            for _ in 0..groups {
                unsigned(&mut body, random.number(9));
                body.push(0x7f - random.below(4) as u8);
            }
            block(&mut body, random, 4);
            body
        })
        .collect();
    unsigned(&mut code, functions.len() as u64 * 2);
    for body in functions.iter().chain(&functions) {
        unsigned(&mut code, body.len() as u64);
        code.extend(body);
    }
    section(&mut out, 10, &code);
    let text = b"partition of unity; nonnegative; symmetric; ".repeat(random.below(5) as usize);
    let noise: Vec<u8> = (0..random.below(300)).map(|_| random.below(256) as u8).collect();
    section(&mut out, 11, &[&text[..], &noise].concat());
    out
}

#[test]
fn modules_come_back() {
    let mut random = Random(7);
    for round in 0..12 {
        let module = module(&mut random);
        let packed = pack(&module).unwrap();
        assert_eq!(unpack(&packed), Ok(module), "module {round}");
    }
}

/// A code section of functions without variables.
fn code(functions: &[&[u8]]) -> Vec<u8> {
    let mut content = vec![functions.len() as u8];
    for instructions in functions {
        content.extend([instructions.len() as u8 + 1, 0]);
        content.extend(*instructions);
    }
    let mut out = Vec::new();
    section(&mut out, 10, &content);
    out
}

const MISSING: &[u8] = &[0x00, 0x0b];

#[test]
fn parts_come_one_after_the_other() {
    let mut first = b"\0asm\x01\0\0\0".to_vec();
    section(&mut first, 1, &[2, 0x60, 0, 0, 0x60, 3, 0x7f, 0x7f, 0x7f, 0]);
    section(&mut first, 3, &[4, 0, 1, 0, 1]);
    first.extend(code(&[&[0x10, 1, 0x0b], MISSING, &[0x01, 0x0b], MISSING]));
    section(&mut first, 11, b"text of the first part");
    let later = code(&[&[0x41, 7, 0x21, 3, 0x0b]]);
    let mut last = code(&[&[0x41, 9, 0x22, 3, 0x1a, 0x0b]]);
    section(&mut last, 11, b"text of the last part");
    let packed = pack(&[&first[..], &later, &last].join(&PART)).unwrap();
    let mut parts = Parts::new(packed).unwrap();
    for part in [first, later, last] {
        assert_eq!(parts.next(), Ok(Some(part)));
    }
    assert_eq!(parts.next(), Ok(None));
}

#[test]
fn no_more_functions_come_than_are_missing() {
    let with = |functions: &[&[u8]]| {
        let mut module = b"\0asm\x01\0\0\0".to_vec();
        module.extend(code(&[MISSING, &[0x0b]]));
        module.push(PART);
        module.extend(code(functions));
        pack(&module).map(drop)
    };
    assert_eq!(with(&[&[0x01, 0x0b]]), Ok(()));
    // One that is still missing comes again.
    assert_eq!(with(&[MISSING, &[0x01, 0x0b]]), Ok(()));
    assert_eq!(with(&[&[0x01, 0x0b], &[0x01, 0x0b]]), Err(Damaged));
}

#[test]
fn repetitions_take_next_to_nothing() {
    let text = b"prove partition_of_unity; ".repeat(1000);
    let mut module = b"\0asm\x01\0\0\0".to_vec();
    section(&mut module, 11, &text);
    let packed = pack(&module).unwrap();
    assert_eq!(unpack(&packed).as_ref(), Ok(&module));
    assert!(packed.len() < 400, "{} of {} bytes", packed.len(), module.len());
}

/// A module with one function, which has two parameters and sets a number of variables to 0, each `by` further than the one
/// before it.
fn setting(count: u64, by: u64) -> Vec<u8> {
    let mut module = b"\0asm\x01\0\0\0".to_vec();
    section(&mut module, 1, &[1, 0x60, 2, 0x7f, 0x7f, 0]);
    section(&mut module, 3, &[1, 0]);
    let mut body = vec![0];
    for k in 0..count {
        body.extend([0x41, 0, 0x21]);
        unsigned(&mut body, 2 + (k * by) % count);
    }
    body.push(0x0b);
    let mut code = vec![1];
    unsigned(&mut code, body.len() as u64);
    code.extend(&body);
    section(&mut module, 10, &code);
    module
}

#[test]
fn variables_in_the_order_in_which_they_are_set_take_next_to_nothing() {
    let [ordered, mixed] = [1, 577].map(|by| setting(1000, by)).map(|module| {
        let packed = pack(&module).unwrap();
        assert_eq!(unpack(&packed).as_ref(), Ok(&module));
        packed.len()
    });
    assert!(ordered < 250 && ordered * 3 < mixed, "{ordered} and {mixed} bytes");
}

#[test]
fn types_that_are_damaged_are_packed_as_they_are() {
    for (types, functions) in
        [(&[9, 0x60][..], &[1, 7][..]), (&[], &[]), (&[1, 0x60, 0x80, 0x80, 0x80, 0x80, 0x80], &[2, 0])]
    {
        let mut module = b"\0asm\x01\0\0\0".to_vec();
        section(&mut module, 1, types);
        section(&mut module, 3, functions);
        section(&mut module, 10, &[1, 8, 0, 0x41, 0, 0x21, 0, 0x10, 9, 0x0b]);
        assert_eq!(unpack(&pack(&module).unwrap()), Ok(module));
    }
}

#[test]
fn what_the_compiler_of_the_engine_does_not_write_is_refused() {
    let with = |instruction: &[u8]| {
        let mut module = b"\0asm\x01\0\0\0".to_vec();
        let mut body = vec![0];
        body.extend(instruction);
        body.push(0x0b);
        let mut code = vec![1, body.len() as u8];
        code.extend(&body);
        section(&mut module, 10, &code);
        pack(&module).map(drop)
    };
    assert_eq!(with(&[0x01]), Ok(()));
    // A vector, `ref.null`, what no instruction begins with, an alignment that is too large, and calls far away.
    for unknown in
        [&[0xfd, 0x0c][..], &[0xd0, 0x70], &[0xff], &[0x28, 3, 0], &[0x10, 0x80, 0x80, 0x02], &[0xfc, 12, 0]]
    {
        assert_eq!(with(unknown), Err(Damaged), "{unknown:x?}");
    }
    assert_eq!(pack(b"\0asm"), Err(Damaged));
    assert_eq!(pack(b"\0asm\x01\0\0\0\x0a\x7f"), Err(Damaged));
}

#[test]
fn whatever_is_damaged_ends() {
    let mut random = Random(11);
    let whole = module(&mut random);
    let packed = pack(&whole).unwrap();
    // The coder may never look at its last bytes.
    for length in (0..packed.len() - 4).step_by(packed.len() / 8) {
        assert_ne!(unpack(&packed[..length]).as_ref(), Ok(&whole), "{length} of {} bytes", packed.len());
    }
    let mut errors = 0;
    for _ in 0..20 {
        let mut changed = packed.clone();
        for _ in 0..=random.below(3) {
            changed[random.below(packed.len() as u64) as usize] = random.below(256) as u8;
        }
        errors += usize::from(unpack(&changed).is_err());
    }
    assert!(errors > 10, "{errors} errors");
    assert_eq!(unpack(&[]), Err(Damaged));
}
