// The page's statistics of a run that is over: statistics.mjs URL READ_TOKEN PICTURES. They are those of all of its shots,
// held against the shots themselves.

import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import { Pictures, ask, assert, assertQuiet, axeFinds, enterToken, look, openBench, readingOf, settle, until, withBrowser } from "./browser.mjs";

const [url, readToken, pictures] = process.argv.slice(2);
/** The first requests have no token; projections of the volume are not stored. */
const EXPECTED = /Failed to load resource: the server responded with a status of (401|404|410)/;
const get = (path) => ask(url, readToken, path);

/** A number as the page writes it. */
const read = (text) => Number(text.replace("−", "-"));

/** That two numbers are equal in the three digits that are shown. */
function assertShown(text, expected, what) {
  const shown = read(text);
  assert.ok(Math.abs(shown - expected) <= 0.006 * Math.abs(expected) + 1e-6, `${what}: ${text}, and not ${expected}`);
}

await withBrowser(async (browser) => {
  await mkdir(pictures, { recursive: true });
  const { page, complaints } = await openBench(browser, url);
  await page.waitForSelector("dialog[open] #token");
  await enterToken(page, readToken);
  const { shots: listed } = await get("/api/v1/shots?limit=100");
  const shots = listed.filter(({ vectors }) => vectors).map(({ shot }) => shot);
  const results = await Promise.all(shots.map((shot) => get(`/api/v1/results/${shot}`)));

  await look(page, "statistics");
  const view = page.locator(".view.statistics");
  await until(() => readingOf(view, "Shots"), (text) => Number(text) === shots.length, "all shots");
  assert.equal(await view.locator(".advice").textContent(), `Of the valid vectors of all ${shots.length} shots measured so far.`);
  const choose = (label, value) => view.getByLabel(label, { exact: true }).selectOption(value);

  // The point that is shown: in the middle of the slice, on the line.
  const { vectors_xyz: n, first_mm: first, spacing_mm: spacing } = results[0].grid;
  const middle = n.map((m) => Math.floor(m / 2));
  const point = middle[0] + n[0] * (middle[1] + n[1] * middle[2]);
  const here = view.locator(".reading.wide");
  const label = await here.locator("dt").textContent();
  assertShown(label.match(/^On the line, at x = (\S+) mm$/)[1], first[0] + spacing * middle[0], label);
  const samples = results.filter(({ status }) => status[point] === "valid");
  const UNITS = { mean: "m/s", rms: "m/s" };
  for (const [c, component] of ["u", "v", "w"].entries()) {
    await choose("Quantity", `${component}_mean`);
    const mean = samples.reduce((sum, { velocity_m_s: velocity }) => sum + velocity[point][c], 0) / samples.length;
    const { maps } = await get(`/api/v1/statistics?quantities=${component}_mean`);
    const text = await until(() => here.locator("dd").textContent(), (words) => Math.abs(read(words.split(" ")[0]) - mean) <= 0.006 * Math.abs(mean) + 1e-6, `the mean ${mean}`);
    const [, value, unit, low, high, count] = text.match(/^(\S+) (\S+), 95 %: (\S+) to (\S+); (\d+) vectors$/);
    assertShown(value, mean, text);
    assert.equal(unit, UNITS.mean);
    assertShown(low, maps[0].low[point], text);
    assertShown(high, maps[0].high[point], text);
    assert.equal(Number(count), samples.length);
    assert.ok(read(low) < read(value) && read(value) < read(high), text);
  }
  // A stress has another unit, and its own numbers; what is shown of the slice can be how sure it is.
  for (const [quantity, unit] of [["uv", " m²/s²"], ["u_rms", " m/s"], ["w_skewness", ""]]) {
    await choose("Quantity", quantity);
    const { maps: [map] } = await get(`/api/v1/statistics?quantities=${quantity}`);
    const expected = map.value[point];
    const text = await until(() => here.locator("dd").textContent(),
      (words) => (expected === null ? words === "too few shots" : Math.abs(read(words.split(/[ ,]/)[0]) - expected) <= 0.006 * Math.abs(expected) + 1e-6), `${quantity} ${expected}`);
    if (expected !== null && map.low[point] !== null) assert.ok(text.includes(`${unit}, 95 %: `), text);
  }
  await choose("Quantity", "u_mean");
  const bar = view.locator(".colour-bar .title");
  await until(() => bar.textContent(), (text) => text === "mean of u (m/s)", "the mean");
  const eye = await Pictures.open(browser);
  const canvas = view.locator("canvas.slice");
  assert.ok((await eye.differing(await eye.take(canvas))) > 2000, "a slice is drawn");
  await choose("Show", "samples");
  await until(() => bar.textContent(), (text) => text === "valid vectors", "the counts");
  assert.equal(await view.locator(".colour-bar .ends span").last().textContent(), String(shots.length));
  // None where it is not flow.
  const { samples: counts } = await get("/api/v1/statistics");
  assert.ok(counts.includes(0) && Math.max(...counts) === shots.length);
  await choose("Show", "half");
  await until(() => bar.textContent(), (text) => text === "mean of u: half of its 95 % interval (m/s)", "the intervals");
  await choose("Show", "value");

  // Convergence: to nothing at all shots.
  for (const plot of await view.locator(".plot canvas").all()) {
    assert.ok((await eye.differing(await eye.take(plot))) > 300, "a plot is drawn");
  }

  // The view Velocity has the same, as vectors.
  await look(page, "velocity");
  await page.locator(".velocity").getByLabel("Show", { exact: true }).selectOption("mean");
  await until(() => readingOf(page.locator(".velocity"), "Shots in mean and rms"), (text) => Number(text) === shots.length, "the mean of all shots");
  await look(page, "statistics");

  const violations = [];
  for (const [size, width] of [["wide", 1440], ["narrow", 420]]) {
    await page.setViewportSize({ width, height: 1000 });
    for (const theme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme: theme, reducedMotion: "reduce" });
      await page.evaluate(() => scrollTo(0, 0));
      await settle(page);
      await page.screenshot({ path: join(pictures, `statistics-${size}-${theme}.png`), fullPage: true });
      violations.push(...(await axeFinds(page, `${size}, ${theme}`)));
    }
    const [inner, whole] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
    assert.ok(whole <= inner + 1, `${size}: the page is ${whole} pixels wide`);
  }
  assert.deepEqual(violations, []);
  assertQuiet(complaints, EXPECTED);
});
