// Formulas: the page's MathML beside that of KaTeX, which reads all of LaTeX.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import katex from 'katex';
import { load } from './bundle.mjs';
import { engine } from './engine.mjs';

const { mathml } = await load('latex.ts');

/** The elements in the text that KaTeX writes. */
function elements(text) {
  const open = [[]];
  for (const [, end, tag, empty, words] of text.matchAll(/<(\/?)(\w+)[^>]*?(\/?)>|([^<]+)/g)) {
    if (words !== undefined) open.at(-1).push(words.replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&amp;', '&'));
    else if (end) {
      const content = open.pop();
      open.at(-1).push({ tag, content: typeof content[0] === 'string' ? content.join('') : content });
    } else if (empty) open.at(-1).push({ tag, content: [] });
    else open.push([]);
  }
  return open[0];
}

/** What is seen: elements and their text, without spaces, rows, and the sign between a function and its argument. */
function seen({ tag, content }) {
  const inside = typeof content === 'string' ? content.trim() : content.map(seen).filter(Boolean);
  if (tag === 'mspace' || inside === '\u2061' || inside === '') return '';
  if (['math', 'mrow', 'mstyle', 'mpadded', 'semantics'].includes(tag)) return Array.isArray(inside) ? inside.join('') : inside;
  return `${tag}(${Array.isArray(inside) ? inside.join('|') : inside})`;
}

function judged(latex) {
  const text = katex.renderToString(latex, { output: 'mathml', strict: 'ignore', maxExpand: 1_000_000 });
  const [, inside] = /<semantics>(.*)<annotation/s.exec(text);
  // Each prime is an element of its own there.
  return elements(inside).map(seen).join('').replaceAll('mo(′)mo(′)', 'mo(′′)');
}

test('every formula of the library is as KaTeX has it', async () => {
  const ask = await engine();
  const formulas = new Set();
  const collect = (value) => {
    if (value === null || typeof value !== 'object') return;
    if (typeof value.latex === 'string') formulas.add(value.latex);
    Object.values(value).forEach(collect);
  };
  for (const { text } of ask({ ask: 'library' }).specs) {
    ask({ ask: 'open', text }).items.forEach((_, item) => ['facts', 'ends'].forEach((question) => collect(ask({ ask: question, item }))));
  }
  assert.ok(formulas.size > 5000, `${formulas.size}`);
  for (const latex of formulas) assert.equal(seen(mathml(latex)), judged(latex), latex);
});

test('so is what the library does not write', () => {
  const formulas = [
    '\\sin^{2}\\left(\\theta\\right) e^{-2\\,t}', "C''\\left(0\\right)", "{b}''", '{b}^{(3)}', "b_{1}'", '{Q_{1}}_{0}', 'x^{2}_{1}', '\\binom{n}{k}',
    '\\sum_{0 \\le i \\le n} \\frac{i}{n}\\,b_{i} = t', '\\prod_{i \\ne j} x_{i}', '\\int x', '\\left\\lfloor x \\right\\rfloor', '\\left\\lceil x \\right\\rceil',
    '\\left(a + b\\right)!', '\\left\\langle a, b \\right\\rangle', '\\left(a\\right) \\times \\left(b\\right)', '\\sqrt{2}', '\\left[\\,\\right]', 'a \\parallel b',
    '\\Lambda_{P}', '\\vartheta', '\\ell', '\\max\\left(a, b\\right)', '\\partial_{\\lambda}^{2} b', '2 \\cdot 3^{n} > 1', '\\left(1\\right)\\quad 0 \\le i < n,\\ i \\ne 1',
  ];
  for (const latex of formulas) assert.equal(seen(mathml(latex)), judged(latex), latex);
});

test('names of several letters stay together, and rare letters are themselves', () => {
  assert.deepEqual(mathml('\\mathit{wei\\_ght}').content, [{ tag: 'mi', content: 'wei_ght', attributes: { class: 'word' } }]);
  assert.equal(mathml('\\mathrm{u416}_{1}').content[0].content[0].content, 'Ж');
});

test('what the engine does not write is an error', () => {
  for (const latex of ['\\href{a}{b}', '{', '}', '\\frac{1}', '\\left(', '\\left( a', 'a^', 'x^2', '$', '\\', '&', `${'{'.repeat(100_000)}`]) {
    assert.throws(() => mathml(latex), /no LaTeX that the engine writes/, latex.slice(0, 20));
  }
});
