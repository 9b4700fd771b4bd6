// The page before a server that is fed with shots: fed.mjs URL SHOTS CALIBRATION. It must not grow, whatever it is told.

import { Pictures, assert, assertQuiet, demand, holdings, look, openBench, settle, until, withBrowser } from "./browser.mjs";

const [url, shots, calibration] = process.argv.slice(2);
/** Four times as many shots fill everything that is bounded. */
const FILLED = 1100;
const MOST_GROWTH = 1.05;
/**
 * Everything is compiled once, when it is first called. Otherwise what runs for long is compiled anew, for speed: that
 * code is in the heap too, and after 288,000 shots was all that had come to it.
 */
const COMPILED_ONCE = ["--always-sparkplug", "--no-maglev", "--no-opt"];

await withBrowser(async (browser) => {
  const { page, complaints } = await openBench(browser, url);
  const fed = async (count) => {
    const last = await demand(`feed ${count}`);
    await until(() => page.locator(".lamp.shot").textContent(), (text) => text.includes(`shot ${last}`), `shot ${last}`, 600_000);
    await settle(page, { quietMs: 500 });
  };
  for (const view of ["cameras", "volume", "run", "velocity", "overview"]) await look(page, view);
  // Twice what is measured below: what is made once, or up to a bound, is there then.
  for (const view of ["velocity", "overview", "velocity", "overview"]) {
    await look(page, view);
    await fed(FILLED);
  }
  await until(() => page.locator(".overview .log").textContent(), (text) => text.includes("<img"), "hostile words");
  assert.match(await page.locator(".overview").textContent(), /1 of 2 cameras/);
  assert.match(await page.locator(".overview .hashes tbody tr").textContent(), new RegExp(`^cam2<img.*${calibration}$`));
  await placedParticles(browser, page);
  const before = await holdings(page);
  await look(page, "velocity");
  await fed(Math.floor(Number(shots) / 2));
  await look(page, "overview");
  await fed(Math.ceil(Number(shots) / 2));
  const after = await holdings(page);
  console.log(JSON.stringify({ shots: Number(shots), before, after }));
  for (const what of ["heap", "nodes", "gpu"]) {
    assert.ok(after[what] <= MOST_GROWTH * before[what], `${what} grew from ${before[what]} to ${after[what]}`);
  }
  assert.ok(before.gpu > 0, "something is drawn in space");
  // Words of the server have stayed words.
  assert.equal(await page.evaluate(() => window.taken), undefined);
  assert.equal(await page.locator("main img, main script, main iframe").count(), 0);
  assertQuiet(complaints, /Failed to load resource: the server responded with a status of (404|410|503)/);
}, COMPILED_ONCE);

/** The particles of the latest shot are counted and drawn, unless they are not wanted. */
async function placedParticles(browser, page) {
  await look(page, "volume");
  const reading = page.locator(".volume .reading", { hasText: "Particles placed" }).locator("dd");
  await until(() => reading.textContent(), (text) => text === "300, 225 valid", "the number of particles");
  assert.ok(await page.locator(".volume .colour-bar").isVisible());
  const eye = await Pictures.open(browser);
  for (const plane of await page.locator("canvas.projection").all()) {
    await page.check(".volume .tick input");
    const drawn = await eye.take(plane);
    await page.uncheck(".volume .tick input");
    const pixels = await eye.differing(drawn, await eye.take(plane));
    assert.ok(pixels > 300, `particles are drawn on ${pixels} pixels`);
  }
  await page.check(".volume .tick input");
  await eye.reader.close();
  await look(page, "overview");
}
