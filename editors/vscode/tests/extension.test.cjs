// The extension as it is packaged, with a language server of its own, in an editor that has no window.
const assert = require('node:assert/strict');
const fs = require('node:fs');
const Module = require('node:module');
const os = require('node:os');
const path = require('node:path');
const { after, test } = require('node:test');
const { editor } = require('./vscode.cjs');

const command = process.env.BASIS ?? path.join(__dirname, '../../../target/debug/basis');
const { vscode, seen, open, type, select } = editor(command);
const load = Module._load;
Module._load = function (name, ...rest) {
  return name === 'vscode' ? vscode : load.call(this, name, ...rest);
};
const extension = require('../dist/extension.js');

const SPEC = `// 𝔸
family First {
    domain 0 <= t <= 1;
    shape 0 <= λ <= 1;
    b[0] = 1 - λ*t;
    b[1] = λ*t;
    prove nonnegative;
}
family Second(n in 2..=3) {
    domain 0 <= t <= 1;
    c[i] = binomial(n, i)*t^i*(1 - t)^(n - i) for i in 0..=n;
}
`;
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'basis-extension-'));
const context = { subscriptions: [] };
let shown;

/** What a question says when it is no longer empty. */
async function until(question) {
  for (const end = Date.now() + 20_000; Date.now() < end; ) {
    const answer = question();
    if (answer) return answer;
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  throw new Error(`nothing after 20 s: ${question}`);
}

const messages = () => seen.diagnostics.get(shown.document.uri.toString());

after(async () => {
  await extension.deactivate();
  fs.rmSync(folder, { recursive: true });
});

test('verdicts follow the text', async () => {
  shown = open(path.join(folder, 'f.basis'), SPEC, 1);
  await extension.activate(context);
  assert.deepEqual(seen.errors, []);
  assert.equal((await until(messages)).length, 0);
  type(shown, 'λ <= 1', 'λ <= 2');
  const [wrong] = await until(() => messages().length === 1 && messages());
  assert.match(wrong.message, /`b\[0\]` is -1 at λ = 2, t = 1/);
  assert.equal(wrong.range.start.line, 6);
  type(shown, '// 𝔸', '// 𝔸𝔸\n');
  await until(() => messages()[0]?.range.start.line === 7);
  type(shown, 'λ <= 2', 'λ <= 1');
  await until(() => messages().length === 0);
});

test('the preview draws the family around the cursor, with its sliders', async () => {
  await seen.commands.get('basis.preview')();
  const panel = await until(() => seen.panels[0]);
  // The cursor stands above all families.
  await until(() => panel.title === 'First');
  assert.match(panel.webview.html, /id="sliders"/);
  assert.match(panel.webview.html, /"name":"λ"/);
  select(shown, 10);
  await until(() => panel.title === 'Second(2)');
  // A text with errors keeps the last picture; the next one that has none is drawn.
  const before = panel.webview.html;
  type(shown, 'n - i)', 'n - i');
  await new Promise((resolve) => setTimeout(resolve, 1500));
  assert.equal(panel.webview.html, before);
  type(shown, 'n - i f', 'n - i)*2 f');
  await until(() => panel.webview.html !== before);
  // Closed and shown again.
  panel.close();
  await seen.commands.get('basis.preview')();
  await until(() => seen.panels[1]?.title === 'Second(2)');
  seen.panels[1].close();
});

test('a family opens as LaTeX', async () => {
  await seen.commands.get('basis.latex')();
  assert.match(seen.shown[0].content, /\\section\*\{Second/);
});

test('a server starts again, and one that cannot start says how to install it', async () => {
  await seen.commands.get('basis.restart')();
  type(shown, 'prove nonnegative', 'refute nonnegative');
  await until(() => messages().length === 1);
  const { getConfiguration } = vscode.workspace;
  vscode.workspace.getConfiguration = () => ({ ...getConfiguration(), get: () => '/no/such/command' });
  await seen.commands.get('basis.restart')();
  await until(() => seen.errors.some((e) => /cargo install --path cli/.test(e)));
});
