// Starts the engine while the page itself is still being read, and unpacks its first data and the page's script beside it.
import { contents, fetched, turned } from './unpack';

const worker = new Worker('worker.js');

async function load(): Promise<void> {
  try {
    const [packing, packed] = await Promise.all(['packing.wasm', 'page.packed'].map(fetched));
    const { instance } = await WebAssembly.instantiate(packing!, {});
    const { data, script } = contents(turned(instance, 'unpacked', new Uint8Array(packed!)));
    worker.postMessage({ kind: 'data', data });
    Object.assign(globalThis, { basis: { worker, data } });
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
