// Tables whose cells are kept and filled anew: who reads the screen hears what is new.

import { h, scrollable, setAttribute, setText } from "./dom.js";

/** A table with a caption. A cell is a text, or { text, tone }. */
export function table(caption) {
  const head = h("thead");
  const body = h("tbody");
  const words = h("caption", {}, caption);
  const element = h("div", { class: "table", ...scrollable(caption) }, h("table", {}, words, head, body));
  function row(into, n, tag, cells) {
    const line = into.children[n] ?? into.appendChild(h("tr"));
    while (line.childElementCount < cells.length) line.append(h(tag, tag === "th" ? { scope: "col" } : {}));
    while (line.childElementCount > cells.length) line.lastChild.remove();
    cells.forEach((cell, at) => {
      setText(line.children[at], cell.text ?? cell);
      setAttribute(line.children[at], "data-tone", cell.tone ?? null);
    });
  }
  return {
    element,
    show(columns, rows, remark = "") {
      row(head, 0, "th", columns);
      rows.forEach((cells, n) => row(body, n, "td", cells));
      while (body.childElementCount > rows.length) body.lastChild.remove();
      setText(words, remark || caption);
    },
  };
}
