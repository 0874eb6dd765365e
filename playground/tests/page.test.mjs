// The page in a browser: what a user does, and what has to be seen then. `npm run build` comes first.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import zlib from 'node:zlib';
import { chromium } from 'playwright-core';
import { BUDGET } from '../budget.mjs';
import { serve } from '../serve.mjs';
import { LAUNCH } from './browser.mjs';
import { load } from './bundle.mjs';

const dist = path.join(path.dirname(fileURLToPath(import.meta.url)), '..', 'dist');
let server, address, browser;
/** What pages complained about. */
const complaints = [];

before(async () => {
  ({ server, address } = await serve(0));
  browser = await chromium.launch(LAUNCH);
});
after(async () => {
  await browser?.close();
  server?.close();
});

async function open(fragment = '', options = {}) {
  const context = await browser.newContext({ viewport: { width: 1300, height: 850 }, ...options });
  const page = await context.newPage();
  page.on('console', (m) => { if (['error', 'warning'].includes(m.type())) complaints.push(m.text()); });
  page.on('pageerror', (e) => complaints.push(e.message));
  page.on('request', (r) => { if (![address, `blob:${address}`, 'data:'].some((own) => r.url().startsWith(own))) complaints.push(`asks for ${r.url()}`); });
  await page.goto(address + fragment);
  return page;
}

/** What the page says beside its name. */
const status = (page) => page.textContent('#status');
/** Until every claim is decided. */
const decided = (page, timeout = 20_000) => page.waitForSelector('body[data-state=done]', { timeout });

/** Replaces the text as a user does. */
async function write(page, text) {
  await page.click('.cm-content');
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
}

/** Replaces the text by the clipboard, in which a browser is faster. */
async function paste(page, text) {
  await page.click('.cm-content');
  await page.keyboard.press('Control+a');
  await page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text/plain', text);
    document.querySelector('.cm-content').dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  }, text);
}

/** A family that no file has. */
const TENSION = `/// A cubic with a tension.
family Tension {
    domain 0 <= t <= 1;
    shape 0 <= τ <= 3;

    b[0] = (1 - t)^2 * (1 - τ*t/3);
    b[1] = t*(1 - t)*(2 + τ/3);
    b[2] = t^2 * (1 - τ*(1 - t)/3);

    prove partition_of_unity;
    prove nonnegative;
    refute b[1] <= 1/2;
}
`;

test('the first spec is decided at once', async () => {
  const page = await open();
  await decided(page);
  assert.match(await status(page), /^14 proved · 1 refuted · /);
  assert.equal(await page.locator('.verdicts .verdict.right').count() > 8, true);
  assert.deepEqual(await page.locator('path.function').evaluateAll((all) => all.map((p) => p.dataset.function)), ['b[0]', 'b[1]', 'b[2]', 'b[3]']);
  const first = await page.evaluate(() => performance.getEntriesByName('first-verdict')[0].startTime);
  console.log(`first verdict ${first.toFixed(0)} ms after the page was asked for`);
  assert.ok(first < 4000, `${first} ms, on a busy machine`);
  await page.context().close();
});

/** The fragment of a state. */
async function link(state) {
  const { encode } = await load('share.ts');
  return `#${await encode(state)}`;
}

/** What only the whole engine knows, asked while no more than its first part is there. */
const LATE = {
  'a spec with functions that the first one does not call': [{ library: 'trigonometric/shape' }, 'path.function'],
  'a spec that uses others': [{ text: 'use library "hermite"; family F { domain 0 <= t <= 1; b[0] = CubicHermite[0]; b[1] = CubicHermite[2]; prove partition_of_unity; }' }, 'path.function'],
  'formulas': [{ library: 'quartic', tab: 'functions' }, '#panel-functions .formula math'],
  'code': [{ library: 'quartic', tab: 'code' }, 'pre.code'],
  'the library': [{ library: 'quartic', tab: 'library' }, '[data-spec]'],
};

for (const [name, [state, seen]] of Object.entries(LATE)) {
  test(`asked at once: ${name}`, async () => {
    const page = await open(await link(state));
    await decided(page);
    assert.equal(await page.getAttribute('#status', 'class'), 'right', await status(page));
    await page.waitForSelector(seen, { timeout: 20_000 });
    assert.equal(await page.locator('#panels .wrong:not(.verdict):visible').count(), 0);
    await page.context().close();
  });
}

