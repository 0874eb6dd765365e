// Which functions a module calls while it is used: each one notes it in a global variable of its own.
import { bodies, code, encoded, joined, sections, start, unsigned } from './module.mjs';

const [GLOBALS, EXPORTS, CODE] = [6, 7, 10];
const [I32, MUTABLE, I32_CONST, GLOBAL_SET, END] = [0x7f, 1, 0x41, 0x24, 0x0b];
const GLOBAL = 3;

const name = (k) => `called ${k}`;

/** A list with further items. */
function longer(content, items) {
  const [count, at] = unsigned(content, 0);
  return Uint8Array.from(Buffer.concat([Uint8Array.from(encoded(count + items.length)), content.subarray(at), ...items]));
}

/** The same module, whose functions note that they are called. */
export function noting(bytes) {
  const all = sections(bytes);
  const content = (id) => all.find((section) => section.id === id).content;
  const functions = bodies(content(CODE));
  const [first] = unsigned(content(GLOBALS), 0);
  const changed = {
    [GLOBALS]: longer(content(GLOBALS), functions.map(() => Uint8Array.of(I32, MUTABLE, I32_CONST, 0, END))),
    [EXPORTS]: longer(content(EXPORTS), functions.map((_, k) => {
      const text = Buffer.from(name(k));
      return Uint8Array.from([...encoded(text.length), ...text, GLOBAL, ...encoded(first + k)]);
    })),
    [CODE]: code(functions.map((body, k) => {
      const at = start(body);
      return Uint8Array.from([...body.subarray(0, at), I32_CONST, 1, GLOBAL_SET, ...encoded(first + k), ...body.subarray(at)]);
    })),
  };
  return joined(all.map(({ id, content }) => ({ id, content: changed[id] ?? content })));
}

/** The numbers of the functions that were called since the last time. */
export function called({ exports }) {
  const numbers = new Set();
  for (let k = 0; name(k) in exports; k++) {
    const note = exports[name(k)];
    if (note.value) numbers.add(k);
    note.value = 0;
  }
  return numbers;
}
