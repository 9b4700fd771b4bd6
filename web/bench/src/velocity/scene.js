// The field in space: vectors, surfaces of equal vorticity and a slice, turned with mouse, finger or arrow keys.
// Buffers and textures are made once and filled anew, so that a run of days takes no more of them.

import {
  AmbientLight, BoxGeometry, BufferAttribute, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DataTexture,
  DirectionalLight, DoubleSide, DynamicDrawUsage, EdgesGeometry, Group, InstancedMesh, LineBasicMaterial, LineSegments,
  LinearFilter, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, PerspectiveCamera, PlaneGeometry, Quaternion,
  RGBAFormat, SRGBColorSpace, Scene, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";

import { fitCanvas, h, themeColour } from "../dom.js";
import { faces } from "../mask.js";
import { number } from "../words.js";

const UP = new Vector3(0, 1, 0);
/** A step of an arrow key, in rad. */
const TURN = Math.PI / 24;
/** Where the view stands at first, seen from the middle of the field. */
const VIEWPOINT = new Vector3(0.7, 0.5, 1.22).normalize();
/** Room around the field for its labels, as a share of its size. */
const MARGIN = 1.08;

/** An arrow of length 1 along y, about its middle. */
function arrow() {
  const shaft = new CylinderGeometry(0.035, 0.035, 0.7, 6).translate(0, -0.15, 0);
  const head = new ConeGeometry(0.11, 0.3, 8).translate(0, 0.35, 0);
  const merged = mergeGeometries([shaft, head]);
  shaft.dispose();
  head.dispose();
  return merged;
}

export class FieldScene {
  constructor() {
    this.canvas = h("canvas", { class: "space", tabindex: "0", role: "img", "aria-label": "Velocity vectors in space; arrow keys turn them, plus and minus zoom" });
    this.labels = ["x", "y", "z"].map((name) => h("span", { class: "axis-label", "aria-hidden": "true" }, name));
    this.element = h("div", { class: "space-frame" }, this.canvas, ...this.labels);
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(35, 1, 0.1, 1000);
    this.camera.up.set(0, 1, 0);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => this.draw());
    this.canvas.addEventListener("keydown", (event) => this.key(event));
    new ResizeObserver(() => this.draw()).observe(this.canvas);

    this.scene.add(new AmbientLight(0xffffff, 1.6));
    const light = new DirectionalLight(0xffffff, 2.2);
    this.camera.add(light);
    light.position.set(1, 2, 3);
    this.scene.add(this.camera);

    // Everything in mm, about the middle of the field.
    this.group = new Group();
    this.scene.add(this.group);
    this.box = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
    this.group.add(this.box);
    this.vectorMaterial = new MeshLambertMaterial();
    this.arrow = arrow();
    this.vectors = null;
    this.surface = new Mesh(new BufferGeometry(), new MeshLambertMaterial({ side: DoubleSide, transparent: true, opacity: 0.6, depthWrite: false }));
    this.surface.visible = false;
    this.group.add(this.surface);
    this.bodies = new Mesh(new BufferGeometry(), new MeshLambertMaterial({ side: DoubleSide, transparent: true, opacity: 0.45, depthWrite: false }));
    this.bodies.visible = false;
    this.drawnMask = null;
    this.group.add(this.bodies);
    this.slice = new Mesh(new PlaneGeometry(1, 1), new MeshBasicMaterial({ side: DoubleSide, transparent: true, opacity: 0.7 }));
    this.slice.visible = false;
    this.group.add(this.slice);
    this.size = null;
    this.isFramed = false;
  }

  key(event) {
    const turns = { ArrowLeft: [-TURN, 0], ArrowRight: [TURN, 0], ArrowUp: [0, -TURN], ArrowDown: [0, TURN] };
    const zooms = { "+": 0.9, "=": 0.9, "-": 1 / 0.9 };
    if (turns[event.key]) this.turn(...turns[event.key]);
    else if (zooms[event.key]) this.camera.position.multiplyScalar(zooms[event.key]);
    else return;
    event.preventDefault();
    this.controls.update();
    this.draw();
  }

  turn(about, over) {
    const { position } = this.camera;
    position.applyAxisAngle(UP, about);
    const side = new Vector3().crossVectors(UP, position).normalize();
    const lifted = position.clone().applyAxisAngle(side, over);
    // Not beyond the poles, where up is not defined.
    if (Math.abs(lifted.clone().normalize().y) < 0.99) position.copy(lifted);
    this.camera.lookAt(0, 0, 0);
  }

  /** The field's box; the view is set when it is another one. */
  frame(field) {
    this.shot = field.shot;
    const size = field.n.map((n) => n * field.spacing);
    if (this.size && size.every((mm, axis) => mm === this.size[axis])) return;
    this.size = size;
    this.box.geometry.dispose();
    const box = new BoxGeometry(...size);
    this.box.geometry = new EdgesGeometry(box);
    box.dispose();
    this.isFramed = false;
  }

  /** Stands so far away that the box is whole, however it is turned: its corners lie on a sphere. */
  standBack() {
    const upright = (this.camera.fov / 2) * (Math.PI / 180);
    const narrowest = Math.min(upright, Math.atan(Math.tan(upright) * this.camera.aspect));
    const radius = Math.hypot(...this.size) / 2;
    this.camera.position.copy(VIEWPOINT).multiplyScalar((MARGIN * radius) / Math.sin(narrowest));
    this.isFramed = true;
    this.controls.target.set(0, 0, 0);
    this.controls.update();
  }

  /** A place on the grid, in mm about the middle. */
  place(field, i, j, k) {
    return new Vector3(...[i, j, k].map((m, axis) => (m - (field.n[axis] - 1) / 2) * field.spacing));
  }

  /** Vectors as arrows whose length and colour are their size; `scale` is a colour scale. */
  showVectors(field, vectors, scale, visible) {
    const count = field.status.length;
    if (!this.vectors || this.vectors.instanceMatrix.count < count) {
      if (this.vectors) {
        this.group.remove(this.vectors);
        this.vectors.dispose();
      }
      this.vectors = new InstancedMesh(this.arrow, this.vectorMaterial, count);
      this.vectors.instanceMatrix.setUsage(DynamicDrawUsage);
      this.vectors.frustumCulled = false;
      this.group.add(this.vectors);
    }
    this.vectors.visible = visible;
    const [along, matrix, turn, size, colour] = [new Vector3(), new Matrix4(), new Quaternion(), new Vector3(), new Color()];
    const longest = 1.3 * field.spacing;
    let shown = 0;
    for (let v = 0; v < count; v += 1) {
      along.set(vectors[3 * v], vectors[3 * v + 1], vectors[3 * v + 2]);
      const speed = along.length();
      if (!(speed > 0)) continue;
      const [i, j] = [v % field.n[0], Math.floor(v / field.n[0]) % field.n[1]];
      const k = Math.floor(v / (field.n[0] * field.n[1]));
      turn.setFromUnitVectors(UP, along.divideScalar(speed));
      const length = longest * Math.min(1.2, Math.max(0.15, speed / scale.high));
      size.set(0.75 * longest, length, 0.75 * longest);
      this.vectors.setMatrixAt(shown, matrix.compose(this.place(field, i, j, k), turn, size));
      const [r, g, b] = scale.rgb(speed);
      this.vectors.setColorAt(shown, colour.setRGB(r / 255, g / 255, b / 255, SRGBColorSpace));
      shown += 1;
    }
    this.vectors.count = shown;
    this.vectors.instanceMatrix.needsUpdate = true;
    if (this.vectors.instanceColor) this.vectors.instanceColor.needsUpdate = true;
  }

  /** Where the flow ends at what is masked, within the field's box; nothing without a mask. */
  showBodies(field, mask) {
    this.bodies.visible = Boolean(mask);
    if (!mask || (this.drawnMask === mask && this.maskedSize === this.size)) return;
    [this.drawnMask, this.maskedSize] = [mask, this.size];
    const middle = field.first.map((mm, axis) => mm + ((field.n[axis] - 1) / 2) * field.spacing);
    const end = (side) => middle.map((mm, axis) => mm + (side * this.size[axis]) / 2);
    const corners = faces(mask, end(-1), end(1)).map((mm, n) => mm - middle[n % 3]);
    const { geometry } = this.bodies;
    geometry.dispose();
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    geometry.deleteAttribute("normal");
    geometry.computeVertexNormals();
    this.bodies.visible = corners.length > 0;
  }

  /** A surface, in units of the grid; `null` hides it. */
  showSurface(field, triangles) {
    this.surface.visible = Boolean(triangles?.length);
    if (!this.surface.visible) return;
    const { geometry } = this.surface;
    const known = geometry.getAttribute("position");
    if (!known || known.array.length < triangles.length) {
      geometry.dispose();
      geometry.setAttribute("position", new BufferAttribute(new Float32Array(2 * triangles.length), 3).setUsage(DynamicDrawUsage));
      geometry.deleteAttribute("normal");
    }
    const position = geometry.getAttribute("position");
    triangles.forEach((m, n) => {
      const axis = n % 3;
      position.array[n] = (m - (field.n[axis] - 1) / 2) * field.spacing;
    });
    position.needsUpdate = true;
    geometry.setDrawRange(0, triangles.length / 3);
    geometry.computeVertexNormals();
  }

  /** A slice across `axis` at grid place `index`, painted with `pixels` (RGBA, `columns` × `rows`); `null` hides it. */
  showSlice(field, axis, index, pixels, columns, rows) {
    this.slice.visible = Boolean(pixels);
    if (!pixels) return;
    const { material } = this.slice;
    if (!material.map || material.map.image.width !== columns || material.map.image.height !== rows) {
      material.map?.dispose();
      material.map = new DataTexture(new Uint8Array(4 * columns * rows), columns, rows, RGBAFormat);
      material.map.colorSpace = SRGBColorSpace;
      material.map.magFilter = LinearFilter;
      material.needsUpdate = true;
    }
    material.map.image.data.set(pixels);
    material.map.needsUpdate = true;
    const { n, spacing } = field;
    const place = this.place(field, ...n.map((m, a) => (a === axis ? index : (m - 1) / 2)));
    // A plane's own axes are x to the right and y upwards, its normal z.
    const [right, up] = [[1, 2], [0, 2], [0, 1]][axis];
    const unit = (a) => new Vector3(...[0, 1, 2].map((b) => (a === b ? 1 : 0)));
    const across = new Vector3().crossVectors(unit(right), unit(up));
    this.slice.setRotationFromMatrix(new Matrix4().makeBasis(unit(right), unit(up), across));
    this.slice.position.copy(place);
    this.slice.scale.set(n[right] * spacing, n[up] * spacing, 1);
  }

  /** Draws what there is, if it can be seen. */
  draw() {
    if (this.canvas.clientWidth === 0 || !this.size) return;
    const { width, height, ratio } = fitCanvas(this.canvas);
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (!this.isFramed) this.standBack();
    this.box.material.color.set(themeColour("faint-ink"));
    this.surface.material.color.set(themeColour("surface"));
    this.bodies.material.color.set(themeColour("mask"));
    this.renderer.render(this.scene, this.camera);
    this.placeLabels(width / ratio, height / ratio);
    const { geometries, textures } = this.renderer.info.memory;
    // For whoever watches that they do not grow, and which shot is drawn.
    this.canvas.dataset.gpuObjects = String(geometries + textures);
    this.canvas.dataset.shot = String(this.shot);
  }

  placeLabels(width, height) {
    const [x, y, z] = this.size.map((mm) => mm / 2);
    const ends = [new Vector3(0, -y, z), new Vector3(-x, 0, z), new Vector3(x, -y, 0)];
    ends.forEach((end, axis) => {
      const label = this.labels[axis];
      label.textContent = `${"xyz"[axis]}  ${number(this.size[axis])} mm`;
      const seen = end.multiplyScalar(1.12).project(this.camera);
      label.style.left = `${((seen.x + 1) / 2) * width}px`;
      label.style.top = `${((1 - seen.y) / 2) * height}px`;
    });
  }
}