test('what is typed before the whole engine is there is decided all the same', async () => {
  const page = await open();
  await page.waitForFunction(() => /family/.test(document.querySelector('.cm-content')?.textContent));
  await paste(page, TENSION);
  await page.waitForFunction(() => document.querySelector('#family').textContent === 'Tension');
  await decided(page);
  assert.match(await status(page), /^2 proved · 1 refuted/);
  await page.click('#tab-functions');
  await page.waitForFunction(() => document.querySelector('#panel-functions h2')?.textContent === 'Tension');
  await page.context().close();
});

test('typing a family of one’s own, and a false claim', async () => {
  const page = await open();
  await decided(page);
  await write(page, TENSION);
  await page.waitForFunction(() => document.querySelector('#family').textContent === 'Tension');
  await decided(page);
  // At τ = 3 and t = 1/3 the sum is 1, and b[0] has no negative value.
  assert.match(await status(page), /^2 proved · 1 refuted/);
  assert.equal(await page.locator('.verdicts .verdict.wrong').count(), 0);
  // A wider range makes the first function negative.
  await write(page, TENSION.replace('τ <= 3', 'τ <= 4'));
  await page.waitForSelector('.verdicts .verdict.wrong');
  assert.equal(await page.textContent('.verdicts .verdict.wrong'), '✗');
  await page.click('#tab-verdicts');
  const wrong = page.locator('li.wrong button');
  assert.match(await wrong.textContent(), /nonnegative.*refuted: b\[0\] is -.* at τ = /s);
  await wrong.click();
  // The slider stands where the claim fails, and the point is marked.
  await page.waitForSelector('circle.counterexample');
  const [, shape, t] = /τ = ([\d/]+), t = ([\d/]+)/.exec(await page.textContent('.mark-note'));
  const value = (q) => q.split('/').reduce((a, b) => Number(a) / Number(b ?? 1));
  assert.ok(Math.abs(Number(await page.inputValue('#shape-τ')) - value(shape)) < 1e-6);
  assert.ok(value(t) > 0 && value(t) < 1 && value(shape) > 3);
  await page.context().close();
});

test('a counterexample belongs to the text that was decided, and to its function', async () => {
  const page = await open();
  await decided(page);
  await write(page, TENSION.replace('refute', 'prove'));
  await page.waitForSelector('.verdicts .verdict.wrong');
  await decided(page);
  await page.click('#tab-verdicts');
  await page.click('li.wrong button');
  // The claim is about one function, and the point lies on it.
  const circle = page.locator('circle.counterexample');
  await circle.waitFor();
  const [at, curve] = [await circle.boundingBox(), await page.locator('path.function[data-function="b[1]"]').boundingBox()];
  const height = at.y + at.height / 2;
  assert.ok(height > curve.y - 8 && height < curve.y + curve.height / 2, `${height} beside ${JSON.stringify(curve)}`);
  assert.match(await page.textContent('.mark-note'), /fails at/);
  await write(page, TENSION);
  await decided(page);
  await page.waitForFunction(() => !document.querySelector('circle.counterexample'));
  assert.equal(await page.locator('.mark-note').isVisible(), false);
  await page.context().close();
});

test('every span has its formulas', async () => {
  const page = await open();
  await decided(page);
  await write(page, `family Hat {
    domain 0 <= x <= 1, 1 <= x <= 3;
    f[0] = x^2 | (3 - x)^2/4;
    f[1] = 1 - f[0];
}`);
  await page.waitForFunction(() => document.querySelector('#family').textContent === 'Hat');
  await page.click('#tab-functions');
  await page.waitForFunction(() => document.querySelectorAll('#panel-functions .formulas .formula').length >= 6);
  const lines = await page.locator('#panel-functions .formulas').first().locator('.formula').allTextContents();
  assert.equal(lines.filter((line) => line.startsWith('on ')).length, 2, lines.join('\n'));
  assert.equal(lines.length, 6);
  // The curve ends where the last span does.
  await page.waitForFunction(() => /C\(3\)/.test(document.querySelector('#panel-functions').textContent));
  await page.context().close();
});

test('a mistake has its message at its place', async () => {
  const page = await open();
  await decided(page);
  await write(page, TENSION.replace('(2 + τ/3)', '(2 + σ/3)'));
  await page.waitForSelector('.cm-lintRange-error');
  assert.equal(await page.textContent('.cm-lintRange-error'), 'σ');
  await page.click('#tab-verdicts');
  assert.match(await page.textContent('.message'), /error: .*σ/);
  await page.context().close();
});

