// The page before a run whose particles are placed in the images: placed.mjs URL READ_TOKEN PICTURES [SHOT].
// A shot is named where the run is over; otherwise it goes on, and the particles change from shot to shot.

import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import { Pictures, assert, assertQuiet, enterToken, look, openBench, settle, until, withBrowser } from "./browser.mjs";

const [url, readToken, pictures, shot] = process.argv.slice(2);
/** The first requests have no token; there is nothing to see before the first shot; light of the volume is not stored. */
const EXPECTED = /Failed to load resource: the server responded with a status of (401|404|410)/;

await withBrowser(async (browser) => {
  await mkdir(pictures, { recursive: true });
  const { page, complaints } = await openBench(browser, url);
  await page.waitForSelector("dialog[open] #token");
  await enterToken(page, readToken);
  await look(page, "volume");
  const reading = page.locator(".volume .reading", { hasText: "Particles placed" }).locator("dd");
  const placed = () => reading.textContent();
  const words = await until(placed, (text) => /^\d+, \d+ valid$/.test(text), "placed particles", 120_000);
  const [found, valid] = words.match(/\d+/g).map(Number);
  assert.ok(valid > 20 && valid <= found, words);
  assert.match(await page.locator(".volume .colour-bar").textContent(), /speed of the particles \(m\/s\)0/);

  const number = page.locator(".volume .shot-choice input");
  if (shot) {
    assert.equal(await number.inputValue(), shot);
  } else {
    await until(placed, (text) => text !== words && /valid$/.test(text), "particles of another shot", 120_000);
    await page.click(".volume .shot-choice button:text('Hold')");
  }
  await settle(page);
  const eye = await Pictures.open(browser);
  for (const theme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: theme, reducedMotion: "reduce" });
    for (const plane of await page.locator("canvas.projection").all()) {
      const drawn = await eye.take(plane);
      await page.uncheck(".volume .tick input");
      const pixels = await eye.differing(drawn, await eye.take(plane));
      assert.ok(pixels > 10 * valid / 2, `${valid} particles are drawn on ${pixels} pixels`);
      await page.check(".volume .tick input");
    }
    await page.screenshot({ path: join(pictures, `volume-placed${shot ? "-recorded" : ""}-${theme}.png`), fullPage: true });
  }
  assertQuiet(complaints, EXPECTED);
});
