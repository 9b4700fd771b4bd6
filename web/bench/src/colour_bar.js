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
    /** Numbers are written by `words`. */
    show(scale, label, words = number) {
      setText(title, label);
      setText(low, words(scale.low));
      setText(middle, words((scale.low + scale.high) / 2));
      setText(high, words(scale.high));
      if (painted !== scale.colours) scale.paint(canvas);
      painted = scale.colours;
    },
  };
}
