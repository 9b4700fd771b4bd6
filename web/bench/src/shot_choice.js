// Which shot is looked at: the latest, or one that is kept.

import { h, setText } from "./dom.js";

/** `hold(shot)` is called with a number, or with `null` for the latest. */
export function shotChoice(run, hold) {
  let held = null;
  const field = h("input", { type: "number", min: 0, step: 1, "aria-label": "Shot number", onchange: () => keep(Number(field.value)) });
  const toggle = h("button", { type: "button", onclick: () => (held === null ? keep(run.latestResult) : follow()) }, "Hold");
  const before = h("button", { type: "button", "aria-label": "Shot before", onclick: () => keep(Math.max(0, (held ?? run.latestResult ?? 0) - 1)) }, "‹");
  const after = h("button", { type: "button", "aria-label": "Shot after", onclick: () => keep((held ?? run.latestResult ?? 0) + 1) }, "›");
  const words = h("span", { class: "hint" });
  const element = h("div", { class: "choice shot-choice" }, h("span", { class: "label" }, "Shot"), before, field, after, toggle, words);

  function keep(shot) {
    if (shot === null || !Number.isInteger(shot) || shot < 0) return;
    held = shot;
    hold(shot);
    update();
  }

  function follow() {
    held = null;
    hold(null);
    update();
  }

  function update() {
    const shown = held ?? run.latestResult;
    if (document.activeElement !== field) field.value = shown ?? "";
    setText(toggle, held === null ? "Hold" : "Follow");
    toggle.setAttribute("aria-pressed", String(held !== null));
    setText(words, held === null ? "the latest" : "held");
  }

  return { element, update, get held() { return held; } };
}
