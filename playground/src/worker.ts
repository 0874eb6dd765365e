// The engine beside the page: answers questions, and decides the claims of the open spec in slices in between, so that a
// newer text stops the work on an older one.
import type { Item, Question, Reply, Request, Verdicts } from './protocol';
import { fetched, turned, whole } from './unpack';

interface Exports {
  memory: WebAssembly.Memory;
  alloc(length: number): number;
  answer(): number;
  text(): number;
  free(): void;
}

/** Milliseconds of deciding before messages are looked at again. */
const SLICE = 25;
/** Milliseconds between two reports of what is known so far. */
const REPORT = 250;
/** Milliseconds of deciding after which a spec is left as it is. */
const LIMIT = 30_000;

const say = (reply: Reply): void => postMessage(reply);
const channel = new MessageChannel();
let engine: Exports | undefined;
/** The engine's data, which the page unpacks. */
let bring: (data: Uint8Array<ArrayBuffer>) => void;
const data = new Promise<Uint8Array<ArrayBuffer>>((resolve) => { bring = resolve; });
let waiting: Question[] = [];
/** Why there is no engine. */
let broken = '';
/** What is being decided. */
let job: { version: number; spent: number; reported: number; decided: number } | undefined;

// The handler stands before anything is awaited: what arrives meanwhile would be lost otherwise.
onmessage = ({ data }: MessageEvent<Request>) => {
  if (data.kind === 'data') bring(data.data);
  else if (broken) say({ kind: 'failed', message: broken });
  else if (engine) handle(data);
  else waiting.push(data);
};
channel.port1.onmessage = slice;

function ask(question: Record<string, unknown>): any {
  if (!engine) throw new Error('the engine is not there');
  const bytes = new TextEncoder().encode(JSON.stringify(question));
  const place = engine.alloc(bytes.length);
  new Uint8Array(engine.memory.buffer, place, bytes.length).set(bytes);
  const length = engine.answer();
  const answer = new TextDecoder().decode(new Uint8Array(engine.memory.buffer, engine.text(), length));
  engine.free();
  return JSON.parse(answer);
}

function handle(request: Question): void {
  try {
    if (request.kind === 'ask') {
      say({ kind: 'answer', id: request.id, answer: ask(request.question) });
      return;
    }
    job = undefined;
    const start = performance.now();
    const opened: { items: Item[]; claims: number } = ask({ ask: 'open', text: request.text });
    job = { version: request.version, spent: performance.now() - start, reported: 0, decided: 0 };
    say({ kind: 'opened', version: request.version, ...opened });
    slice();
  } catch (error) {
    say({ kind: 'failed', message: String(error) });
  }
}

function slice(): void {
  if (!job) return;
  const start = performance.now();
  let more = true;
  try {
    while (more && performance.now() - start < SLICE) {
      const answer: { decided: number; more: boolean } = ask({ ask: 'decide' });
      ({ more } = answer);
      job.decided = answer.decided;
    }
    job.spent += performance.now() - start;
    const stopped = more && job.spent > LIMIT;
    if (!more || stopped || job.spent - job.reported > REPORT) {
      job.reported = job.spent;
      const verdicts: Verdicts = ask({ ask: 'verdicts' });
      say({ kind: 'verdicts', version: job.version, decided: job.decided, verdicts, milliseconds: job.spent, stopped });
    } else {
      say({ kind: 'alive' });
    }
    if (more && !stopped) channel.port2.postMessage(null);
    else job = undefined;
  } catch (error) {
    job = undefined;
    say({ kind: 'failed', message: String(error) });
  }
}

async function load(): Promise<void> {
  try {
    const [packing, packed] = await Promise.all(['packing.wasm', 'engine.packed'].map(fetched));
    const unpacker = await WebAssembly.instantiate(packing!, {});
    const code = turned(unpacker.instance, 'unpacked', new Uint8Array(packed!));
    const { instance } = await WebAssembly.instantiate(whole(code, await data), {});
    engine = instance.exports as unknown as Exports;
    say({ kind: 'ready' });
    const all = waiting;
    waiting = [];
    all.forEach(handle);
  } catch (error) {
    broken = String(error);
    say({ kind: 'failed', message: broken });
  }
}
void load();