test('a slider changes the curves, by mouse and by keyboard', async () => {
  const page = await open();
  await decided(page);
  const path = () => page.getAttribute('path[data-function="b[1]"]', 'd');
  const before = await path();
  await page.locator('#shape-λ').fill('-2.5');
  const moved = await path();
  assert.notEqual(moved, before);
  assert.equal(await page.inputValue('.sliders input[type=number]'), '-2.5');
  await page.focus('#shape-λ');
  await page.keyboard.press('ArrowRight');
  assert.notEqual(await path(), moved);
  assert.equal(Number(await page.inputValue('.sliders input[type=number]')), -2.46);
  // Outside of the range nothing moves.
  const last = await path();
  await page.fill('.sliders input[type=number]', '7');
  assert.equal(await path(), last);
  assert.equal(await page.getAttribute('.sliders input[type=number]', 'aria-invalid'), 'true');
  await page.context().close();
});

test('control points are dragged, and moved with the arrow keys', async () => {
  const page = await open();
  await decided(page);
  const curve = () => page.getAttribute('path.curve', 'd');
  const before = await curve();
  await page.locator('circle.point').nth(1).scrollIntoViewIfNeeded();
  const box = await page.locator('circle.point').nth(1).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 60, box.y + 40, { steps: 4 });
  await page.mouse.up();
  const dragged = await curve();
  assert.notEqual(dragged, before);
  await page.focus('circle.point[data-point="2"]');
  await page.keyboard.press('ArrowUp');
  assert.notEqual(await curve(), dragged);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.point), '2');
  await page.context().close();
});

test('a surface has points to drag', async () => {
  const page = await open();
  await decided(page);
  await write(page, `use library "triangular"; family Flat { domain triangle (u, v, w); shape 0 < λ <= 1;
    b[1,0,0] = u; b[0,1,0] = v; b[0,0,1] = w; prove partition_of_unity; }`);
  await page.waitForFunction(() => [...document.querySelector('#family').options].some((o) => o.textContent === 'Flat'));
  await page.selectOption('#family', { label: 'Flat' });
  await page.waitForSelector('.scene polygon');
  assert.equal(await page.locator('.scene circle.point').count(), 3);
  const faces = () => page.locator('.scene polygon').first().getAttribute('points');
  const before = await faces();
  await page.locator('.scene circle.point').nth(0).scrollIntoViewIfNeeded();
  const box = await page.locator('.scene circle.point').nth(0).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 30, box.y - 40, { steps: 3 });
  await page.mouse.up();
  assert.notEqual(await faces(), before);
  assert.match(await page.textContent('.map + .hint'), /from 0 to 1;/);
  await page.context().close();
});

test('a family on a prism is cut at its height, wherever the triangle stands among the factors', async () => {
  const page = await open();
  await decided(page);
  for (const [name, domain] of [['Upon', '0 <= h <= 2, triangle (p, q, r)'], ['Below', 'triangle (p, q, r), 0 <= h <= 2']]) {
    await write(page, `family ${name} {
    domain ${domain};
    s[0] = p*(2 - h)/2;
    s[1] = q*(2 - h)/2;
    s[2] = r*(2 - h)/2;
    s[3] = (p + q + r)*h/2;
    prove partition_of_unity;
    prove s[3] <= 1/2;
}
`);
    await page.waitForFunction((name) => document.querySelector('#panel-plot h2')?.textContent === name, name);
    await decided(page);
    await page.selectOption('select[aria-label=function]', '1');
    // s[1] is at most 1 - h/2, at the corner where q is 1.
    await page.locator('input[aria-label=h]').fill('0.5');
    assert.match(await page.textContent('#panel-plot'), /s\[1\] from 0 to 0\.75;.*p = 1 at the right, q = 1 at the top, r = 1 at the left/);
    await page.click('#tab-verdicts');
    await page.locator('li.wrong button').click();
    await page.waitForSelector('circle.counterexample');
    await page.click('#tab-plot');
  }
  await page.context().close();
});

