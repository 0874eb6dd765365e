// The engine as it is packed: its file, and bare traps in place of panics.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import binaryen from 'binaryen';
import { renumbered } from '../pack/locals.mjs';
import { after as behind, bodies, sections, start } from '../pack/module.mjs';
import { divided } from '../pack/parts.mjs';
import { called, noting } from '../pack/profile.mjs';
import { silent } from '../pack/traps.mjs';
import { load } from './bundle.mjs';
import { engine, parts } from './engine.mjs';

const instance = async (bytes) => (await WebAssembly.instantiate(bytes, {})).instance.exports;

/** A module from its text. */
function assembled(text) {
  const parsed = binaryen.parseText(text);
  parsed.setFeatures(binaryen.Features.All);
  const bytes = parsed.emitBinary();
  parsed.dispose();
  return bytes;
}

const SPOKEN = `(module
  (memory (export "memory") 1)
  (data (i32.const 64) "src/deep/place.rs_______\\40\\00\\00\\00\\11\\00\\00\\00\\07\\00\\00\\00\\09\\00\\00\\00")
  (func $say (param i32 i32) (i32.store (local.get 0) (local.get 1)) (unreachable))
  (func $panic (param i32) (if (local.get 0) (then (call $say (i32.const 8) (i32.const 1)) (unreachable)) (else (call $say (i32.const 8) (i32.const 2)))) (unreachable))
  (func (export "quotient") (param i32 i32) (result i32)
    (if (i32.eqz (local.get 1)) (then (i32.store (i32.const 16) (i32.const 5)) (call $panic (i32.const 1)) (unreachable)))
    (i32.div_u (local.get 0) (local.get 1)))
  (func (export "turns") (param i32) (result i32) (local i32)
    (block $out
      (loop $again
        (br_if $out (i32.ge_u (local.get 1) (local.get 0)))
        (if (i32.eq (local.get 1) (i32.const 7)) (then (call $panic (local.get 1)) (unreachable)))
        (local.set 1 (i32.add (local.get 1) (i32.const 1)))
        (br $again)))
    (local.get 1))
  (func (export "chosen") (param i32) (result i32)
    (block $two (block $one (block $none (br_table $none $one $two (local.get 0))) (return (i32.const 10))) (return (i32.const 20)))
    (call $panic (i32.const 0))
    (block (result i32) (drop (i64.const 5)) (i32.const 3)))
  (func (export "forever") (param i32) (result i32) (block $b (call $panic (i32.const 0)) (br $b)) (i32.const 1)))`;

test('traps in place of panics: the same values, the same traps, and no words', async () => {
  const before = assembled(SPOKEN);
  const after = silent(before);
  assert.ok(after.length < before.length);
  const said = (f, ...values) => { try { return f(...values); } catch (error) { assert.ok(error instanceof WebAssembly.RuntimeError); return 'trap'; } };
  const [spoken, quiet] = [await instance(before), await instance(after)];
  for (const [name, ...cases] of [['quotient', [7, 2], [7, 0], [0, 1]], ['turns', [0], [5], [7], [8], [100]], ['chosen', [0], [1], [2], [9]], ['forever', [0]]]) {
    for (const values of cases) assert.equal(said(quiet[name], ...values), said(spoken[name], ...values), `${name} ${values}`);
  }
  // Nothing is written on the way to a trap, neither here nor in what was called; and places in the source are gone.
  assert.equal(new Uint32Array(spoken.memory.buffer)[2] !== 0, true);
  assert.deepEqual([...new Uint32Array(quiet.memory.buffer, 0, 8)], [0, 0, 0, 0, 0, 0, 0, 0]);
  assert.equal(Buffer.from(quiet.memory.buffer, 64, 40).toString('latin1'), `${'\0'.repeat(17)}_______${'\0'.repeat(16)}`);
});

test('a module that could be heard keeps its panics', () => {
  assert.throws(() => silent(assembled('(module (import "a" "b" (func)))')), /could be heard/);
});

const MANY = `(module
  (func (export "mean") (param f64 f64) (result f64) (local $unused i64) (local $n i32) (local $sum f64) (local $one f64)
    (local.set $one (f64.const 1))
    (local.set $sum (f64.add (local.get 1) (local.tee $one (local.get 0))))
    (local.set $n (i32.add (local.get $n) (i32.const 2)))
    (f64.div (local.get $sum) (f64.convert_i32_s (local.get $n))))
  (func (export "constant") (result i32) (i32.const 7)))`;

test('variables in the order in which they are named first: the same values', async () => {
  const before = assembled(MANY);
  const after = renumbered(before);
  const quiet = await instance(after);
  assert.equal(quiet.mean(3, 4), 3.5);
  assert.equal(quiet.constant(), 7);
  const [body] = bodies(sections(after).find(({ id }) => id === 10).content);
  // Two of 64-bit floating point and one of 32 bits; what is not named is gone.
  assert.deepEqual([...body.subarray(0, start(body))], [2, 2, 0x7c, 1, 0x7f]);
  const set = [];
  for (let at = start(body); at < body.length; at = behind(body, at)) if (body[at] === 0x21) set.push(body[at + 1]);
  assert.deepEqual(set, [2, 3, 4]);
});

