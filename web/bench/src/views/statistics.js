// Statistics: what all shots of the run say together, how sure that is, and how it settles.

import { colourBar } from "../colour_bar.js";
import { ColourScale } from "../colour_scale.js";
import { h, panel, reading, select, setAttribute, setText, slider } from "../dom.js";
import { Plot } from "../plot.js";
import { halfWidthAt, uncertaintyAt } from "../statistics.js";
import { at, quantile } from "../velocity/field.js";
import { PLANE, SliceCanvas } from "../velocity/slice.js";
import { count, number, tickNumber } from "../words.js";

const COMPONENTS = "uvw";
const QUANTITIES = {
  u_mean: "mean of u", v_mean: "mean of v", w_mean: "mean of w",
  u_rms: "rms of u", v_rms: "rms of v", w_rms: "rms of w",
  uu: "Reynolds stress uu", vv: "Reynolds stress vv", ww: "Reynolds stress ww",
  uv: "Reynolds stress uv", uw: "Reynolds stress uw", vw: "Reynolds stress vw",
  u_skewness: "skewness of u", v_skewness: "skewness of v", w_skewness: "skewness of w",
};
const PARTS = {
  value: "value",
  half: "half of its 95 % interval",
  uncertainty: "standard uncertainty",
  flow: "its part due to the flow",
  measurement: "its part due to the measurement",
  samples: "valid vectors",
};
const AXES = { 0: "x", 1: "y", 2: "z" };
const UNITS = { "m/s": "m/s", "m2/s2": "m²/s²", 1: "" };
/** Scales reach to this share of the values. */
const WHITE = 0.99;
/** Intervals are from the scatter of groups of shots: below so many shots hardly any point has one. */
const FEW = 4;

