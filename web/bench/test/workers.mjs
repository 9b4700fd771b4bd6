// The page before a run whose shots are measured by workers: workers.mjs URL READ_TOKEN CONTROL_TOKEN PICTURES.
// Workers and the broker are started and killed by whoever started this program.

import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import { ask, assert, assertQuiet, axeFinds, demand, enterToken, look, openBench, readingOf, settle, until, withBrowser } from "./browser.mjs";

const [url, readToken, controlToken, pictures] = process.argv.slice(2);
/** The first requests have no token; there is no result before the first shot. */
const EXPECTED = /Failed to load resource: the server responded with a status of (401|404|410)/;

const began = Date.now();
const step = (words) => console.log(`${((Date.now() - began) / 1000).toFixed(1)} s: ${words}`);

const status = () => ask(url, readToken, "/api/v1/status");

/** Pixels of each projection that are neither black nor of a theme's colour: light is grey. */
const litPixels = (page) => page.evaluate(() => [...document.querySelectorAll("canvas.projection")].map((canvas) => {
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d");
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
  let count = 0;
  for (let n = 0; n < data.length; n += 4) count += data[n + 3] === 255 && data[n] > 40 && data[n] === data[n + 1] && data[n] === data[n + 2];
  return count;
}));

await withBrowser(async (browser) => {
  await mkdir(pictures, { recursive: true });
  const { page, complaints } = await openBench(browser, url);
  await page.waitForSelector("dialog[open] #token");
  await enterToken(page, controlToken);

  const panel = page.locator(".workers");
  const reading = (label) => readingOf(panel, label);
  const words = () => panel.locator(".advice").textContent();
  /** A worker's row: its cells by the names of the columns. */
  async function row(name) {
    return panel.locator("table").first().evaluate((table, wanted) => {
      const texts = (cells) => [...cells].map((cell) => cell.textContent);
      const columns = texts(table.tHead.rows[0].cells);
      const cells = [...table.tBodies[0].rows].map((one) => texts(one.cells)).find(([first]) => first === wanted);
      return cells ? Object.fromEntries(columns.map((column, n) => [column, cells[n]])) : null;
    }, name);
  }

  step("without workers shots wait, and the page says so");
  await until(() => reading("Waiting"), (text) => Number(text) >= 3, "a backlog", 120_000);
  assert.equal(await reading("To be measured"), await reading("Waiting"));
  assert.equal(await reading("Being measured"), "0");
  assert.equal(await reading("All workers"), "0 shots/min");
  assert.match(await words(), /^No worker has taken a shot yet\..* lfpiv work --url nats:\/\/127\.0\.0\.1:\d+$/);
  assert.ok(!(await page.locator(".overview > .readings .reading:visible dt", { hasText: "Queue" }).count()), "nothing queues here");

  step("a shot that cannot be measured is given up, with what was said of it");
  const dead = await demand("fail thrice");
  await until(() => reading("Given up"), (text) => text === "1", "the shot that is given up");
  const reasons = await panel.locator("table").nth(1).locator("tbody tr").allTextContents();
  const told = `<img src=x onerror="window.taken=1">: too dark <img src=x onerror="window.taken=1">`;
  assert.deepEqual(reasons, [`${dead}${told} (3 times)`]);
  assert.equal(await page.evaluate(() => window.taken), undefined);
  assert.equal(await page.locator("main img").count(), 0);
  assert.equal((await row(`<img src=x onerror="window.taken=1">`)).failed, "3");

  step("workers come, and what they deliver is counted");
  for (const name of ["one", "two"]) await demand(`start ${name}`);
  for (const name of ["one", "two"]) {
    await until(() => row(name), (found) => Number(found?.delivered) >= 2 && ["measuring", "idle"].includes(found.state), `shots of ${name}`, 120_000);
    assert.ok(Number((await row(name))["shots/min"]) > 0);
    await until(() => row(name), (found) => found["last heard of"] === "now", "a sign of life");
  }
  assert.ok(parseFloat(await reading("All workers")) > 0);

  step("pictures, and what axe finds");
  const violations = [];
  for (const [size, width] of [["wide", 1440], ["tablet", 820], ["narrow", 420]]) {
    await page.setViewportSize({ width, height: 1000 });
    for (const theme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme: theme, reducedMotion: "reduce" });
      await page.evaluate(() => scrollTo(0, 0));
      await settle(page);
      await page.screenshot({ path: join(pictures, `workers-${size}-${theme}.png`), fullPage: true });
      violations.push(...(await axeFinds(page, `${size}, ${theme}`)));
    }
    const [inner, whole] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
    assert.ok(whole <= inner + 1, `${size}: the page is ${whole} pixels wide`);
  }
  assert.deepEqual(violations, []);
  await page.setViewportSize({ width: 1440, height: 1000 });

  step("the light of shots that workers have measured is seen");
  await look(page, "volume");
  await until(() => page.locator(".volume .shot-choice input").inputValue(), (text) => Number(text) > 1, "a worker's shot");
  await until(() => litPixels(page), (planes) => planes.length === 3 && planes.every((pixels) => pixels > 100), "its light");
  assert.equal(await page.locator(".volume .empty").textContent(), "");
  await look(page, "overview");

  step("a worker is killed: it is lost, and the other one goes on");
  const before = Number((await row("two")).delivered);
  await demand("kill one");
  await until(() => row("one"), (found) => found.state === "lost" && found["in hand"] === "0", "the loss");
  assert.match((await row("one"))["last heard of"], /^\d.* ago$/);
  // As is the one that has failed three times, and was not heard of since.
  await until(words, (text) => text.includes("2 were not heard of for more than 2.0 s: what they had in hand goes to others."), "a word on it");
  await until(() => row("two"), (found) => Number(found.delivered) > before + 2, "shots of the other one", 120_000);
  await page.screenshot({ path: join(pictures, "workers-lost.png"), fullPage: true });

  step("all shots are measured once: by the daemon, the reference, and by workers");
  await page.click(".press .stop");
  await until(() => reading("To be measured"), (text) => text === "0", "the end of the backlog", 120_000);
  // The shot that was given up is settled at the end of the run.
  const settled = await until(status, ({ shots }) => shots.queued === 1 && shots.awaiting_frames + shots.processing === 0, "all shots are settled");
  const delivered = async (name) => Number((await row(name)).delivered);
  const all = await until(async () => (await delivered("one")) + (await delivered("two")) + 1, (sum) => sum >= settled.shots.done, "all results");
  assert.equal(all, settled.shots.done);
  assert.equal(await reading("Work left"), "none");
  // As many as a program that asks is told, by worker.
  await until(async () => {
    const { workers } = (await status()).cluster;
    const shown = await Promise.all(workers.map(({ worker }) => row(worker)));
    return workers.map(({ shots, attempts }, n) => [shots, attempts, Number(shown[n]?.delivered), Number(shown[n]?.begun)]);
  }, (all) => all.length === 3 && all.every(([shots, attempts, delivered, begun]) => shots === delivered && attempts === begun), "the same numbers");

  step("a worker that ends says so");
  await demand("end two");
  await until(() => row("two"), (found) => found.state === "ended", "its end");

  step("the broker goes away, and is back");
  await demand("broker ends");
  await until(words, (text) => /^The broker at nats:\S+ does not answer\./.test(text), "a word on it");
  await demand("broker starts");
  await until(words, (text) => text.includes("answers."), "the broker");

  await look(page, "run");
  await look(page, "overview");
  assertQuiet(complaints, EXPECTED);
});
step("done");
