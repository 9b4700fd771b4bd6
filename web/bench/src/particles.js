// Particles placed in the images of a shot, as docs/http.md lays them out, and how they are drawn.

import { getBytes } from "./api.js";
import { ColourScale, ON_BLACK } from "./colour_scale.js";
import { quantile } from "./velocity/field.js";

const MAGIC = "LFPIVPA1";
/** The scale reaches to this share of the speeds: a few outliers must not darken all others. */
const WHITE = 0.99;
/** Edge of a particle's square on the screen, in CSS pixels: where there are many, they hide each other. */
const EDGE = { few: 3, many: 2 };
const MANY = 3000;
/** Width of the dark rim that sets a bright square off from bright light. */
const RIM = 1;

/** The particles of a shot; `null` if none were placed. */
export async function fetchParticles(shot) {
  const bytes = await getBytes(`/api/v1/results/${shot}/particles?format=binary`);
  return bytes.byteLength > 0 ? decodeParticles(bytes) : null;
}

/**
 * Reads particles: their `count`, places `at` (mm, 3 each), `speed` (m/s), and which are `valid` (1), of which there
 * are `accepted`. `scale` colours the speeds of these.
 */
export function decodeParticles(buffer) {
  const view = new DataView(buffer);
  const magic = String.fromCharCode(...new Uint8Array(buffer, 0, 8));
  if (magic !== MAGIC) throw new Error(`particles of another version: ${magic}`);
  const [count, cameras] = [16, 20].map((at) => view.getUint32(at, true));
  const start = view.getUint32(28, true);
  const factor = (view.getFloat64(32, true) * 1e-3) / view.getFloat64(40, true);
  const displacement = new Float32Array(buffer, start + 12 * count, 3 * count);
  const valid = new Uint8Array(buffer, start + (36 + 4 * cameras) * count, count);
  const speed = Float32Array.from({ length: count }, (_, n) => factor * Math.hypot(...displacement.subarray(3 * n, 3 * n + 3)));
  const accepted = valid.reduce((sum, one) => sum + one, 0);
  const scale = new ColourScale(0, quantile(speed.map((one, n) => (valid[n] ? one : NaN)), WHITE), false, ON_BLACK);
  return { count, at: new Float32Array(buffer, start, 3 * count), speed, valid, accepted, scale };
}

/**
 * Draws the valid ones; `place` turns a particle's place along two axes into pixels of the canvas. Rims are below all
 * squares: where particles are dense, none hides another.
 */
export function drawParticles(context, { count, at, speed, valid, scale }, [right, up], place, ratio) {
  const edge = (count < MANY ? EDGE.few : EDGE.many) * ratio;
  const square = (n, width) => {
    const [x, y] = place(at[3 * n + right], at[3 * n + up]);
    context.fillRect(x - width / 2, y - width / 2, width, width);
  };
  context.fillStyle = "#000000";
  for (let n = 0; n < count; n += 1) if (valid[n]) square(n, edge + 2 * RIM * ratio);
  for (let n = 0; n < count; n += 1) {
    if (!valid[n]) continue;
    context.fillStyle = `rgb(${scale.rgb(speed[n]).join(" ")})`;
    square(n, edge);
  }
}
