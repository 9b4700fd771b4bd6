// What the page reckons, held against what is known.

import assert from "node:assert/strict";
import { EventParser } from "../src/event_stream.js";
import { dtAdvice, histogram, locking } from "../src/velocity/displacement.js";
import { decodeMask, faces, projected } from "../src/mask.js";
import { decodeParticles, drawParticles } from "../src/particles.js";
import { decode, inFlow, magnitudes, quantile, validShare, vorticity } from "../src/velocity/field.js";
import { decodeStatistics, halfWidthAt, uncertaintyAt, vectorsOf } from "../src/statistics.js";
import { surface } from "../src/velocity/surface.js";

/** A field as the daemon sends it, with displacements by a function of the place in mm. */
function field(n, displacement, { status = () => 0, dt = 1e-4 } = {}) {
  const count = n[0] * n[1] * n[2];
  const start = 80;
  const uncertain = Math.ceil((start + 17 * count) / 4) * 4;
  const buffer = new ArrayBuffer(uncertain + 12 * count);
  const view = new DataView(buffer);
  new Uint8Array(buffer).set(new TextEncoder().encode("LFPIVVF2"));
  view.setBigUint64(8, 42n, true);
  n.forEach((m, axis) => view.setUint32(16 + 4 * axis, m, true));
  view.setUint32(28, start, true);
  const [first, spacing] = [[-1, -2, -3], 0.5];
  first.forEach((mm, axis) => view.setFloat64(32 + 8 * axis, mm, true));
  view.setFloat64(56, spacing, true);
  view.setFloat64(64, 0.1, true);
  view.setFloat64(72, dt, true);
  for (let v = 0; v < count; v += 1) {
    const place = [v % n[0], Math.floor(v / n[0]) % n[1], Math.floor(v / n[0] / n[1])].map((m, axis) => first[axis] + m * spacing);
    const state = status(v);
    displacement(...place).forEach((d, c) => {
      view.setFloat32(start + 4 * (3 * v + c), state === 2 ? NaN : d, true);
      view.setFloat32(uncertain + 4 * (3 * v + c), state === 2 ? NaN : 0.02, true);
    });
    view.setUint8(start + 16 * count + v, state);
  }
  return decode(buffer);
}

// One voxel of 0.1 mm in 100 us is 1 m/s.
const rotation = field([7, 6, 5], (x, y, z) => [-2 * y + z, 2 * x, 0.5 * y], { status: (v) => (v === 100 ? 2 : v === 7 ? 1 : 0) });
assert.equal(rotation.shot, 42);
assert.ok(Math.abs(rotation.u[0] - (4 - 3)) < 1e-6);
assert.ok(Math.abs(rotation.uncertainty[1] - 0.02) < 1e-6);
assert.ok(Math.abs(validShare(rotation) - (210 - 2) / 210) < 1e-9);
const spin = vorticity(rotation);
for (let v = 0; v < 210; v += 1) {
  const found = [...spin.slice(3 * v, 3 * v + 3)];
  if (v === 100) assert.ok(found.every(Number.isNaN));
  // curl (−2y + z, 2x, y/2) = (1/2, 1, 4) per mm of displacement: 1000 times that per second.
  else [500, 1000, 4000].forEach((expected, c) => assert.ok(Math.abs(found[c] - expected) < 1, `${v}: ${found}`));
}
assert.ok(Number.isNaN(magnitudes(rotation.u)[100]));
assert.equal(quantile([3, NaN, 1, 2], 0.99), 3);

// What is masked is in no share.
const masked = field([4, 3, 2], () => [1, 0, 0], { status: (v) => (v < 6 ? 3 : v < 9 ? 2 : 0) });
assert.equal(inFlow(masked), 18);
assert.ok(Math.abs(validShare(masked) - 15 / 18) < 1e-9);

