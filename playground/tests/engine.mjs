// The engine as it lies in dist/, asked without a page. `npm run build` comes first.
import fs from 'node:fs';
import { load } from './bundle.mjs';

const dist = (name) => Uint8Array.from(fs.readFileSync(new URL(`../dist/${name}`, import.meta.url)));

/** The module that the worker makes of the files. */
export async function module() {
  const { parts, turned, whole } = await load('unpack.ts');
  const unpacked = async (name) => turned((await WebAssembly.instantiate(dist('packing.wasm'), {})).instance, 'unpacked', dist(name));
  return whole(await unpacked('engine.packed'), parts(await unpacked('page.packed')).data);
}

/** What answers questions, as `playground/engine` lists them. */
export async function engine() {
  const { instance } = await WebAssembly.instantiate(await module(), {});
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
