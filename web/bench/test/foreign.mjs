// A page of another port beside the daemon: foreign.mjs URL CONTROL_TOKEN. It may neither frame, read nor control.

import { createServer } from "node:http";
import { assert, until, withBrowser } from "./browser.mjs";

const [url, token] = process.argv.slice(2);
const server = createServer((_, answer) => {
  answer.setHeader("Content-Type", "text/html");
  answer.end(`<!doctype html><title>foreign</title><iframe id="bench" src="${url}/"></iframe>`);
});
await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
const foreign = `http://127.0.0.1:${server.address().port}`;

await withBrowser(async (browser) => {
  const page = await browser.newPage();
  const said = [];
  page.on("console", (message) => said.push(message.text()));
  await page.goto(foreign);
  await until(() => said.join("; "), (text) => /frame/i.test(text), "the browser's reason");
  const framed = await page.evaluate(() => {
    try {
      return document.getElementById("bench").contentDocument?.body?.innerHTML ?? "closed";
    } catch {
      return "closed";
    }
  });
  assert.equal(framed, "closed");
  const inside = page.frames().find((frame) => frame !== page.mainFrame());
  assert.ok(!(await inside.locator(".lamp").count()), "the bench is shown in a foreign frame");

  const tries = await page.evaluate(async ([bench, secret]) => {
    const headers = { Authorization: `Bearer ${secret}` };
    const attempt = async (path, options) => {
      try {
        const answer = await fetch(bench + path, options);
        return `${answer.type} ${answer.status}`;
      } catch (error) {
        return String(error);
      }
    };
    return [
      await attempt("/api/v1/status"),
      await attempt("/api/v1/status", { headers }),
      await attempt("/api/v1/control/note", { method: "POST", headers: { ...headers, "Content-Type": "application/json" }, body: '{"text":"x"}' }),
      await attempt("/api/v1/control/stop", { method: "POST", headers }),
      await attempt("/api/v1/control/stop", { method: "POST", mode: "no-cors" }),
      await attempt("/api/v1/status", { mode: "no-cors" }),
    ];
  }, [url, token]);
  // Neither is an answer readable, nor is a request without a token worth anything.
  for (const tried of tries.slice(0, 4)) assert.match(tried, /TypeError/, tries.join("; "));
  for (const tried of tries.slice(4)) assert.match(tried, /TypeError|opaque 0/, tries.join("; "));
});
server.close();
