// Elements, numbers and colours.

type Attributes = Record<string, string | number | boolean | ((event: any) => void)>;

function fill(e: Element, attributes: Attributes, children: (Node | string)[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') e.addEventListener(name.replace(/^on/, ''), value);
    else if (value === true) e.setAttribute(name, '');
    else if (value !== false) e.setAttribute(name, String(value));
  }
  e.append(...children);
}

/** An element; attributes that are functions are listeners. */
export function h<K extends keyof HTMLElementTagNameMap>(name: K, attributes: Attributes = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
  const e = document.createElement(name);
  fill(e, attributes, children);
  return e;
}

export function svg<K extends keyof SVGElementTagNameMap>(name: K, attributes: Attributes = {}, ...children: (Node | string)[]): SVGElementTagNameMap[K] {
  const e = document.createElementNS('http://www.w3.org/2000/svg', name);
  fill(e, attributes, children);
  return e;
}

export const byId = (id: string): HTMLElement => document.getElementById(id)!;

/** A number for reading, with a few digits. */
export const number = (x: number, digits = 6): string =>
  String(Number(Math.abs(x) < 1e-12 ? 0 : x.toPrecision(digits))).replace('-', '−');

/** `<=` as it is printed. */
export const signs = (text: string): string => text.replaceAll('<=', '≤').replaceAll('>=', '≥').replaceAll('`', '');

const COLOURS = ['#0072b2', '#d55e00', '#008c66', '#b45a96', '#b08000', '#3ca0d7', '#808080', '#8c5a28'];

/** Colours that can be told apart for a few functions, and a scale for many. */
export const colour = (k: number, n: number): string =>
  n <= COLOURS.length ? COLOURS[k]! : `hsl(${(265 - (230 * k) / (n - 1) + 360) % 360} 65% 45%)`;

/** A family of lines that differ beside their colours, for more functions than colours. */
export const dashes = (k: number, n: number): string => (n <= COLOURS.length ? '' : ['', '7 4', '2 3'][k % 3]!);

/** Round numbers between two others. */
export function ticks(low: number, high: number, parts: number): number[] {
  const raw = (high - low) / parts;
  if (!(raw > 0) || !Number.isFinite(raw)) return [low];
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((s) => s * power).find((s) => s >= raw * 0.999)!;
  const all: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step && all.length < 40; k++) all.push(k * step);
  return all;
}