// A ball of voxels of 0.5 mm that are not flow.
const [side, reach] = [12, 4.2];
const isFlow = (v) => Math.hypot((v % side) - 5, (Math.floor(v / side) % side) - 6, Math.floor(v / side ** 2) - 6) > reach;
const wire1 = new Uint8Array(80 + side ** 3 / 8);
wire1.set(new TextEncoder().encode("LFPIVMK1"));
const header = new DataView(wire1.buffer);
[side, side, side, 80].forEach((m, n) => header.setUint32(16 + 4 * n, m, true));
[-3, -2, -1, 0.5].forEach((mm, n) => header.setFloat64(32 + 8 * n, mm, true));
for (let v = 0; v < side ** 3; v += 1) wire1[80 + (v >> 3)] |= isFlow(v) << (v & 7);
const ball = decodeMask(wire1.buffer);
assert.deepEqual([ball.n, ball.first, ball.voxel], [[12, 12, 12], [-3, -2, -1], 0.5]);
assert.ok(ball.flow.every((flow, v) => flow === Number(isFlow(v))));
const solid = ball.flow.reduce((sum, flow) => sum + 1 - flow, 0);
for (const [right, up] of [[0, 1], [0, 2], [1, 2]]) {
  const shares = projected(ball, right, up);
  assert.ok(Math.abs(shares.reduce((sum, share) => sum + share * side, 0) - solid) < 1e-3);
  const middle = [5, 6, 6];
  assert.ok(Math.abs(shares[middle[up] * side + middle[right]] - 9 / side) < 1e-6, "nine voxels across its middle");
}
// Seen along x every column of it shows two faces.
const skin = faces(ball, [-99, -99, -99], [99, 99, 99]);
const facing = (axis) => {
  let count = 0;
  for (let t = 0; t < skin.length; t += 9) count += skin[t + axis] === skin[t + 3 + axis] && skin[t + axis] === skin[t + 6 + axis];
  return count / 2;
};
const columns = projected(ball, 1, 2).filter((share) => share > 0).length;
assert.equal(facing(0), 2 * columns);
assert.ok(skin.every((mm, n) => Math.abs(mm - [-0.5, 1, 2][n % 3]) <= 0.5 * (reach + 0.5)), "it lies about its middle");
assert.equal(faces(ball, [-99, -99, -99], [-3, 99, 99]).length, 0, "none outside the box");

// Three particles of one camera, of which the second disagrees with the others.
const wire2 = new DataView(new ArrayBuffer(80 + 41 * 3));
new Uint8Array(wire2.buffer).set(new TextEncoder().encode("LFPIVPA1"));
[3, 1, 0, 80].forEach((m, n) => wire2.setUint32(16 + 4 * n, m, true));
[0.1, 2e-4].forEach((m, n) => wire2.setFloat64(32 + 8 * n, m, true));
[-1, 2, 3, 0, 0, 0, 1, 2, -3].forEach((mm, n) => wire2.setFloat32(80 + 4 * n, mm, true));
[3, 0, 4, 9, 9, 9, 0, 2, 0].forEach((voxels, n) => wire2.setFloat32(80 + 36 + 4 * n, voxels, true));
[1, 0, 1].forEach((valid, n) => wire2.setUint8(80 + 40 * 3 + n, valid));
const placed = decodeParticles(wire2.buffer);
assert.deepEqual([placed.count, placed.accepted, [...placed.valid]], [3, 2, [1, 0, 1]]);
// A voxel of 0.1 mm in 200 us is 0.5 m/s.
assert.ok([2.5, 1].every((speed, n) => Math.abs(placed.speed[2 * n] - speed) < 1e-6));
assert.ok(Math.abs(placed.scale.high - 2.5) < 1e-6, "those that disagree do not widen the scale");
const squares = [];
const context = { set fillStyle(colour) { squares.push([colour]); }, fillRect: (...square) => squares.at(-1).push(square) };
drawParticles(context, placed, [0, 2], (right, up) => [10 * right, -10 * up], 2);
const [rims, ...bright] = squares;
assert.deepEqual(rims, ["#000000", [-15, -35, 10, 10], [5, 25, 10, 10]]);
assert.deepEqual(bright.map(([, square]) => square), [[-13, -33, 6, 6], [7, 27, 6, 6]]);
assert.equal(bright[0][0], "rgb(240 249 33)", "the fastest is the lightest");

