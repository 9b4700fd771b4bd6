// Workers on other machines, how fast they are, and the shots that wait for them.

import { h, panel, reading, setAttribute, setText } from "./dom.js";
import { Plot } from "./plot.js";
import { table } from "./table.js";
import { count, duration, number } from "./words.js";

/** What each does, in the order of the rows. */
const STATES = { measuring: "good", idle: null, lost: "bad", ended: null };
/** Workers listed. */
const ROWS = 40;
/** Who was heard of so lately is heard of now. */
const NOW_S = 2;

export function workersPanel(run) {
  const readings = {
    backlog: reading("To be measured"),
    inHand: reading("Being measured"),
    waiting: reading("Waiting"),
    rate: reading("All workers", { title: "results over the last minute" }),
    left: reading("Work left", { title: "shots to be measured, over the present rate" }),
    begun: reading("Begun", { title: "measurements that workers have begun" }),
    notEnded: reading("Not ended", { title: "measurements whose worker was lost: their shots went to others" }),
    givenUp: reading("Given up", { title: "after three failures or ten lost workers" }),
    refused: reading("Results refused", { title: "damaged, or not of this run" }),
  };
  const words = h("p", { class: "advice" });
  const list = table("What each has done for this run");
  const more = h("p", { class: "hint" });
  const dead = table("Shots that were given up");
  const course = new Plot({
    x: "minutes from now", y: "shots", height: 150, alt: "Shots to be measured and being measured, over the last minutes",
    series: [{ label: "to be measured" }, { label: "being measured" }],
  });
  const element = panel("Workers",
    h("dl", { class: "readings" }, ...Object.values(readings).map((one) => one.element)),
    words, list.element, more,
    h("div", { class: "two" }, dead.element, course.element));
  element.classList.add("workers");
  element.hidden = true;

  return {
    element,
    /** Shows `status.cluster`; nothing where a run has none. */
    show(cluster) {
      element.hidden = !cluster;
      if (!cluster) return;
      const { shots, workers } = cluster;
      readings.backlog.show(count(shots.backlog));
      readings.inHand.show(count(shots.in_hand));
      readings.waiting.show(count(Math.max(0, shots.backlog - shots.in_hand)));
      readings.rate.show(`${number(60 * cluster.shots_per_s)} shots/min`);
      readings.left.show(shots.backlog === 0 ? "none" : cluster.shots_per_s > 0 ? duration(shots.backlog / cluster.shots_per_s) : "–");
      readings.begun.show(count(shots.attempts));
      readings.notEnded.show(count(shots.lost_workers), shots.lost_workers > 0 ? "doubt" : null);
      readings.givenUp.show(count(shots.given_up), shots.given_up > 0 ? "bad" : null);
      readings.refused.show(count(shots.refused_results), shots.refused_results > 0 ? "bad" : null);
      const [tone, text] = situation(cluster);
      setText(words, text);
      setAttribute(words, "data-tone", tone);
      showWorkers(workers);
      dead.element.hidden = cluster.given_up.length === 0;
      dead.show(["Shot", "why"], cluster.given_up.map(({ shot, reasons }) => [String(shot), counted(reasons)]),
        cluster.given_up.length < shots.given_up ? `The first ${cluster.given_up.length} of ${count(shots.given_up)} shots that were given up` : "");
      const now = run.backlog.at(-1)?.at ?? 0;
      course.show([
        run.backlog.map(({ at }) => (at - now) / 60_000),
        run.backlog.map((one) => one.backlog),
        run.backlog.map((one) => one.inHand),
      ]);
    },
  };

  function showWorkers(workers) {
    const order = Object.keys(STATES);
    const sorted = [...workers].sort((a, b) => order.indexOf(a.state) - order.indexOf(b.state));
    list.element.hidden = workers.length === 0;
    list.show(["Worker", "state", "last heard of", "delivered", "shots/min", "in hand", "begun", "failed", "not ended"],
      sorted.slice(0, ROWS).map((worker) => [
        worker.worker,
        { text: worker.state, tone: STATES[worker.state] },
        worker.silent_s < NOW_S ? "now" : `${duration(worker.silent_s)} ago`,
        count(worker.shots),
        number(60 * worker.shots_per_s),
        count(worker.in_hand),
        count(worker.attempts),
        { text: count(worker.failures), tone: worker.failures > 0 ? "doubt" : null },
        { text: count(worker.not_ended), tone: worker.not_ended > 0 ? "doubt" : null },
      ]));
    more.hidden = workers.length <= ROWS;
    setText(more, `and ${count(workers.length - ROWS)} more: GET /api/v1/status lists all of them`);
  }
}

/** Reasons in words, each once. */
function counted(reasons) {
  const times = new Map();
  for (const reason of reasons) times.set(reason, (times.get(reason) ?? 0) + 1);
  return [...times].map(([reason, n]) => (n > 1 ? `${reason} (${n} times)` : reason)).join("; ");
}

/** What is to be known of all of it: [tone, text]. */
function situation({ broker, connected, heartbeat_timeout_s: silence, shots, workers }) {
  if (!connected) {
    return ["doubt", `The broker at ${broker} does not answer. Shots are recorded, and wait until it does.`];
  }
  const at = (...states) => workers.filter(({ state }) => states.includes(state)).length;
  const there = at("measuring", "idle");
  if (there === 0 && shots.backlog > 0) {
    return ["doubt", workers.length === 0
      ? `No worker has taken a shot yet. On each machine that is to measure: lfpiv work --url ${broker}`
      : "No worker is left: all are lost or have ended. Shots are recorded, and wait for others."];
  }
  const lost = at("lost");
  const gone = lost > 0 ? ` ${count(lost)} ${lost === 1 ? "was" : "were"} not heard of for more than ${duration(silence)}: what ${lost === 1 ? "it" : "they"} had in hand goes to others.` : "";
  return [null, `Measuring: ${count(at("measuring"))} of ${count(there)}. The broker at ${broker} answers.${gone}`];
}
