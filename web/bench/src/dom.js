// Elements. Text from the server is only ever set as text, never as markup.

/**
 * Makes an element: `h("p", { class: "note" }, "text", child)`. Keys that begin with "on" are
 * listeners, `true` sets a bare attribute, `false`, `null` and `undefined` leave it out.
 */
export function h(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : String(value));
  }
  element.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return element;
}

/** Sets the text of an element, only where it changes: readers of the screen hear what is new. */
export function setText(element, text) {
  const words = String(text);
  if (element.textContent !== words) element.textContent = words;
}

/** Sets an attribute, only where it changes; `null` removes it. */
export function setAttribute(element, name, value) {
  if (value === null) element.removeAttribute(name);
  else if (element.getAttribute(name) !== String(value)) element.setAttribute(name, value);
}

/** A labelled number that changes: its element, and `show(text, tone)`. */
export function reading(label, { wide = false, title } = {}) {
  const value = h("dd", { class: "value" }, "–");
  const element = h("div", { class: wide ? "reading wide" : "reading", title }, h("dt", {}, label), value);
  return {
    element,
    show(text, tone = null) {
      setText(value, text);
      setAttribute(value, "data-tone", tone);
    },
  };
}

/** Attributes of what may scroll: keys alone reach it too, and readers of the screen say its `label`. */
export function scrollable(label) {
  return { tabindex: "0", role: "region", "aria-label": label };
}

/** A titled part of a view. */
export function panel(title, ...children) {
  return h("section", { class: "panel" }, h("h2", {}, title), ...children);
}

let labels = 0;

/** A choice among a few: `select(label, { value: words }, listener)`. */
export function select(label, options, listener) {
  const id = `choice-${(labels += 1)}`;
  const input = h("select", { id, onchange: () => listener(input.value) },
    ...Object.entries(options).map(([value, words]) => h("option", { value }, words)));
  return { element: h("div", { class: "choice" }, h("label", { for: id }, label), input), input };
}

/** A slider from 0 to `max`. */
export function slider(label, { max, value = 0, step = 1 }, listener) {
  const id = `slider-${(labels += 1)}`;
  const shown = h("output", { for: id });
  const input = h("input", { id, type: "range", min: 0, max, step, value, oninput: () => listener(Number(input.value)) });
  return { element: h("div", { class: "choice" }, h("label", { for: id }, label), input, shown), input, shown };
}

/** A box to tick. */
export function tick(label, checked, listener) {
  const id = `tick-${(labels += 1)}`;
  const input = h("input", { id, type: "checkbox", checked, onchange: () => listener(input.checked) });
  return { element: h("div", { class: "choice tick" }, input, h("label", { for: id }, label)), input };
}

/** The drawing size of a canvas, in device pixels, set to that of its place on the screen. */
export function fitCanvas(canvas) {
  const ratio = Math.min(window.devicePixelRatio || 1, 2);
  const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  return { width, height, ratio };
}

/** A colour of the style sheet. */
export function themeColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
