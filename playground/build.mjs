// Builds the page into dist/: the engine as WebAssembly, what it says of the library, the scripts. Says how large it is.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import zlib from 'node:zlib';
import binaryen from 'binaryen';
import esbuild from 'esbuild';
import { minify } from 'terser';
import { BUDGET } from './budget.mjs';
import { renumbered } from './pack/locals.mjs';
import { HEADER, joined, sections } from './pack/module.mjs';
import { divided } from './pack/parts.mjs';
import { called, noting } from './pack/profile.mjs';
import { silent } from './pack/traps.mjs';

const here = path.dirname(fileURLToPath(import.meta.url));
const root = path.dirname(here);
const dist = path.join(here, 'dist');

const cargo = process.env.CARGO ?? 'cargo';
const target = process.env.CARGO_TARGET_DIR ?? path.join(root, 'target');
/** A package of the workspace as WebAssembly, in which panics say nothing. */
function compiled(name, command = ['build'], flags = []) {
  execFileSync(cargo, [...command, '--locked', '--profile', 'playground', '--target', 'wasm32-unknown-unknown', '-p', `basis-${name}`, ...flags], { cwd: root, stdio: 'inherit' });
  return silent(fs.readFileSync(path.join(target, 'wasm32-unknown-unknown', 'playground', `basis_${name}.wasm`)));
}
const wasm = renumbered(compact(compiled('playground')));
// With vectors, which browsers have had since March 2023, it takes less time; with fewer functions inlined, as much and less room.
const packing = compiled('packing', ['rustc', '--lib', '--crate-type', 'cdylib'], ['--', '-C', 'target-feature=+simd128', '-C', 'llvm-args=--inline-threshold=25']);

/**
 * The same module in fewer bytes when packed. Of the passes only those that make it more alike in its parts: what -Oz does
 * besides takes away bytes that compress well, and leaves such that do not. Functions are in the order of their names, in which
 * instances of the same one, and parts of the same module, lie beside one another; the names themselves go.
 */
function compact(bytes) {
  const module = binaryen.readBinary(bytes);
  module.setFeatures(binaryen.Features.All);
  module.runPasses([
    'duplicate-function-elimination', 'remove-unused-module-elements', 'dae', 'remove-unused-module-elements', 'precompute-propagate',
    'rse', 'vacuum', 'optimize-instructions', 'reorder-functions-by-name',
    'strip-debug', 'strip-producers', 'strip-target-features',
  ]);
  const smaller = module.emitBinary();
  module.dispose();
  return smaller;
}

/** What the page needs of the module that packs and unpacks. */
function unpacking(bytes) {
  const module = binaryen.readBinary(bytes);
  module.setFeatures(binaryen.Features.All);
  module.removeExport('packed');
  module.optimize();
  module.runPasses(['strip-debug', 'strip-producers', 'strip-target-features']);
  const smaller = module.emitBinary();
  module.dispose();
  return smaller;
}

const [CODE, DATA] = [10, 11];
/** Sections, and what the page unpacks them with. */
const content = (bytes, wanted) => sections(bytes).find(({ id }) => id === wanted).content;
const built = await esbuild.build({ entryPoints: [path.join(here, 'src', 'unpack.ts')], bundle: true, format: 'esm', write: false });
const unpack = await import(`data:text/javascript;base64,${Buffer.from(built.outputFiles[0].contents).toString('base64')}`);
const packer = async () => (await WebAssembly.instantiate(packing, {})).instance;

/** What stands between two parts where they are packed. */
const BETWEEN = 255;
/** The parts of the engine in few bytes. */
async function packed(parts) {
  const bytes = Buffer.concat(parts.flatMap((part, k) => (k ? [Uint8Array.of(BETWEEN), part] : [part])));
  const small = unpack.turned(await packer(), 'packed', bytes);
  const instance = await packer();
  parts.forEach((part, k) => {
    const back = k ? unpack.next(instance) : unpack.turned(instance, 'unpacked', small);
    if (Buffer.compare(back, part) !== 0) throw new Error(`what is unpacked is not part ${k}`);
  });
  return small;
}

/** Fails where the parts are not the engine: the same code, and the same bytes in its memory. */
async function same(engine, { first, data, later }) {
  const all = new Uint8Array(await unpack.whole(unpack.joined(first, data), later).arrayBuffer());
  if (Buffer.compare(content(all, CODE), content(engine, CODE)) !== 0) throw new Error('the parts are not the code of the engine');
  const memory = async (bytes) => new Uint8Array((await WebAssembly.instantiate(bytes, {})).instance.exports.memory.buffer);
  if (Buffer.compare(await memory(all), await memory(engine)) !== 0) throw new Error('the parts are not the data of the engine');
}

