// The bar on top of every view: laser, cameras, last shot, and stop and disarm in one press each.

import { h, setAttribute, setText } from "./dom.js";
import { cameraStates, laserState, shotVerdict } from "./laser.js";

function lamp(label, className = "") {
  const word = h("strong", {});
  const detail = h("span", { class: "detail" });
  const element = h("div", { class: `lamp ${className}` }, h("span", { class: "label" }, label), word, detail);
  return {
    element,
    show({ word: text, detail: more = "", tone }) {
      setText(word, text);
      setText(detail, more);
      setAttribute(element, "data-tone", tone ?? null);
      setAttribute(element, "title", more || null);
    },
  };
}

export function safetyBar(run, desk) {
  const laser = lamp("Laser", "laser");
  const cameras = h("div", { class: "cameras" });
  const shot = lamp("Last shot", "shot");
  const live = h("span", { class: "live", role: "status" });
  const stop = h("button", { type: "button", class: "stop", onclick: () => desk.send("stop") }, "Stop");
  const disarm = h("button", { type: "button", class: "disarm", onclick: () => desk.send("disarm") }, "Disarm");
  const token = h("button", { type: "button", class: "quiet", onclick: () => desk.askForToken() }, "Token");
  const element = h("div", { class: "safety" },
    h("div", { class: "press" }, stop, disarm),
    laser.element, cameras, shot.element,
    h("div", { class: "connection" }, live, token));
  const lamps = [];

  function update() {
    laser.show(laserState(run));
    const states = cameraStates(run);
    while (lamps.length < states.length) {
      lamps.push(lamp("", "camera"));
      cameras.append(lamps.at(-1).element);
    }
    lamps.forEach((one, n) => {
      const state = states[n];
      one.element.hidden = !state;
      if (!state) return;
      setText(one.element.firstChild, state.name);
      one.show(state);
    });
    shot.show(shotVerdict(run));
    const recorded = run.permissions && !run.permissions.controllable;
    stop.disabled = disarm.disabled = Boolean(recorded);
    setText(live, run.stale ? connectionWords(run) : recorded ? "recorded" : "live");
    setAttribute(live, "data-tone", run.stale ? "bad" : "good");
  }

  return { element, update };
}

function connectionWords(run) {
  if (run.refusal) return run.refusal.message;
  return run.connection === "connecting" ? "connecting" : "no sign of life";
}
