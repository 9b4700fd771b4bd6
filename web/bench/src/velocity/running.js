// Mean and root mean square of the fluctuation over the shots that this page has fetched (Welford 1962).

import { VALID, sameGrid } from "./field.js";

export class Running {
  constructor() {
    this.clear();
  }

  clear() {
    this.grid = null;
    this.shots = 0;
  }

  /** Adds a shot; begins anew where its vectors are in other places or its dt is another. */
  add(field) {
    if (!sameGrid(this.grid, field) || this.grid.dt !== field.dt) {
      this.grid = field;
      this.shots = 0;
      this.counts = new Uint32Array(field.status.length);
      this.means = new Float64Array(field.u.length);
      this.squares = new Float64Array(field.u.length);
    }
    this.shots += 1;
    for (let v = 0; v < field.status.length; v += 1) {
      if (field.status[v] !== VALID) continue;
      const count = (this.counts[v] += 1);
      for (let c = 3 * v; c < 3 * v + 3; c += 1) {
        const before = field.u[c] - this.means[c];
        this.means[c] += before / count;
        this.squares[c] += before * (field.u[c] - this.means[c]);
      }
    }
  }

  /** Mean velocity in m/s, of valid vectors; NaN where there was none. */
  mean() {
    return Float32Array.from(this.means, (mean, c) => (this.counts[Math.floor(c / 3)] > 0 ? mean : NaN));
  }

  /** Root mean square of the fluctuation about the mean in m/s; NaN below two valid vectors. */
  rms() {
    return Float32Array.from(this.squares, (square, c) => {
      const count = this.counts[Math.floor(c / 3)];
      return count > 1 ? Math.sqrt(square / (count - 1)) : NaN;
    });
  }
}
