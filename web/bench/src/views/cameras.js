// Cameras: what both see now, down to the microlens, and whether light, focus and aperture are right.

import { ApiError, getImage, getJson } from "../api.js";
import { h, panel, reading, select, setText, slider, tick } from "../dom.js";
import { Plot } from "../plot.js";
import { shotChoice } from "../shot_choice.js";
import { number, percent } from "../words.js";
import { ZoomCanvas } from "../zoom_canvas.js";

/** Images and numbers are asked for this far apart at least. */
const LEAST_MS = 2000;
/** Widths that are asked for: to look at all of it, and at every pixel. */
const [WHOLE, EVERY_PIXEL] = [900, 8192];
/** Magnifications beyond this show every pixel. */
const NEAR = 2.5;
/** Frames whose light differs by more than this factor are not equally lit. */
const UNEQUAL = 1.25;
/** Corners brighter than this share of the middle: micro-images run into each other. */
const OVERLAPPING = 0.15;
/** Micro-images below this share of the configured diameter waste pixels. */
const UNDERFILLED = 0.9;
/** An edge wider than this is out of focus, in pixels. */
const SOFT_PX = 5;

export function camerasView(run) {
  const element = h("div", { class: "view cameras-view" });
  const choice = { frame: "a", held: null };
  const shot = shotChoice(run, (held) => {
    choice.held = held;
    refresh(true);
  });
  const frame = select("Frame", { a: "a", b: "b" }, (value) => {
    choice.frame = value;
    refresh(true);
  });
  const circles = tick("Configured micro-images", true, () => cameras.forEach((camera) => camera.draw()));
  const brighter = slider("Brightness", { max: 4, value: 0 }, (value) => {
    setText(brighter.shown, `× ${2 ** value}`);
    cameras.forEach((camera) => camera.brighten(2 ** value));
  });
  setText(brighter.shown, "× 1");
  const grid = h("div", { class: "two" });
  const cameras = [];
  element.append(h("div", { class: "controls" }, shot.element, frame.element, brighter.element, circles.element), grid);
  let lastAsked = -Infinity;
  let busy = false;

  function names() {
    return run.status?.configuration.cameras ?? [];
  }

  async function refresh(now = false) {
    if (element.hidden || !element.isConnected || busy || document.hidden) return;
    while (cameras.length < names().length) {
      cameras.push(cameraPanel(names()[cameras.length], cameras.length + 1, run, choice, circles.input));
      grid.append(cameras.at(-1).element);
    }
    if (!now && (performance.now() - lastAsked < LEAST_MS || choice.held !== null)) return;
    lastAsked = performance.now();
    busy = true;
    await Promise.all(cameras.map((camera) => camera.load()));
    busy = false;
  }

  return {
    element,
    update() {
      shot.update();
      refresh();
    },
    show: () => refresh(true),
  };
}

function cameraPanel(name, number_, run, choice, circles) {
  const near = () => image.zoom > NEAR;
  let shown = { shot: null, frame: null, near: false };
  let configured = null;
  const image = new ZoomCanvas(`Image of ${name}`, {
    changed: () => near() !== shown.near && load(),
    overlay: (context, view) => circles.checked && configured && drawCircles(context, view, configured),
  });
  const problem = h("p", { class: "empty" });
  const mean = h("canvas", { class: "micro-image", role: "img", "aria-label": "Mean micro-image" });
  const readings = {
    light: reading("Light a, b", { title: "mean light above black, in counts" }),
    ratio: reading("Light a over b"),
    saturated: reading("Saturated a, b"),
    bright: reading("Lit by particles", { title: "share of the pixels that hold a particle's light" }),
    seeding: reading("Seeding a, b", { title: "particles per microlens of the volume" }),
    black: reading("Black, noise"),
    diameter: reading("Micro-images fill"),
    fNumber: reading("f-number", { title: "of the main lens, as the micro-images show it" }),
    edge: reading("Edge", { title: "distance over which light falls from 80 % to 20 %" }),
  };
  const advice = h("ul", { class: "causes" });
  const histogram = new Plot({
    x: "counts", y: "log10 pixels", height: 150, alt: `Histogram of ${name}`,
    series: [{ label: "frame a" }, { label: "frame b" }],
  });
  const element = panel(name, problem, image.canvas,
    h("dl", { class: "readings" }, ...Object.values(readings).map((one) => one.element)),
    h("div", { class: "beside" }, h("figure", {}, mean, h("figcaption", {}, "Mean micro-image")), h("div", {}, advice)),
    histogram.element);

  async function load() {
    const path = `/api/v1/shots/${choice.held ?? "latest"}/frames/${number_}`;
    const width = near() ? EVERY_PIXEL : WHOLE;
    try {
      const [{ bitmap }, statistics] = await Promise.all([
        getImage(`${path}/${choice.frame}.png?width=${width}`),
        getJson(`${path}/statistics`),
      ]);
      shown = { shot: statistics.shot, frame: choice.frame, near: near() };
      configured = statistics.configured;
      const [columns, rows] = configured.sensor_px;
      image.show(bitmap, [columns, rows]);
      setText(problem, "");
      numbers(statistics);
    } catch (error) {
      setText(problem, error instanceof ApiError ? error.message : "the daemon does not answer");
    }
  }

  function numbers(statistics) {
    const [a, b] = statistics.frames;
    const both = (pick) => `${pick(a)}, ${pick(b)}`;
    readings.light.show(both((one) => number(one.light_counts)));
    const ratio = statistics.a_over_b;
    const unequal = ratio !== null && (ratio > UNEQUAL || ratio < 1 / UNEQUAL);
    readings.ratio.show(number(ratio, 2), unequal ? "doubt" : null);
    const saturated = Math.max(a.saturated_share, b.saturated_share);
    readings.saturated.show(both((one) => percent(one.saturated_share, 2)), saturated > 0.001 ? "doubt" : null);
    readings.bright.show(both((one) => percent(one.bright_share)));
    readings.seeding.show(both((one) => number(one.seeding_ppm, 2)));
    readings.black.show(`${number(a.offset_counts)}, ${number(a.noise_counts, 2)}`);
    const micro = a.micro_image;
    readings.diameter.show(micro ? percent(micro.diameter_pitches) : "–");
    readings.fNumber.show(micro ? `f/${number(micro.f_number, 2)} (configured f/${number(configured.f_number, 2)})` : "–");
    readings.edge.show(micro?.edge_px ? `${number(micro.edge_px, 2)} px` : "–");
    const lines = words(statistics, { unequal, saturated });
    advice.replaceChildren(...lines.map(([tone, text]) => h("li", { "data-tone": tone }, text)));
    drawMean(mean, micro);
    const bins = Math.max(a.histogram.length, b.histogram.length);
    // Frames may have other greatest counts, and so other bins.
    const width = Math.max(a.bin_counts, b.bin_counts);
    const centres = Array.from({ length: bins }, (_, n) => (n + 0.5) * width);
    const rebinned = (one) => {
      const sums = new Array(bins).fill(0);
      one.histogram.forEach((pixels, n) => {
        sums[Math.min(bins - 1, Math.floor(((n + 0.5) * one.bin_counts) / width))] += pixels;
      });
      return sums.map((pixels) => (pixels > 0 ? Math.log10(pixels) : null));
    };
    histogram.show([centres, rebinned(a), rebinned(b)]);
  }

  return {
    element,
    load,
    draw: () => image.draw(),
    brighten(factor) {
      image.brightness = factor;
      image.draw();
    },
  };
}

