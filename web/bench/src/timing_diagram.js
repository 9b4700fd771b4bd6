// When lamps, Q-switches and cameras fire in one period: the part around the light pulses, to scale.

import { h, scrollable } from "./dom.js";
import { number, tickNumber } from "./words.js";

const SVG = "http://www.w3.org/2000/svg";
const [LEFT, WIDTH, ROW, TOP] = [120, 860, 34, 10];

function s(tag, attributes, ...children) {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

export function timingDiagram() {
  const element = h("div", { class: "timing", ...scrollable("Timing") });
  let timing = null;

  function draw() {
    if (!timing) return;
    // [name, [[start, end, label], …], class]; trigger pulses are drawn as wide as they are.
    const pulse = (at) => [at, at + timing.pulse_width_us, tickNumber(at)];
    const rows = [
      ["Lamps 1, 2", timing.lamp_us.map(pulse), "lamp-pulse"],
      ["Q-switches 1, 2", timing.q_switch_us.map(pulse), "light-pulse"],
      ["Camera trigger", [pulse(timing.camera_trigger_us)], "trigger-pulse"],
      ["Exposures a, b", [[...timing.exposure_1_us, "a"], [...timing.exposure_2_us, "b"]], "exposure"],
    ];
    const last = Math.max(...timing.q_switch_us, ...timing.lamp_us) + 2 * timing.pulse_width_us + 40;
    const end = Math.max(last, timing.exposure_2_us[0] + 0.3 * (timing.exposure_1_us[1] - timing.exposure_1_us[0]));
    const x = (us) => LEFT + (WIDTH * Math.min(us, end)) / end;
    const height = TOP + ROW * rows.length + 46;
    const picture = s("svg", { viewBox: `0 0 ${LEFT + WIDTH + 16} ${height}`, role: "img", "aria-label": alt(timing) });
    rows.forEach(([name, pulses, kind], n) => {
      const base = TOP + ROW * (n + 1) - 6;
      picture.append(s("text", { x: 0, y: base - 6, class: "name" }, name));
      picture.append(s("line", { x1: LEFT, x2: LEFT + WIDTH, y1: base, y2: base, class: "base" }));
      for (const [from, to, label] of pulses) {
        const width = Math.max(2.5, x(to) - x(from));
        picture.append(s("rect", { x: x(from), y: base - 20, width, height: 20, class: kind }));
        // An exposure has its name in it, a pulse its time behind it.
        const at = kind === "exposure" ? x(from) + 8 : x(from) + width + 4;
        picture.append(s("text", { x: at, y: base - 6, class: "at" }, label));
      }
    });
    const base = TOP + ROW * rows.length + 8;
    const step = niceStep(end);
    for (let us = 0; us <= end; us += step) {
      picture.append(s("line", { x1: x(us), x2: x(us), y1: base, y2: base + 5, class: "base" }));
      picture.append(s("text", { x: x(us), y: base + 20, class: "tick" }, tickNumber(us)));
    }
    picture.append(s("text", { x: LEFT + WIDTH / 2, y: base + 36, class: "tick" }, "µs after T0"));
    const [q1, q2] = timing.q_switch_us;
    element.replaceChildren(picture, h("p", { class: "hint" },
      `Light pulses at ${tickNumber(q1)} and ${tickNumber(q2)} µs, ${tickNumber(timing.dt_us)} µs apart; cameras ready again after ${number(timing.camera_ready_us / 1000)} ms of a period of ${number(timing.period_us / 1000)} ms.`));
  }

  return {
    element,
    draw,
    show(asked) {
      timing = asked;
      draw();
    },
  };
}

function alt({ q_switch_us: [q1, q2], exposure_1_us: a, exposure_2_us: b }) {
  return `Timing diagram: light pulse 1 at ${number(q1, 4)} µs in exposure a from ${number(a[0], 4)} to ${number(a[1], 4)} µs; light pulse 2 at ${number(q2, 4)} µs in exposure b from ${number(b[0], 4)} µs`;
}

function niceStep(end) {
  const power = 10 ** Math.floor(Math.log10(end / 8));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= end / 8);
}
