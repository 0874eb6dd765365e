// The engine and the page's script from their files, by the module that `packing` is compiled to. The engine comes in parts, as
// `pack/parts.mjs` makes them: the first is a module that answers the first questions, in which functions that come later trap. Its
// data, which are text for the most part, come with the script.

interface Exports {
  memory: WebAssembly.Memory;
  room(length: number): number;
  packed(): number;
  unpacked(): number;
  result(): number;
}

type Bytes = Uint8Array<ArrayBuffer>;

/** Packs bytes, or unpacks their first part, with an instance of `packing` of its own. */
export function turned(packing: WebAssembly.Instance, way: 'packed' | 'unpacked', bytes: Uint8Array): Bytes {
  const { memory, room } = packing.exports as unknown as Exports;
  const place = room(bytes.length); // may move the memory
  new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
  return next(packing, way);
}

/** Unpacks the next part. */
export function next(packing: WebAssembly.Instance, way: 'packed' | 'unpacked' = 'unpacked'): Bytes {
  const { memory, result, [way]: turn } = packing.exports as unknown as Exports;
  const length = turn();
  if (length === 0) throw new Error(`the engine cannot be ${way}`);
  // A copy: the memory moves, and can go.
  return new Uint8Array(memory.buffer as ArrayBuffer, result(), length).slice();
}

/** Bytes of the header of a module. */
const HEADER = 8;
const CODE = 10;
const DATA = 11;

/** An unsigned number of variable length at a place; the place after it. */
function unsigned(bytes: Bytes, at: number): [number, number] {
  let value = 0;
  for (let scale = 1; ; scale *= 128) {
    const byte = bytes[at++]!;
    value += (byte & 127) * scale;
    if (byte < 128) return [value, at];
  }
}

/** The bytes of an unsigned number of variable length. */
function encoded(value: number): number[] {
  return value > 127 ? [(value % 128) | 128, ...encoded(Math.floor(value / 128))] : [value];
}

/** The sections from a place on, each with its number. */
function sections(bytes: Bytes, from: number): [number, Bytes][] {
  const all: [number, Bytes][] = [];
  for (let at = from; at < bytes.length;) {
    const id = bytes[at]!;
    const [length, start] = unsigned(bytes, at + 1);
    at = start + length;
    all.push([id, bytes.subarray(start, at)]);
  }
  return all;
}

/** The functions of a code section, each with its length before it. */
function functions(content: Bytes): Bytes[] {
  const all: Bytes[] = [];
  for (let [, at] = unsigned(content, 0); at < content.length;) {
    const [length, start] = unsigned(content, at);
    all.push(content.subarray(at, start + length));
    at = start + length;
  }
  return all;
}

/** The file with two sections: that of the first data of the engine, as it stands at the end of a module, and one with the script. */
export function contents(file: Bytes): { data: Bytes; script: Bytes } {
  const [[, data], [, script]] = sections(file, HEADER) as [[number, Bytes], [number, Bytes]];
  return { data: file.slice(HEADER, data.byteOffset - file.byteOffset + data.length), script };
}

/** Bytes after one another. */
export function joined(first: Bytes, second: Bytes): Bytes {
  const all = new Uint8Array(first.length + second.length);
  all.set(first);
  all.set(second, first.length);
  return all;
}

/** Whether a part is the last one: the only one with data. */
export function last(part: Bytes): boolean {
  return part[0] === DATA;
}

/** The engine of its parts, the first with its data. */
export function whole(first: Bytes, later: Bytes[]): Blob {
  const all = later.flatMap((part) => sections(part, 0));
  const of = (wanted: number): Bytes[] => all.filter(([id]) => id === wanted).map(([, content]) => content);
  const missing = of(CODE).flatMap(functions).values();
  const list = (id: number, content: Bytes): (number[] | Bytes)[] => {
    const [count, start] = unsigned(content, 0);
    if (id === CODE) return [encoded(count), ...functions(content).map((f) => (f.length === 4 && f[2] === 0 ? missing.next().value! : f))];
    if (id !== DATA) return [content];
    const [[more, next], data] = [unsigned(of(DATA)[0]!, 0), of(DATA)[0]!];
    return [encoded(count + more), content.subarray(start), data.subarray(next)];
  };
  const parts = sections(first, HEADER).flatMap(([id, content]) => {
    const parts = list(id, content);
    return [[id, ...encoded(parts.reduce((sum, { length }) => sum + length, 0))], ...parts];
  });
  return new Blob([first.subarray(0, HEADER), ...parts.map((part) => (part instanceof Uint8Array ? part : Uint8Array.from(part)))]);
}

/** A file of the page. */
export async function fetched(name: string): Promise<ArrayBuffer> {
  const answer = await fetch(name);
  if (!answer.ok) throw new Error(`${name} cannot be loaded: ${answer.status}`);
  return answer.arrayBuffer();
}
