// What the displacements say of the measurement: their histogram, whether they lock to whole voxels, and
// which dt would suit the flow.

import { VALID, quantile } from "./field.js";

/** Below this spread, in voxels, peak locking cannot be distinguished from a flow that is nearly uniform. */
const LEAST_SPREAD = 0.35;
/** Fewer vectors than this do not tell, either: they scatter by themselves. */
const LEAST_VECTORS = 300;
/** A first harmonic of the fractional parts above this is locking. */
const LOCKED = 0.2;
/** Displacements stay below this share of a window (Keane and Adrian 1992). */
export const QUARTER = 0.25;

/** Displacements of valid vectors along one axis, in voxels. */
export function validDisplacements(field, axis) {
  const values = [];
  for (let v = 0; v < field.status.length; v += 1) {
    if (field.status[v] === VALID) values.push(field.displacement[3 * v + axis]);
  }
  return values;
}

/** Counts in `bins` equal bins between the least and the greatest value. */
export function histogram(values, bins) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  if (!(high > low)) [low, high] = Number.isFinite(low) ? [low - 0.5, low + 0.5] : [0, 1];
  const width = (high - low) / bins;
  const counts = new Array(bins).fill(0);
  for (const value of values) counts[Math.min(bins - 1, Math.floor((value - low) / width))] += 1;
  return { centres: counts.map((_, n) => low + (n + 0.5) * width), counts, width };
}

/**
 * Peak locking along one axis: the first harmonic |mean exp(2πi d)| of the fractional parts, 0 for none and 1
 * where every displacement is whole, less what a smooth distribution as wide as this one has by itself. `null`
 * where there are too few displacements, or they spread too little to tell.
 */
export function locking(values) {
  if (values.length < LEAST_VECTORS) return null;
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const variance = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length;
  if (Math.sqrt(variance) < LEAST_SPREAD) return null;
  let [re, im] = [0, 0];
  for (const value of values) {
    re += Math.cos(2 * Math.PI * value);
    im += Math.sin(2 * Math.PI * value);
  }
  // Characteristic function of the normal distribution of this variance.
  const smooth = Math.exp(-2 * Math.PI ** 2 * variance);
  return Math.max(0, Math.hypot(re, im) / values.length - smooth);
}

/** What to say of it: `{ text, tone }`. */
export function lockingWords(field) {
  const found = ["x", "y", "z"].map((name, axis) => [name, locking(validDisplacements(field, axis))]);
  const known = found.filter(([, degree]) => degree !== null);
  if (known.length === 0) {
    return { text: "Peak locking cannot be judged: too few vectors, or displacements spread over less than a voxel.", tone: null };
  }
  const locked = known.filter(([, degree]) => degree > LOCKED).map(([name]) => name);
  const degrees = known.map(([name, degree]) => `${name} ${degree.toFixed(2)}`).join(", ");
  return locked.length
    ? { text: `Displacements lock to whole voxels along ${locked.join(", ")} (${degrees}).`, tone: "doubt" }
    : { text: `No peak locking (first harmonic ${degrees}; above ${LOCKED} is locking).`, tone: "good" };
}

/**
 * The dt that the one-quarter rule gives: the largest displacement, the 99th percentile of any component,
 * is a quarter of a window. `null` without valid vectors.
 */
export function dtAdvice(field, windowMm) {
  const largest = Math.max(...[0, 1, 2].map((axis) => quantile(validDisplacements(field, axis).map(Math.abs), 0.99)));
  if (!(largest > 0)) return null;
  const quarter = (QUARTER * windowMm) / field.voxel;
  const dtUs = field.dt * 1e6;
  const bestUs = (dtUs * quarter) / largest;
  const share = largest / ((windowMm / field.voxel));
  const shown = `largest displacement ${largest.toFixed(1)} voxels, ${(100 * share).toFixed(0)} % of a window`;
  if (largest > quarter) return { text: `dt is too long: ${shown}. Shorten it to ${Number(bestUs.toPrecision(2))} µs.`, tone: "doubt", bestUs };
  if (largest < quarter / 2) {
    return { text: `dt may be longer: ${shown}. Up to ${Number(bestUs.toPrecision(2))} µs keeps a quarter of a window, and errors weigh less.`, tone: null, bestUs };
  }
  return { text: `dt suits the flow: ${shown}.`, tone: "good", bestUs };
}
