// Control requests, and the token that they need.

import { ApiError, hasToken, post, setToken } from "./api.js";
import { h, setText } from "./dom.js";

/** What was granted longer ago may no longer be so. */
const GRANTED_MS = 15_000;

/** Asks for a token, shows what was refused, and sends control requests. */
export class Desk {
  constructor(run) {
    this.run = run;
    this.said = h("p", { class: "said", role: "status" });
    this.input = h("input", { type: "password", id: "token", autocomplete: "off", spellcheck: "false", size: 40 });
    this.why = h("p", {});
    this.dialog = h("dialog", { "aria-labelledby": "token-title" },
      h("form", { onsubmit: (event) => this.take(event) },
        h("h2", { id: "token-title" }, "Token"),
        this.why,
        h("label", { for: "token" }, "Token of scope read or control"),
        this.input,
        h("p", { class: "hint" }, "It is kept in this page's memory until the page is closed, and nowhere else."),
        h("div", { class: "row" },
          h("button", { type: "submit", class: "primary" }, "Use it"),
          h("button", { type: "button", onclick: () => this.dialog.close() }, "Cancel"))));
  }

  askForToken(why = "") {
    setText(this.why, why);
    if (!this.dialog.open) this.dialog.showModal();
    this.input.focus();
  }

  take(event) {
    event.preventDefault();
    setToken(this.input.value);
    this.input.value = "";
    this.dialog.close();
    this.run.reconnect();
    this.say(hasToken() ? "The token is used from now on." : "No token is used.");
  }

  say(text, tone = null) {
    setText(this.said, text);
    if (tone) this.said.setAttribute("data-tone", tone);
    else this.said.removeAttribute("data-tone");
    clearTimeout(this.fading);
    // What was refused stays until something else is asked for.
    if (text && !tone) this.fading = setTimeout(() => this.say(""), GRANTED_MS);
  }

  /** Nothing is known any more: what was granted is not repeated. */
  doubt() {
    if (!this.said.hasAttribute("data-tone")) this.say("");
  }

  /** Sends a request; true where it was granted. */
  async send(command, body) {
    this.say(`${command} …`);
    try {
      const granted = await post(command, body);
      this.say(granted.pending ? `${command}: the bench is still about it.` : `${command}: done, the run is ${granted.mode}.`);
      return true;
    } catch (error) {
      const words = error instanceof ApiError ? error.message : "the daemon does not answer: use the interlock";
      this.say(`${command} failed: ${words}`, "bad");
      if (error instanceof ApiError && error.status === 401) this.askForToken(`${command} needs a token of scope control.`);
      return false;
    } finally {
      this.run.ask();
    }
  }
}
