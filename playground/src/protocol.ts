// What the engine answers, and what goes between the page and its worker.

/** A family, theorem or join of the open spec. */
export interface Item {
  kind: 'family' | 'theorem' | 'join';
  name: string;
  title: string;
  doc: string[];
  /** Whether the text declares it itself, and not a spec that it uses. */
  own: boolean;
}

export interface Witness {
  /** Coordinates by name; only for families. */
  at?: Record<string, number>;
  /** The function that the failing statement is about. */
  function?: number | null;
  /** The exact point as text. */
  point: string;
}

export interface Claim {
  item: number | null;
  title: string;
  text: string;
  verdict: 'proved' | 'refuted' | 'undecided';
  reason: string;
  witness: Witness | null;
}

/** A statement with the verdicts on its claims. */
export interface Statement {
  from: number;
  to: number;
  about: string | null;
  text: string | null;
  declared: string | null;
  /** The values that a block fixes, such as `t = 0`. */
  at: string | null;
  proved: number;
  refuted: number;
  undecided: number;
  /** How many verdicts are not the declared one. */
  unexpected: number;
  complete: boolean;
  claims: Claim[];
}

export interface Message {
  from: number;
  to: number;
  severity: 'error' | 'warning';
  message: string;
}

export interface Verdicts {
  done: boolean;
  statements: Statement[];
  unlisted: number;
  messages: Message[];
}

/** Coefficient, then variables with their exponents. */
export type Term = number[];
export type Sum = { bernstein: Term[][] } | { terms: Term[] };
export interface Quotient { above: Sum; below: Sum | null }

export interface Angle {
  name: string;
  kind: 'atan' | 'atanh' | '';
  rate: number;
  shift: number;
  low: { above: Term[]; below: Term[] };
  width: { above: Term[]; below: Term[] };
  var: number;
  itself: number;
}

export interface Span {
  ranges: [number, number][];
  width: number;
  domain: number[];
  numbers: [number, number][];
  angles: Angle[];
  functions: Quotient[];
}

export interface Shape {
  name: string;
  declared: string;
  doc: string[];
  var: number;
  low: number;
  high: number;
  value: number;
  excluded: [boolean, boolean];
  open: [boolean, boolean];
}

export interface Drawing {
  title: string;
  doc: string[];
  /** An interval, or a product of simplices and intervals. */
  kind: 'interval' | 'product';
  /** The independent ones, and after them the last barycentric coordinate of each simplex. */
  variables: string[];
  /** The places of the independent coordinates of each simplex, and the one after them. */
  simplices: [number, number][];
  shapes: Shape[];
  conditions: { value: Term[]; text: string }[];
  labels: string[];
  indices: number[][];
  spans: Span[];
}

export interface Formula { text: string; latex: string | null }

export interface FunctionFacts {
  label: Formula;
  factored: Formula;
  expanded: Formula;
  bernstein: Formula[];
  between: [Formula, Formula] | null;
}

export interface Facts {
  title: string;
  doc: string[];
  domain?: Formula[];
  shapes?: { declared: Formula; doc: string[] }[];
  conditions?: Formula[];
  functions?: FunctionFacts[];
  /** On several spans of the domain, in the place of the functions. */
  spans?: { domain: Formula[]; functions: FunctionFacts[] }[];
  patches?: { name: string; written: string }[];
  points?: Formula[];
}

export interface LibrarySpec {
  name: string;
  text: string;
  items: { kind: Item['kind']; name: string; doc: string }[];
}

export interface Library { specs: LibrarySpec[]; languages: [string, string][]; words: [string, string][] }

export interface Suggestion { label: string; insert: string; meaning: string; from: number; to: number }

/** What the engine says where it has no answer. */
export interface Refusal { error: string }
export type Answer<T> = T | Refusal;

export const isRefusal = (answer: object): answer is Refusal => 'error' in answer;

/** From the page to the worker: a text, or a question about it. */
export type Question =
  | { kind: 'open'; version: number; text: string }
  | { kind: 'ask'; id: number; question: Record<string, unknown> };

/** What the first script of the page has for the worker: the packed engine with what unpacks it, and then its first data. */
export type Part =
  | { kind: 'engine'; packing: WebAssembly.Module; packed: ArrayBuffer }
  | { kind: 'data'; data: Uint8Array<ArrayBuffer> };

export type Request = Question | Part;

/** From the worker to the page. */
export type Reply =
  | { kind: 'ready' }
  | { kind: 'failed'; message: string }
  | { kind: 'opened'; version: number; items: Item[]; claims: number }
  | { kind: 'verdicts'; version: number; decided: number; verdicts: Verdicts; milliseconds: number; stopped: boolean }
  | { kind: 'alive' }
  | { kind: 'answer'; id: number; answer: object };
