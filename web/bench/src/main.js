// The page: the bar on top of everything, and one view below it.

import "uplot/dist/uPlot.min.css";
import "./style.css";

import { Desk } from "./desk.js";
import { h, setAttribute } from "./dom.js";
import { RunState } from "./run_state.js";
import { safetyBar } from "./safety_bar.js";
import { Statistics } from "./statistics.js";
import { themeButton } from "./theme.js";
import { Results } from "./velocity/results.js";
import { camerasView } from "./views/cameras.js";
import { overviewView } from "./views/overview.js";
import { runView } from "./views/run.js";
import { statisticsView } from "./views/statistics.js";
import { velocityView } from "./views/velocity.js";
import { volumeView } from "./views/volume.js";

const run = new RunState();
const desk = new Desk(run);
const results = new Results(run);
const statistics = new Statistics(run);
const bar = safetyBar(run, desk);

const VIEWS = {
  overview: ["Overview", () => overviewView(run)],
  cameras: ["Cameras", () => camerasView(run)],
  volume: ["Volume", () => volumeView(run)],
  velocity: ["Velocity", () => velocityView(run, results, statistics)],
  statistics: ["Statistics", () => statisticsView(run, statistics)],
  run: ["Run", () => runView(run, desk)],
};
/** Made when they are first looked at. */
const made = {};
let current = null;
let wasStale = true;

const links = Object.entries(VIEWS).map(([name, [title]]) => h("a", { href: `#${name}`, "data-view": name }, title));
const main = h("main", { tabindex: "-1" });
document.body.replaceChildren(
  h("header", {}, bar.element, h("nav", { "aria-label": "Views" }, ...links, themeButton()), desk.said),
  main,
  desk.dialog,
);

function show() {
  const asked = location.hash.slice(1);
  current = Object.hasOwn(VIEWS, asked) ? asked : "overview";
  made[current] ??= VIEWS[current][1]();
  const { element } = made[current];
  if (!element.isConnected) main.append(element);
  for (const [name, view] of Object.entries(made)) view.element.hidden = name !== current;
  links.forEach((link) => setAttribute(link, "aria-current", link.dataset.view === current ? "page" : null));
  document.title = `lfpiv bench: ${VIEWS[current][0]}`;
  made[current].update();
  made[current].show();
}

function update() {
  setAttribute(document.documentElement, "data-stale", run.stale ? "" : null);
  if (run.stale && !wasStale) desk.doubt();
  wasStale = run.stale;
  bar.update();
  made[current]?.update();
}

window.addEventListener("hashchange", show);
document.addEventListener("themechange", () => made[current].show());
document.addEventListener("visibilitychange", () => {
  if (!document.hidden) {
    run.ask();
    results.fetchWanted();
  }
});
run.watch(() => {
  update();
  if (run.refusal?.status === 401) askOnce();
});
show();
update();
run.start();

let asked = false;
/** Reading needs a token here: asked for once, and again when the operator presses the button. */
function askOnce() {
  if (asked) return;
  asked = true;
  desk.askForToken(run.refusal.message);
}
