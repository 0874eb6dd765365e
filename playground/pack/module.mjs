// A WebAssembly module as it lies in its file: sections, the bodies of functions, single instructions.
// https://webassembly.github.io/spec/core/binary

/** An unsigned number of variable length at a place; the place after it. */
export function unsigned(bytes, at) {
  let value = 0;
  for (let scale = 1; ; scale *= 128) {
    const byte = bytes[at++];
    value += (byte & 127) * scale;
    if (byte < 128) return [value, at];
  }
}

/** The bytes of an unsigned number of variable length. */
export function encoded(value) {
  const bytes = [];
  for (; value > 127; value = Math.floor(value / 128)) bytes.push((value % 128) | 128);
  return [...bytes, value];
}

/** A signed number of 32 bits at a place; the place after it. */
export function signed(bytes, at) {
  let value = 0;
  let shift = 0;
  let byte;
  do {
    byte = bytes[at++];
    value |= (byte & 127) << shift;
    shift += 7;
  } while (byte > 127);
  return [shift < 32 && byte & 64 ? value | (-1 << shift) : value, at];
}

/** Bytes of the header of a module. */
export const HEADER = 8;

/** The sections, each with its number and its content. */
export function sections(bytes) {
  const all = [];
  for (let at = HEADER; at < bytes.length;) {
    const id = bytes[at];
    const [length, start] = unsigned(bytes, at + 1);
    all.push({ id, content: bytes.subarray(start, start + length) });
    at = start + length;
  }
  return all;
}

/** A module of sections. */
export function joined(all) {
  const parts = [Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0)];
  for (const { id, content } of all) parts.push(Uint8Array.from([id, ...encoded(content.length)]), content);
  return Uint8Array.from(Buffer.concat(parts));
}

/** The bodies in a code section. */
export function bodies(content) {
  let [count, at] = unsigned(content, 0);
  const all = [];
  for (; count > 0; count--) {
    const [length, start] = unsigned(content, at);
    all.push(content.subarray(start, start + length));
    at = start + length;
  }
  return all;
}

/** A code section of bodies. */
export function code(all) {
  const parts = [Uint8Array.from(encoded(all.length))];
  for (const body of all) parts.push(Uint8Array.from(encoded(body.length)), body);
  return Uint8Array.from(Buffer.concat(parts));
}

/** Where data lies in memory: address, length, and the bytes. */
export function segments(content) {
  let [count, at] = unsigned(content, 0);
  const all = [];
  for (; count > 0; count--) {
    // Mode 0, `i32.const address`, end.
    if (content[at] !== 0 || content[at + 1] !== 0x41) throw new Error('data at no fixed address');
    const [address, end] = signed(content, at + 2);
    const [length, start] = unsigned(content, end + 1);
    all.push({ address, bytes: content.subarray(start, start + length) });
    at = start + length;
  }
  return all;
}

/** A data section of what lies in memory. */
export function data(all) {
  const parts = [Uint8Array.from(encoded(all.length))];
  for (const { address, bytes } of all) {
    const bits = encoded(address);
    // The sign is the second highest bit of the last byte.
    if (bits.at(-1) & 64) bits.push(bits.pop() | 128, 0);
    parts.push(Uint8Array.from([0, 0x41, ...bits, 0x0b, ...encoded(bytes.length)]), bytes);
  }
  return Uint8Array.from(Buffer.concat(parts));
}

/** Where the instructions of a body begin, after its local variables. */
export function start(body) {
  let [count, at] = unsigned(body, 0);
  for (; count > 0; count--) at = unsigned(body, at)[1] + 1;
  return at;
}

/** The place after an instruction. What the Rust compiler does not write is an error. */
export function after(body, at) {
  const op = body[at++];
  const number = () => { while (body[at++] > 127); };
  if (op === 0x02 || op === 0x03 || op === 0x04) { number(); return at; } // block, loop, if
  if (op === 0x0c || op === 0x0d || op === 0x10 || (op >= 0x20 && op <= 0x26)) { number(); return at; }
  if (op === 0x0e) { // br_table
    let count;
    [count, at] = unsigned(body, at);
    for (; count >= 0; count--) number();
    return at;
  }
  if (op === 0x11) { number(); number(); return at; } // call_indirect
  if (op >= 0x28 && op <= 0x3e) { number(); number(); return at; } // loads and stores
  if (op === 0x3f || op === 0x40) return at + 1;
  if (op === 0x41 || op === 0x42) { number(); return at; }
  if (op === 0x43) return at + 4;
  if (op === 0x44) return at + 8;
  if (op === 0xfc) {
    const [which, next] = unsigned(body, at);
    if (which <= 7) return next;
    if (which === 10) return next + 2; // memory.copy
    if (which === 11) return next + 1; // memory.fill
  } else if (op === 0xfd) { // vectors
    let which;
    [which, at] = unsigned(body, at);
    const [whole, lane] = [which <= 11 || which === 92 || which === 93, which >= 84 && which <= 91]; // loads and stores
    if (whole || lane) { number(); number(); }
    if (which === 12 || which === 13) return at + 16; // v128.const, i8x16.shuffle
    return lane || (which >= 21 && which <= 34) ? at + 1 : at;
  } else if (op <= 0xc4 && op !== 0x1c && (op < 0x05 || op === 0x05 || op === 0x0b || op === 0x0f || op === 0x1a || op === 0x1b || op >= 0x45)) {
    return at;
  }
  throw new Error(`no instruction that is known: 0x${op.toString(16)} 0x${body[at].toString(16)}`);
}
