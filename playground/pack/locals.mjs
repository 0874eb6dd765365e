// Local variables in the order in which functions name them first. Which one comes next is then known when the engine is unpacked.
import { after, bodies, code, encoded, joined, sections, start, unsigned } from './module.mjs';

const [TYPES, FUNCTIONS, CODE] = [1, 3, 10];
const [LOCAL_GET, LOCAL_TEE] = [0x20, 0x22];

/** The numbers in a section that is a list, each read from its place by `item`. */
function list(content, item) {
  let [count, at] = unsigned(content, 0);
  const all = [];
  for (let value; count > 0; count--) {
    [value, at] = item(at);
    all.push(value);
  }
  return all;
}

/** How many parameters the functions of each type have. */
function parameters(content) {
  return list(content, (at) => {
    const [count, first] = unsigned(content, at + 1); // behind the mark of a function
    const [results, last] = unsigned(content, first + count);
    return [count, last + results];
  });
}

/** The same body with its variables behind the parameters in another order. */
function ordered(body, parameters) {
  const types = [];
  let [groups, at] = unsigned(body, 0);
  for (let count; groups > 0; groups--) {
    [count, at] = unsigned(body, at);
    for (; count > 0; count--) types.push(body[at]);
    at++;
  }
  const names = new Map(types.map((_, k) => [parameters + k, undefined]));
  const declared = [];
  const out = [];
  for (at = start(body); at < body.length;) {
    const next = after(body, at);
    if (body[at] < LOCAL_GET || body[at] > LOCAL_TEE) {
      out.push(...body.subarray(at, next));
    } else {
      const [old] = unsigned(body, at + 1);
      if (names.has(old) && names.get(old) === undefined) {
        names.set(old, parameters + declared.length);
        declared.push(types[old - parameters]);
      }
      out.push(body[at], ...encoded(names.get(old) ?? old));
    }
    at = next;
  }
  const runs = [];
  for (const type of declared) {
    if (runs.at(-1)?.type === type) runs.at(-1).count++;
    else runs.push({ type, count: 1 });
  }
  return Uint8Array.from([...encoded(runs.length), ...runs.flatMap(({ type, count }) => [...encoded(count), type]), ...out]);
}

/** The same module with the variables of each function in the order in which it names them first; those it never names go. */
export function renumbered(bytes) {
  const all = sections(bytes);
  const content = (id) => all.find((section) => section.id === id).content;
  const counts = parameters(content(TYPES));
  const types = list(content(FUNCTIONS), (at) => unsigned(content(FUNCTIONS), at));
  const done = bodies(content(CODE)).map((body, k) => ordered(body, counts[types[k]]));
  return joined(all.map((section) => (section.id === CODE ? { id: CODE, content: code(done) } : section)));
}