// Every speed is seen on black, and brighter than slower ones, but for the rounding of single steps: WCAG 2.1,
// relative luminance.
const luminance = (rgb) => rgb.map((part) => part / 255)
  .map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4))
  .reduce((sum, part, c) => sum + [0.2126, 0.7152, 0.0722][c] * part, 0);
const seen = Array.from({ length: 256 }, (_, n) => luminance(placed.scale.rgb((placed.scale.high * n) / 255)));
assert.ok((seen[0] + 0.05) / 0.05 >= 3, `${seen[0]}`);
assert.ok(seen.every((light, n) => n < 4 || light > seen[n - 4]));

// Statistics as the daemon sends them: the second of three points has too few shots.
const statistics = decodeStatistics({
  shots: 7,
  samples: [7, 0, 6],
  grid: { vectors_xyz: [3, 1, 1], first_mm: [1, 2, 3], spacing_mm: 0.4 },
  maps: ["u_mean", "v_mean", "w_mean"].map((quantity, c) => ({
    quantity, unit: "m/s", value: [1, null, 3 + c], low: [0, null, 2], high: [2, null, 5], flow_uncertainty: [0.3, null, 0], measurement_uncertainty: [0.4, null, 0.1],
  })),
  convergence: [],
  correlations: [],
});
assert.deepEqual([statistics.n, statistics.first, statistics.spacing, [...statistics.samples]], [[3, 1, 1], [1, 2, 3], 0.4, [7, 0, 6]]);
assert.deepEqual([...vectorsOf(statistics, ["u_mean", "v_mean", "w_mean"])], [1, 1, 1, NaN, NaN, NaN, 3, 4, 5]);
assert.ok(Math.abs(uncertaintyAt(statistics.maps.u_mean, 0) - 0.5) < 1e-6);
assert.equal(halfWidthAt(statistics.maps.v_mean, 2), 1.5);
assert.ok(Number.isNaN(halfWidthAt(statistics.maps.v_mean, 1)));

// A sphere.
const n = [21, 21, 21];
const distance = Array.from({ length: 21 ** 3 }, (_, v) => Math.hypot((v % 21) - 10, (Math.floor(v / 21) % 21) - 10, Math.floor(v / 441) - 10));
const triangles = surface(distance, n, 7);
let area = 0;
for (let t = 0; t < triangles.length; t += 9) {
  const [a, b] = [3, 6].map((o) => [0, 1, 2].map((c) => triangles[t + o + c] - triangles[t + c]));
  area += Math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]) / 2;
}
assert.ok(Math.abs(area / (4 * Math.PI * 49) - 1) < 0.01, `${area}`);

// Peak locking.
let seed = 1;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
const smooth = Array.from({ length: 4000 }, () => 4 * random() - 2);
assert.ok(locking(smooth) < 0.05);
assert.ok(locking(smooth.map((d) => Math.round(d) + 0.2 * (d - Math.round(d)))) > 0.5);
assert.equal(locking(smooth.map((d) => 0.1 * d)), null, "a narrow flow does not tell");
assert.equal(histogram(smooth, 40).counts.reduce((sum, count) => sum + count, 0), 4000);

// A window of 1.6 mm is 16 voxels: a quarter is 4.
const slow = dtAdvice(field([5, 5, 5], () => [1, 0, 0]), 1.6);
assert.ok(Math.abs(slow.bestUs - 400) < 1 && slow.text.includes("longer"), slow.text);
const fast = dtAdvice(field([5, 5, 5], () => [8, 0, 0]), 1.6);
assert.ok(Math.abs(fast.bestUs - 50) < 1 && fast.text.includes("too long"), fast.text);

// Events in pieces of any size.
const wire = ": heartbeat\n\nevent: shot\nid: a-1\ndata: {\"x\":\ndata: 1}\n\r\ndata: plain\n\n";
for (let size = 1; size < 12; size += 1) {
  const told = [];
  const parser = new EventParser({ event: (...event) => told.push(event), comment: (text) => told.push(text) });
  for (let at = 0; at < wire.length; at += size) parser.push(wire.slice(at, at + size));
  assert.deepEqual(told, ["heartbeat", ["shot", '{"x":\n1}', "a-1"], ["message", "plain", null]]);
}