/** What to do about light, aperture and focus: [tone, text]. */
function words({ configured, frames, a_over_b: ratio }, { unequal, saturated }) {
  const lines = [];
  if (unequal) lines.push(["doubt", `Frame a has ${number(ratio, 2)} times the light of frame b: set the laser heads alike.`]);
  if (saturated > 0.001) lines.push(["doubt", `${percent(saturated, 1)} of the pixels are saturated: less laser light, or a lower gain.`]);
  const micro = frames[0].micro_image;
  if (!micro) {
    lines.push(["doubt", "Micro-images do not stand out: too little light, main lens opened too far, or the array is out of focus."]);
    return lines;
  }
  const filled = micro.diameter_pitches && micro.diameter_pitches / (configured.diameter_px / configured.pitch_px);
  if (micro.corner_share > OVERLAPPING || filled === null) {
    lines.push(["doubt", `Micro-images overlap: their corners have ${percent(micro.corner_share)} of the light. Stop the main lens down towards f/${number(configured.f_number, 2)}.`]);
  } else if (filled < UNDERFILLED) {
    lines.push(["doubt", `Micro-images fill only ${percent(filled)} of their diameter: open the main lens from f/${number(micro.f_number, 2)} to f/${number(configured.f_number, 2)}.`]);
  } else {
    lines.push(["good", "Micro-images fill their pitch and do not overlap: the f-numbers match."]);
  }
  if (micro.edge_px !== null) {
    lines.push(micro.edge_px > SOFT_PX
      ? ["doubt", `Their edges are ${number(micro.edge_px, 2)} px wide: move the sensor into the microlenses' focal plane.`]
      : ["good", `Their edges are ${number(micro.edge_px, 2)} px wide: the array is in focus.`]);
  }
  return lines;
}

/** The configured micro-images, where they are large enough to be seen. */
function drawCircles(context, { place, scale, ratio, width, height }, { pitch_px: pitch, diameter_px: diameter, middle_px: middle }) {
  if (pitch * scale < 14 * ratio) return;
  const [x, y] = place(...middle);
  const step = pitch * scale;
  context.strokeStyle = "#ffb000";
  context.lineWidth = 1.2 * ratio;
  context.beginPath();
  for (let cx = x % step - step; cx < width + step; cx += step) {
    for (let cy = y % step - step; cy < height + step; cy += step) {
      context.moveTo(cx + (diameter * scale) / 2, cy);
      context.arc(cx, cy, (diameter * scale) / 2, 0, 2 * Math.PI);
    }
  }
  context.stroke();
}

function drawMean(canvas, micro) {
  const cells = micro?.cells ?? 1;
  [canvas.width, canvas.height] = [cells, cells];
  const context = canvas.getContext("2d");
  const image = context.createImageData(cells, cells);
  const brightest = Math.max(1, ...(micro?.light ?? []));
  for (let n = 0; n < cells * cells; n += 1) {
    const grey = Math.max(0, Math.round((255 * (micro?.light[n] ?? 0)) / brightest));
    image.data.set([grey, grey, grey, 255], 4 * n);
  }
  context.putImageData(image, 0, 0);
}
