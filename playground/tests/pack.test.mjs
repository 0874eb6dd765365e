// The engine as it is packed: its file, and bare traps in place of panics.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import binaryen from 'binaryen';
import { silent } from '../pack/traps.mjs';
import { module } from './engine.mjs';

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

test('the engine comes back from its file', async () => {
  assert.equal(WebAssembly.validate(await module()), true);
});
