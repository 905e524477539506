// Opens a report in headless Chromium and does what a reader would; prints what it saw as JSON.
// report_browser.mjs PACKAGES CHROMIUM PAGE PICTURE WIDTH HEIGHT SCHEME [ELEMENT]; without ELEMENT it only looks
import { mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [packages, chromium, page_path, picture, width, height, scheme, element] = process.argv.slice(2);
const playwright = createRequire(join(packages, 'package.json'))('playwright-core').chromium;
const profile = mkdtempSync(join(tmpdir(), 'towform-browser-'));
const seen = { errors: [], requests: [] };

const browser = await playwright.launchPersistentContext(profile, {
  executablePath: chromium, headless: true, viewport: { width: Number(width), height: Number(height) }, colorScheme: scheme,
  args: ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update',
    '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
});
try {
  const page = await browser.newPage();
  page.on('console', (message) => { if (message.type() === 'error') seen.errors.push(message.text()); });
  page.on('pageerror', (error) => seen.errors.push(String(error)));
  page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) seen.requests.push(request.url()); });
  await page.goto(pathToFileURL(page_path).href);
  await page.waitForFunction(() => document.getElementById('viewer').dataset.ready, null, { timeout: 60000 });
  seen.ready = await page.evaluate(() => document.getElementById('viewer').dataset.ready);
  if (seen.ready !== 'yes') throw new Error(await page.evaluate(() => document.getElementById('viewer').textContent));

  if (element !== undefined) await use(page);
  seen.overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  await page.screenshot({ path: picture });
} finally {
  await browser.close();
  rmSync(profile, { recursive: true, force: true });
}
console.log(JSON.stringify(seen));

async function use(page) {
  // Where an element's middle is on the page, seen from below with the tools off.
  for (const box of await page.locator('input[id^="tool-"]').all()) await box.uncheck();
  await page.uncheck('#yarns');
  await page.click('[data-view="below"]');
  const middle = () => page.evaluate((number) => {
    const { sheet, camera, renderer } = window.towformViewer;
    camera.updateMatrixWorld();
    const point = camera.position.clone().set(0, 0, 0);
    for (let k = 0; k < 3; k++) {
      const n = sheet.triangles[3 * number + k];
      point.x += sheet.nodes[3 * n] / 3;
      point.y += sheet.nodes[3 * n + 1] / 3;
      point.z += sheet.nodes[3 * n + 2] / 3;
    }
    point.project(camera);
    const box = renderer.domElement.getBoundingClientRect();
    return [box.left + (0.5 + 0.5 * point.x) * box.width, box.top + (0.5 - 0.5 * point.y) * box.height];
  }, Number(element));
  const colour = async () => {
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    const [x, y] = await middle();
    return page.evaluate(([px, py]) => {
      const canvas = window.towformViewer.renderer.domElement;
      const box = canvas.getBoundingClientRect();
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const context = copy.getContext('2d');
      context.drawImage(canvas, 0, 0);
      const at = [((px - box.left) * canvas.width) / box.width, ((py - box.top) * canvas.height) / box.height];
      return [...context.getImageData(Math.round(at[0]), Math.round(at[1]), 1, 1).data];
    }, [x, y]);
  };
  const picked = () => page.evaluate(() => {
    const place = document.getElementById('picked');
    const values = {};
    for (const cell of place.querySelectorAll('[data-field]')) values[cell.dataset.field] = Number(cell.dataset.value);
    return { element: Number(place.dataset.element), values, curve: place.querySelectorAll('path.curve').length };
  });

  await page.evaluate(() => document.getElementById('stage').scrollIntoView());
  await page.mouse.click(...(await middle()));
  await page.waitForFunction(() => document.getElementById('picked').dataset.element !== undefined, null, { timeout: 10000 });
  seen.picked = await picked();
  seen.colour = await colour();
  seen.label = await page.textContent('#bar-label');
  await page.selectOption('#field', 'thickness');
  await page.waitForFunction(() => document.getElementById('bar-label').textContent.startsWith('Thickness'));
  seen.other_colour = await colour();
  await page.selectOption('#field', 'shear_angle');

  seen.last = await page.evaluate(() => [...window.towformViewer.sheet.nodes]);
  seen.last_time = await page.textContent('#time');
  await page.fill('#frame', '0');
  seen.first = await page.evaluate(() => [...window.towformViewer.sheet.nodes]);
  seen.first_time = await page.textContent('#time');
  await page.fill('#frame', await page.getAttribute('#frame', 'max'));

  await page.selectOption('#cut', '1');
  seen.cut = await page.evaluate(() => window.towformViewer.cut.sheet.object.geometry.attributes.instanceStart?.count ?? 0);
  await page.selectOption('#cut', '-1');
  for (const box of await page.locator('input[id^="tool-"]').all()) await box.check();
  await page.check('#yarns');
  await page.click('[data-view="iso"]');
  await page.click('#play');
  await page.waitForFunction(() => Number(document.getElementById('frame').value) > 0 && document.getElementById('play').textContent === '▶',
    null, { timeout: 60000 });
}
