// SPDX-License-Identifier: MIT
// Elements without any text that is parsed as HTML, and small helpers of the page.

const SVG = "http://www.w3.org/2000/svg";

export const by_id = (id) => document.getElementById(id);

// el("button", {type: "button", text: "Go"}, [children]): attributes by name; `text` is text.
export function el(tag, attributes = {}, children = []) {
  const out = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "text") out.textContent = value;
    else if (value === true) out.setAttribute(name, "");
    else if (value !== false && value !== undefined) out.setAttribute(name, value);
  }
  out.append(...children);
  return out;
}

// One of the symbols in index.html.
export function icon(name) {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  const use = document.createElementNS(SVG, "use");
  use.setAttribute("href", "#icon-" + name);
  svg.append(use);
  return svg;
}

export function bytes_text(bytes) {
  if (!Number.isFinite(bytes)) return "";
  if (bytes < 1000) return `${bytes} B`;
  if (bytes < 999500) return `${(bytes / 1000).toPrecision(3)} kB`;
  return `${(bytes / 1e6).toPrecision(3)} MB`;
}

// What a person set, kept for the next visit. Nothing secret.
export const preferences = {
  get(name, otherwise) {
    try {
      return localStorage.getItem("pabd." + name) ?? otherwise;
    } catch {
      return otherwise;
    }
  },
  set(name, value) {
    try {
      localStorage.setItem("pabd." + name, value);
    } catch {
      // not kept, then
    }
  },
};

// Copies within the click that asked for it; false where the browser refuses.
export async function copy(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = el("textarea", { class: "unseen", "aria-hidden": "true" });
    const before = document.activeElement;
    document.body.append(field);
    field.value = text;
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    before?.focus?.({ preventScroll: true });
    return done;
  }
}
