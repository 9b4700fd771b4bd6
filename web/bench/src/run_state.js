// What is known of the run: fed by the event stream, completed by asking now and then. Views read it
// and are told when it changes, a few times a second at most. Everything kept here is bounded.

import { ApiError, getJson } from "./api.js";
import { follow } from "./event_stream.js";
import { fetchMask } from "./mask.js";
import { controlEvent, shotEvent } from "./words.js";

/** Without a sign of life for so long nothing here is known any more. */
export const STALE_MS = 2000;
/** Shots remembered. */
const SHOTS = 200;
/** Lines of the log remembered. */
const LINES = 200;
/** Events of before this page that are asked for, for the log. */
const HISTORY = 400;
/** Numbers of the backlog remembered: half an hour. */
const BACKLOG = 900;
/** How often the status is asked for: what events do not tell. */
const ASK_MS = 2000;
/** Views are told this often at most. */
const TELL_MS = 200;
/** Waits between attempts to connect. */
const RETRY_MS = [300, 600, 1200, 2500];

export class RunState {
  constructor() {
    this.listeners = new Set();
    this.resultListeners = new Set();
    this.forget();
    this.connection = "connecting";
    this.refusal = null;
    this.lastSign = -Infinity;
    this.aborter = null;
    this.attempt = 0;
    this.toldStale = null;
    this.telling = null;
  }

  /** Another run, or none yet. */
  forget() {
    this.run = null;
    this.lastId = null;
    this.historyUpTo = 0;
    this.status = null;
    this.brief = null;
    this.control = null;
    this.shots = new Map();
    this.log = [];
    this.latestResult = null;
    this.finished = [];
    this.frames = [];
    /** Shots that workers on other machines have still to measure, as they were at some times. */
    this.backlog = [];
    /** Which voxels are flow; `null` where all are, or as long as it is not known. */
    this.mask = null;
  }

  /** Whether nothing is known any more. */
  get stale() {
    return performance.now() - this.lastSign > STALE_MS;
  }

  /** Calls back when something has changed. */
  watch(listener) {
    this.listeners.add(listener);
  }

  /** Calls back with the number of a shot whose result can be fetched; `null` when another run begins. */
  watchResults(listener) {
    this.resultListeners.add(listener);
  }

  tell() {
    this.telling ??= setTimeout(() => {
      this.telling = null;
      this.toldStale = this.stale;
      this.listeners.forEach((listener) => listener());
    }, TELL_MS);
  }

  start() {
    this.connect();
    setInterval(() => this.ask(), ASK_MS);
    // A heartbeat that does not come is nobody's event.
    setInterval(() => {
      if (this.stale !== this.toldStale) this.tell();
    }, 250);
  }

  /** Connects anew, as with another token. */
  reconnect() {
    this.attempt = 0;
    this.aborter?.abort();
    if (this.waiting) {
      clearTimeout(this.waiting);
      this.connect();
    }
  }

  async connect() {
    this.waiting = null;
    this.aborter = new AbortController();
    const handlers = {
      event: (name, data, id) => this.event(name, data, id),
      comment: (text) => text === "heartbeat" && this.sign(),
    };
    try {
      this.ask();
      await follow(this.lastId, handlers, this.aborter.signal);
      this.connection = "lost";
    } catch (error) {
      this.refusal = error instanceof ApiError ? error : null;
      this.connection = this.refusal ? "refused" : "lost";
    }
    this.tell();
    const wait = this.aborter.signal.aborted ? 0 : RETRY_MS[Math.min(this.attempt, RETRY_MS.length - 1)];
    this.attempt += 1;
    this.waiting = setTimeout(() => this.connect(), wait);
  }

  /** The run is alive. */
  sign() {
    this.lastSign = performance.now();
    this.attempt = 0;
    this.refusal = null;
    this.connection = "live";
    if (this.toldStale) this.tell();
  }

  event(name, text, id) {
    const data = JSON.parse(text);
    const number = id ? this.place(id) : null;
    const isPast = number !== null && number <= this.historyUpTo;
    if (name === "status" && !isPast) {
      this.brief = data;
      this.control = data.control;
      this.noteFrames(data.cameras);
      this.sign();
    } else if (name === "control") {
      if (!isPast && data.mode) this.control = { mode: data.mode, dt_us: data.dt_us, held: data.held };
      this.note(controlEvent(data), isPast);
      if (!isPast) this.ask();
    } else if (name === "shot") {
      this.shotEnded(data, isPast);
    } else if (name === "result" && !isPast) {
      this.latestResult = data.shot;
      this.resultListeners.forEach((listener) => listener(data.shot));
    } else if (name === "watermarks" && this.brief) {
      this.brief.watermarks = data;
    } else if (name === "missed" && data.missed) {
      this.note({ tone: "doubt", text: `${data.missed} events were missed` }, isPast);
    }
    this.tell();
  }

