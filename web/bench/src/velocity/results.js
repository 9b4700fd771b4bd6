// The fields of the run: the latest as it comes, as fast as they can be fetched and no faster than they can be
// looked at.

import { ApiError, getBytes } from "../api.js";
import { decode } from "./field.js";

/** Fields are fetched this far apart at least. */
const LEAST_MS = 250;

export class Results {
  constructor(run) {
    this.run = run;
    this.field = null;
    this.held = null;
    this.error = null;
    this.listeners = new Set();
    this.wanted = null;
    this.busy = false;
    this.lastFetch = -Infinity;
    run.watchResults((shot) => this.isReady(shot));
  }

  watch(listener) {
    this.listeners.add(listener);
  }

  tell() {
    this.listeners.forEach((listener) => listener());
  }

  isReady(shot) {
    if (shot === null) {
      this.field = this.held = this.wanted = null;
      this.tell();
      return;
    }
    this.wanted = shot;
    this.fetchWanted();
  }

  /** Keeps to a shot; `null` follows the latest. */
  hold(shot) {
    this.held = shot;
    if (shot === null) {
      this.wanted = this.run.latestResult;
      this.fetchWanted();
    } else {
      this.fetchHeld(shot);
    }
    this.tell();
  }

  async fetchWanted() {
    if (this.busy || this.wanted === null || this.held !== null || document.hidden) return;
    const wait = LEAST_MS - (performance.now() - this.lastFetch);
    if (wait > 0) {
      this.timer ??= setTimeout(() => {
        this.timer = null;
        this.fetchWanted();
      }, wait);
      return;
    }
    const shot = this.wanted;
    this.wanted = null;
    this.busy = true;
    this.lastFetch = performance.now();
    try {
      const field = decode(await getBytes(`/api/v1/results/${shot}?format=binary`));
      if (this.held === null) this.field = field;
      this.error = null;
      this.tell();
    } catch (error) {
      this.fail(error);
    } finally {
      this.busy = false;
      this.fetchWanted();
    }
  }

  async fetchHeld(shot) {
    try {
      const field = decode(await getBytes(`/api/v1/results/${shot}?format=binary`));
      if (this.held === shot) this.field = field;
      this.error = null;
    } catch (error) {
      this.fail(error);
    }
    this.tell();
  }

  fail(error) {
    this.error = error instanceof ApiError ? error.message : "the daemon does not answer";
    this.tell();
  }
}
