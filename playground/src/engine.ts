// The worker as the page sees it: the newest text wins, and what does not answer is ended.
import type { Answer, Item, Part, Question, Reply, Verdicts } from './protocol';

/** Milliseconds of silence after which the worker is ended. */
const PATIENCE = 5000;

export interface Listener {
  opened(items: Item[], claims: number): void;
  verdicts(verdicts: Verdicts, decided: number, milliseconds: number, stopped: boolean): void;
  /** The engine is gone; it comes back with the next text. */
  failed(message: string): void;
}

export class Engine {
  private worker: Worker | undefined;
  private ready = false;
  private version = 0;
  private deciding = false;
  private heard = 0;
  private asked = 0;
  private readonly pending = new Map<number, (answer: any) => void>();
  private text = '';

  constructor(private readonly listener: Listener) {
    this.start();
    setInterval(() => this.watch(), 250);
  }

  /** Reads, expands and decides a text; what is known of an older one is forgotten. */
  open(text: string): void {
    this.text = text;
    this.version += 1;
    this.deciding = true;
    this.send({ kind: 'open', version: this.version, text });
  }

  /** The answer to a question; a refusal where the engine was ended meanwhile. */
  ask<T extends object>(question: Record<string, unknown>): Promise<Answer<T>> {
    this.asked += 1;
    const id = this.asked;
    return new Promise((resolve) => {
      this.pending.set(id, resolve);
      this.send({ kind: 'ask', id, question });
    });
  }

  private send(request: Question): void {
    if (!this.worker) {
      this.start();
      // A question is about the text that was open.
      if (request.kind === 'ask') this.worker!.postMessage({ kind: 'open', version: this.version, text: this.text });
    }
    if (!this.busy()) this.heard = performance.now();
    this.worker!.postMessage(request);
  }

  private busy(): boolean {
    return this.pending.size > 0 || this.deciding;
  }

  private start(): void {
    this.ready = false;
    // The first one was started by the page's first script, which keeps the engine's parts for all of them.
    const boot = (globalThis as unknown as { basis: { worker?: Worker; parts: Part[] } }).basis;
    this.worker = boot.worker;
    delete boot.worker;
    if (!this.worker) {
      const worker = new Worker('worker.js');
      boot.parts.forEach((part) => worker.postMessage(part));
      this.worker = worker;
    }
    this.worker.onmessage = ({ data }: MessageEvent<Reply>) => this.hear(data);
    this.worker.onerror = (event) => this.end(event.message || 'the worker cannot be started');
  }

  private hear(reply: Reply): void {
    this.heard = performance.now();
    // Also where the first message came before anyone listened.
    this.ready = true;
    switch (reply.kind) {
      case 'ready':
        break;
      case 'failed':
        this.end(`The engine stopped: ${reply.message}`);
        break;
      case 'opened':
        if (reply.version === this.version) this.listener.opened(reply.items, reply.claims);
        break;
      case 'verdicts':
        if (reply.version !== this.version) break;
        if (reply.verdicts.done || reply.stopped) this.deciding = false;
        this.listener.verdicts(reply.verdicts, reply.decided, reply.milliseconds, reply.stopped);
        break;
      case 'answer':
        this.pending.get(reply.id)?.(reply.answer);
        this.pending.delete(reply.id);
        break;
      case 'alive':
        break;
    }
  }

  private watch(): void {
    if (!this.worker || !this.ready || !this.busy() || performance.now() - this.heard < PATIENCE) return;
    this.end(`The engine was stopped: one step took longer than ${PATIENCE / 1000} s. Change the text to try again.`);
  }

  private end(message: string): void {
    this.worker?.terminate();
    this.worker = undefined;
    this.deciding = false;
    const answers = [...this.pending.values()];
    this.pending.clear();
    answers.forEach((answer) => answer({ error: message }));
    this.listener.failed(message);
  }
}
