// The engine in parts, the first of which is a module that answers the first questions before the others are there. Functions that
// it lacks are traps, and texts that it lacks lie where there is no memory: what would need them traps, and never answers wrongly.
import { after, bodies, code, data, HEADER, joined, sections, segments, signed, start, unsigned } from './module.mjs';

const [CODE, DATA, COUNT] = [10, 11, 12];
const I32_CONST = 0x41;
const LOADS = [0x28, 0x3e]; // and stores

/** The body of a function that comes later. */
const MISSING = Uint8Array.of(0, 0x00, 0x0b);
/** Bytes of functions in one part: what is unpacked in some ten milliseconds. */
const PART = 24_000;
/** An address behind all memory. */
const NOWHERE = 0xc000_0000;
/** The most bytes between two segments that are filled with zeros, or with what was there, rather than beginning another segment. */
const GAP = 400;

/** Runs of bytes that are wanted, with few others in between. */
function runs({ address, bytes }, wanted) {
  const all = [];
  let [from, to] = [0, -GAP - 1];
  for (let k = 0; k <= bytes.length; k++) {
    if (k < bytes.length && !wanted(k)) continue;
    if (k - to > GAP || k === bytes.length) {
      if (to > from) all.push({ address: address + from, bytes: bytes.slice(from, to) });
      from = k;
    }
    to = k + 1;
  }
  return all;
}

/** Fails where code knows one of the addresses, which only the data may name. */
function unnamed(functions, addresses) {
  for (const body of functions) {
    for (let at = start(body); at < body.length; at = after(body, at)) {
      const op = body[at];
      const known = op === I32_CONST ? signed(body, at + 1)[0] : op >= LOADS[0] && op <= LOADS[1] ? unsigned(body, at + 2)[0] : 0;
      if (addresses.has(known)) throw new Error(`a function has the address ${known} of a text`);
    }
  }
}

/** The data without texts, whose addresses lead nowhere; and what has to be put over these data. */
function without(content, texts, functions) {
  const all = segments(content);
  const less = all.map(({ address, bytes }) => ({ address, bytes: Uint8Array.from(bytes) }));
  const addresses = new Set();
  for (const text of texts) {
    const which = all.findIndex(({ bytes }) => Buffer.from(bytes).includes(text));
    if (which < 0) throw new Error('the engine does not hold a text');
    const place = Buffer.from(all[which].bytes).indexOf(text);
    less[which].bytes.fill(0, place, place + text.length);
    const address = all[which].address + place;
    addresses.add(address);
    let names = 0;
    for (const { bytes } of less) {
      const view = new DataView(bytes.buffer);
      for (let at = 0; at + 8 <= bytes.length; at += 4) {
        if (view.getUint32(at, true) !== address || view.getUint32(at + 4, true) !== text.length) continue;
        view.setUint32(at, NOWHERE, true);
        names += 1;
      }
    }
    if (names === 0) throw new Error('a text that nothing leads to');
  }
  unnamed(functions, addresses);
  return {
    first: less.flatMap((segment) => runs(segment, (k) => segment.bytes[k] !== 0)),
    later: all.flatMap((segment, i) => runs(segment, (k) => segment.bytes[k] !== less[i].bytes[k])),
  };
}

/**
 * The first part, a module with the functions of these numbers but without its data; these data, without the texts, as the section
 * that is its end; and the parts after it, code sections and at last a data section.
 */
export function divided(bytes, called, texts) {
  const all = sections(bytes).filter(({ id }) => id !== COUNT);
  const content = (id) => all.find((section) => section.id === id).content;
  const functions = bodies(content(CODE));
  const { first, later } = without(content(DATA), texts, functions);
  const early = code(functions.map((body, k) => (called.has(k) ? body : MISSING)));
  const rest = [[]];
  let size = 0;
  functions.forEach((body, k) => {
    // One that is nothing but a trap is as if it came later.
    if (called.has(k) && Buffer.compare(body, MISSING) !== 0) return;
    if (size > PART) {
      rest.push([]);
      size = 0;
    }
    rest.at(-1).push(body);
    size += body.length;
  });
  const part = (id, content) => joined([{ id, content }]).subarray(HEADER);
  return {
    first: joined(all.filter(({ id }) => id !== DATA).map(({ id, content }) => ({ id, content: id === CODE ? early : content }))),
    data: part(DATA, data(first)),
    later: [...rest.map((some) => part(CODE, code(some))), part(DATA, data(later))],
  };
}
