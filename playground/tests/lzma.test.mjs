// The decoder of the engine: what other programs packed, and what is no LZMA file or a damaged one.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compress } from 'lzma1';
import { load } from './bundle.mjs';

const { decode } = await load('lzma.ts');

/** Numbers that are the same in every run. */
function random(seed) {
  let state = seed;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

const text = 'to be, or not to be: λ. ';
const bytes = (string) => new TextEncoder().encode(string);
/** Packed by liblzma with other properties than those of the page; the length in place of the mark at the end. */
const VECTORS = {
  'lc = 3, lp = 0, pb = 2': 'XQAAAARzAAAAAAAAAAA6G8AFIeVImxmdIuqVXkWT2mN5JB2cYZiseIoA1UtkTxqztdG3jL55eHBhU3FzeU74LefYaGsSAsTFQ7lq/OCGAE5tFi1RH///NWwAAA==',
  'lc = 0, lp = 2, pb = 0': 'EgAAAARzAAAAAAAAAAA6HJ5oTHrJlAOaANpSR/5AFMx1bDF0/L3UaFTWdAEnGsjC9K0tcgF4XYpcD06wPNAWxQKusxth+RDbCl4WlPI0PLCVefH//5OeAAA=',
  'lc = 4, lp = 0, pb = 4': 'uAAAAARzAAAAAAAAAAA6G8AGI0jwSogAUi8rnM/3A6EY/BGLVl/hL3yjbxqMeNoFKAx9s02D1/sjCf7oCmQL4Wjv4ubgLC58WtrMhznidW4OIO8vJsv8//3gEAA=',
  'lc = 0, lp = 4, pb = 2': 'fgAAAARzAAAAAAAAAAA6G8AGI0H7cq3K9vxjcASHv9JccUWndDg6WOMbJiiL8+HOxYRDxTRkgrazcINRbLPIYwtPfdFpCnPgRVPRUP7lzzPOBTA+gYGt//zEgAA=',
  'lc = 2, lp = 1, pb = 1': 'OAAAAARzAAAAAAAAAAA6G8Amhz1P8OeH8KrbfDtC4RkmSEj4v7fhqraGntrlnaBAVKOJexHB9e2S5KtOQylzYNaZyZ7QRcyzhAo4r+uAVg52I4G8///QyQAA',
};
for (const [properties, packed] of Object.entries(VECTORS)) {
  test(`what liblzma packed with ${properties}`, () => {
    const expected = bytes(text.repeat(3) + Array.from({ length: 40 }, (_, k) => String.fromCharCode(33 + ((k * k) % 90))).join(''));
    assert.deepEqual(decode(Buffer.from(packed, 'base64')), new Uint8Array(expected));
  });
}

test('texts of all kinds come back', () => {
  const next = random(7);
  const kinds = {
    one: new Uint8Array([255]),
    zeros: new Uint8Array(100_000),
    noise: Uint8Array.from({ length: 20_000 }, () => next(256)),
    // Repetitions near and far, of all lengths, and with changed bytes between them.
    mixed: (() => {
      const all = [...Uint8Array.from({ length: 300 }, () => next(256))];
      while (all.length < 120_000) {
        const from = next(2) ? next(all.length) : Math.max(0, all.length - 1 - next(20));
        const length = 1 + next(next(10) ? 20 : 400);
        for (let k = 0; k < length; k++) all.push(all[from + k]);
        if (next(2)) all.push(next(256));
      }
      return Uint8Array.from(all);
    })(),
  };
  for (const [name, content] of Object.entries(kinds)) {
    for (const level of [1, 5, 9]) {
      const packed = Uint8Array.from(compress(content, level));
      assert.ok(Buffer.compare(decode(packed), content) === 0, `${name} at level ${level}`);
    }
  }
  // A view into a longer buffer.
  const packed = Uint8Array.from(compress(kinds.mixed, 9));
  const longer = new Uint8Array(packed.length + 20);
  longer.set(packed, 10);
  assert.ok(Buffer.compare(decode(longer.subarray(10, 10 + packed.length)), kinds.mixed) === 0);
});

test('a file that ends too early is refused', () => {
  const content = bytes(text.repeat(50));
  const packed = Uint8Array.from(compress(content, 9));
  // The last bytes of the coder may never be read.
  for (let length = 0; length < packed.length - 6; length++) {
    assert.throws(() => decode(packed.subarray(0, length)), /LZMA file|too early/, `${length} of ${packed.length} bytes`);
  }
});

test('a header that promises too much is refused', () => {
  const packed = Uint8Array.from(compress(bytes(text), 9));
  const changed = (at, value) => {
    const copy = packed.slice();
    copy[at] = value;
    return copy;
  };
  assert.throws(() => decode(changed(0, 225)), /no LZMA file/);
  assert.throws(() => decode(changed(9, 1)), /does not say how long/); // 4 GiB and more
  assert.throws(() => decode(changed(8, 0x7f)), /does not say how long/); // 2 GiB
  assert.throws(() => decode(new Uint8Array(18).fill(255)), /no LZMA file/);
  const unknown = packed.slice();
  unknown.fill(255, 5, 13); // the length stands at the end of such a file, where this decoder does not look
  assert.throws(() => decode(unknown), /does not say how long/);
});

test('whatever is damaged ends, with the promised length or an error', () => {
  const next = random(11);
  const content = Uint8Array.from({ length: 3000 }, (_, k) => (k % 7) * (next(9) ? 1 : next(30)));
  const packed = Uint8Array.from(compress(content, 9));
  let [errors, others] = [0, 0];
  for (let round = 0; round < 2000; round++) {
    const copy = packed.slice();
    // Behind the header: another length in it only makes the content longer or shorter.
    for (let k = 0; k <= next(3); k++) copy[13 + next(copy.length - 13)] = next(256);
    try {
      assert.equal(decode(copy).length, content.length);
      others++;
    } catch (error) {
      assert.match(error.message, /damaged|too early/);
      errors++;
    }
  }
  assert.ok(errors > 100 && others > 0, `${errors} errors`);
});
