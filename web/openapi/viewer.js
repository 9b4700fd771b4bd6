// Shows /api/v1/openapi.json and tries its GET endpoints. No library, no network but this server.
// Text from the server is only ever set as text, never as markup.
"use strict";

const make = (tag, attributes = {}, ...children) => {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children.filter((child) => child !== undefined && child !== null));
  return element;
};

// Words of the document, with what stands in `backticks` as code.
const prose = (text) =>
  make("span", {}, ...(text || "").split("`").map((part, n) => (n % 2 ? make("code", {}, part) : part)));

const byId = (id) => document.getElementById(id);

// A schema in a few words.
function typeOf(schema) {
  if (!schema) return "";
  if (schema.$ref) {
    const name = schema.$ref.split("/").pop();
    return make("a", { href: `#type-${name}` }, name);
  }
  if (schema.enum) return schema.enum.map((value) => JSON.stringify(value)).join(" | ");
  for (const key of ["oneOf", "anyOf", "allOf"]) {
    if (schema[key]) {
      const parts = schema[key].map(typeOf);
      const sign = key === "allOf" ? " & " : " | ";
      return make("span", {}, ...parts.flatMap((part, n) => (n ? [sign, part] : [part])));
    }
  }
  if (schema.type === "array" || schema.items) {
    return make("span", {}, "[", typeOf(schema.items || {}), "]");
  }
  const type = Array.isArray(schema.type) ? schema.type.join(" | ") : schema.type || "any";
  const limits = [
    schema.minimum !== undefined ? `≥ ${schema.minimum}` : "",
    schema.maximum !== undefined ? `≤ ${schema.maximum}` : "",
  ].filter(Boolean);
  return limits.length ? `${type} (${limits.join(", ")})` : type;
}

function table(heads, rows) {
  const cell = (tag) => (content) => make(tag, {}, content ?? "");
  return make("table", {}, make("tr", {}, ...heads.map(cell("th"))),
    ...rows.map((row) => make("tr", {}, ...row.map(cell("td")))));
}

// Members of an object, those of its parts included.
function members(schema) {
  const own = Object.entries(schema.properties || {});
  const required = new Set(schema.required || []);
  const rows = own.map(([name, member]) =>
    [name, typeOf(member), required.has(name) ? "" : "may be absent", prose(member.description)]);
  return (schema.allOf || []).reduce((all, part) => all.concat(members(part)), rows);
}

function showType(name, schema) {
  const box = make("details", { id: `type-${name}`, open: "" }, make("summary", {}, make("code", {}, name)));
  if (schema.description) box.append(make("p", {}, prose(schema.description)));
  const rows = members(schema);
  box.append(rows.length ? table(["member", "type", "", ""], rows) : make("p", {}, typeOf(schema)));
  return box;
}

// Fills an endpoint's path and query from its inputs.
function addressOf(path, parameters, inputs) {
  const query = new URLSearchParams();
  let filled = path;
  parameters.forEach((parameter, n) => {
    const value = inputs[n].value;
    if (parameter.in === "path") {
      filled = filled.replace(`{${parameter.name}}`, encodeURIComponent(value));
    } else if (parameter.in === "query" && value !== "") {
      query.set(parameter.name, value);
    }
  });
  return query.size ? `${filled}?${query}` : filled;
}

async function show(answer, target) {
  const type = answer.headers.get("content-type") || "";
  target.replaceChildren(make("p", {}, `${answer.status} ${answer.statusText} · ${type}`));
  if (type.startsWith("image/")) {
    const url = URL.createObjectURL(await answer.blob());
    target.append(make("img", { src: url, alt: "" }));
  } else if (type.includes("octet-stream")) {
    target.append(make("p", {}, `${(await answer.arrayBuffer()).byteLength} bytes`));
  } else {
    const text = await answer.text();
    const shown = type.includes("json") ? JSON.stringify(JSON.parse(text), null, 2) : text;
    target.append(make("pre", {}, shown.length > 20000 ? `${shown.slice(0, 20000)}\n…` : shown));
  }
}

function tryForm(path, operation) {
  const parameters = (operation.parameters || []).filter((p) => p.in !== "header");
  const inputs = parameters.map((p) => make("input", { placeholder: p.name, size: "12" }));
  const target = make("div");
  const button = make("button", { type: "button" }, "try");
  button.addEventListener("click", async () => {
    const token = byId("token").value.trim();
    const headers = token ? { Authorization: `Bearer ${token}` } : {};
    try {
      await show(await fetch(addressOf(path, parameters, inputs), { headers }), target);
    } catch (error) {
      target.replaceChildren(make("p", {}, String(error)));
    }
  });
  return make("div", {}, ...inputs, button, target);
}

function showEndpoint(method, path, operation) {
  const box = make("details", {}, make("summary", {},
    make("span", { class: `method ${method}` }, method.toUpperCase()),
    make("code", {}, path), make("span", { class: "brief" }, prose(operation.summary))));
  if (operation.description) box.append(make("p", {}, prose(operation.description)));
  const parameters = (operation.parameters || []).map((p) =>
    [p.name, p.in, typeOf(p.schema), prose(p.description)]);
  if (parameters.length) box.append(table(["parameter", "in", "type", ""], parameters));
  const body = operation.requestBody?.content?.["application/json"]?.schema;
  if (body) box.append(make("p", {}, "Body: ", typeOf(body)));
  const answers = Object.entries(operation.responses).sort().map(([status, answer]) => {
    const content = Object.entries(answer.content || {});
    const types = content.flatMap(([type, { schema }]) => [make("div", {}, `${type} `, typeOf(schema))]);
    return [status, prose(answer.description), make("span", {}, ...types)];
  });
  box.append(table(["status", "", "body"], answers));
  if (method === "get" && !path.endsWith("/events")) box.append(tryForm(path, operation));
  return box;
}

async function main() {
  const api = await (await fetch("/api/v1/openapi.json")).json();
  byId("description").append(prose(api.info.description));
  const endpoints = [];
  for (const [path, item] of Object.entries(api.paths)) {
    for (const [method, operation] of Object.entries(item)) {
      endpoints.push({ method, path, operation, tag: (operation.tags || ["other"])[0] });
    }
  }
  const sections = (api.tags || []).map((tag) => make("section", {},
    make("h2", {}, tag.name), make("p", {}, prose(tag.description)),
    ...endpoints.filter((e) => e.tag === tag.name)
      .map((e) => showEndpoint(e.method, e.path, e.operation))));
  byId("endpoints").replaceChildren(...sections);
  const types = Object.entries(api.components.schemas);
  byId("types").replaceChildren(...types.map(([name, schema]) => showType(name, schema)));
}

main().catch((error) => { byId("endpoints").textContent = String(error); });
