// What can be said of the laser, the cameras and the last shot: a word, what it means, and a tone.

import { percent, shotState } from "./words.js";

/** How long a camera may bring nothing while shots are taken, in ms. */
const SILENT_MS = 3000;

/** The laser: `{ word, detail, tone }`. */
export function laserState(run) {
  if (run.stale) return { word: "unknown", detail: "no sign of life: use the interlock", tone: "unknown" };
  const state = run.brief?.state ?? run.status?.state;
  if (run.permissions && !run.permissions.controllable) {
    return { word: "no laser", detail: "a recorded run is shown", tone: "safe" };
  }
  if (state === "failed") return { word: "unknown", detail: "the run has failed: use the interlock", tone: "unknown" };
  if (state === "finished") return { word: "safe", detail: "the run is over", tone: "safe" };
  const control = run.control;
  if (!control || state === "starting") {
    return { word: "safe", detail: state === "starting" ? "disabled while the run starts" : "nothing is fired", tone: "safe" };
  }
  switch (control.mode) {
    case "disarmed":
      return { word: "safe", detail: "disarmed: lamps and Q-switches off", tone: "safe" };
    case "armed":
      return { word: "armed", detail: "the lamps fire, the Q-switches do not", tone: "armed" };
    case "firing":
      return control.held?.length
        ? { word: "held", detail: control.held.join("; "), tone: "armed" }
        : { word: "firing", detail: "light pulses: goggles on", tone: "firing" };
    case "lost":
      return { word: "unknown", detail: "the synchroniser does not answer: use the interlock", tone: "unknown" };
    case "stopping":
      return { word: "stopping", detail: "the laser is made safe", tone: "armed" };
    default:
      return { word: "unknown", detail: `mode ${control.mode}`, tone: "unknown" };
  }
}

/** Every camera: `{ name, word, tone }`. */
export function cameraStates(run) {
  const names = run.status?.configuration.cameras ?? run.frames.map((camera) => camera.camera);
  return names.map((name, n) => {
    const camera = run.frames[n];
    if (run.stale || !camera) return { name, word: "unknown", tone: "unknown" };
    if (run.permissions && !run.permissions.controllable) return { name, word: "recorded", tone: "safe" };
    if (!camera.connected) return { name, word: "gone", tone: "bad" };
    const firing = run.control?.mode === "firing" && !run.control.held?.length;
    const silentMs = performance.now() - camera.since;
    if (firing && silentMs > SILENT_MS) return { name, word: "silent", tone: "doubt" };
    return { name, word: firing ? "delivers" : "alive", tone: "good" };
  });
}

/** The last shot: `{ word, detail, tone }`. */
export function shotVerdict(run) {
  const shot = run.lastEnded;
  if (!shot) return { word: "none yet", detail: "", tone: null };
  const name = `shot ${shot.shot}`;
  if (shot.state !== "done") return { word: shotState(shot.state), detail: name, tone: run.stale ? "unknown" : "bad" };
  const verdict = shot.model_fit?.verdict;
  const detail = `${name}, ${percent(shot.valid_share)} valid`;
  if (run.stale) return { word: verdict ?? "measured", detail, tone: "unknown" };
  return { word: verdict ?? "measured", detail, tone: { good: "good", doubtful: "doubt", poor: "bad" }[verdict] ?? null };
}
