// Statistics of all shots of the run so far, as the daemon has them (docs/http.md): means, fluctuations, Reynolds
// stresses with their intervals, and how they settle. Asked for only while somebody looks at them.

import { ApiError, getJson } from "./api.js";

/** Asked for this far apart at least, and for longer where answers take long. */
const LEAST_MS = 2000;
const PART_OF_TIME = 5;

/** Names of the components' quantities, for three-component maps. */
export const VECTORS = { mean: ["u_mean", "v_mean", "w_mean"], rms: ["u_rms", "v_rms", "w_rms"] };

/** The daemon's answer with its maps as arrays: NaN where there are too few shots. */
export function decodeStatistics(answer) {
  const numbers = (list) => Float32Array.from(list, (value) => value ?? NaN);
  const maps = answer.maps.map((map) => [map.quantity, {
    unit: map.unit,
    value: numbers(map.value),
    low: numbers(map.low),
    high: numbers(map.high),
    flow: numbers(map.flow_uncertainty),
    measurement: numbers(map.measurement_uncertainty),
  }]);
  return {
    shots: answer.shots,
    n: answer.grid.vectors_xyz,
    first: answer.grid.first_mm,
    spacing: answer.grid.spacing_mm,
    samples: Float32Array.from(answer.samples),
    maps: Object.fromEntries(maps),
    convergence: answer.convergence,
    correlations: answer.correlations,
  };
}

/** Three maps as vectors: 3 per point, by `pick(map, point)`; NaN where one has no value. */
export function vectorsOf(statistics, names, pick = (map, v) => map.value[v]) {
  const maps = names.map((name) => statistics.maps[name]);
  const vectors = new Float32Array(3 * statistics.samples.length);
  for (let c = 0; c < 3; c += 1) {
    for (let v = 0; v < statistics.samples.length; v += 1) vectors[3 * v + c] = pick(maps[c], v);
  }
  return vectors;
}

/** Standard uncertainty at a point: the flow's part and the measurement's together. */
export const uncertaintyAt = (map, v) => Math.hypot(map.flow[v], map.measurement[v]);

/** Half the width of the interval of 95 % at a point. */
export const halfWidthAt = (map, v) => (map.high[v] - map.low[v]) / 2;

export class Statistics {
  constructor(run) {
    this.run = run;
    this.listeners = new Set();
    this.busy = false;
    this.restMs = 0;
    this.lastAsked = -Infinity;
    this.clear();
    run.watchResults((shot) => {
      if (shot === null) this.clear();
    });
  }

  clear() {
    /** As decoded; `null` before the first. */
    this.now = null;
    this.error = null;
    this.measured = null;
  }

  watch(listener) {
    this.listeners.add(listener);
  }

  /** Whether these quantities are there. */
  has(quantities) {
    return Boolean(this.now) && quantities.every((name) => this.now.maps[name]);
  }

  /** Somebody looks at these quantities: they are asked for where they are not there, or where more shots were measured since. */
  async want(quantities) {
    const measured = this.run.status?.shots.done ?? 0;
    const isDue = performance.now() - this.lastAsked > this.restMs;
    const isOld = this.measured !== measured || (this.now?.shots ?? 0) < measured;
    if (this.busy || document.hidden || (this.has(quantities) && !(isDue && isOld)) || (this.error && !isDue)) return;
    this.busy = true;
    const began = performance.now();
    this.lastAsked = began;
    try {
      this.now = decodeStatistics(await getJson(`/api/v1/statistics?quantities=${quantities.join(",")}`));
      this.measured = measured;
      this.error = null;
    } catch (error) {
      this.error = error instanceof ApiError ? error.message : "the daemon does not answer";
    } finally {
      this.busy = false;
      this.restMs = Math.max(LEAST_MS, PART_OF_TIME * (performance.now() - began));
      this.listeners.forEach((listener) => listener());
    }
  }
}
