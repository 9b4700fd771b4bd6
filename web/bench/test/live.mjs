// The page before a run that takes shots: live.mjs URL READ_TOKEN CONTROL_TOKEN PICTURES

import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import {
  Pictures, ask, assert, assertQuiet, axeFinds, demand, enterToken, laserWord, look, openBench, readingOf, settle, until,
  withBrowser,
} from "./browser.mjs";

const [url, readToken, controlToken, pictures] = process.argv.slice(2);
const VIEWS = ["overview", "cameras", "volume", "velocity", "statistics", "run"];
const HOSTILE = `<img src=x onerror="window.taken=1"><script>window.taken=2</script>&lt;b&gt;`;
/** The browser's own lines on refused requests, and on those that nobody answered while the daemon was away. */
const EXPECTED = /Failed to load resource: (the server responded with a status of (401|403|404|409|410|503)|net::ERR_(CONNECTION|INCOMPLETE|EMPTY|FAILED))/;

/** Pixels of a canvas in the tint of what is not flow: light is grey, and red of no size or speed exceeds green so far. */
const tintedPixels = (page, canvasName) => page.evaluate((name) => {
  const canvas = document.querySelector(name);
  // Of a copy: a canvas of the page that is read several times makes Chromium complain.
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let n = 0; n < data.length; n += 4) count += data[n] > data[n + 1] + 30 && data[n] > data[n + 2] + 40;
  return count;
}, canvasName);

const began = Date.now();
const step = (words) => console.log(`${((Date.now() - began) / 1000).toFixed(1)} s: ${words}`);

