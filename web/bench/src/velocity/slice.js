// A slice through the field: contour by colour, arrows of the components in its plane, and a line along which
// a profile is taken.

import { fitCanvas, h, themeColour } from "../dom.js";
import { MASKED, at } from "./field.js";
import { tickNumber } from "../words.js";

/** The axes in the plane of a slice across x, y and z: to the right, upwards. */
export const PLANE = [[1, 2], [0, 2], [0, 1]];

/** Numbers of a slice: rows from below, with columns to the right. */
export function slicePlane(field, values, axis, index) {
  const [right, up] = PLANE[axis];
  const rows = [];
  for (let row = 0; row < field.n[up]; row += 1) {
    const line = [];
    for (let column = 0; column < field.n[right]; column += 1) {
      const place = [0, 0, 0];
      [place[axis], place[right], place[up]] = [index, column, row];
      line.push(values[at(field, ...place)]);
    }
    rows.push(line);
  }
  return rows;
}

/** RGBA pixels of a slice, the lowest row first; transparent where there is no value. */
export function slicePixels(rows, scale) {
  const columns = rows[0].length;
  const pixels = new Uint8Array(4 * columns * rows.length);
  rows.flat().forEach((value, n) => {
    if (value === value) pixels.set([...scale.rgb(value), 255], 4 * n);
  });
  return pixels;
}

/** Opacity of the tint of what is not flow. */
const TINT = 0.5;

