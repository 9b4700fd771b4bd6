// Velocity: the field in space, in slices and along lines, over shots, and what it says of the measurement.

import { colourBar } from "../colour_bar.js";
import { ColourScale } from "../colour_scale.js";
import { h, panel, reading, select, setText, slider, tick } from "../dom.js";
import { Plot } from "../plot.js";
import { shotChoice } from "../shot_choice.js";
import { VECTORS, uncertaintyAt, vectorsOf } from "../statistics.js";
import { dtAdvice, histogram, lockingWords, validDisplacements } from "../velocity/displacement.js";
import { component, inFlow, magnitudes, quantile, sameGrid, validShare, vorticity } from "../velocity/field.js";
import { FieldScene } from "../velocity/scene.js";
import { PLANE, SliceCanvas, slicePixels, slicePlane } from "../velocity/slice.js";
import { surface } from "../velocity/surface.js";
import { count, number, percent } from "../words.js";

const SHOWN = { shot: "this shot", mean: "mean of the run", rms: "rms of the run" };
const QUANTITIES = {
  speed: "speed",
  u: "u along x",
  v: "v along y",
  w: "w along z",
  vorticity: "|vorticity|",
  vorticity_x: "vorticity about x",
  vorticity_y: "vorticity about y",
  vorticity_z: "vorticity about z",
  uncertainty: "standard uncertainty",
};
const AXES = { 0: "x", 1: "y", 2: "z" };
/** Scales reach to this share of the values: a few outliers must not darken all others. */
const WHITE = 0.99;

