// The engine beside the page: answers questions, and decides the claims of the open spec in slices in between, so that a
// newer text stops the work on an older one. The first part of the engine answers while the others are unpacked. Where it traps,
// for it lacks a function or a text, the question is asked again when all is there.
import type { Item, Part, Question, Reply, Request, Verdicts } from './protocol';
import { joined, last, next, turned, whole } from './unpack';

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
/** Questions besides texts that the first part of the engine answers; it is not asked others. */
const EARLY: unknown[] = ['spec', 'draw'];

const say = (reply: Reply): void => postMessage(reply);
const deciding = new MessageChannel();
const unpacking = new MessageChannel();
/** The first part of the engine, and then all of it; nothing between a trap of the first part and then. */
let engine: Exports | undefined;
let complete = false;
/** The parts of the engine that the page brings. */
const bring = {} as { [K in Part['kind']]: (part: Extract<Part, { kind: K }>) => void };
const brought = {
  engine: new Promise<Extract<Part, { kind: 'engine' }>>((resolve) => { bring.engine = resolve; }),
  data: new Promise<Extract<Part, { kind: 'data' }>>((resolve) => { bring.data = resolve; }),
};
let waiting: Question[] = [];
/** Why there is no engine. */
let broken = '';
/** The text that is open. */
let text: string | undefined;
/** What is being decided. */
let job: { version: number; spent: number; reported: number; decided: number } | undefined;

// The handler stands before anything is awaited: what arrives meanwhile would be lost otherwise.
onmessage = ({ data }: MessageEvent<Request>) => {
  if (data.kind === 'engine') bring.engine(data);
  else if (data.kind === 'data') bring.data(data);
  else handle(data);
};
deciding.port1.onmessage = slice;

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
  if (broken) return say({ kind: 'failed', message: broken });
  if (!engine || (!complete && request.kind === 'ask' && !EARLY.includes(request.question['ask']))) {
    waiting.push(request);
    return;
  }
  try {
    if (request.kind === 'ask') {
      say({ kind: 'answer', id: request.id, answer: ask(request.question) });
      return;
    }
    job = undefined;
    const start = performance.now();
    const opened: { items: Item[]; claims: number } = ask({ ask: 'open', text: request.text });
    text = request.text;
    job = { version: request.version, spent: performance.now() - start, reported: 0, decided: 0 };
    say({ kind: 'opened', version: request.version, ...opened });
    slice();
  } catch (error) {
    failed(error, request);
  }
}

/** A question that the first part could not answer waits for the others; another failure is the end. */
function failed(error: unknown, request?: Question): void {
  if (!complete && error instanceof WebAssembly.RuntimeError) {
    engine = undefined;
    if (request) waiting.push(request);
    return;
  }
  job = undefined;
  say({ kind: 'failed', message: String(error) });
}

function slice(): void {
  if (!job || !engine) return;
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
    if (more && !stopped) deciding.port2.postMessage(null);
    else job = undefined;
  } catch (error) {
    failed(error);
  }
}

/** The first part of the engine or all of it, in the place and the state of the one before it; then what waited. */
async function start(module: ArrayBuffer, all: boolean): Promise<void> {
  const { instance } = await WebAssembly.instantiate(module, {});
  // Not before: meanwhile the first part answers.
  engine = instance.exports as unknown as Exports;
  complete = all;
  if (text !== undefined) ask({ ask: 'open', text });
  const questions = waiting;
  waiting = [];
  questions.forEach(handle);
  slice();
}

/** A turn of the loop of events, in which messages are answered. */
function turn(): Promise<unknown> {
  return new Promise((resolve) => {
    unpacking.port1.onmessage = resolve;
    unpacking.port2.postMessage(null);
  });
}

async function load(): Promise<void> {
  try {
    const { packing, packed } = await brought.engine;
    const instance = await WebAssembly.instantiate(packing, {});
    const unpacked = turned(instance, 'unpacked', new Uint8Array(packed));
    const first = joined(unpacked, (await brought.data).data);
    await start(first.buffer, false);
    say({ kind: 'ready' });
    const later = [];
    do {
      await turn();
      later.push(next(instance));
      say({ kind: 'alive' });
    } while (!last(later.at(-1)!));
    await start(await whole(first, later).arrayBuffer(), true);
  } catch (error) {
    broken = String(error);
    say({ kind: 'failed', message: broken });
  }
}
void load();
