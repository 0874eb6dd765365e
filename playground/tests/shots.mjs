// Pictures of the page, to be looked at: `node tests/shots.mjs FOLDER`.
import fs from 'node:fs';
import { chromium } from 'playwright-core';
import { serve } from '../serve.mjs';
import { LAUNCH } from './browser.mjs';

const folder = process.argv[2] ?? 'shots';
fs.mkdirSync(folder, { recursive: true });
const { server, address } = await serve(0);
const browser = await chromium.launch(LAUNCH);
async function shots(name, options, specs) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  page.on('console', (m) => console.log(name, m.type(), m.text()));
  page.on('pageerror', (e) => console.log(name, 'error', e.message));
  await page.goto(address);
  for (const [spec, tabs] of specs) {
    if (spec) {
      await page.click('#tab-library');
      await page.click(`[data-spec="${spec}"]`);
    }
    await page.waitForSelector('body[data-state=done]', { timeout: 60_000 });
    for (const tab of tabs) {
      await page.click(`#tab-${tab}`);
      await page.waitForTimeout(500);
      await page.screenshot({ path: `${folder}/${name}-${(spec || 'first').replace('/', '-')}-${tab}.png` });
    }
  }
  await context.close();
}
const wide = { viewport: { width: 1300, height: 850 } };
const wanted = process.argv[3] ?? 'all';
if (wanted === 'all' || wanted === 'light') await shots('light', { ...wide, colorScheme: 'light' }, [['', ['plot', 'functions', 'verdicts', 'code', 'library']], ['triangular', ['plot']], ['lagrange', ['plot', 'verdicts']], ['splines/bspline', ['plot']], ['trigonometric/han', ['plot', 'functions']], ['quartic_surface', ['functions', 'verdicts']]]);
if (wanted === 'all' || wanted === 'dark') await shots('dark', { ...wide, colorScheme: 'dark' }, [['', ['plot', 'functions', 'verdicts']], ['triangular', ['plot']]]);
if (wanted === 'all' || wanted === 'phone') await shots('phone', { viewport: { width: 390, height: 780 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true, colorScheme: 'light' }, [['', ['text', 'plot', 'functions', 'verdicts', 'library']], ['triangular', ['plot']]]);
await browser.close();
server.close();
