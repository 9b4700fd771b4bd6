// Debian's Chromium without a screen, WebGL by software, driven by playwright-core.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { chromium } from "playwright-core";

const CHROMIUM = process.env.LFPIV_CHROMIUM ?? "/usr/bin/chromium";
const PATIENCE_MS = 60_000;

/** Starts the browser, with more flags of its JavaScript engine, and ends it when `body` has ended. */
export async function withBrowser(body, engineFlags = []) {
  const browser = await chromium.launch({
    executablePath: CHROMIUM,
    args: [
      "--no-sandbox", "--no-first-run", "--disable-background-networking", "--use-gl=angle",
      "--use-angle=swiftshader", "--enable-unsafe-swiftshader", `--js-flags=${["--expose-gc", ...engineFlags].join(" ")}`,
    ],
  });
  try {
    await body(browser);
  } finally {
    await browser.close();
  }
}

/** A page at `url` that notes what it complains of, and where it asks. */
export async function openBench(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 1000 }, ...options });
  context.setDefaultTimeout(PATIENCE_MS);
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) complaints.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => complaints.push(`uncaught: ${error.stack ?? error}`));
  page.on("dialog", (dialog) => {
    complaints.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  const underWay = new Set();
  let lastEnd = Date.now();
  page.on("request", (request) => {
    const asked = request.url();
    if (!asked.startsWith(url) && !asked.startsWith("blob:")) complaints.push(`asked elsewhere: ${asked}`);
    // The event stream has no end.
    if (!asked.endsWith("/events")) underWay.add(request);
  });
  for (const end of ["requestfinished", "requestfailed"]) {
    page.on(end, (request) => {
      underWay.delete(request);
      lastEnd = Date.now();
    });
  }
  page.quietFor = () => (underWay.size ? 0 : Date.now() - lastEnd);
  await page.goto(`${url}/`);
  return { page, context, complaints };
}

/** What a page complained of, but for what is expected there. */
export function assertQuiet(complaints, expected = /^$/) {
  const rest = complaints.filter((line) => !expected.test(line));
  assert.deepEqual(rest, [], "the page complains");
}

/**
 * Waits until `read` gives something that is `reached`, and gives that. Patience ends when what is
 * read has not changed for so long, or in any case after ten times as long: work that goes on takes
 * as long as the machine needs.
 */
export async function until(read, reached, what, patienceMs = PATIENCE_MS) {
  const began = Date.now();
  let [seen, since] = [undefined, began];
  for (;;) {
    const before = JSON.stringify(seen);
    seen = await read();
    if (reached(seen)) return seen;
    if (JSON.stringify(seen) !== before) since = Date.now();
    const now = Date.now();
    if (now - since > patienceMs || now - began > 10 * patienceMs) throw new Error(`${what} did not come; last seen: ${JSON.stringify(seen)}`);
    await new Promise((wake) => setTimeout(wake, 150));
  }
}

/** What the daemon answers to who asks without the page. */
export async function ask(url, token, path) {
  const get = () => fetch(url + path, { headers: { Authorization: `Bearer ${token}` } });
  // The daemon may just have closed a connection that was idle.
  const answer = await get().catch(get);
  return answer.json();
}

/** The text of a reading in a part of the page, by its label. */
export function readingOf(part, label) {
  return part.locator(".reading", { has: part.page().locator(`dt:text-is("${label}")`) }).locator("dd").textContent();
}

/** Goes to a view. */
export async function look(page, view) {
  await page.click(`nav a[data-view="${view}"]`);
  await page.waitForSelector(`.view:not([hidden])`);
}

/** Waits until the page has had nothing to ask for `quietMs`, or for `mostMs`, and has drawn what it got. */
export async function settle(page, { quietMs = 250, mostMs = 2500 } = {}) {
  const began = Date.now();
  while (Math.min(page.quietFor(), Date.now() - began) < quietMs && Date.now() - began < mostMs) await page.waitForTimeout(30);
  await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
}

/** What axe finds serious on a page, and what no key reaches, each with `where`. */
export async function axeFinds(page, where) {
  if (!(await page.evaluate(() => "axe" in window))) {
    await page.evaluate(await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8"));
  }
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  return violations.filter(({ impact }) => ["serious", "critical"].includes(impact))
    .map(({ id, nodes }) => `${where}: ${id}: ${nodes.map((node) => `${node.target} ${node.any[0]?.message ?? ""}`).slice(0, 4).join(" | ")}`)
    .concat((await outOfReach(page)).map((element) => `${where}: ${element} may scroll, and no key reaches it`));
}

/**
 * Visible parts of a page that scroll once they hold enough, and that no key reaches. Axe sees only
 * those that hold enough now, which depends on how long a run has gone on.
 */
function outOfReach(page) {
  return page.evaluate(() => [...document.querySelectorAll("body *")]
    .filter((element) => {
      const { overflowX, overflowY } = getComputedStyle(element);
      const scrolls = [overflowX, overflowY].some((overflow) => ["auto", "scroll"].includes(overflow));
      return scrolls && element.checkVisibility() && element.tabIndex < 0;
    })
    .map((element) => `${element.localName}.${element.className}`));
}

/** Enters a token. */
export async function enterToken(page, token) {
  if (!(await page.locator("dialog[open] #token").count())) await page.click(".connection button");
  await page.fill("#token", token);
  await page.press("#token", "Enter");
}

export const laserWord = (page) => page.locator(".lamp.laser strong").textContent();

/** Pictures of elements, read by a page of nobody: what is counted is what is on the screen. */
export class Pictures {
  static async open(browser) {
    const pictures = new Pictures();
    pictures.reader = await browser.newPage();
    return pictures;
  }

  async take(shown, options = {}) {
    return (await shown.screenshot(options)).toString("base64");
  }

  /** A picture of what stands still: it is the same twice. */
  async still(shown) {
    let last = await this.take(shown);
    const change = async () => {
      const before = last;
      last = await this.take(shown);
      return this.differing(before, last);
    };
    await until(change, (pixels) => pixels === 0, "a picture that stands still");
    return last;
  }

  /** How many pixels of `picture` differ by more than a trace from `other`, or from its own commonest colour. */
  differing(picture, other = null) {
    return this.reader.evaluate(async ([one, two]) => {
      const pixels = async (base64) => {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
        const draw = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
        draw.drawImage(bitmap, 0, 0);
        return draw.getImageData(0, 0, bitmap.width, bitmap.height).data;
      };
      const commonest = (data) => {
        const counts = new Map();
        const colours = new Uint32Array(data.buffer);
        for (const colour of colours) counts.set(colour, (counts.get(colour) ?? 0) + 1);
        const [colour] = [...counts].reduce((most, next) => (next[1] > most[1] ? next : most));
        return new Uint8ClampedArray(new Uint32Array(colours.length).fill(colour).buffer);
      };
      const a = await pixels(one);
      const b = two ? await pixels(two) : commonest(a);
      let count = 0;
      for (let n = 0; n < a.length; n += 4) {
        count += Math.abs(a[n] - b[n]) + Math.abs(a[n + 1] - b[n + 1]) + Math.abs(a[n + 2] - b[n + 2]) > 30;
      }
      return count;
    }, [picture, other]);
  }
}

/** What a page holds after everything that can go is gone: bytes of heap, DOM nodes, GPU objects. */
export async function holdings(page) {
  const session = await page.context().newCDPSession(page);
  for (let n = 0; n < 3; n += 1) await session.send("HeapProfiler.collectGarbage");
  await session.send("Performance.enable");
  const { metrics } = await session.send("Performance.getMetrics");
  const metric = (name) => metrics.find((one) => one.name === name).value;
  const gpu = await page.evaluate(() => Number(document.querySelector("canvas.space")?.dataset.gpuObjects ?? 0));
  await session.detach();
  return { heap: metric("JSHeapUsedSize"), nodes: metric("Nodes"), gpu };
}

/** Asks whoever started this program for something, and waits for the answer. */
export async function demand(what) {
  process.stdout.write(`ask ${what}\n`);
  process.stdin.resume();
  // A line may come in pieces.
  let answer = "";
  while (!answer.endsWith("\n")) {
    answer += await new Promise((answered) => process.stdin.once("data", answered));
  }
  // Standard input that is listened to would keep this program alive.
  process.stdin.pause();
  return answer.trim();
}

export { assert };
