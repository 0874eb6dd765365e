// LZMA, which no browser decodes: the engine is a quarter smaller by it than by gzip. The format, and the names used here, are
// those of `lzma-specification.txt`, https://www.7-zip.org/sdk.html. The package lzma1 encodes when the page is built; it decodes
// as well, but takes twice as long, and every visitor waits for it.

/** Probabilities are numbers of 11 bits, and move by 1/32 of what is missing. */
const HALF = 1 << 10;

class Range {
  private range = 0xffffffff;
  private code = 0;

  constructor(private readonly input: Uint8Array, private at: number) {
    // The first of the five bytes is zero.
    for (let i = 0; i < 5; i++) this.code = ((this.code << 8) | this.next()) >>> 0;
  }

  private next(): number {
    if (this.at >= this.input.length) throw new Error('the compressed data ends too early');
    return this.input[this.at++]!;
  }

  private normalize(): void {
    if (this.range < 0x1000000) {
      this.range = (this.range << 8) >>> 0;
      this.code = ((this.code << 8) | this.next()) >>> 0;
    }
  }

  bit(probabilities: Uint16Array, i: number): number {
    const p = probabilities[i]!;
    const bound = (this.range >>> 11) * p;
    let bit = 0;
    if (this.code < bound) {
      this.range = bound;
      probabilities[i] = p + ((2048 - p) >> 5);
    } else {
      this.range -= bound;
      this.code -= bound;
      probabilities[i] = p - (p >> 5);
      bit = 1;
    }
    this.normalize();
    return bit;
  }

  /** A number with `bits` bits from the highest down, each with the probability of what came before it. */
  tree(probabilities: Uint16Array, base: number, bits: number): number {
    let m = 1;
    for (let i = 0; i < bits; i++) m = (m << 1) | this.bit(probabilities, base + m);
    return m - (1 << bits);
  }

  /** The same from the lowest bit up. */
  reverse(probabilities: Uint16Array, base: number, bits: number): number {
    let m = 1;
    let value = 0;
    for (let i = 0; i < bits; i++) {
      const bit = this.bit(probabilities, base + m);
      m = (m << 1) | bit;
      value |= bit << i;
    }
    return value;
  }

  /** A number with `bits` bits of equal probabilities. */
  direct(bits: number): number {
    let value = 0;
    for (let i = 0; i < bits; i++) {
      this.range >>>= 1;
      const bit = this.code >= this.range ? 1 : 0;
      if (bit) this.code -= this.range;
      value = value * 2 + bit;
      this.normalize();
    }
    return value;
  }
}

const probabilities = (length: number): Uint16Array => new Uint16Array(length).fill(HALF);

/** Lengths of matches: [choice, choice 2], 16 × 8 low, 16 × 8 middle, 256 high ones. */
class Lengths {
  private readonly choice = probabilities(2);
  private readonly low = probabilities(16 << 3);
  private readonly mid = probabilities(16 << 3);
  private readonly high = probabilities(256);

  read(range: Range, position: number): number {
    if (!range.bit(this.choice, 0)) return 2 + range.tree(this.low, position << 3, 3);
    if (!range.bit(this.choice, 1)) return 10 + range.tree(this.mid, position << 3, 3);
    return 18 + range.tree(this.high, 0, 8);
  }
}

/** The most bytes that are made of a file: far more than the engine has. */
const MAX = 1 << 26;

/** The bytes of a file `.lzma` whose header says how many they are. */
export function decode(file: Uint8Array): Uint8Array<ArrayBuffer> {
  const header = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const properties = file[0] ?? 255;
  if (file.length < 18 || properties >= 9 * 5 * 5) throw new Error('this is no LZMA file');
  const size = header.getUint32(5, true);
  if (header.getUint32(9, true) !== 0 || size > MAX) throw new Error('the LZMA file does not say how long its content is');
  const lc = properties % 9;
  const lp = Math.floor(properties / 9) % 5;
  const pb = Math.floor(properties / 45);
  const out = new Uint8Array(size);
  const range = new Range(file, 13);
  const literals = probabilities(0x300 << (lc + lp));
  const isMatch = probabilities(12 << 4);
  const isRep = probabilities(12);
  const isRep0 = probabilities(12);
  const isRep1 = probabilities(12);
  const isRep2 = probabilities(12);
  const isRep0Long = probabilities(12 << 4);
  const slots = probabilities(4 << 6);
  const special = probabilities(128);
  const align = probabilities(16);
  const lengths = new Lengths();
  const repLengths = new Lengths();
  let [rep0, rep1, rep2, rep3] = [1, 1, 1, 1];
  let state = 0;
  let at = 0;
  while (at < size) {
    const position = at & ((1 << pb) - 1);
    if (!range.bit(isMatch, (state << 4) + position)) {
      const before = at > 0 ? out[at - 1]! : 0;
      const base = 0x300 * (((at & ((1 << lp) - 1)) << lc) + (before >> (8 - lc)));
      let symbol = 1;
      if (state >= 7) {
        let match = out[at - rep0]!;
        while (symbol < 0x100) {
          const expected = (match >> 7) & 1;
          match <<= 1;
          const bit = range.bit(literals, base + ((1 + expected) << 8) + symbol);
          symbol = (symbol << 1) | bit;
          if (bit !== expected) break;
        }
      }
      while (symbol < 0x100) symbol = (symbol << 1) | range.bit(literals, base + symbol);
      out[at++] = symbol;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let length;
    if (range.bit(isRep, state)) {
      if (!range.bit(isRep0, state)) {
        if (!range.bit(isRep0Long, (state << 4) + position)) length = 1;
      } else if (!range.bit(isRep1, state)) {
        [rep0, rep1] = [rep1, rep0];
      } else if (!range.bit(isRep2, state)) {
        [rep0, rep1, rep2] = [rep2, rep0, rep1];
      } else {
        [rep0, rep1, rep2, rep3] = [rep3, rep0, rep1, rep2];
      }
      if (length === 1) {
        state = state < 7 ? 9 : 11;
      } else {
        length = repLengths.read(range, position);
        state = state < 7 ? 8 : 11;
      }
    } else {
      [rep1, rep2, rep3] = [rep0, rep1, rep2];
      length = lengths.read(range, position);
      state = state < 7 ? 7 : 10;
      const slot = range.tree(slots, Math.min(length - 2, 3) << 6, 6);
      if (slot < 4) {
        rep0 = slot + 1;
      } else {
        const bits = (slot >> 1) - 1;
        const high = (2 | (slot & 1)) * 2 ** bits;
        rep0 = 1 + high + (slot < 14
          ? range.reverse(special, high - slot, bits)
          : range.direct(bits - 4) * 16 + range.reverse(align, 0, 4));
      }
    }
    if (rep0 > at || length > size - at) throw new Error('the compressed data is damaged');
    for (const end = at + length; at < end; at++) out[at] = out[at - rep0]!;
  }
  return out;
}