export class SliceCanvas {
  /** `picked(fraction right, fraction up)` is called where the canvas is pressed. */
  constructor(picked) {
    this.canvas = h("canvas", { class: "slice", role: "img", "aria-label": "Slice through the field" });
    this.buffer = document.createElement("canvas");
    this.drawn = null;
    const again = () => this.drawn && this.draw(...this.drawn);
    new ResizeObserver(again).observe(this.canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", again);
    document.addEventListener("themechange", again);
    this.canvas.addEventListener("pointerdown", (event) => {
      if (!this.area) return;
      const box = this.canvas.getBoundingClientRect();
      const [x, y, width, height] = this.area;
      const right = (event.clientX - box.left - x) / width;
      const up = 1 - (event.clientY - box.top - y) / height;
      if (right >= 0 && right <= 1 && up >= 0 && up <= 1) picked(right, up);
    });
  }

  /** Paints a slice of `values` with arrows of `vectors`; `line` is { along: 0 or 1, index }. */
  draw(field, values, vectors, chosen) {
    this.drawn = [field, values, vectors, chosen];
    const { axis, index, scale, longest, line } = chosen;
    const { width, height, ratio } = fitCanvas(this.canvas);
    const context = this.canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    if (width < 20) return;
    const [right, up] = PLANE[axis];
    const [columns, rows] = [field.n[right], field.n[up]];
    const [left, below] = [44 * ratio, 34 * ratio];
    const cell = Math.min((width - left - 8 * ratio) / columns, (height - below - 8 * ratio) / rows);
    const [w, hgt] = [cell * columns, cell * rows];
    const [x0, y0] = [left + (width - left - 8 * ratio - w) / 2, 8 * ratio + (height - below - 8 * ratio - hgt) / 2];
    this.area = [x0, y0, w, hgt].map((length) => length / ratio);

    this.contour(context, slicePlane(field, values, axis, index), scale, [x0, y0, w, hgt]);
    this.body(context, slicePlane(field, field.status, axis, index), [x0, y0 + hgt, cell]);
    const ink = themeColour("ink");
    context.strokeStyle = ink;
    context.lineWidth = ratio;
    context.strokeRect(x0, y0, w, hgt);
    this.arrows(context, field, vectors, { axis, index, cell, x0, y0: y0 + hgt, longest, ratio });
    if (line) {
      const place = (line.index + 0.5) * cell;
      context.setLineDash([6 * ratio, 4 * ratio]);
      context.lineWidth = 2 * ratio;
      context.strokeStyle = ink;
      context.beginPath();
      if (line.along === 0) {
        context.moveTo(x0, y0 + hgt - place);
        context.lineTo(x0 + w, y0 + hgt - place);
      } else {
        context.moveTo(x0 + place, y0);
        context.lineTo(x0 + place, y0 + hgt);
      }
      context.stroke();
      context.setLineDash([]);
    }
    this.axes(context, field, { axis, ratio, x0, y0, w, hgt, ink });
  }

  contour(context, rows, scale, [x, y, w, hgt]) {
    const columns = rows[0].length;
    [this.buffer.width, this.buffer.height] = [columns, rows.length];
    const pixels = slicePixels([...rows].reverse(), scale);
    const image = new ImageData(new Uint8ClampedArray(pixels), columns, rows.length);
    this.buffer.getContext("2d").putImageData(image, 0, 0);
    // Where a value is missing the cell stays empty: smoothing would invent one.
    context.imageSmoothingEnabled = false;
    context.drawImage(this.buffer, x, y, w, hgt);
  }

  /** Tints what is not flow: an empty cell alone would be a vector that is missing. */
  body(context, statuses, [x0, y0, cell]) {
    context.globalAlpha = TINT;
    context.fillStyle = themeColour("mask");
    statuses.forEach((line, row) => line.forEach((status, column) => {
      if (status === MASKED) context.fillRect(x0 + column * cell, y0 - (row + 1) * cell, cell, cell);
    }));
    context.globalAlpha = 1;
  }

  arrows(context, field, vectors, { axis, index, cell, x0, y0, longest, ratio }) {
    const [right, up] = PLANE[axis];
    context.lineCap = "round";
    // Light on dark and dark on light: a dark line in a pale one is seen on every colour.
    for (const [colour, width] of [["#ffffffc0", 3.2], ["#101418", 1.5]]) {
      context.strokeStyle = colour;
      context.lineWidth = width * ratio * Math.min(1, cell / (14 * ratio));
      context.beginPath();
      for (let row = 0; row < field.n[up]; row += 1) {
        for (let column = 0; column < field.n[right]; column += 1) {
          const place = [0, 0, 0];
          [place[axis], place[right], place[up]] = [index, column, row];
          const v = at(field, ...place);
          const [a, b] = [vectors[3 * v + right], vectors[3 * v + up]];
          if (!(a === a) || Math.hypot(a, b) < 0.02 * longest) continue;
          const size = (0.95 * cell) / longest;
          const [cx, cy] = [x0 + (column + 0.5) * cell, y0 - (row + 0.5) * cell];
          const [dx, dy] = [a * size, -b * size];
          const [tipX, tipY] = [cx + dx / 2, cy + dy / 2];
          context.moveTo(cx - dx / 2, cy - dy / 2);
          context.lineTo(tipX, tipY);
          const [back, side] = [0.3, 0.17];
          context.moveTo(tipX - back * dx - side * dy, tipY - back * dy + side * dx);
          context.lineTo(tipX, tipY);
          context.lineTo(tipX - back * dx + side * dy, tipY - back * dy - side * dx);
        }
      }
      context.stroke();
    }
  }

  axes(context, field, { axis, ratio, x0, y0, w, hgt, ink }) {
    const [right, up] = PLANE[axis];
    context.fillStyle = ink;
    context.font = `${12 * ratio}px system-ui, sans-serif`;
    const ends = (a) => [field.first[a] - field.spacing / 2, field.first[a] + (field.n[a] - 0.5) * field.spacing];
    const [low, high] = ends(right);
    const [bottom, top] = ends(up);
    context.textBaseline = "top";
    context.textAlign = "left";
    context.fillText(tickNumber(low), x0, y0 + hgt + 6 * ratio);
    context.textAlign = "right";
    context.fillText(tickNumber(high), x0 + w, y0 + hgt + 6 * ratio);
    context.textAlign = "center";
    context.fillText(`${"xyz"[right]} (mm)`, x0 + w / 2, y0 + hgt + 6 * ratio);
    context.textAlign = "right";
    context.textBaseline = "bottom";
    context.fillText(tickNumber(bottom), x0 - 6 * ratio, y0 + hgt);
    context.textBaseline = "top";
    context.fillText(tickNumber(top), x0 - 6 * ratio, y0);
    context.textBaseline = "middle";
    context.fillText(`${"xyz"[up]}`, x0 - 6 * ratio, y0 + hgt / 2);
  }
}
