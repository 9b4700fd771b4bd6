// Volume: the light that was reconstructed, and the particles placed in the images, seen along three axes.

import { ApiError, getImage } from "../api.js";
import { colourBar } from "../colour_bar.js";
import { fitCanvas, h, panel, reading, select, setText, themeColour, tick } from "../dom.js";
import { projected } from "../mask.js";
import { drawParticles, fetchParticles } from "../particles.js";
import { shotChoice } from "../shot_choice.js";
import { count, number, percent, tickNumber } from "../words.js";

const PLANES = { xy: [0, 1], xz: [0, 2], yz: [1, 2] };
const LEAST_MS = 700;
/** Opacity of the tint where all of a line of sight is not flow: light shows through. */
const DEEPEST = 0.7;
const FLOW = "share of the voxels that are flow, as [volume.mask] says";

export function volumeView(run) {
  const choice = { frame: "a", held: null };
  const shot = shotChoice(run, (held) => {
    choice.held = held;
    load();
  });
  const frame = select("Frame", { a: "a", b: "b" }, (value) => {
    choice.frame = value;
    load();
  });
  const placed = tick("Particles", true, () => showParticles());
  const speeds = colourBar();
  const problem = h("p", { class: "empty" });
  const readings = {
    size: reading("Volume"),
    voxels: reading("Voxels"),
    flow: reading("Flow", { title: FLOW }),
    particles: reading("Particles", { title: "from the statistics of the first measured pair's views" }),
    perWindow: reading("Particles per window"),
    placed: reading("Particles placed", { title: "seen in the images of both frames; valid: they agree with those about them, and are drawn; none where correlation resolves the flow" }),
    unexplained: reading("Light unexplained", { title: "per camera; 0: everything is explained" }),
    agreement: reading("Cameras agree", { title: "correlation of the cameras' light along the direction that both see" }),
    disparity: reading("Cameras apart"),
  };
  const legend = h("p", { class: "hint legend" }, h("span", { class: "swatch", "aria-hidden": "true" }),
    "Not flow: the deeper the tint, the more of the line of sight. There is light in it, but no vector is measured, and no particle is placed in a volume with a mask.");
  const planes = Object.entries(PLANES).map(([name, axes]) => plane(name, axes));
  const element = h("div", { class: "view volume" },
    h("div", { class: "controls" }, shot.element, frame.element, placed.element, problem),
    h("dl", { class: "readings" }, ...Object.values(readings).map((one) => one.element)),
    legend,
    h("div", { class: "three" }, ...planes.map((one) => one.element)),
    speeds.element);
  for (const one of [legend, placed.element, readings.placed.element, speeds.element]) one.hidden = true;
  let shown = null;
  let particles = null;
  let busy = false;
  let last = -Infinity;

  async function load() {
    if (busy || element.hidden || document.hidden || !run.status) return;
    const wanted = choice.held ?? run.latestResult;
    if (wanted === null) {
      setText(problem, "No result yet.");
      return;
    }
    busy = true;
    last = performance.now();
    try {
      const { configuration } = run.status;
      const [light, found] = await Promise.allSettled([
        Promise.all(planes.map((one) => getImage(`/api/v1/results/${wanted}/projections/${choice.frame}/${one.name}.png`))),
        configuration.place_particles ? fetchParticles(wanted) : null,
      ]);
      particles = found.value ?? null;
      // A run that is over has no projections, but its particles.
      if (!light.value && !particles) throw light.reason;
      planes.forEach((one, n) => one.show(light.value?.[n].bitmap ?? null, configuration, run.mask));
      showParticles();
      shown = `${wanted} ${choice.frame}`;
      setText(problem, (light.reason ?? found.reason)?.message ?? "");
    } catch (error) {
      setText(problem, error instanceof ApiError ? error.message : "the daemon does not answer");
    } finally {
      busy = false;
    }
  }

  function showParticles() {
    planes.forEach((one) => one.particles(placed.input.checked ? particles : null));
    speeds.element.hidden = !(particles && placed.input.checked);
    readings.placed.show(particles ? `${count(particles.count)}, ${count(particles.accepted)} valid` : "–");
    if (particles) speeds.show(particles.scale, "speed of the particles (m/s)");
  }

  function update() {
    shot.update();
    const { status } = run;
    if (!status) return;
    placed.element.hidden = readings.placed.element.hidden = !status.configuration.place_particles;
    const { voxels_xyz: voxels, voxel_mm: voxel } = status.configuration;
    readings.size.show(`${voxels.map((n) => number(n * voxel)).join(" × ")} mm`);
    readings.voxels.show(`${voxels.join(" × ")} of ${number(voxel)} mm`);
    const { mask } = status.configuration;
    readings.flow.show(mask ? `${percent(mask.flow_share, 1)} of the volume` : "all of it");
    readings.flow.element.title = [FLOW, ...(mask?.files ?? []).map(({ file, sha256 }) => `${file}, SHA-256 ${sha256}`)].join("\n");
    legend.hidden = !run.mask;
    planes.forEach((one) => one.mask(run.mask));
    const scene = status.model_choice?.scene;
    readings.particles.element.hidden = readings.perWindow.element.hidden = !scene;
    const cubicMm = voxels.reduce((product, n) => product * n * voxel, 1);
    readings.particles.show(scene ? `${count(Math.round(scene.particles_per_mm3 * cubicMm))}, ${number(scene.particles_per_mm3, 2)} per mm³` : "–");
    readings.perWindow.show(number(scene?.particles_per_window, 2));
    const fit = status.model_fit;
    readings.unexplained.show(fit ? fit.cameras.map((camera) => percent(camera.unexplained)).join(", ") : "–");
    readings.agreement.show(number(fit?.camera_agreement, 2));
    readings.disparity.show(fit?.camera_disparity_mm ? `${number(fit.camera_disparity_mm, 2)} mm` : "–");
    const wanted = `${choice.held ?? run.latestResult} ${choice.frame}`;
    if (wanted !== shown && choice.held === null && performance.now() - last > LEAST_MS) load();
  }

  return {
    element,
    update,
    show() {
      load();
      planes.forEach((one) => one.draw());
    },
  };
}

