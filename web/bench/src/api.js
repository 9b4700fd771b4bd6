// Requests to the daemon that served this page. The token lives in this module's memory only: not in
// an address, a cookie or a store of the browser.

let token = "";

/** Uses this token from now on; empty for none. */
export function setToken(text) {
  token = text.trim();
}

export function hasToken() {
  return token !== "";
}

/** An answer that is not what was asked for. */
export class ApiError extends Error {
  constructor(status, message, reasons = []) {
    super(message);
    this.status = status;
    this.reasons = reasons;
  }
}

function headers(more = {}) {
  return token ? { ...more, Authorization: `Bearer ${token}` } : more;
}

async function checked(answer) {
  if (answer.ok) return answer;
  let body = {};
  try {
    body = await answer.json();
  } catch {
    // A proxy's page, or nothing: the status says enough.
  }
  throw new ApiError(answer.status, body.error ?? `${answer.status} ${answer.statusText}`, body.reasons ?? []);
}

/** GET, any type. */
export async function get(path, { signal, more } = {}) {
  return checked(await fetch(path, { headers: headers(more), signal, cache: "no-store", credentials: "omit" }));
}

export async function getJson(path, options) {
  return (await get(path, options)).json();
}

export async function getBytes(path, options) {
  return (await get(path, options)).arrayBuffer();
}

/** An image, and the counts that its white stands for. The caller closes the bitmap. */
export async function getImage(path, options) {
  const answer = await get(path, options);
  const white = Number(answer.headers.get("lfpiv-white"));
  return { bitmap: await createImageBitmap(await answer.blob()), white };
}

/** A control request. */
export async function post(command, body) {
  const options = { method: "POST", headers: headers(), credentials: "omit" };
  if (body !== undefined) {
    options.headers = headers({ "Content-Type": "application/json" });
    options.body = JSON.stringify(body);
  }
  return (await checked(await fetch(`/api/v1/control/${command}`, options))).json();
}
