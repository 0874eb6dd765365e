// The engine as it lies in dist/, asked without a page. `npm run build` comes first.
import fs from 'node:fs';
import { load } from './bundle.mjs';

const dist = (name) => Uint8Array.from(fs.readFileSync(new URL(`../dist/${name}`, import.meta.url)));

/** The parts that the worker unpacks, and the module that it makes of all of them. */
export async function parts() {
  const { contents, joined, last, next, turned, whole } = await load('unpack.ts');
  const unpacking = async () => (await WebAssembly.instantiate(dist('packing.wasm'), {})).instance;
  const { data } = contents(turned(await unpacking(), 'unpacked', dist('page.packed')));
  const instance = await unpacking();
  const first = joined(turned(instance, 'unpacked', dist('engine.packed')), data);
  const later = [];
  do later.push(next(instance)); while (!last(later.at(-1)));
  return { first, whole: new Uint8Array(await whole(first, later).arrayBuffer()) };
}

/** What answers questions, as `playground/engine` lists them: all of the engine, or another module. */
export async function engine(module) {
  const { instance } = await WebAssembly.instantiate(module ?? (await parts()).whole, {});
  return (question) => {
    const { alloc, answer, text, free, memory } = instance.exports;
    const bytes = new TextEncoder().encode(JSON.stringify(question));
    const place = alloc(bytes.length); // may move the memory
    new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
    const length = answer();
    const reply = JSON.parse(new TextDecoder().decode(new Uint8Array(memory.buffer, text(), length)));
    free();
    return reply;
  };
}
