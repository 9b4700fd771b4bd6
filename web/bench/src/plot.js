// Line plots and histograms by uPlot, in the colours of the page's theme.

import uPlot from "uplot";

import { h, themeColour } from "./dom.js";
import { tickNumber } from "./words.js";

/** Lines that differ by colour (Okabe and Ito 2008) and by dash. */
const DASHES = [[], [8, 4], [2, 3]];

function axis(label, ink, grid) {
  return {
    label,
    labelSize: 18,
    labelFont: "12px system-ui, sans-serif",
    font: "12px system-ui, sans-serif",
    stroke: ink,
    grid: { stroke: grid, width: 1 },
    ticks: { stroke: grid, width: 1 },
    values: (_, ticks) => ticks.map(tickNumber),
  };
}

export class Plot {
  /** `series` are { label, kind: "line" | "bars" }; `alt` says what is seen to who does not see it. */
  constructor({ x, y, series, alt, height = 190 }) {
    this.options = { x, y, series, height };
    this.element = h("div", { class: "plot", role: "img", "aria-label": alt });
    this.data = [[], ...series.map(() => [])];
    this.plot = null;
    new ResizeObserver(() => this.resize()).observe(this.element);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.restyle());
    document.addEventListener("themechange", () => this.restyle());
  }

  make() {
    const { x, y, series, height } = this.options;
    const [ink, grid] = [themeColour("ink"), themeColour("line")];
    const colours = [1, 2, 3].map((n) => themeColour(`series-${n}`));
    this.plot = new uPlot({
      width: Math.max(120, this.element.clientWidth),
      height,
      legend: { show: series.length > 1, live: false },
      cursor: { show: false },
      scales: { x: { time: false, range: (_, low, high) => this.reach(low, high) } },
      axes: [axis(x, ink, grid), { ...axis(y, ink, grid), size: 56 }],
      series: [{}, ...series.map(({ label, kind = "line" }, n) => ({
        label,
        stroke: colours[n % 3],
        width: 2,
        dash: DASHES[n % 3],
        points: { show: false },
        spanGaps: false,
        ...(kind === "bars" ? { paths: uPlot.paths.bars({ size: [0.9, 60] }), fill: colours[n % 3], dash: [], width: 0 } : {}),
      }))],
    }, this.data, this.element);
  }

  /** Bars need half their width beside the first and the last of them. */
  reach(low, high) {
    const [x] = this.data;
    const isBars = this.options.series.some(({ kind }) => kind === "bars");
    const beside = isBars && x.length > 1 ? (x[1] - x[0]) / 2 : 0;
    return high > low ? [low - beside, high + beside] : [low - 1, high + 1];
  }

  resize() {
    if (this.element.clientWidth === 0) return;
    if (!this.plot) this.make();
    else this.plot.setSize({ width: Math.max(120, this.element.clientWidth), height: this.options.height });
  }

  restyle() {
    this.plot?.destroy();
    this.plot = null;
    this.resize();
  }

  /** Names what is upwards, where it is not always the same. */
  label(y) {
    if (this.options.y === y) return;
    this.options.y = y;
    if (this.plot) this.restyle();
  }

  /** Shows numbers: those along x, then those of each series; `null` is a gap. */
  show(data) {
    this.data = data;
    this.plot?.setData(data);
  }
}
