// The page before a run that is over: served.mjs URL READ_TOKEN SHOTS. It is shown, and there is nothing to control.

import { Pictures, assert, assertQuiet, enterToken, laserWord, look, openBench, until, withBrowser } from "./browser.mjs";

const [url, readToken, shots] = process.argv.slice(2);
/** The first requests have no token; projections of the volume are not stored. */
const EXPECTED = /Failed to load resource: the server responded with a status of (401|404|410)/;

await withBrowser(async (browser) => {
  const { page, complaints } = await openBench(browser, url);
  await page.waitForSelector("dialog[open] #token");
  await enterToken(page, readToken);
  await until(() => laserWord(page), (word) => word === "no laser", "the laser's state");
  await until(() => page.locator(".overview tbody tr td").first().textContent(), (text) => Number(text) === Number(shots) - 1, "the last shot");
  await until(() => page.locator(".overview dd").first().textContent(), (text) => text === "finished", "the run's state");
  assert.equal(await page.locator(".connection .live").textContent(), "recorded");

  await look(page, "velocity");
  const space = page.locator("canvas.space");
  await until(() => space.getAttribute("data-gpu-objects"), (objects) => Number(objects) > 0, "a field");
  const eye = await Pictures.open(browser);
  await until(async () => eye.differing(await eye.take(space)), (pixels) => pixels > 2000, "vectors");
  const speed = () => page.locator(".velocity .readings dd").nth(3).textContent();
  const last = await until(speed, (text) => text.includes("m/s"), "the largest speed");
  await page.click(".velocity button[aria-label='Shot before']");
  await until(speed, (text) => text.includes("m/s") && text !== last, "the shot before");

  // The file of the body is gone since the run.
  const masked = () => page.locator(".velocity .readings dd").nth(2).textContent();
  await until(masked, (text) => Number(text) > 0, "masked vectors");
  await look(page, "volume");
  await until(() => page.locator(".volume .readings dd").nth(2).textContent(), (text) => text.includes("% of the volume"), "the share of the flow");
  assert.ok(await page.locator(".volume .legend").isVisible());

  await look(page, "cameras");
  const images = page.locator("canvas.zoom");
  await until(() => images.count(), (cameras) => cameras === 2, "both cameras");
  await until(async () => eye.differing(await eye.take(images.first())), (pixels) => pixels > 2000, "a raw image");

  await look(page, "run");
  await until(() => page.locator(".settings").textContent(), (text) => text.includes("[optics]"), "the configuration");
  for (const name of [".press .stop", ".press .disarm", "button:text('Arm …')", "button:text('Start')", "button:text('Set dt')"]) {
    assert.ok(await page.locator(name).isDisabled(), name);
  }
  assertQuiet(complaints, EXPECTED);
});
