// An image that is moved and magnified with mouse, finger or keys, down to single pixels.

import { fitCanvas, h, themeColour } from "./dom.js";

const MOST = 40;

export class ZoomCanvas {
  /** `changed` is called when another part is seen; `overlay(context, place)` draws on top of the image. */
  constructor(label, { changed = () => {}, overlay = null } = {}) {
    this.canvas = h("canvas", { class: "zoom", tabindex: "0", role: "img", "aria-label": `${label}; plus and minus magnify, arrow keys move` });
    this.changed = changed;
    this.overlay = overlay;
    this.bitmap = null;
    /** Size of the sensor, in pixels: what coordinates are in, however small the image is. */
    this.size = [1, 1];
    this.zoom = 1;
    this.brightness = 1;
    this.middle = [0.5, 0.5];
    this.pointers = new Map();
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.magnify(Math.exp(-event.deltaY / 300), this.under(event));
    }, { passive: false });
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    this.canvas.addEventListener("pointermove", (event) => this.drag(event));
    for (const end of ["pointerup", "pointercancel"]) {
      this.canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    }
    this.canvas.addEventListener("dblclick", (event) => this.magnify(2, this.under(event)));
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  key(event) {
    const step = 0.15 / this.zoom;
    const moves = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] };
    const zooms = { "+": 1.4, "=": 1.4, "-": 1 / 1.4, 0: 1 / this.zoom };
    if (moves[event.key]) this.move(...moves[event.key]);
    else if (zooms[event.key]) this.magnify(zooms[event.key], this.middle);
    else return;
    event.preventDefault();
  }

  /** Two fingers magnify, one moves. */
  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    this.pointers.set(event.pointerId, now);
    if (others.length === 1) {
      const apart = (place) => Math.hypot(place[0] - others[0][0], place[1] - others[0][1]);
      this.magnify(apart(now) / Math.max(1, apart(before)), this.middle);
      return;
    }
    const scale = this.scale();
    this.move(-(now[0] - before[0]) / (scale * this.size[0]), -(now[1] - before[1]) / (scale * this.size[1]));
  }

  move(right, down) {
    this.middle = [this.middle[0] + right, this.middle[1] + down];
    this.settle();
  }

  magnify(factor, place) {
    const zoom = Math.min(MOST, Math.max(1, this.zoom * factor));
    const kept = this.zoom / zoom;
    this.middle = this.middle.map((middle, axis) => place[axis] + (middle - place[axis]) * kept);
    this.zoom = zoom;
    this.settle();
  }

  settle() {
    this.middle = this.middle.map((middle) => Math.min(1 - 0.5 / this.zoom, Math.max(0.5 / this.zoom, middle)));
    this.draw();
    this.changed();
  }

  /** Screen pixels per sensor pixel. */
  scale() {
    const { clientWidth, clientHeight } = this.canvas;
    return this.zoom * Math.min(clientWidth / this.size[0], clientHeight / this.size[1]);
  }

  /** Share of the image under the pointer. */
  under(event) {
    const box = this.canvas.getBoundingClientRect();
    const scale = this.scale();
    return [
      this.middle[0] + (event.clientX - box.left - box.width / 2) / (scale * this.size[0]),
      this.middle[1] + (event.clientY - box.top - box.height / 2) / (scale * this.size[1]),
    ];
  }

  /** Shows an image of a sensor of this size; the one before is given back. */
  show(bitmap, size) {
    this.bitmap?.close();
    this.bitmap = bitmap;
    this.size = size;
    this.draw();
  }

  draw() {
    const { width, height, ratio } = fitCanvas(this.canvas);
    const context = this.canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = themeColour("image-ground");
    context.fillRect(0, 0, width, height);
    if (!this.bitmap) return;
    const scale = this.scale() * ratio;
    const [left, top] = [width / 2 - this.middle[0] * this.size[0] * scale, height / 2 - this.middle[1] * this.size[1] * scale];
    const pixel = (scale * this.size[0]) / this.bitmap.width;
    context.imageSmoothingEnabled = pixel < 3 * ratio;
    context.filter = this.brightness === 1 ? "none" : `brightness(${this.brightness})`;
    context.drawImage(this.bitmap, left, top, this.size[0] * scale, this.size[1] * scale);
    context.filter = "none";
    // Sensor pixels, from the middle of the first, to the canvas.
    const place = (column, row) => [left + (column + 0.5) * scale, top + (row + 0.5) * scale];
    this.overlay?.(context, { place, scale, ratio, width, height });
  }
}
