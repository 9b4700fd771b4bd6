// Numbers and states in words.

const PREFIXES = [[1e12, "T"], [1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""]];

/** A number with about three significant digits; "–" for what is not known. */
export function number(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const places = Math.max(0, Math.min(6, digits - 1 - Math.floor(Math.log10(Math.abs(value)))));
  return value.toFixed(places).replace("-", "−");
}

/** A number on an axis: without zeros that say nothing. */
export function tickNumber(value) {
  return value === null ? "" : String(Number(value.toPrecision(6))).replace("-", "−");
}

export function count(value) {
  return value === null || value === undefined ? "–" : value.toLocaleString("en-GB").replaceAll(",", " ");
}

export function percent(share, places = 0) {
  return share === null || share === undefined || !Number.isFinite(share) ? "–" : `${(100 * share).toFixed(places)} %`;
}

export function bytes(value) {
  if (value === null || value === undefined) return "–";
  const [factor, prefix] = PREFIXES.find(([least]) => value >= least) ?? [1, ""];
  return `${number(value / factor)} ${prefix}B`;
}

export function duration(seconds) {
  if (seconds === null || seconds === undefined || !Number.isFinite(seconds)) return "–";
  if (seconds < 10) return `${number(seconds, 2)} s`;
  if (seconds < 120) return `${Math.round(seconds)} s`;
  if (seconds < 7200) return `${Math.round(seconds / 60)} min`;
  return `${number(seconds / 3600)} h`;
}

/** Hours, minutes and seconds of an RFC 3339 time, in the browser's time zone. */
export function clockTime(text) {
  const time = text ? new Date(text) : null;
  return time && !Number.isNaN(time.getTime()) ? time.toLocaleTimeString("en-GB") : "–";
}

const RUN_STATES = {
  starting: "starting",
  running: "running",
  bench_lost: "synchroniser lost",
  stopping: "stopping",
  finished: "finished",
  failed: "failed",
};

export const runState = (state) => RUN_STATES[state] ?? state ?? "–";

const SHOT_STATES = {
  awaiting_frames: "waits for frames",
  queued: "queued",
  processing: "is measured",
  done: "done",
  failed: "failed",
  write_failed: "not written",
  shed: "shed",
  not_fired: "not fired",
  lost: "lost",
};

export const shotState = (state) => SHOT_STATES[state] ?? state ?? "–";

const OUTCOMES = {
  complete: "complete",
  missing_packets: "packets missing",
  underrun: "no buffer",
  missed_trigger: "missed trigger",
  late: "late",
  unpaired: "unpaired",
  shed: "shed",
  write_failed: "not written",
  not_fired: "not fired",
};

export const outcome = (name) => OUTCOMES[name] ?? name ?? "open";

const COMMANDS = {
  start: "start",
  stop: "stop",
  arm: "arm",
  disarm: "disarm",
  go_on: "go on",
  set_dt: "dt",
  note: "note",
};

/** An event of a control request, in words. */
export function controlEvent(data) {
  const name = COMMANDS[data.command] ?? String(data.command);
  if (data.refused) return { tone: "bad", text: `${name} was refused: ${data.refused.join("; ")}` };
  if (data.command === "note") return { tone: "note", text: `Note: ${data.text}` };
  if (data.command === "set_dt") return { tone: null, text: `dt is ${number(data.dt_us)} µs from the next burst on` };
  return { tone: null, text: `${name}: the run is ${data.mode}` };
}

/** The end of a shot that is worth a line; `null` for one that is in order. */
export function shotEvent(data) {
  const shot = `Shot ${data.shot}`;
  if (data.stage === "failed") return { tone: "bad", text: `${shot} gave no result: ${data.message ?? "no reason given"}` };
  if (data.stage === "write_failed") return { tone: "bad", text: `${shot} was not written: ${data.message ?? ""}` };
  if (data.fit && data.fit.verdict !== "good") {
    return { tone: data.fit.verdict === "poor" ? "bad" : "doubt", text: `${shot}: model fit ${data.fit.verdict}. ${data.fit.causes[0] ?? ""}` };
  }
  if (data.warnings?.length) return { tone: "doubt", text: `${shot}: ${data.warnings[0]}` };
  return null;
}