const VECTORS = `(module (memory 1)
  (func (export "sum") (param i32) (result i32) (local v128)
    (local.set 1 (i32x4.add (v128.load offset=16 (i32.const 0)) (i8x16.shuffle 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 (i32x4.splat (local.get 0)) (v128.const i32x4 1 2 3 4))))
    (v128.store32_lane offset=4 2 (i32.const 0) (v128.load32_lane 1 (i32.const 4) (local.get 1)))
    (i32.add (i32x4.extract_lane 3 (i32x4.replace_lane 3 (local.get 1) (local.get 0))) (i32.load offset=4 (i32.const 0)))))`;

test('instructions on vectors are gone through, with what belongs to them', async () => {
  const before = assembled(VECTORS);
  assert.equal((await instance(silent(before))).sum(5), 10);
  const [body] = bodies(sections(before).find(({ id }) => id === 10).content);
  let at = start(body);
  while (at < body.length) at = behind(body, at);
  assert.equal(at, body.length);
});

const DIVIDED = `(module
  (global (mut i32) (i32.const 0))
  (memory (export "memory") 1)
  (data (i32.const 64) "the name of a texta text that comes later\\00\\00\\00\\40\\00\\00\\00\\12\\00\\00\\00\\52\\00\\00\\00\\17\\00\\00\\00")
  (func (export "early") (param i32) (result i32) (if (result i32) (local.get 0) (then (call $rare (local.get 0))) (else (i32.const 1))))
  (func $rare (param i32) (result i32) (i32.mul (local.get 0) (i32.const 3)))
  (func (export "never") (unreachable))
  (func (export "letter") (param i32) (result i32) (i32.load8_u (i32.load (i32.add (i32.const 108) (local.get 0))))))`;

test('a module in parts: the first one answers as the whole does, or traps', async () => {
  const { joined, whole } = await load('unpack.ts');
  const before = assembled(DIVIDED);
  const { instance: noted } = await WebAssembly.instantiate(noting(before), {});
  assert.equal(noted.exports.early(0), 1);
  noted.exports.letter(0);
  const numbers = called(noted);
  assert.deepEqual([...numbers], [0, 3]);
  assert.deepEqual([...called(noted)], []);
  const { first: code, data, later } = divided(before, numbers, [Buffer.from('a text that comes later')]);
  const first = joined(code, data);
  const part = await instance(first);
  assert.equal(part.early(0), 1);
  assert.throws(() => part.early(5), WebAssembly.RuntimeError);
  assert.equal(part.letter(0), 't'.charCodeAt());
  assert.throws(() => part.letter(8), WebAssembly.RuntimeError);
  const all = await instance(new Uint8Array(await whole(first, later).arrayBuffer()));
  assert.deepEqual([all.early(0), all.early(5), all.letter(0), all.letter(8)].map(String), ['1', '15', '116', '97']);
  assert.throws(() => all.never(), WebAssembly.RuntimeError);
  assert.deepEqual(Buffer.from(all.memory.buffer), Buffer.from((await instance(before)).memory.buffer));
});

test('a text that code finds by itself cannot come later', () => {
  const known = DIVIDED.replace('(i32.const 3)', '(i32.const 82)');
  assert.throws(() => divided(assembled(known), new Set(), [Buffer.from('a text that comes later')]), /has the address 82/);
  assert.throws(() => divided(assembled(DIVIDED), new Set(), [Buffer.from('another text')]), /does not hold/);
  assert.throws(() => divided(assembled(DIVIDED), new Set(), [Buffer.from('name')]), /nothing leads to/);
});

test('the engine comes back from its file', async () => {
  const { first, whole } = await parts();
  assert.equal(WebAssembly.validate(whole), true);
  assert.ok(first.length < whole.length / 2, `${first.length} of ${whole.length} bytes`);
});

test('of the library, the first part answers as all of the engine does, or not at all', async () => {
  const { first, whole } = await parts();
  const all = await engine(whole);
  let answered = 0;
  for (const { name, text } of all({ ask: 'library' }).specs) {
    const some = await engine(first);
    for (const question of [{ ask: 'spec', name }, { ask: 'open', text }, { ask: 'decide' }, { ask: 'verdicts' }, { ask: 'draw', item: 0 }, { ask: 'facts', item: 0 }]) {
      const expected = all(question);
      try {
        assert.deepEqual(some(question), expected, `${name}: ${question.ask}`);
        answered += 1;
      } catch (error) {
        if (!(error instanceof WebAssembly.RuntimeError)) throw error;
        break;
      }
    }
  }
  assert.ok(answered >= 5, `${answered}`);
});
