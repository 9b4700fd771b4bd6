// A velocity field as docs/http.md lays it out, in SI units, and what follows from it.

const MAGIC = "LFPIVVF2";
export const VALID = 0;
export const REPLACED = 1;
export const INVALID = 2;
export const MASKED = 3;

/**
 * Reads a field: vector counts `n` [nx, ny, nz], `first` and `spacing` in mm, `u` (m/s, 3 per vector, NaN
 * where there is none), `uncertainty` likewise, `displacement` (voxels), `status`, `dt` (s), `voxel` (mm).
 * Arrays are ordered z, y, x (x fastest).
 */
export function decode(buffer) {
  const view = new DataView(buffer);
  const magic = String.fromCharCode(...new Uint8Array(buffer, 0, 8));
  if (magic !== MAGIC) throw new Error(`a field of another version: ${magic}`);
  const n = [16, 20, 24].map((at) => view.getUint32(at, true));
  const count = n[0] * n[1] * n[2];
  const start = view.getUint32(28, true);
  const [first, spacing, voxel, dt] = [
    [32, 40, 48].map((at) => view.getFloat64(at, true)),
    view.getFloat64(56, true),
    view.getFloat64(64, true),
    view.getFloat64(72, true),
  ];
  const displacement = new Float32Array(buffer, start, 3 * count);
  const status = new Uint8Array(buffer, start + 16 * count, count);
  const uncertaintyStart = Math.ceil((start + 17 * count) / 4) * 4;
  const speed = (voxel * 1e-3) / dt;
  const scaled = (vectors) => vectors.map((value) => value * speed);
  return {
    shot: Number(view.getBigUint64(8, true)),
    n,
    first,
    spacing,
    voxel,
    dt,
    displacement,
    status,
    u: scaled(displacement),
    uncertainty: scaled(new Float32Array(buffer, uncertaintyStart, 3 * count)),
  };
}

/** Far less than any spacing of vectors, in mm. */
const SAME_MM = 1e-6;

/** Whether two fields have their vectors at the same places. */
export function sameGrid(a, b) {
  const near = (one, other) => Math.abs(one - other) < SAME_MM;
  return Boolean(a && b) && near(a.spacing, b.spacing) && a.n.every((m, k) => m === b.n[k] && near(a.first[k], b.first[k]));
}

/** Index of vector (i, j, k). */
export const at = (field, i, j, k) => i + field.n[0] * (j + field.n[1] * k);

/** Magnitudes of vectors; NaN where there is none. */
export function magnitudes(vectors) {
  const size = new Float32Array(vectors.length / 3);
  for (let v = 0; v < size.length; v += 1) size[v] = Math.hypot(vectors[3 * v], vectors[3 * v + 1], vectors[3 * v + 2]);
  return size;
}

/** One component of vectors. */
export function component(vectors, axis) {
  const values = new Float32Array(vectors.length / 3);
  for (let v = 0; v < values.length; v += 1) values[v] = vectors[3 * v + axis];
  return values;
}

/**
 * Vorticity in 1/s, 3 per vector: central differences, one-sided where a neighbour has no value or is
 * beyond the edge, NaN where there is no neighbour with a value along an axis.
 */
export function vorticity(field, u = field.u) {
  const { n, spacing } = field;
  const strides = [1, n[0], n[0] * n[1]];
  const rotation = new Float32Array(u.length);
  for (let k = 0; k < n[2]; k += 1) {
    for (let j = 0; j < n[1]; j += 1) {
      for (let i = 0; i < n[0]; i += 1) {
        const here = at(field, i, j, k);
        const place = [i, j, k];
        // The derivative of component c along axis a, in 1/s.
        const slope = (c, a) => {
          const value = (step) => {
            const inside = place[a] + step >= 0 && place[a] + step < n[a];
            return inside ? u[3 * (here + step * strides[a]) + c] : NaN;
          };
          const [before, own, after] = [value(-1), value(0), value(1)];
          if (own !== own) return NaN;
          const step = spacing * 1e-3;
          if (before === before && after === after) return (after - before) / (2 * step);
          if (after === after) return (after - own) / step;
          return (own - before) / step;
        };
        rotation[3 * here] = slope(2, 1) - slope(1, 2);
        rotation[3 * here + 1] = slope(0, 2) - slope(2, 0);
        rotation[3 * here + 2] = slope(1, 0) - slope(0, 1);
      }
    }
  }
  return rotation;
}

/** The value below which a share of the numbers lie, those that are none left out; NaN where all are. */
export function quantile(values, share) {
  const known = Float32Array.from(values).filter((value) => value === value).sort();
  return known.length ? known[Math.min(known.length - 1, Math.floor(share * known.length))] : NaN;
}

/** How many vectors are in the flow. */
export function inFlow(field) {
  return field.status.reduce((count, status) => count + (status !== MASKED), 0);
}

/** Share of the vectors in the flow that were measured and accepted. */
export function validShare(field) {
  let valid = 0;
  for (const status of field.status) valid += status === VALID;
  return valid / Math.max(1, inFlow(field));
}
