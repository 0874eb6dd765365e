// The engine from its file, by the module that `packing` is compiled to.

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
