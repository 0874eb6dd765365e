// The functions of a WebAssembly module as streams of the same kind each: instructions, variables, numbers, places in memory.
// LZMA makes a tenth less of them than of the module, in which they alternate. One way of reading instructions serves both
// directions: what is taken from the module and given to the streams when the page is built goes back when it is opened.
// https://webassembly.github.io/spec/core/binary

/** What streams hold. The last one has all that is rare, and the sections without functions. */
export const STREAMS = 10;
const [OPERATIONS, VARIABLES, NUMBERS, LONG, OFFSETS, CALLS, JUMPS, KINDS, DECLARED, REST] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9];

const CODE = 10;
/** Loads and stores are 0x28 to 0x3e; mostly places in memory are aligned to 2^k bytes by the size of what lies there. */
const LOAD = 0x28;
const USUAL = [2, 3, 2, 3, 0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 2, 3, 2, 3, 0, 1, 0, 1, 2];
const memory = (op: number): boolean => op >= LOAD && op < LOAD + USUAL.length;
/** Loads and stores with smaller alignments, which in their stream are operations of their own, from this number on. */
const OTHER = 0xc5;
const SMALLER = USUAL.flatMap((usual, k) => Array.from({ length: usual }, (_, align) => [LOAD + k, align] as const));

/** Bytes that are read or written one after the other. */
export class Tape {
  at = 0;

  constructor(private bytes: Uint8Array<ArrayBuffer> = new Uint8Array(1 << 16)) {}

  next(): number {
    if (this.at >= this.bytes.length) throw new Error('the module ends too early');
    return this.bytes[this.at++]!;
  }

  put(byte: number): void {
    if (this.at >= this.bytes.length) {
      const more = new Uint8Array(2 * this.bytes.length);
      more.set(this.bytes);
      this.bytes = more;
    }
    this.bytes[this.at++] = byte;
  }

  /** An unsigned number of variable length. */
  number(): number {
    let value = 0;
    for (let scale = 1; scale < 2 ** 35; scale *= 128) {
      const byte = this.next();
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
    throw new Error('no number of 32 bits');
  }

  putNumber(value: number): void {
    for (; value > 127; value = Math.floor(value / 128)) this.put((value % 128) | 128);
    this.put(value);
  }

  putAll(other: Uint8Array): void {
    for (let k = 0; k < other.length; k++) this.put(other[k]!);
  }

  get ended(): boolean {
    return this.at >= this.bytes.length;
  }

  /** What was written. */
  get written(): Uint8Array<ArrayBuffer> {
    return this.bytes.subarray(0, this.at);
  }
}

/** From where to where the parts of functions go. */
interface Way {
  from(stream: number): Tape;
  to(stream: number): Tape;
  /** The operation that comes next. */
  operation(): number;
}

/** One function: its variables, and instructions up to the end of the outermost block. */
function body(way: Way): void {
  /** A number of variable length goes over as it is; its value, as far as it is needed. */
  const move = (stream: number): number => {
    const [from, to] = [way.from(stream), way.to(stream)];
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = from.next();
      to.put(byte);
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
  };
  const bytes = (stream: number, count: number): void => {
    for (; count > 0; count--) way.to(stream).put(way.from(stream).next());
  };
  for (let groups = move(DECLARED); groups > 0; groups--) {
    move(DECLARED);
    bytes(DECLARED, 1);
  }
  for (let depth = 1; depth > 0;) {
    const op = way.operation();
    if (op >= 0x20 && op <= 0x22) move(VARIABLES);
    else if (memory(op)) move(OFFSETS);
    else if (op === 0x41) move(NUMBERS);
    else if (op === 0x10) move(CALLS);
    else if (op === 0x0c || op === 0x0d) move(JUMPS);
    else if (op === 0x0b) depth -= 1;
    else if (op === 0x02 || op === 0x03 || op === 0x04) {
      depth += 1;
      move(KINDS); // what the block leaves
    } else if (op === 0x0e) {
      for (let count = move(JUMPS); count >= 0; count--) move(JUMPS);
    } else if (op === 0x11) {
      move(CALLS);
      move(CALLS);
    } else if (op === 0x42) move(LONG);
    else if (op === 0x23 || op === 0x24 || op === 0x3f || op === 0x40) move(KINDS);
    else if (op === 0x43) bytes(LONG, 4);
    else if (op === 0x44) bytes(LONG, 8);
    else if (op === 0xfc) {
      const which = move(LONG);
      if (which === 10) bytes(LONG, 2); // memory.copy
      else if (which === 11) bytes(LONG, 1); // memory.fill
      else if (which > 7) throw new Error(`no instruction that is known: 0xfc ${which}`);
    } else if (!(op <= 0x01 || op === 0x05 || op === 0x0f || op === 0x1a || op === 0x1b || (op >= 0x45 && op <= 0xc4))) {
      throw new Error(`no instruction that is known: ${op}`);
    }
  }
}

/** The streams of a module. What is not as the compiler of the engine writes it, such as vectors, is an error. */
export function split(module: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer>[] {
  const from = new Tape(module);
  const streams = Array.from({ length: STREAMS }, () => new Tape());
  const rest = streams[REST]!;
  const operation = (): number => {
    const op = from.next();
    let written = op;
    if (memory(op)) {
      const align = from.next();
      if (align !== USUAL[op - LOAD]) {
        const k = SMALLER.findIndex(([smaller, by]) => smaller === op && by === align);
        if (k < 0) throw new Error(`no alignment: ${align}`);
        written = OTHER + k;
      }
    }
    streams[OPERATIONS]!.put(written);
    return op;
  };
  const way: Way = { from: () => from, to: (stream) => streams[stream]!, operation };
  for (let k = 0; k < 8; k++) rest.put(from.next());
  while (!from.ended) {
    const id = from.next();
    const length = from.number();
    rest.put(id);
    if (id !== CODE) {
      rest.putNumber(length);
      for (let k = 0; k < length; k++) rest.put(from.next());
      continue;
    }
    let count = from.number();
    rest.putNumber(count);
    for (; count > 0; count--) {
      from.number(); // how long the function is follows from its instructions
      body(way);
    }
  }
  return streams.map((stream) => stream.written);
}

/** The module of streams. */
export function join(streams: Uint8Array<ArrayBuffer>[]): Uint8Array<ArrayBuffer> {
  const from = streams.map((stream) => new Tape(stream));
  const rest = from[REST]!;
  const module = new Tape(new Uint8Array(1 << 22));
  const single = new Tape();
  const operation = (): number => {
    const written = from[OPERATIONS]!.next();
    const [op, align] = SMALLER[written - OTHER] ?? [written, USUAL[written - LOAD] ?? 0];
    single.put(op);
    if (memory(op)) single.put(align);
    return op;
  };
  const way: Way = { from: (stream) => from[stream]!, to: () => single, operation };
  for (let k = 0; k < 8; k++) module.put(rest.next());
  while (!rest.ended) {
    const id = rest.next();
    module.put(id);
    if (id !== CODE) {
      let length = rest.number();
      module.putNumber(length);
      for (; length > 0; length--) module.put(rest.next());
      continue;
    }
    const all = new Tape(new Uint8Array(1 << 22));
    let count = rest.number();
    all.putNumber(count);
    for (; count > 0; count--) {
      single.at = 0;
      body(way);
      all.putNumber(single.at);
      all.putAll(single.written);
    }
    module.putNumber(all.at);
    module.putAll(all.written);
  }
  return module.written;
}