test('a link holds the text, the shape values and the points', async () => {
  const page = await open();
  await decided(page);
  await write(page, TENSION);
  await page.waitForFunction(() => document.querySelector('#family').textContent === 'Tension');
  await page.locator('#shape-τ').fill('2.25');
  await page.focus('circle.point[data-point="1"]');
  await page.keyboard.press('ArrowUp');
  const curve = await page.getAttribute('path.curve', 'd');
  await page.click('#share');
  await page.waitForFunction(() => /link/.test(document.querySelector('#status').textContent));
  const link = page.url();
  assert.ok(link.length < 1500, `${link.length} characters`);
  const other = await open(link.slice(address.length));
  await decided(other);
  assert.equal(await other.textContent('#family'), 'Tension');
  assert.equal(Number(await other.inputValue('.sliders input[type=number]')), 2.25);
  await other.waitForSelector('path.curve');
  assert.equal(await other.locator('circle.point').count(), 3);
  // The same curve, up to the digits of a link.
  const numbers = (d) => d.match(/[\d.]+/g).map(Number);
  const [a, b] = [numbers(curve), numbers(await other.getAttribute('path.curve', 'd'))];
  assert.equal(a.length, b.length);
  await other.context().close();
  // A damaged one says so.
  const damaged = await open('#1.AAAA');
  await damaged.waitForSelector('path.function');
  await damaged.context().close();
  await page.context().close();
});

test('every spec of the library opens without errors and is drawn', async () => {
  const page = await open();
  await decided(page);
  await page.click('#tab-library');
  await page.waitForSelector('[data-spec]');
  const names = await page.locator('[data-spec]').evaluateAll((all) => all.map((b) => b.dataset.spec));
  assert.ok(names.length >= 28, `${names.length}`);
  for (const name of names) {
    await page.click('#tab-library');
    await page.click(`[data-spec="${name}"]`);
    await page.waitForSelector('body[data-state=done], body[data-state=failed]', { timeout: 60_000 });
    assert.equal(await page.getAttribute('#status', 'class'), 'right', `${name}: ${await status(page)}`);
    assert.equal(await page.locator('.verdicts .verdict.wrong').count(), 0, name);
    const options = await page.locator('#family option').evaluateAll((all) => all.map((o, k) => [k, o.textContent]));
    // The first and the last family; joins and theorems have no picture.
    const families = options.filter(([, title]) => !/^(join|theorem) /.test(title));
    await page.click('#tab-plot');
    for (const [k, title] of new Set([families[0], families.at(-1)].filter(Boolean))) {
      await page.selectOption('#family', String(k));
      await page.waitForFunction((title) => document.querySelector('#panel-plot h2')?.textContent === title, title);
      const drawn = await page.locator('#panel-plot path.function, #panel-plot .scene polygon').count();
      assert.ok(drawn > 0, `${name}, ${title}`);
      const broken = await page.locator('#panel-plot path.function').evaluateAll((all) => all.filter((p) => !/^M/.test(p.getAttribute('d')) || /NaN/.test(p.getAttribute('d'))).length);
      assert.equal(broken, 0, `${name}, ${title}`);
    }
    await page.click('#tab-functions');
    const title = await page.evaluate(() => document.querySelector('#family').selectedOptions[0].textContent);
    await page.waitForFunction((title) => document.querySelector('#panel-functions h2')?.textContent === title, title);
    assert.equal(await page.locator('#panel-functions .wrong').count(), 0, name);
  }
  await page.click('#tab-library');
  assert.ok(await page.locator('#panel-library dt').count() >= 20, 'what the literature has wrong');
  await page.context().close();
});

test('code is that of the command, and a false claim has none', async () => {
  const page = await open();
  await decided(page);
  await page.click('#tab-code');
  await page.waitForSelector('pre.code');
  for (const language of await page.locator('#panel-code option').evaluateAll((all) => all.map((o) => o.value))) {
    await page.selectOption('#panel-code select', language);
    await page.waitForFunction((to) => document.querySelector('#panel-code code')?.textContent.endsWith(`--to ${to}`), language);
    assert.match(await page.textContent('pre.code'), /[Qq]uartic_?[Bb]ernstein/);
  }
  await write(page, TENSION.replace('τ <= 3', 'τ <= 4'));
  await page.waitForSelector('#panel-code .wrong');
  assert.match(await page.textContent('#panel-code .wrong'), /nonnegative is false/);
  await page.context().close();
});

