// Asks for all files of the page at once, before the page itself is read. The worker unpacks the engine; beside it, the page's script
// and the engine's first data are unpacked here.
import type { Part } from './protocol';
import { contents, fetched, turned } from './unpack';

const files = Promise.all(['packing.wasm', 'engine.packed', 'page.packed'].map(fetched));
const worker = new Worker('worker.js');

async function load(): Promise<void> {
  try {
    const [code, packed, page] = await files;
    const packing = await WebAssembly.compile(code!);
    const engine: Part = { kind: 'engine', packing, packed: packed! };
    worker.postMessage(engine);
    const { data, script } = contents(turned(await WebAssembly.instantiate(packing, {}), 'unpacked', new Uint8Array(page!)));
    const first: Part = { kind: 'data', data };
    worker.postMessage(first);
    Object.assign(globalThis, { basis: { worker, parts: [engine, first] } });
    const element = document.createElement('script');
    element.src = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
    if (document.readyState === 'loading') await new Promise((resolve) => document.addEventListener('DOMContentLoaded', resolve));
    document.body.append(element);
  } catch (error) {
    document.addEventListener('DOMContentLoaded', () => say(error));
    if (document.readyState !== 'loading') say(error);
  }
}

function say(error: unknown): void {
  document.querySelector('#status')!.textContent = `the page cannot be loaded: ${error}`;
}

void load();