/** A projection with its axes in mm. */
function plane(name, [right, up]) {
  const across = "xyz"[3 - right - up];
  const canvas = h("canvas", { class: "projection", role: "img", "aria-label": `Largest light along ${across}` });
  let bitmap = null;
  let configuration = null;
  let mask = null;
  let tinted = null;
  let particles = null;
  new ResizeObserver(() => draw()).observe(canvas);

  function draw() {
    const { width, height, ratio } = fitCanvas(canvas);
    const context = canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    if (!configuration) return;
    const size = [right, up].map((axis) => configuration.voxels_xyz[axis] * configuration.voxel_mm);
    const middle = [right, up].map((axis) => configuration.centre_mm[axis]);
    const [left, below, rest] = [46 * ratio, 38 * ratio, 10 * ratio];
    const scale = Math.min((width - left - rest) / size[0], (height - below - rest) / size[1]);
    const [w, hgt] = size.map((mm) => mm * scale);
    const [x, y] = [left + (width - left - rest - w) / 2, rest + (height - below - rest - hgt) / 2];
    context.imageSmoothingEnabled = false;
    context.fillStyle = "#000000";
    context.fillRect(x, y, w, hgt);
    if (bitmap) context.drawImage(bitmap, x, y, w, hgt);
    if (mask) {
      tinted ??= tint(mask, right, up);
      context.drawImage(tinted, x, y, w, hgt);
    }
    if (particles) {
      const place = (a, b) => [x + (a - middle[0] + size[0] / 2) * scale, y + hgt - (b - middle[1] + size[1] / 2) * scale];
      context.save();
      context.beginPath();
      context.rect(x, y, w, hgt);
      // Some lie in the margin of the volume.
      context.clip();
      drawParticles(context, particles, [right, up], place, ratio);
      context.restore();
    }
    const ink = themeColour("ink");
    context.strokeStyle = context.fillStyle = ink;
    context.lineWidth = ratio;
    context.strokeRect(x, y, w, hgt);
    context.font = `${12 * ratio}px system-ui, sans-serif`;
    for (const [axis, along] of [[0, "x"], [1, "y"]]) {
      for (const tick of ticks(middle[axis] - size[axis] / 2, middle[axis] + size[axis] / 2)) {
        const at = (tick - middle[axis] + size[axis] / 2) * scale;
        context.beginPath();
        if (along === "x") {
          context.moveTo(x + at, y + hgt);
          context.lineTo(x + at, y + hgt + 5 * ratio);
          context.textAlign = "center";
          context.textBaseline = "top";
          context.fillText(tickNumber(tick), x + at, y + hgt + 7 * ratio);
        } else {
          context.moveTo(x, y + hgt - at);
          context.lineTo(x - 5 * ratio, y + hgt - at);
          context.textAlign = "right";
          context.textBaseline = "middle";
          context.fillText(tickNumber(tick), x - 8 * ratio, y + hgt - at);
        }
        context.stroke();
      }
    }
  }

  return {
    name,
    element: panel(`Along ${across}: ${"xyz"[right]} to the right, ${"xyz"[up]} upwards, in mm`, canvas),
    show(image, settings, masked) {
      bitmap?.close();
      bitmap = image;
      configuration = settings;
      if (mask !== masked) [mask, tinted] = [masked, null];
      draw();
    },
    /** Draws these, or none. */
    particles(found) {
      particles = found;
      draw();
    },
    /** Draws anew where the mask is another one. */
    mask(other) {
      if (mask === other) return;
      [mask, tinted] = [other, null];
      draw();
    },
    draw,
  };
}

/** What of a plane is not flow, as an image whose rows go down. */
function tint(mask, right, up) {
  const [columns, rows] = [mask.n[right], mask.n[up]];
  const shares = projected(mask, right, up);
  const image = new ImageData(columns, rows);
  const ofTheme = themeColour("mask");
  const colour = [1, 3, 5].map((start) => parseInt(ofTheme.slice(start, start + 2), 16));
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      const share = shares[(rows - 1 - row) * columns + column];
      image.data.set([...colour, Math.round(255 * DEEPEST * share)], 4 * (row * columns + column));
    }
  }
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [columns, rows];
  canvas.getContext("2d").putImageData(image, 0, 0);
  return canvas;
}

/** Round numbers between two lengths, about five of them. */
function ticks(low, high) {
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((one) => one >= rough);
  const found = [];
  for (let n = Math.ceil(low / step); n * step <= high + 1e-9; n += 1) found.push(n * step);
  return found;
}