export function statisticsView(run, statistics) {
  const chosen = { quantity: "u_mean", part: "value", axis: 2, index: null, along: 0, line: null, at: null };
  const words = h("p", { class: "advice" });
  const readings = {
    shots: reading("Shots", { title: "of the run, whose valid vectors are in the statistics" }),
    samples: reading("Valid vectors at a point", { title: "median over the points that have any, and fewest" }),
    middle: reading("Median over the points", { title: "of the chosen quantity, with the median half of its 95 % interval" }),
    here: reading("On the line", { wide: true, title: "value, 95 % interval, and the standard uncertainties due to the flow and to the measurement" }),
    scale: reading("Integral scales of u, v, w", { title: "along the profile's axis, from the two-point correlation" }),
  };
  const quantity = select("Quantity", QUANTITIES, (value) => redraw({ quantity: value }));
  const part = select("Show", PARTS, (value) => redraw({ part: value }));
  const axis = select("Slice across", AXES, (value) => redraw({ axis: Number(value), index: null, line: null, at: null }));
  axis.input.value = "2";
  const place = slider("at", { max: 1 }, (value) => redraw({ index: value }));
  const along = select("Profile along", AXES, (value) => redraw({ along: Number(value), line: null, at: null }));
  const slice = new SliceCanvas((right, up) => pick(right, up));
  slice.canvas.setAttribute("aria-label", "Slice through the statistics of the run");
  const bar = colourBar();
  const profile = new Plot({
    x: "position (mm)", y: "", alt: "The chosen quantity along the dashed line of the slice, with the bounds of its 95 % interval",
    series: [{ label: "value" }, { label: "95 % interval: upper bound" }, { label: "95 % interval: lower bound" }],
  });
  const means = new Plot({
    x: "shots", y: "m/s", alt: "How the mean settles with the number of shots",
    series: [{ label: "uncertainty of the mean" }, { label: "difference from the mean of all shots" }, { label: "expected of independent shots" }],
  });
  const fluctuations = new Plot({
    x: "shots", y: "rms difference (m/s)", alt: "How the rms of parts of the run differs from that of all shots", height: 190,
    series: [{ label: "rms difference from all shots" }],
  });
  const correlation = new Plot({
    x: "separation (mm)", y: "coefficient", alt: "Two-point correlation of u, v and w", height: 150,
    series: [{ label: "u" }, { label: "v" }, { label: "w" }],
  });
  const course = h("p", { class: "hint" });
  const body = h("div", { class: "parts" },
    h("dl", { class: "readings" }, ...Object.values(readings).map((one) => one.element)),
    h("div", { class: "two" },
      h("div", {},
        panel("Slice",
          h("div", { class: "controls" }, axis.element, place.element),
          slice.canvas, bar.element),
        panel("Convergence", course, means.element, fluctuations.element)),
      h("div", {},
        panel("Profile",
          h("div", { class: "controls" }, along.element, h("p", { class: "hint" }, "Press a place in the slice to move the line.")),
          profile.element),
        panel("Two-point correlation", correlation.element))));
  const element = h("div", { class: "view statistics" },
    h("div", { class: "controls" }, quantity.element, part.element), words, body);

  statistics.watch(() => redraw());

  /** What is asked for: the chosen quantity alone, which is enough for everything here. */
  const wanted = () => [chosen.quantity];

  function redraw(change = {}) {
    Object.assign(chosen, change);
    if (element.isConnected && !element.hidden) draw();
  }

  function pick(right, up) {
    const found = statistics.now;
    if (!found) return;
    const [a, b] = PLANE[chosen.axis];
    if (chosen.along === chosen.axis) chosen.along = a;
    const [across, share, here] = chosen.along === b ? [a, right, up] : [b, up, right];
    const nth = (axis_, part_) => Math.min(found.n[axis_] - 1, Math.floor(part_ * found.n[axis_]));
    redraw({ line: nth(across, share), at: nth(chosen.along, here) });
  }

  function draw() {
    statistics.want(wanted());
    const found = statistics.now;
    const map = found?.maps[chosen.quantity];
    setText(words, statistics.error ?? situation(run, found, map));
    setAttribute(words, "data-tone", statistics.error ? "doubt" : null);
    body.hidden = !map;
    if (!map) return;
    const unit = UNITS[map.unit] ?? map.unit;
    const values = valuesOf(found, map, chosen.part);
    drawSlice(found, values, chosen.part === "samples" ? "" : unit);
    drawProfile(found, map, unit);
    drawCourse(found);
    drawReadings(found, map, unit);
  }

  function drawSlice(found, values, unit) {
    const n = found.n[chosen.axis];
    chosen.index = Math.min(n - 1, chosen.index ?? Math.floor(n / 2));
    place.input.max = n - 1;
    place.input.value = chosen.index;
    setText(place.shown, `${"xyz"[chosen.axis]} = ${number(found.first[chosen.axis] + chosen.index * found.spacing, 2)} mm`);
    const [right, up] = PLANE[chosen.axis];
    if (chosen.along === chosen.axis) chosen.along = right;
    along.input.value = String(chosen.along);
    const across = chosen.along === right ? up : right;
    chosen.line = Math.min(found.n[across] - 1, chosen.line ?? Math.floor(found.n[across] / 2));
    chosen.at = Math.min(found.n[chosen.along] - 1, chosen.at ?? Math.floor(found.n[chosen.along] / 2));
    const isSigned = chosen.part === "value" && !/_rms$|^(uu|vv|ww)$/.test(chosen.quantity);
    const high = quantile(values.map(Math.abs), WHITE);
    const scale = new ColourScale(isSigned ? -high : 0, high, isSigned);
    const geometry = { ...found, status: new Uint8Array(values.length) };
    const noArrows = new Float32Array(3 * values.length).fill(NaN);
    slice.draw(geometry, values, noArrows, {
      axis: chosen.axis, index: chosen.index, scale, longest: 1, line: { along: chosen.along === right ? 0 : 1, index: chosen.line },
    });
    const label = chosen.part === "value" ? QUANTITIES[chosen.quantity] : `${QUANTITIES[chosen.quantity]}: ${PARTS[chosen.part]}`;
    if (chosen.part === "samples") bar.show(scale, PARTS.samples, tickNumber);
    else bar.show(scale, unit ? `${label} (${unit})` : label);
  }

  /** The point of the line at place `m` along it. */
  function pointOf(found, m) {
    const across = 3 - chosen.axis - chosen.along;
    const where = [0, 0, 0];
    [where[chosen.axis], where[chosen.along], where[across]] = [chosen.index, m, chosen.line];
    return at(found, ...where);
  }

  function drawProfile(found, map, unit) {
    const positions = [];
    const lines = [[], [], []];
    for (let m = 0; m < found.n[chosen.along]; m += 1) {
      const v = pointOf(found, m);
      positions.push(found.first[chosen.along] + m * found.spacing);
      [map.value, map.high, map.low].forEach((values, n) => lines[n].push(Number.isNaN(values[v]) ? null : values[v]));
    }
    profile.label(unit ? `${QUANTITIES[chosen.quantity]} (${unit})` : QUANTITIES[chosen.quantity]);
    profile.show([positions, ...lines]);
  }

  function drawCourse({ convergence, correlations }) {
    // Of a stress: its first component.
    const c = COMPONENTS.indexOf(chosen.quantity[0]);
    setText(course, `Root mean square over the points, of ${COMPONENTS[c]}, for parts of the run from a twenty-third to all of it.`);
    const shots = convergence.map((step) => step.shots);
    means.show([shots, ...["mean_uncertainty_m_s", "mean_difference_m_s", "mean_difference_expected_m_s"].map((name) => convergence.map((step) => step[name][c]))]);
    // One shot has no fluctuation.
    fluctuations.show([shots, convergence.map((step) => (step.shots > 1 ? step.rms_difference_m_s[c] : null))]);
    const { separation_mm: separations, coefficient, integral_scale_mm: scales } = correlations[chosen.along];
    correlation.show([separations, ...[0, 1, 2].map((one) => coefficient.map((values) => values[one]))]);
    readings.scale.show(`${scales.map((scale) => number(scale, 2)).join(", ")} mm along ${"xyz"[chosen.along]}`);
  }

  function drawReadings(found, map, unit) {
    const measured = run.status?.shots.done ?? found.shots;
    readings.shots.show(found.shots < measured ? `${count(found.shots)} of ${count(measured)}` : count(found.shots), found.shots < FEW ? "doubt" : null);
    const known = found.samples.map((samples) => (samples > 0 ? samples : NaN));
    readings.samples.show(`${count(quantile(known, 0.5))}, ${count(quantile(known, 0))} at least`);
    const halves = found.samples.map((_, v) => halfWidthAt(map, v));
    const half = quantile(halves, 0.5);
    const shownUnit = unit ? ` ${unit}` : "";
    readings.middle.show(`${number(quantile(map.value, 0.5))}${Number.isNaN(half) ? "" : ` ± ${number(half, 2)}`}${shownUnit}`);
    const v = pointOf(found, chosen.at);
    const where = `${"xyz"[chosen.along]} = ${number(found.first[chosen.along] + chosen.at * found.spacing, 2)} mm`;
    setText(readings.here.element.querySelector("dt"), `On the line, at ${where}`);
    readings.here.show(Number.isNaN(map.value[v]) ? "too few shots" : Number.isNaN(map.low[v])
      ? `${number(map.value[v])}${shownUnit}`
      : `${number(map.value[v])}${shownUnit}, 95 %: ${number(map.low[v])} to ${number(map.high[v])}; ${count(found.samples[v])} vectors`);
  }

  return {
    element,
    update: () => statistics.want(wanted()),
    show: () => draw(),
  };
}

function valuesOf(found, map, part) {
  if (part === "samples") return found.samples;
  if (part === "half") return map.value.map((_, v) => halfWidthAt(map, v));
  if (part === "uncertainty") return map.value.map((_, v) => uncertaintyAt(map, v));
  return map[part];
}

/** What is to be known of it, in words. */
function situation(run, found, map) {
  if (!found) return "Asked for …";
  if (found.shots < FEW) return "Intervals are known once there are some more shots.";
  const measured = run.status?.shots.done ?? found.shots;
  const all = found.shots < measured ? `${count(found.shots)} of the ${count(measured)} shots measured so far` : `all ${count(found.shots)} shots measured so far`;
  return map ? `Of the valid vectors of ${all}.` : "";
}