await withBrowser(async (browser) => {
  await mkdir(pictures, { recursive: true });
  const { page, context, complaints } = await openBench(browser, url);

  step("nothing is shown without a token, and the laser is unknown");
  await page.waitForSelector("dialog[open] #token");
  assert.equal(await laserWord(page), "unknown");
  await enterToken(page, readToken);
  await until(() => laserWord(page), (word) => word === "firing", "the laser's state");

  step("the token is nowhere but in memory");
  assert.deepEqual(await context.cookies(), []);
  assert.deepEqual(await page.evaluate(() => [localStorage.length, sessionStorage.length, location.href.includes("?")]), [0, 0, false]);
  const held = await page.evaluate(() => document.documentElement.outerHTML);
  assert.ok(!held.includes(readToken));

  step("numbers are live");
  const firstShot = () => page.locator(".overview tbody tr td").first().textContent();
  const before = Number(await until(firstShot, (text) => /^\d+$/.test(text ?? ""), "a shot"));
  await until(firstShot, (text) => Number(text) > before + 2, "more shots");
  await until(() => page.locator(".lamp.camera strong").allTextContents(), (words) => words.join() === "delivers,delivers", "both cameras");

  assert.ok(!(await page.locator(".workers").isVisible()), "this run has no workers on other machines");

  step("vectors are drawn, and turn");
  await look(page, "velocity");
  const space = page.locator("canvas.space");
  await until(() => space.getAttribute("data-gpu-objects"), (objects) => Number(objects) > 0, "a field", 120_000);
  // What is held does not change by itself, once it is drawn.
  const choice = page.locator(".velocity .shot-choice");
  await choice.getByText("Hold").click();
  const kept = await choice.getByLabel("Shot number").inputValue();
  await until(() => space.getAttribute("data-shot"), (shot) => shot === kept, "the shot that is held");
  await settle(page);
  const eye = await Pictures.open(browser);
  const straight = await eye.take(space);
  assert.ok((await eye.differing(straight)) > 2000, `${await eye.differing(straight)} pixels are drawn`);
  const lastShot = async () => Number((await page.locator(".lamp.shot").textContent()).match(/shot (\d+)/)?.[1] ?? -1);
  const shotThen = await lastShot();
  await until(lastShot, (shot) => shot > shotThen, "another shot");
  await settle(page);
  assert.ok((await eye.differing(straight, await eye.take(space))) < 50, "the picture changes by itself");
  // How soon a change is drawn depends on what else the processors do.
  const isTurned = (from, by) => until(async () => eye.differing(from, await eye.take(space)), (pixels) => pixels > 2000, `a turn by ${by}`);
  await space.focus();
  for (let n = 0; n < 4; n += 1) await page.keyboard.press("ArrowRight");
  await isTurned(straight, "keys");
  const turned = await eye.still(space);
  const box = await space.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 120, box.y + box.height / 2 + 30, { steps: 4 });
  await page.mouse.up();
  await isTurned(turned, "the mouse");
  // However it is turned, its box is whole: nothing reaches the rim.
  const rims = [{ y: box.y }, { y: box.y + box.height - 3 }, { width: 3 }, { x: box.x + box.width - 3, width: 3 }];
  for (const rim of rims) {
    const clip = { ...box, height: rim.width ? box.height : 3, ...rim };
    assert.equal(await eye.differing(await eye.take(page, { clip })), 0, `something is cut at ${JSON.stringify(clip)}`);
  }
  await page.click(".velocity .shot-choice button:text('Follow')");

  step("the mean is that of the run, not of the shots that the page has fetched");
  const { done } = (await ask(url, readToken, "/api/v1/status")).shots;
  const velocity = page.locator(".velocity");
  await velocity.getByLabel("Show", { exact: true }).selectOption("mean");
  const inMean = () => readingOf(velocity, "Shots in mean and rms");
  await until(inMean, (text) => Number(text) >= done, "the mean of the run");
  await velocity.getByLabel("Show", { exact: true }).selectOption("shot");
  await until(() => velocity.locator(".reading:visible dt", { hasText: "Shots in mean and rms" }).count(), (shown) => shown === 0, "a shot alone");

  step("what is not flow is tinted, and no vector is there");
  await until(() => page.locator(".velocity .readings dd").nth(2).textContent(), (text) => Number(text) > 0, "masked vectors");
  await look(page, "volume");
  await until(() => page.locator(".volume .legend").isVisible(), (visible) => visible, "the legend");
  await until(() => tintedPixels(page, "canvas.projection"), (pixels) => pixels > 500, "the tint");
  await look(page, "velocity");
  // A slice through the middle of the body, which lies along z.
  await until(() => tintedPixels(page, "canvas.slice"), (pixels) => pixels > 500, "the tint of the slice");

  step("the seeding of both images of both cameras");
  await look(page, "cameras");
  const seedings = () => page.locator(".cameras-view .reading", { hasText: "Seeding a, b" }).locator("dd").allTextContents();
  const densities = await until(seedings, (words) => words.length === 2 && words.every((text) => /^\d+\.\d+, \d+\.\d+$/.test(text)), "densities");
  // The scene has 0.5; chance, and the body in the corner, have their share.
  for (const found of densities.join(", ").split(", ").map(Number)) assert.ok(found > 0.2 && found < 1, `${found} particles per microlens`);
  await look(page, "velocity");

  step("control fails without the scope");
  await page.click(".press .stop");
  const said = () => page.locator(".said").textContent();
  await until(said, (text) => text.includes("needs control"), "the refusal");
  assert.equal(await laserWord(page), "firing");

  step("control works with a token: stop and disarm are one press in every view");
  await enterToken(page, controlToken);
  for (const view of VIEWS) {
    await look(page, view);
    for (const name of ["stop", "disarm"]) {
      assert.ok(await page.locator(`.press .${name}`).isEnabled());
      assert.ok(await page.locator(`.press .${name}`).isVisible());
    }
  }
  await page.click(".press .stop");
  await until(() => laserWord(page), (word) => word === "armed", "the end of the shots");
  await page.click(".press .disarm");
  await until(() => laserWord(page), (word) => word === "safe", "the safe state");

  step("arming asks first");
  await look(page, "run");
  await page.click("button:text('Arm …')");
  assert.ok(await page.locator("button:text('Arm the laser')").isDisabled());
  await page.check("#goggles");
  await page.click("button:text('Arm the laser')");
  await until(() => laserWord(page), (word) => word === "armed", "the armed state");

  step("dt is previewed, refused and set");
  await page.fill("#dt", "90000");
  await until(() => page.locator(".run .advice").textContent(), (text) => text.length > 20, "why no schedule has it");
  await page.fill("#dt", "110");
  await until(() => page.locator(".run .advice").textContent(), (text) => text === "", "a schedule");
  await page.click("button:text('Set dt')");
  await until(said, (text) => text.startsWith("dt: done"), "the dt");

  step("a hostile note is words");
  await page.fill("#note", HOSTILE);
  await page.click("button:text('Add the note')");
  await until(() => page.locator(".run .log").textContent(), (text) => text.includes(HOSTILE), "the note");
  assert.equal(await page.evaluate(() => window.taken), undefined);
  assert.equal(await page.locator("main img, main script").count(), 0);

  step("start");
  await page.click("button:text('Start')");
  await until(() => laserWord(page), (word) => word === "firing", "shots");

  step("pictures, and what axe finds");
  const serious = [];
  for (const theme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme: theme, reducedMotion: "reduce" });
    for (const view of VIEWS) {
      await look(page, view);
      await settle(page);
      await page.screenshot({ path: join(pictures, `${view}-${theme}.png`), fullPage: true });
      serious.push(...(await axeFinds(page, `${view}, ${theme}`)));
    }
  }
  assert.deepEqual(serious, []);

  step("a tablet shows all of it, without a scroll bar below");
  await page.setViewportSize({ width: 820, height: 1180 });
  for (const view of VIEWS) {
    await look(page, view);
    const [inner, whole] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
    assert.ok(whole <= inner + 1, `${view} is ${whole} pixels wide`);
    await page.screenshot({ path: join(pictures, `${view}-tablet.png`) });
  }
  await page.setViewportSize({ width: 1440, height: 1000 });

  step("keys reach everything: views by Tab and Enter");
  await page.locator('nav a[data-view="volume"]').focus();
  await page.keyboard.press("Enter");
  await page.waitForSelector(".view.volume:not([hidden])");
  await look(page, "overview");

  step("the daemon goes away: values are grey, the laser is unknown");
  // In tenths of a second of the page: where processors are busy, all of it is slower.
  await page.evaluate(() => setInterval(() => (window.tenths = (window.tenths ?? 0) + 1), 100));
  await demand("kill");
  const killed = await page.evaluate(() => window.tenths ?? 0);
  await until(() => laserWord(page), (word) => word === "unknown", "doubt");
  assert.ok((await page.evaluate(() => window.tenths)) - killed < 50, "within a few seconds");
  assert.ok(await page.evaluate(() => document.documentElement.hasAttribute("data-stale")));
  assert.equal(await said(), "", "nothing says that the run goes on");
  await page.screenshot({ path: join(pictures, "overview-stale.png") });
  step("and is back");
  await demand("start");
  await until(() => laserWord(page), (word) => word === "firing", "the run");
  await until(firstShot, (text) => Number(text) >= 1, "shots of the new run");
  await until(() => page.locator(".overview .log").textContent(), (text) => text.includes("another run"), "a word on it");
  assertQuiet(complaints, EXPECTED);
});
step("done");