export function velocityView(run, results, statistics) {
  const chosen = { shown: "shot", quantity: "speed", axis: 2, index: null, along: 0, line: null, level: 60 };
  const scene = new FieldScene();
  const bar = colourBar();
  const sliceBar = colourBar();
  const slice = new SliceCanvas((right, up) => pick(right, up));
  const shot = shotChoice(run, (held) => results.hold(held));
  const none = h("p", { class: "empty" });
  const readings = {
    valid: reading("Valid vectors"),
    replaced: reading("Replaced"),
    masked: reading("Masked", { title: "vectors whose place is not flow, as [volume.mask] says; no share counts them" }),
    speed: reading("Largest speed", { title: "99th percentile" }),
    uncertainty: reading("Uncertainty", { title: "median standard uncertainty of a component" }),
    shots: reading("Shots in mean and rms", { title: "all shots of the run so far, their valid vectors" }),
  };
  const vectors = tick("Vectors", true, () => redraw());
  const surfaces = tick("Vorticity surface", true, () => redraw());
  const inSpace = tick("Slice", true, () => redraw());
  const level = slider("Surface at", { max: 95, value: chosen.level }, (value) => redraw({ level: value }));
  const shown = select("Show", SHOWN, (value) => redraw({ shown: value }));
  const quantity = select("Colour of the slice", QUANTITIES, (value) => redraw({ quantity: value }));
  const axis = select("Slice across", AXES, (value) => redraw({ axis: Number(value), index: null, line: null }));
  axis.input.value = "2";
  const place = slider("at", { max: 1 }, (value) => redraw({ index: value }));
  const along = select("Profile along", AXES, (value) => redraw({ along: Number(value), line: null }));
  const profile = new Plot({
    x: "position (mm)", y: "velocity (m/s)", alt: "Velocity along the dashed line of the slice",
    series: [{ label: "u" }, { label: "v" }, { label: "w" }],
  });
  const displacements = [0, 1, 2].map((a) => new Plot({
    x: `displacement along ${"xyz"[a]} (voxel)`, y: "vectors", height: 130,
    alt: `Histogram of the displacements along ${"xyz"[a]}`, series: [{ label: "vectors", kind: "bars" }],
  }));
  const legend = h("p", { class: "hint legend" }, h("span", { class: "swatch", "aria-hidden": "true" }), "Not flow");
  legend.hidden = true;
  const locking = h("p", { class: "advice" });
  const advice = h("p", { class: "advice" });

  const element = h("div", { class: "view velocity" },
    h("div", { class: "controls" }, shot.element, shown.element, none),
    h("dl", { class: "readings" }, ...Object.values(readings).map((one) => one.element)),
    h("div", { class: "two" },
      panel("In space", scene.element, bar.element,
        h("div", { class: "controls" }, vectors.element, surfaces.element, level.element, inSpace.element)),
      panel("Slice",
        h("div", { class: "controls" }, axis.element, place.element, quantity.element),
        slice.canvas, sliceBar.element, legend)),
    h("div", { class: "two" },
      panel("Profile", h("div", { class: "controls" }, along.element, h("p", { class: "hint" }, "Press a place in the slice to move the line.")), profile.element),
      panel("Displacements", ...displacements.map((plot) => plot.element), locking, advice)));

  results.watch(() => redraw());
  statistics.watch(() => chosen.shown !== "shot" && redraw());

  function redraw(change = {}) {
    Object.assign(chosen, change);
    if (element.isConnected && !element.hidden) draw();
  }

  function pick(right, up) {
    const { field } = results;
    if (!field) return;
    const [a, b] = PLANE[chosen.axis];
    const isAcross = chosen.along === b;
    const [share, n] = isAcross ? [right, field.n[a]] : [up, field.n[b]];
    if (chosen.along === chosen.axis) chosen.along = a;
    along.input.value = String(chosen.along);
    redraw({ line: Math.min(n - 1, Math.floor(share * n)) });
  }

  /** The statistics of the run, where they are chosen and there, at the places of this shot's vectors. */
  function ofTheRun(field) {
    if (chosen.shown === "shot") return null;
    statistics.want(VECTORS[chosen.shown]);
    return statistics.has(VECTORS[chosen.shown]) && sameGrid(field, statistics.now) ? statistics.now : null;
  }

  function chosenValues({ u, uncertainty }, rotation) {
    const name = chosen.quantity;
    if (name === "speed") return [magnitudes(u), "speed (m/s)", false];
    if (name === "uncertainty") return [magnitudes(uncertainty).map((size) => size / Math.sqrt(3)), "standard uncertainty of a component (m/s)", false];
    if (name === "vorticity") return [magnitudes(rotation), "|vorticity| (1/s)", false];
    const axisOf = { u: 0, v: 1, w: 2, vorticity_x: 0, vorticity_y: 1, vorticity_z: 2 }[name];
    return name.startsWith("vorticity")
      ? [component(rotation, axisOf), `${QUANTITIES[name]} (1/s)`, true]
      : [component(u, axisOf), `${QUANTITIES[name]} (m/s)`, chosen.shown !== "rms"];
  }

  function draw() {
    const { field } = results;
    const whole = field && ofTheRun(field);
    const isMissing = field && chosen.shown !== "shot" && !whole;
    setText(none, !field ? results.error ?? "No result yet: the first shot that is measured appears here."
      : isMissing ? statistics.error ?? `The ${SHOWN[chosen.shown]} is asked for: this is shot ${field.shot}.` : results.error ?? "");
    element.classList.toggle("without", !field);
    if (!field) return;
    const names = VECTORS[chosen.shown];
    const drawn = whole ? { u: vectorsOf(whole, names), uncertainty: vectorsOf(whole, names, uncertaintyAt) } : field;
    const { u } = drawn;
    const rotation = vorticity(field, u);
    const speeds = magnitudes(u);
    const speedScale = new ColourScale(0, quantile(speeds, WHITE));
    scene.frame(field);
    scene.showVectors(field, u, speedScale, vectors.input.checked);
    scene.showBodies(field, run.mask);
    bar.show(speedScale, whole && chosen.shown === "rms" ? "fluctuation (m/s)" : "speed (m/s)");

    const spin = magnitudes(rotation);
    const surfaceLevel = (quantile(spin, 0.995) * chosen.level) / 100;
    setText(level.shown, `${number(surfaceLevel)} 1/s`);
    scene.showSurface(field, surfaces.input.checked && surfaceLevel > 0 ? surface(spin, field.n, surfaceLevel) : null);
    drawSlice(field, drawn, rotation, speedScale);
    drawProfile(field, u);
    drawWords(field, drawn, speeds);
    readings.shots.element.hidden = !whole;
    readings.shots.show(whole ? count(whole.shots) : "–");
    scene.draw();
  }

  function drawSlice(field, drawn, rotation, speedScale) {
    const n = field.n[chosen.axis];
    chosen.index = Math.min(n - 1, chosen.index ?? Math.floor(n / 2));
    place.input.max = n - 1;
    place.input.value = chosen.index;
    setText(place.shown, `${"xyz"[chosen.axis]} = ${number(field.first[chosen.axis] + chosen.index * field.spacing, 2)} mm`);
    const [values, label, signed] = chosenValues(drawn, rotation);
    const high = quantile(values.map(Math.abs), WHITE);
    const scale = new ColourScale(signed ? -high : 0, high, signed);
    if (chosen.along === chosen.axis) chosen.along = PLANE[chosen.axis][0];
    along.input.value = String(chosen.along);
    const [right, up] = PLANE[chosen.axis];
    const isAlongRight = chosen.along === right;
    const lines = field.n[isAlongRight ? up : right];
    chosen.line = Math.min(lines - 1, chosen.line ?? Math.floor(lines / 2));
    const line = { along: isAlongRight ? 0 : 1, index: chosen.line };
    slice.draw(field, values, drawn.u, { axis: chosen.axis, index: chosen.index, scale, longest: speedScale.high, line });
    sliceBar.show(scale, label);
    const rows = slicePlane(field, values, chosen.axis, chosen.index);
    const pixels = inSpace.input.checked ? slicePixels(rows, scale) : null;
    scene.showSlice(field, chosen.axis, chosen.index, pixels, rows[0].length, rows.length);
  }

  function drawProfile(field, u) {
    const [right, up] = PLANE[chosen.axis];
    const other = chosen.along === right ? up : right;
    const positions = [];
    const lines = [[], [], []];
    for (let m = 0; m < field.n[chosen.along]; m += 1) {
      const at = [0, 0, 0];
      [at[chosen.axis], at[chosen.along], at[other]] = [chosen.index, m, chosen.line];
      const v = at[0] + field.n[0] * (at[1] + field.n[1] * at[2]);
      positions.push(field.first[chosen.along] + m * field.spacing);
      lines.forEach((line, c) => line.push(u[3 * v + c] === u[3 * v + c] ? u[3 * v + c] : null));
    }
    profile.show([positions, ...lines]);
  }

  function drawWords(field, drawn, speeds) {
    const replaced = field.status.reduce((sum, status) => sum + (status === 1), 0);
    const share = validShare(field);
    readings.valid.show(percent(share, 1), share < 0.7 ? "doubt" : null);
    const flow = inFlow(field);
    readings.replaced.show(percent(replaced / Math.max(1, flow), 1));
    legend.hidden = flow === field.status.length;
    readings.masked.show(flow < field.status.length ? String(field.status.length - flow) : "none");
    readings.speed.show(`${number(quantile(speeds, WHITE))} m/s`);
    readings.uncertainty.show(`${number(quantile(drawn.uncertainty, 0.5), 2)} m/s`);
    displacements.forEach((plot, a) => {
      const values = validDisplacements(field, a);
      const bins = histogram(values, Math.min(48, Math.max(8, Math.round(1.5 * Math.sqrt(values.length)))));
      plot.show([bins.centres, bins.counts]);
    });
    for (const [line, words] of [[locking, lockingWords(field)], [advice, adviceWords(field)]]) {
      setText(line, words?.text ?? "");
      if (words?.tone) line.dataset.tone = words.tone;
      else delete line.dataset.tone;
    }
  }

  function adviceWords(field) {
    const window = run.status?.configuration.window_mm;
    return window ? dtAdvice(field, window) : null;
  }

  let drawnMask = null;
  function update() {
    shot.update();
    if (run.mask !== drawnMask) {
      drawnMask = run.mask;
      redraw();
    }
    if (chosen.shown !== "shot") statistics.want(VECTORS[chosen.shown]);
  }

  return { element, update, show: () => draw() };
}
