// The state of the page as the fragment of its address.

export interface State {
  /** The text, or the name of a spec of the library. */
  text?: string;
  library?: string;
  /** The family that is shown, by title. */
  family?: string;
  /** Shape values by name. */
  shapes?: Record<string, number>;
  points?: number[][];
  tab?: string;
}

const FORMAT = '1.';

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  const all = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(all).arrayBuffer());
}

/** Deflated JSON in the base64 of addresses. */
export async function encode(state: State): Promise<string> {
  const short = JSON.stringify(state, (_, value) => (typeof value === 'number' ? Number(value.toPrecision(6)) : value));
  const bytes = await through(new TextEncoder().encode(short), new CompressionStream('deflate-raw'));
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return FORMAT + btoa(text).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

/** The most characters of a state: that of a spec of 1 MiB is far below. */
const MAX = 4 << 20;

/** The state of a fragment; nothing where it is none. */
export async function decode(fragment: string): Promise<State | undefined> {
  if (!fragment.startsWith(FORMAT)) return undefined;
  try {
    const text = atob(fragment.slice(FORMAT.length).replace(/-/g, '+').replace(/_/g, '/'));
    const bytes = await through(Uint8Array.from(text, (c) => c.charCodeAt(0)), new DecompressionStream('deflate-raw'));
    if (bytes.length > MAX) return undefined;
    const state: unknown = JSON.parse(new TextDecoder().decode(bytes));
    return typeof state === 'object' && state !== null ? (state as State) : undefined;
  } catch {
    return undefined;
  }
}