  /** Follows the event's number; notices another run. Asks for what came before the first event, once. */
  place(id) {
    const [run, text] = id.split("-");
    const number = Number(text);
    if (run !== this.run) {
      const isAnother = this.run !== null;
      this.forget();
      if (isAnother) {
        this.note({ tone: null, text: "The daemon was started again: this is another run" }, false);
        this.resultListeners.forEach((listener) => listener(null));
      }
      this.run = run;
      this.historyUpTo = number;
      this.lastId = `${run}-${Math.max(0, number - HISTORY)}`;
      if (number > 0) queueMicrotask(() => this.aborter?.abort());
      this.ask();
    } else {
      this.lastId = id;
    }
    return number;
  }

  /** Frames that each camera has delivered, with the time at which they were more than before. */
  noteFrames(cameras) {
    const now = performance.now();
    this.frames = (cameras ?? []).map(({ camera, connected, frames }, n) => {
      const before = this.frames[n];
      const since = before && before.frames === frames ? before.since : now;
      return { camera, connected, frames, since };
    });
  }

  noteBacklog(cluster) {
    if (!cluster) return;
    this.backlog.push({ at: performance.now(), backlog: cluster.shots.backlog, inHand: cluster.shots.in_hand });
    if (this.backlog.length > BACKLOG) this.backlog.shift();
  }

  shotEnded(record, isPast) {
    const { shot } = record;
    const known = this.shots.get(shot) ?? { shot, cameras: [] };
    this.keepShot({ ...known, ...record, state: record.stage, model_fit: record.fit });
    if (!isPast) {
      this.finished.push({ at: performance.now(), shot });
      if (this.finished.length > SHOTS) this.finished.shift();
    }
    const line = shotEvent(record);
    if (line) this.note(line, isPast);
  }

  keepShot(shot) {
    this.shots.set(shot.shot, shot);
    while (this.shots.size > SHOTS) this.shots.delete(Math.min(...this.shots.keys()));
  }

  note(line, isPast) {
    this.log.push({ ...line, at: isPast ? null : new Date() });
    if (this.log.length > LINES) this.log.shift();
  }

  /** What events do not tell: ledger, latency, disk, shots that never came to a worker. */
  async ask() {
    if (this.asking || document.hidden) return;
    this.asking = true;
    const { signal } = this.aborter ?? new AbortController();
    try {
      const [status, control, listed] = await Promise.all([
        getJson("/api/v1/status", { signal }),
        getJson("/api/v1/control", { signal }),
        getJson("/api/v1/shots?limit=60", { signal }),
      ]);
      this.status = status;
      this.noteBacklog(status.cluster);
      this.permissions = control;
      this.control = control.state;
      if (!this.brief) this.noteFrames(status.cameras);
      listed.shots.reverse().forEach((shot) => this.keepShot(shot));
      if (this.latestResult === null) {
        const done = [...this.shots.values()].filter((shot) => shot.vectors);
        const latest = done.map((shot) => shot.shot).sort((a, b) => b - a)[0];
        if (latest !== undefined) {
          this.latestResult = latest;
          this.resultListeners.forEach((listener) => listener(latest));
        }
      }
      // It does not change in a run.
      if (status.configuration.mask && !this.mask) this.mask = await fetchMask();
      this.refusal = null;
    } catch (error) {
      if (error instanceof ApiError) this.refusal = error;
    } finally {
      this.asking = false;
      this.tell();
    }
  }

  /** The latest `most` shots, newest first. */
  latestShots(most) {
    return [...this.shots.values()].sort((a, b) => b.shot - a.shot).slice(0, most);
  }

  /** The latest shot that tells how good shots are: measured, failed or lost, not one that was left out. */
  get lastEnded() {
    return this.latestShots(SHOTS).find((shot) => ["done", "failed", "write_failed", "lost"].includes(shot.state));
  }

  /** Measured shots per second over the last few seconds. */
  get rate() {
    const now = performance.now();
    const recent = this.finished.filter(({ at }) => now - at < 10_000);
    return recent.length < 2 ? 0 : recent.length / Math.max(1, (now - recent[0].at) / 1000);
  }
}