test('claims that hold are found and inserted', async () => {
  const page = await open();
  await decided(page);
  await write(page, TENSION);
  await page.waitForFunction(() => document.querySelector('#family').textContent === 'Tension');
  await page.click('#tab-verdicts');
  await page.click('text=Find more that holds');
  await page.click('text=Insert these claims');
  await page.waitForFunction(() => /prove symmetric;/.test(document.querySelector('.cm-content').textContent));
  await page.waitForFunction(() => /^[5-9]|^\d\d/.test(document.querySelector('#status').textContent));
  assert.equal(await page.locator('.verdicts .verdict.wrong').count(), 0);
  await page.context().close();
});

test('Greek letters are written by their names', async () => {
  const page = await open();
  await decided(page);
  await write(page, '');
  await page.keyboard.type('family F { shape 0 <= \\lam');
  await page.waitForSelector('.cm-tooltip-autocomplete li[aria-selected]:has-text("lambda")');
  // The editor does not take a key for an answer to a list that has only just opened.
  await page.waitForTimeout(200);
  await page.keyboard.press('Enter');
  assert.match(await page.textContent('.cm-content'), /0 <= λ/);
  await page.context().close();
});

/** Specs that take as long as the engine or the page lets them: in one claim, or in all of them together. */
const HOSTILE = {
  'one claim': [`family H { budget 1000; domain 0 <= t <= 1; shape 0 <= λ <= 1; shape 0 <= μ <= 1; shape 0 <= ν <= 1;
    b[0] = t; b[1] = 1 - t;
    prove (t^2*μ - λ)^2 + (t*λ - 3/7*ν)^2 + (λ*μ - ν*t)^2*(μ - ν)^2 + (λ - 1/3)^2*(ν - 2/5*t)^2 + 1/10^12 > 0; }`, /longer than 5 s|1 undecided/],
  'many claims': [`family H { domain 0 <= t <= 1; shape 0 <= λ <= 1; b[0] = t; b[1] = 1 - t;
    ${Array.from({ length: 3000 }, (_, k) => `prove (t^2 - λ)^2*(t*λ - 3/7 - ${k}/3000)^2 + 1/10^18 > 0;`).join('\n')} }`, /\d+ undecided · .*error|stopped after 3\d s, \d+ claims decided/],
};

for (const [name, [text, said]] of Object.entries(HOSTILE)) {
  test(`a hostile spec does not freeze the page, and is told of: ${name}`, async () => {
    const page = await open();
    await decided(page);
    await page.evaluate(() => { window.ticks = 0; setInterval(() => { window.ticks += 1; }, 50); });
    const start = Date.now();
    await paste(page, text);
    await page.waitForFunction(() => document.body.dataset.state !== 'deciding', undefined, { timeout: 120_000 });
    console.log(`after ${Date.now() - start} ms: ${await status(page)}`);
    assert.match(await status(page), said);
    const ticks = await page.evaluate(() => window.ticks);
    assert.ok(ticks * 50 > (Date.now() - start) / 4, `the page itself goes on: ${ticks}`);
    // And the engine is there for the next text.
    await paste(page, TENSION);
    await page.waitForFunction(() => document.querySelector('#family').textContent === 'Tension', undefined, { timeout: 20_000 });
    await decided(page);
    assert.match(await status(page), /^2 proved · 1 refuted/);
    await page.context().close();
  });
}

test('on a phone one view is seen at a time, and nothing is wider than the screen', async () => {
  const page = await open('', { viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2, colorScheme: 'dark' });
  await decided(page);
  assert.ok(await page.isVisible('.cm-content'));
  for (const tab of ['functions', 'plot', 'verdicts', 'code', 'library']) {
    await page.click(`#tab-${tab}`);
    await page.waitForTimeout(150);
    assert.ok(!(await page.isVisible('.cm-content')), tab);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), tab);
  }
  await page.context().close();
});

test('everything can be reached with the keyboard', async () => {
  const page = await open();
  await decided(page);
  await page.focus('#tab-plot');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'tab-verdicts');
  assert.ok(await page.isVisible('#panel-verdicts'));
  await page.keyboard.press('Tab');
  assert.ok(await page.evaluate(() => document.activeElement.matches('#family, #panel-verdicts button, .cm-content')));
  await page.context().close();
});

test('no page complained, and all of it fits into the budget', () => {
  assert.deepEqual(complaints, []);
  const sizes = fs.readdirSync(dist).map((file) => zlib.gzipSync(fs.readFileSync(path.join(dist, file)), { level: 9 }).length);
  const all = sizes.reduce((a, b) => a + b, 0);
  assert.ok(all <= BUDGET, `${all} bytes`);
});
