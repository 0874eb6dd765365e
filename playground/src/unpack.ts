// The engine and the page's script from their files, by the module that `packing` is compiled to. Two files, which are unpacked
// beside one another: the engine without its data, and these data, which are text for the most part, with the script.

interface Exports {
  memory: WebAssembly.Memory;
  room(length: number): number;
  packed(): number;
  unpacked(): number;
  result(): number;
}

/** Packs or unpacks bytes with an instance of `packing`, which does so once. */
export function turned(packing: WebAssembly.Instance, way: 'packed' | 'unpacked', bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const { memory, room, result, [way]: turn } = packing.exports as unknown as Exports;
  const place = room(bytes.length); // may move the memory
  new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
  const length = turn();
  if (length === 0) throw new Error(`the engine cannot be ${way}`);
  return new Uint8Array(memory.buffer as ArrayBuffer, result(), length);
}

/** Bytes of the header of a module. */
const HEADER = 8;

/**
 * The file with two sections: that of the engine's data, as it stands at the end of the engine, and one with the script. Both are
 * copies, so that the memory in which they were unpacked can go.
 */
export function parts(file: Uint8Array<ArrayBuffer>): { data: Uint8Array<ArrayBuffer>; script: Uint8Array<ArrayBuffer> } {
  /** Where the content of the section at a place begins and ends. */
  const section = (at: number): [number, number] => {
    let length = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = file[++at]!;
      length += (byte & 127) * scale;
      if (byte < 128) return [at + 1, at + 1 + length];
    }
  };
  const [, middle] = section(HEADER);
  const [start, end] = section(middle);
  return { data: file.slice(HEADER, middle), script: file.slice(start, end) };
}

/** The engine of its two parts. */
export function whole(code: Uint8Array, data: Uint8Array): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(code.length + data.length);
  all.set(code);
  all.set(data, code.length);
  return all;
}

/** A file of the page. */
export async function fetched(name: string): Promise<ArrayBuffer> {
  const answer = await fetch(name);
  if (!answer.ok) throw new Error(`${name} cannot be loaded: ${answer.status}`);
  return answer.arrayBuffer();
}
