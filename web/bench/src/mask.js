// Which voxels of the volume are flow, as docs/http.md lays it out, and how that is drawn.

import { getBytes } from "./api.js";

const MAGIC = "LFPIVMK1";

/** The mask of the run. */
export async function fetchMask() {
  return decodeMask(await getBytes("/api/v1/mask"));
}

/**
 * Reads a mask: voxel counts `n` [nx, ny, nz], centre of the first voxel `first` and edge `voxel` in mm, and
 * `flow`, 1 where a voxel is flow, ordered z, y, x (x fastest).
 */
export function decodeMask(buffer) {
  const view = new DataView(buffer);
  const magic = String.fromCharCode(...new Uint8Array(buffer, 0, 8));
  if (magic !== MAGIC) throw new Error(`a mask of another version: ${magic}`);
  const n = [16, 20, 24].map((at) => view.getUint32(at, true));
  const bits = new Uint8Array(buffer, view.getUint32(28, true));
  const flow = new Uint8Array(n[0] * n[1] * n[2]);
  for (let v = 0; v < flow.length; v += 1) flow[v] = (bits[v >> 3] >> (v & 7)) & 1;
  return { n, first: [32, 40, 48].map((at) => view.getFloat64(at, true)), voxel: view.getFloat64(56, true), flow };
}

/** Share of every line of sight across a plane that is not flow: `right` fastest, the lowest row first. */
export function projected(mask, right, up) {
  const { n, flow } = mask;
  const strides = [1, n[0], n[0] * n[1]];
  const across = 3 - right - up;
  const shares = new Float32Array(n[right] * n[up]);
  for (let row = 0; row < n[up]; row += 1) {
    for (let column = 0; column < n[right]; column += 1) {
      let voxel = row * strides[up] + column * strides[right];
      let solid = 0;
      for (let m = 0; m < n[across]; m += 1, voxel += strides[across]) solid += 1 - flow[voxel];
      shares[row * n[right] + column] = solid / n[across];
    }
  }
  return shares;
}

/**
 * The faces between voxels that are flow and voxels that are not, in the box from `low` to `high` (mm): two
 * triangles each, nine numbers per triangle, in mm.
 */
export function faces(mask, low, high) {
  const { n, first, voxel, flow } = mask;
  const strides = [1, n[0], n[0] * n[1]];
  const corners = [];
  // Voxels whose centres are in the box.
  const from = low.map((mm, axis) => Math.max(0, Math.ceil((mm - first[axis]) / voxel - 1e-6)));
  const to = high.map((mm, axis) => Math.min(n[axis] - 1, Math.floor((mm - first[axis]) / voxel + 1e-6)));
  for (let k = from[2]; k <= to[2]; k += 1) {
    for (let j = from[1]; j <= to[1]; j += 1) {
      for (let i = from[0]; i <= to[0]; i += 1) {
        const place = [i, j, k];
        const here = i + j * strides[1] + k * strides[2];
        for (let axis = 0; axis < 3; axis += 1) {
          if (place[axis] < to[axis] && flow[here] !== flow[here + strides[axis]]) corners.push(...face(mask, place, axis));
        }
      }
    }
  }
  return new Float32Array(corners);
}

/** The face of a voxel towards the next one along an axis. */
function face({ first, voxel }, place, axis) {
  const [b, c] = [(axis + 1) % 3, (axis + 2) % 3];
  const corner = (right, up) => {
    const at = place.map((m, a) => first[a] + m * voxel);
    at[axis] += voxel / 2;
    at[b] += (right - 0.5) * voxel;
    at[c] += (up - 0.5) * voxel;
    return at;
  };
  const square = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
  return [0, 1, 2, 0, 2, 3].flatMap((n) => square[n]);
}
