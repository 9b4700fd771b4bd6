// A colour scale with its numbers.

import { h, setText } from "./dom.js";
import { number } from "./words.js";

export function colourBar() {
  const canvas = h("canvas", { class: "colours", "aria-hidden": "true" });
  const [low, middle, high] = [h("span"), h("span"), h("span")];
  const title = h("span", { class: "title" });
  const element = h("div", { class: "colour-bar" }, title, canvas, h("div", { class: "ends" }, low, middle, high));
  let painted = null;
  return {
    element,
    show(scale, label) {
      setText(title, label);
      setText(low, number(scale.low));
      setText(middle, number((scale.low + scale.high) / 2));
      setText(high, number(scale.high));
      if (painted !== scale.colours) scale.paint(canvas);
      painted = scale.colours;
    },
  };
}