// The engine itself says what the library holds: words for the editor, verdicts for the list.
const { instance } = await WebAssembly.instantiate(noting(wasm), {});
function ask(question) {
  const { alloc, answer, text, free, memory } = instance.exports;
  const bytes = new TextEncoder().encode(JSON.stringify(question));
  const place = alloc(bytes.length);
  new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
  const length = answer();
  const reply = JSON.parse(new TextDecoder().decode(new Uint8Array(memory.buffer, text(), length)));
  free();
  if (reply.error) throw new Error(reply.error);
  return reply;
}

/** The spec that the page begins with: what the first part of the engine is for. */
const FIRST = 'quartic';
const { items } = ask({ ask: 'open', text: ask({ ask: 'spec', name: FIRST }).text });
while (ask({ ask: 'decide' }).more);
ask({ ask: 'verdicts' });
items.forEach((_, item) => ask({ ask: 'draw', item }));
const early = called(instance);

const library = ask({ ask: 'library' });
/** What the comment of a file says first: of a paper its title, of other specs a sentence. */
function title(name, text) {
  const comment = text.split('\n').filter((l) => l.startsWith('//!')).map((l) => l.slice(3).trim()).join(' ');
  const [, quoted] = (name.startsWith('papers/') && /"([^"]+?),?"/.exec(comment)) || [];
  return quoted ?? comment.split(/(?<=[^.A-Z][.:])\s/)[0].replace(/[:.]$/, '');
}
const specs = [];
const papers = [];
for (const spec of library.specs) {
  ask({ ask: 'open', text: spec.text });
  while (ask({ ask: 'decide' }).more);
  const { statements, messages } = ask({ ask: 'verdicts' });
  const errors = messages.filter((m) => m.severity === 'error');
  if (errors.length) throw new Error(`${spec.name}: ${errors[0].message}`);
  const sum = (key) => statements.reduce((all, s) => all + s[key], 0);
  specs.push({ name: spec.name, title: title(spec.name, spec.text), proved: sum('proved'), refuted: sum('refuted') });
  const wrong = ask({ ask: 'published', text: spec.text }).statements.filter((s) => s.verdict === 'refuted');
  if (wrong.length) {
    papers.push({ name: spec.name, title: title(spec.name, spec.text), wrong: wrong.map(({ id, statement, remark }) => ({ id, statement, remark })) });
  }
}
fs.mkdirSync(path.join(here, 'src', 'generated'), { recursive: true });
fs.writeFileSync(path.join(here, 'src', 'generated', 'catalogue.json'), JSON.stringify({ first: FIRST, words: library.words, languages: library.languages, specs, papers }, null, 1));

fs.rmSync(dist, { recursive: true, force: true });
fs.mkdirSync(dist);
const { outputFiles: scripts } = await esbuild.build({
  entryPoints: ['boot', 'main', 'worker'].map((name) => path.join(here, 'src', `${name}.ts`)),
  bundle: true, minify: true, charset: 'utf8', format: 'iife', target: 'es2022', outdir: dist, write: false, logLevel: 'warning', legalComments: 'none',
});
// Once more: what esbuild leaves is a thirtieth larger when packed.
const [boot, main, worker] = await Promise.all(scripts.map(async ({ text }) => {
  const { code } = await minify(text, { ecma: 2020, compress: { passes: 2 } });
  return new TextEncoder().encode(code);
}));
fs.writeFileSync(path.join(dist, 'boot.js'), boot);
fs.writeFileSync(path.join(dist, 'worker.js'), worker);
const style = await esbuild.transform(fs.readFileSync(path.join(here, 'style.css'), 'utf8'), { loader: 'css', minify: true });
fs.writeFileSync(path.join(dist, 'style.css'), style.code);
fs.copyFileSync(path.join(here, 'index.html'), path.join(dist, 'index.html'));
// By gzip, which servers and browsers do by themselves, they would be three quarters as large again.
const texts = library.specs.filter(({ name }) => name !== FIRST).map(({ name }) => fs.readFileSync(path.join(root, 'specs', `${name}.basis`)));
const parts = divided(wasm, early, texts);
const script = joined([{ id: DATA, content: main }]).subarray(HEADER);
await same(wasm, parts);
fs.writeFileSync(path.join(dist, 'engine.packed'), await packed([parts.first, ...parts.later]));
fs.writeFileSync(path.join(dist, 'page.packed'), await packed([unpack.joined(joined([]), unpack.joined(parts.data, script))]));
fs.writeFileSync(path.join(dist, 'packing.wasm'), unpacking(packing));

let all = 0;
for (const file of fs.readdirSync(dist).sort()) {
  const bytes = fs.readFileSync(path.join(dist, file));
  const small = zlib.gzipSync(bytes, { level: 9 }).length;
  all += small;
  console.log(`${String(bytes.length).padStart(9)} ${String(small).padStart(8)}  ${file}`);
}
console.log(`${' '.repeat(9)} ${String(all).padStart(8)}  in all, compressed with gzip; the budget is ${BUDGET}`);
if (all > BUDGET) process.exitCode = 1;
