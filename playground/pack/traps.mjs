// What a panic would say is heard by nobody on the page: WebAssembly without imports can do no more than trap. All that leads
// nowhere but to a trap is therefore the trap itself, and places in the source are zeros, which take no room when compressed.
import { after, bodies, code, joined, sections, segments, start, unsigned } from './module.mjs';

const [UNREACHABLE, BLOCK, LOOP, IF, ELSE, END, BR, BR_IF, BR_TABLE, RETURN, CALL] =
  [0x00, 0x02, 0x03, 0x04, 0x05, 0x0b, 0x0c, 0x0d, 0x0e, 0x0f, 0x10];

/**
 * The same body, in which straight code that ends in a trap, or in a call that never returns, is `unreachable`; and whether the
 * function itself returns at all.
 */
function cut(body, returns) {
  const first = start(body);
  const out = [body.subarray(0, first)];
  /** Blocks that are open: can their ends be reached? A jump to a loop goes to its beginning. */
  const open = [{ op: BLOCK, reached: false }];
  let live = true;
  /** Where straight code began. */
  let straight = first;
  const target = (depth) => {
    const block = open[open.length - 1 - depth];
    if (block.op !== LOOP) block.reached = true;
  };
  for (let at = first; at < body.length;) {
    const op = body[at];
    const next = after(body, at);
    const keep = () => { out.push(body.subarray(straight, next)); straight = next; };
    switch (op) {
      case BLOCK: case LOOP: case IF:
        open.push({ op, reached: false, live });
        keep();
        if (!live) out.push(Uint8Array.of(UNREACHABLE));
        break;
      case ELSE: {
        const block = open.at(-1);
        if (live) block.reached = true;
        block.op = ELSE;
        live = block.live;
        keep();
        if (!live) out.push(Uint8Array.of(UNREACHABLE));
        break;
      }
      case END: {
        const block = open.pop();
        live = live || block.reached || (block.op === IF && block.live);
        keep();
        // What follows a block has to be valid, also where it is never reached.
        if (!live && open.length > 0) out.push(Uint8Array.of(UNREACHABLE));
        break;
      }
      case BR: case BR_IF:
        if (live) target(unsigned(body, at + 1)[0]);
        if (op === BR) live = false;
        keep();
        break;
      case BR_TABLE: {
        let [count, place] = unsigned(body, at + 1);
        for (let depth; count >= 0; count--) {
          [depth, place] = unsigned(body, place);
          if (live) target(depth);
        }
        live = false;
        keep();
        break;
      }
      case RETURN:
        if (live) open[0].reached = true;
        live = false;
        keep();
        break;
      default:
        if (op === UNREACHABLE || (op === CALL && !returns[unsigned(body, at + 1)[0]])) {
          if (live) out.push(Uint8Array.of(UNREACHABLE));
          live = false;
          straight = next;
        } else if (!live) {
          straight = next;
        }
    }
    at = next;
  }
  return { body: Uint8Array.from(Buffer.concat(out)), returns: live };
}

/** A place in the source as the compiler lays it out: address and length of the file's name, line, column. */
const PLACE = 16;

/** Puts zeros where places in the source were, which only panics read, and where their files' names were; how many. */
function forget(content) {
  const all = segments(content);
  const named = (address, length) => {
    const segment = all.find((s) => address >= s.address && address + length <= s.address + s.bytes.length);
    const name = segment?.bytes.subarray(address - segment.address, address - segment.address + length);
    return name && /^[ -~]+\.rs$/.test(Buffer.from(name).toString('latin1')) ? name : undefined;
  };
  const names = new Set();
  let count = 0;
  for (const { bytes } of all) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    for (let at = 0; at + PLACE <= bytes.length; at += 4) {
      const [address, length, line, column] = [0, 4, 8, 12].map((k) => view.getUint32(at + k, true));
      if (length < 4 || length > 300 || line === 0 || line > 100_000 || column === 0 || column > 1000) continue;
      const name = named(address, length);
      if (!name) continue;
      names.add(name);
      bytes.fill(0, at, at + PLACE);
      count += 1;
    }
  }
  for (const name of names) name.fill(0);
  return count;
}

/** The same module with bare traps in place of panics. */
export function silent(bytes) {
  const all = sections(bytes);
  if (all.some(({ id }) => id === 2)) throw new Error('a module with imports could be heard');
  const section = all.find(({ id }) => id === 10);
  let functions = bodies(section.content).map((body) => ({ body, returns: true }));
  for (let changed = true; changed;) {
    const returns = functions.map((f) => f.returns);
    functions = functions.map((f) => cut(f.body, returns));
    changed = functions.some((f, i) => f.returns !== returns[i]);
  }
  section.content = code(functions.map((f) => f.body));
  const data = all.find(({ id }) => id === 11);
  if (data) {
    data.content = data.content.slice();
    forget(data.content);
  }
  return joined(all);
}
