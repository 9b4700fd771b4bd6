// Overview: how the run goes, in numbers and in words.

import { h, panel, reading, scrollable, setAttribute, setText } from "../dom.js";
import { Plot } from "../plot.js";
import { table } from "../table.js";
import { workersPanel } from "../workers.js";
import { bytes, clockTime, count, duration, number, outcome, percent, runState, shotState } from "../words.js";

const OUTCOMES = ["complete", "missing_packets", "underrun", "missed_trigger", "late", "unpaired", "shed", "write_failed", "not_fired"];
const MARKS = ["acquired", "paired", "written", "fsynced", "processed"];
const ROWS = 14;
const LINES = 60;
/** Shots looked through for them. */
const SHOTS = 200;

export function overviewView(run) {
  const state = {
    run: reading("Run"), stage: reading("Now", { wide: true }), dt: reading("dt"),
    rate: reading("Measured"), asked: reading("Asked for"), queue: reading("Queue"),
    latency: reading("Latency", { title: "from trigger to stored velocity: median, 95th percentile" }),
    disk: reading("Disk left"), uptime: reading("Up for"),
  };
  const fit = {
    verdict: reading("Model fit"), unexplained: reading("Light unexplained", { title: "per camera; 0: everything is explained" }),
    offset: reading("Micro-images off", { title: "largest distance from the configured place, per camera" }),
    disparity: reading("Cameras apart", { title: "root mean square distance between the places at which they put particles" }),
    calibration: reading("Calibration"), seeding: reading("Seeding"),
  };
  const causes = h("ul", { class: "causes" });
  const calibrations = table("Calibrated cameras: the file and its SHA-256");
  calibrations.element.classList.add("hashes");
  const ledger = table("Triggers by camera and outcome");
  const marks = table("How many shots have got how far");
  const shots = table("Latest shots, newest first");
  const waiting = h("p", { class: "hint" });
  const quiet = h("p", { class: "hint" }, "Nothing yet that is worth a line.");
  const log = h("ol");
  const workers = workersPanel(run);
  const times = new Plot({ x: "shot", y: "seconds", alt: "Time that the last shots took to measure", height: 150, series: [{ label: "time to measure" }] });

  const element = h("div", { class: "view overview" },
    h("dl", { class: "readings" }, ...Object.values(state).map((one) => one.element)),
    workers.element,
    h("div", { class: "two" },
      h("div", {},
        panel("Shots", waiting, shots.element),
        panel("Model fit", h("dl", { class: "readings" }, ...Object.values(fit).map((one) => one.element)), causes, calibrations.element)),
      h("div", {},
        panel("What happened", quiet, h("div", { class: "log", ...scrollable("What happened") }, log)),
        panel("Ledger", ledger.element, marks.element),
        panel("Time to measure a shot", times.element))));

  function update() {
    const { status } = run;
    const brief = run.brief ?? status;
    if (!brief) return;
    const name = brief.state;
    state.run.show(runState(name), { failed: "bad", bench_lost: "bad" }[name] ?? null);
    state.stage.show(brief.error ?? brief.stage, brief.error ? "bad" : null);
    state.rate.show(`${number(run.rate, 2)} shots/s`);
    showShots(brief.shots);
    showLog();
    if (!status) return;
    const { configuration, latency, disk } = status;
    state.dt.show(`${number(run.control?.dt_us ?? configuration.dt_us)} µs`);
    state.asked.show(`${number(configuration.rate_hz)} Hz${configuration.shots ? `, ${count(configuration.shots)} shots` : ""}`);
    // With workers on other machines nothing waits there: they have a panel of their own.
    state.queue.element.hidden = Boolean(status.cluster);
    state.queue.show(`${brief.shots.queued} of ${configuration.queue}`, brief.shots.queued >= configuration.queue ? "doubt" : null);
    state.latency.show(latency ? `${duration(latency.p50_s)}, ${duration(latency.p95_s)}` : "–");
    showDisk(disk);
    state.uptime.show(duration(status.uptime_s));
    workers.show(status.cluster);
    showFit(status);
    showLedger(status);
  }

  function showDisk(disk) {
    if (!disk) {
      state.disk.show("–");
      return;
    }
    const shotsLeft = disk.shots_left;
    state.disk.show(`${bytes(disk.free_bytes)}${shotsLeft === null ? "" : `, ${count(shotsLeft)} shots`}`, shotsLeft !== null && shotsLeft < 600 ? "doubt" : null);
  }

  function showFit(status) {
    const found = status.model_fit;
    const cameras = (pick) => found?.cameras.map(pick).join(", ") ?? "–";
    fit.verdict.show(found?.verdict ?? "–", { good: "good", doubtful: "doubt", poor: "bad" }[found?.verdict] ?? null);
    fit.unexplained.show(cameras((camera) => percent(camera.unexplained)));
    fit.offset.show(found ? `${cameras((camera) => number(camera.micro_image_offset_px, 2))} px` : "–");
    fit.disparity.show(found?.camera_disparity_mm ? `${number(found.camera_disparity_mm, 2)} mm` : "–");
    showCalibrations(status.configuration);
    const scene = status.model_choice?.scene;
    // Measured where the model follows the scene; the view Cameras has that of every image.
    fit.seeding.element.hidden = !scene;
    fit.seeding.show(scene ? `${number(scene.seeding_ppm, 2)} per microlens` : "–");
    const words = found?.causes ?? [];
    if (causes.childElementCount !== words.length || [...causes.children].some((line, n) => line.textContent !== words[n])) {
      causes.replaceChildren(...words.map((cause) => h("li", {}, cause)));
    }
  }

  function showCalibrations({ cameras, calibrations: files }) {
    fit.calibration.show(files.length === 0 ? "as configured" : `${files.length} of ${cameras.length} cameras`);
    calibrations.element.hidden = files.length === 0;
    calibrations.show(["Camera", "file", "SHA-256"], files.map(({ camera, file, sha256 }) => [camera, file, sha256]));
  }

  function showLedger(status) {
    const { cameras, balanced } = status.ledger;
    const names = OUTCOMES.filter((name, n) => n === 0 || cameras.some((camera) => camera.outcomes[name] > 0));
    ledger.show(["Camera", "triggers", "open", ...names.map(outcome)], cameras.map((camera) => [
      camera.camera, count(camera.triggers), count(camera.open), ...names.map((name) => count(camera.outcomes[name])),
    ]), balanced ? "" : "The ledger does not balance.");
    const reached = run.brief?.watermarks ?? status.watermarks;
    marks.show(reached ? MARKS : ["Raw data"], [reached ? MARKS.map((name) => count(reached[name])) : ["not kept"]]);
  }

  function showShots(counts) {
    // Those on their way are a number: there may be many, and nothing is known of them.
    const isUnderWay = (shot) => ["awaiting_frames", "queued"].includes(shot.state);
    const latest = run.latestShots(SHOTS).filter((shot) => !isUnderWay(shot)).slice(0, ROWS);
    setText(waiting, `${count(counts.triggered)} triggered, ${count(counts.done)} measured; ${count(counts.awaiting_frames)} wait for frames, ${count(counts.queued)} for a worker`);
    shots.show(["Shot", "time", "state", "model fit", "valid", "took"], latest.map((shot) => [
      String(shot.shot),
      clockTime(shot.time?.utc),
      describe(shot),
      shot.model_fit?.verdict ?? "–",
      percent(shot.valid_share),
      shot.seconds ? duration(Object.values(shot.seconds).reduce((sum, part) => sum + part, 0)) : "–",
    ]));
    const timed = run.latestShots(120).filter((shot) => shot.seconds).reverse();
    times.show([timed.map((shot) => shot.shot), timed.map((shot) => Object.values(shot.seconds).reduce((sum, part) => sum + part, 0))]);
  }

  let shownLog = null;
  function showLog() {
    quiet.hidden = run.log.length > 0;
    const last = run.log.at(-1) ?? null;
    if (last === shownLog && log.childElementCount === Math.min(LINES, run.log.length)) return;
    shownLog = last;
    const lines = run.log.slice(-LINES).reverse();
    while (log.childElementCount < lines.length) log.append(h("li", {}, h("time", {}), h("span", {})));
    while (log.childElementCount > lines.length) log.lastChild.remove();
    lines.forEach((line, n) => {
      const item = log.children[n];
      setText(item.firstChild, line.at ? line.at.toLocaleTimeString("en-GB") : "before");
      setText(item.lastChild, line.text);
      setAttribute(item, "data-tone", line.tone);
    });
  }

  return { element, update, show: update };
}

/** What became of a shot: its state, and what to know of it. */
function describe(shot) {
  const lost = (shot.cameras ?? []).filter((camera) => camera.outcome && camera.outcome !== "complete");
  const more = shot.message ?? shot.suspect?.[0] ?? (shot.state === "lost" ? lost.map((camera) => `${camera.camera} ${outcome(camera.outcome)}`).join(", ") : null);
  return more ? `${shotState(shot.state)}: ${more}` : shotState(shot.state);
}
