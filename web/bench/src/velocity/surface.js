// Surfaces of equal value in a field of numbers, by marching tetrahedra: every cell is cut into six
// tetrahedra about its diagonal (Freudenthal), whose cuts are one or two triangles.

// Corners of a cell as bits x, y, z; each tetrahedron follows the edges from corner 0 to corner 7.
const TETRAHEDRA = [
  [0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7],
];

/**
 * Triangles of the surface where `values` (ordered z, y, x) equal `level`, as coordinates in units of the
 * grid, nine numbers per triangle. Cells with a value that is none are left out.
 */
export function surface(values, n, level) {
  const triangles = [];
  const corner = (cell, bits) => cell + (bits & 1) + n[0] * ((bits >> 1) & 1) + n[0] * n[1] * ((bits >> 2) & 1);
  for (let k = 0; k + 1 < n[2]; k += 1) {
    for (let j = 0; j + 1 < n[1]; j += 1) {
      for (let i = 0; i + 1 < n[0]; i += 1) {
        const cell = i + n[0] * (j + n[1] * k);
        const numbers = Array.from({ length: 8 }, (_, bits) => values[corner(cell, bits)]);
        if (numbers.some((value) => value !== value)) continue;
        for (const tetrahedron of TETRAHEDRA) cut(tetrahedron, numbers, [i, j, k], level, triangles);
      }
    }
  }
  return new Float32Array(triangles);
}

function cut(tetrahedron, numbers, cell, level, triangles) {
  const inside = tetrahedron.filter((bits) => numbers[bits] >= level);
  const outside = tetrahedron.filter((bits) => numbers[bits] < level);
  if (inside.length === 0 || outside.length === 0) return;
  // Where the edge between two corners meets the level.
  const point = (a, b) => {
    const share = (level - numbers[a]) / (numbers[b] - numbers[a]);
    return [0, 1, 2].map((axis) => {
      const [from, to] = [(a >> axis) & 1, (b >> axis) & 1];
      return cell[axis] + from + share * (to - from);
    });
  };
  if (inside.length === 2) {
    const [a, b] = inside;
    const [c, d] = outside;
    const [ac, ad, bd, bc] = [point(a, c), point(a, d), point(b, d), point(b, c)];
    triangles.push(...ac, ...ad, ...bd, ...ac, ...bd, ...bc);
    return;
  }
  const [single, others] = inside.length === 1 ? [inside[0], outside] : [outside[0], inside];
  for (const other of others) triangles.push(...point(single, other));
}
