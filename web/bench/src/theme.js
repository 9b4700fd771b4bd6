// Light or dark: as the system is, until the button says otherwise. Kept in the page only.

import { h, setText } from "./dom.js";

const NEXT = { auto: "light", light: "dark", dark: "auto" };

export function themeButton() {
  let theme = "auto";
  const button = h("button", { type: "button", class: "quiet theme", onclick: () => set(NEXT[theme]) }, "Theme: auto");
  function set(name) {
    theme = name;
    setText(button, `Theme: ${name}`);
    if (name === "auto") document.documentElement.removeAttribute("data-theme");
    else document.documentElement.setAttribute("data-theme", name);
    document.dispatchEvent(new Event("themechange"));
  }
  return button;
}
