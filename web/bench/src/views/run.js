// Run: what is set, when the pulses fire, and the controls.

import { ApiError, getJson } from "../api.js";
import { h, panel, reading, scrollable, setAttribute, setText } from "../dom.js";
import { laserState } from "../laser.js";
import { timingDiagram } from "../timing_diagram.js";
import { number } from "../words.js";

/** Longest note, in bytes, as the daemon takes it. */
const NOTE_BYTES = 4096;

export function runView(run, desk) {
  const mode = reading("Laser", { wide: true });
  const held = reading("Why nothing is fired", { wide: true });
  const permissions = {
    configuration: reading("Configuration allows arming", { title: "server.remote_arming" }),
    operator: reading("Operator has enabled it at the bench", { title: "lfpiv run --remote-arming" }),
  };
  const arm = h("button", { type: "button", onclick: () => confirm.showModal() }, "Arm …");
  const start = h("button", { type: "button", onclick: () => desk.send("start") }, "Start");
  const sure = h("input", { type: "checkbox", id: "goggles", onchange: () => { go.disabled = !sure.checked; } });
  const go = h("button", { type: "submit", class: "primary", disabled: true }, "Arm the laser");
  const confirm = h("dialog", { "aria-labelledby": "arm-title" },
    h("form", { onsubmit: (event) => armNow(event) },
      h("h2", { id: "arm-title" }, "Arm the laser?"),
      h("p", {}, "The lamps begin to fire. After start, light pulses leave the laser. This page is no interlock."),
      h("div", { class: "choice" }, sure, h("label", { for: "goggles" }, "The room is clear and everybody in it wears goggles")),
      h("div", { class: "row" }, go, h("button", { type: "button", onclick: () => confirm.close() }, "Cancel"))));
  confirm.addEventListener("close", () => {
    sure.checked = false;
    go.disabled = true;
  });
  const why = h("p", { class: "hint" });

  const dt = h("input", { type: "number", id: "dt", min: 0.1, max: 1e6, step: "any", oninput: () => preview() });
  const set = h("button", { type: "submit" }, "Set dt");
  const dtForm = h("form", { class: "controls", onsubmit: (event) => setDt(event) },
    h("label", { for: "dt" }, "Time between the pulses (µs)"), dt, set);
  const diagram = timingDiagram();
  const timingProblem = h("p", { class: "advice", "data-tone": "doubt" });

  const note = h("textarea", { id: "note", rows: 3, maxlength: NOTE_BYTES });
  const noteForm = h("form", { onsubmit: (event) => addNote(event) },
    h("label", { for: "note" }, "Words for the run's record"), note,
    h("div", { class: "row" }, h("button", { type: "submit" }, "Add the note")));
  const notes = h("ol");
  const file = h("p", { class: "hint" });
  const settings = h("pre", { class: "settings", ...scrollable("Configuration") });

  const element = h("div", { class: "view run" },
    h("div", { class: "two" },
      panel("Controls", h("dl", { class: "readings" }, mode.element, held.element, ...Object.values(permissions).map((one) => one.element)),
        h("div", { class: "controls large" }, arm, start), why),
      panel("Notes", noteForm, h("div", { class: "log", ...scrollable("Notes") }, notes))),
    panel("Timing", dtForm, timingProblem, diagram.element),
    panel("Settings", file, settings),
    confirm);

  async function armNow(event) {
    event.preventDefault();
    if (!sure.checked) return;
    confirm.close();
    await desk.send("arm");
  }

  async function setDt(event) {
    event.preventDefault();
    if (await desk.send("dt", { dt_us: Number(dt.value) })) edited = false;
  }

  async function addNote(event) {
    event.preventDefault();
    if (note.value.trim() && (await desk.send("note", { text: note.value.trim() }))) note.value = "";
  }

  let edited = false;
  let asked = null;
  function preview() {
    edited = true;
    showTiming(Number(dt.value));
  }

  async function showTiming(dtUs) {
    if (!(dtUs > 0) || asked === dtUs) return;
    asked = dtUs;
    try {
      const timing = await getJson(`/api/v1/control/timing?dt_us=${encodeURIComponent(dtUs)}`);
      if (asked !== dtUs) return;
      setText(timingProblem, "");
      diagram.show(timing);
    } catch (error) {
      if (asked !== dtUs) return;
      setText(timingProblem, error instanceof ApiError ? error.message : "the daemon does not answer");
      if (!(error instanceof ApiError)) asked = null;
    }
  }

  let shownRun = null;
  async function showSettings() {
    if (shownRun === run.run && settings.textContent) return;
    try {
      const { file: name, text } = await getJson("/api/v1/configuration");
      shownRun = run.run;
      setText(file, name);
      setText(settings, text);
    } catch (error) {
      setText(file, error instanceof ApiError ? error.message : "the daemon does not answer");
    }
  }

  function update() {
    const laser = laserState(run);
    mode.show(`${laser.word} (${laser.detail})`, laser.tone === "firing" || laser.tone === "unknown" ? "bad" : null);
    held.show(run.control?.held?.join("; ") || "–", run.control?.held?.length ? "doubt" : null);
    const allowed = run.permissions;
    permissions.configuration.show(allowed ? yes(allowed.allowed_by_configuration) : "–");
    permissions.operator.show(allowed ? yes(allowed.enabled_at_bench) : "–");
    const controllable = Boolean(allowed?.controllable);
    arm.disabled = start.disabled = !allowed?.may_arm || run.stale;
    set.disabled = dt.disabled = !controllable;
    noteForm.hidden = !controllable;
    setText(why, !controllable
      ? "A recorded run cannot be controlled."
      : allowed.may_arm
        ? "Arm warms the lamps, start takes shots. Both need a token of scope control; stop and disarm are on top of every view."
        : "Arming over HTTP needs both permissions. Stop and disarm need a token of scope control only.");
    const dtUs = run.control?.dt_us ?? run.status?.configuration.dt_us;
    if (!edited && dtUs && document.activeElement !== dt) {
      dt.value = String(dtUs);
      showTiming(dtUs);
    }
    const written = run.log.filter((line) => line.tone === "note").slice(-30).reverse();
    while (notes.childElementCount < written.length) notes.append(h("li", {}, h("time", {}), h("span", {})));
    while (notes.childElementCount > written.length) notes.lastChild.remove();
    written.forEach((line, n) => {
      setText(notes.children[n].firstChild, line.at ? line.at.toLocaleTimeString("en-GB") : "before");
      setText(notes.children[n].lastChild, line.text.replace(/^Note: /, ""));
      setAttribute(notes.children[n], "data-tone", "note");
    });
    if (!element.hidden) showSettings();
  }

  return {
    element,
    update,
    show() {
      update();
      diagram.draw();
    },
  };
}

const yes = (is) => (is ? "yes" : "no");
