// Server-sent events by `fetch`, which can send a token in a header; `EventSource` cannot.
// https://html.spec.whatwg.org/multipage/server-sent-events.html#event-stream-interpretation

import { get } from "./api.js";

/** Reads lines of a stream into events and comments. */
export class EventParser {
  constructor({ event, comment }) {
    this.event = event;
    this.comment = comment;
    this.rest = "";
    this.clear();
  }

  clear() {
    this.name = "message";
    this.id = null;
    this.data = [];
  }

  push(text) {
    const lines = (this.rest + text).split("\n");
    this.rest = lines.pop();
    lines.forEach((line) => this.line(line.replace(/\r$/, "")));
  }

  line(line) {
    if (line === "") {
      if (this.data.length > 0) this.event(this.name, this.data.join("\n"), this.id);
      this.clear();
      return;
    }
    if (line.startsWith(":")) {
      this.comment(line.slice(1).trim());
      return;
    }
    const colon = line.indexOf(":");
    const field = colon < 0 ? line : line.slice(0, colon);
    const value = colon < 0 ? "" : line.slice(colon + 1).replace(/^ /, "");
    if (field === "event") this.name = value;
    else if (field === "id") this.id = value;
    else if (field === "data") this.data.push(value);
  }
}

/** Follows the stream to its end; throws where it cannot be had. `signal` ends it. */
export async function follow(lastId, handlers, signal) {
  const more = lastId ? { Accept: "text/event-stream", "Last-Event-ID": lastId } : { Accept: "text/event-stream" };
  const answer = await get("/api/v1/events", { signal, more });
  const parser = new EventParser(handlers);
  const decoder = new TextDecoder();
  const reader = answer.body.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return;
    parser.push(decoder.decode(value, { stream: true }));
  }
}
