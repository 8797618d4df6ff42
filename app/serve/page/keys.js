// SPDX-License-Identifier: MIT
// Keys of the browser by the names of scripts: letters and digits by what is printed on them, the others by their
// place on a US keyboard; the number pad is the main block.

const NAMED = {
  " ": "space",
  Enter: "enter",
  Escape: "escape",
  Tab: "tab",
  Backspace: "backspace",
  Delete: "delete",
  Insert: "insert",
  Home: "home",
  End: "end",
  PageUp: "page_up",
  PageDown: "page_down",
  ArrowLeft: "left",
  ArrowRight: "right",
  ArrowUp: "up",
  ArrowDown: "down",
  Control: "ctrl",
  Shift: "shift",
  Alt: "alt",
  Meta: "super",
  OS: "super",
};

const PLACED = {
  Space: "space",
  Minus: "-",
  Equal: "=",
  Comma: ",",
  Period: ".",
  Slash: "/",
  Semicolon: ";",
  Quote: "'",
  BracketLeft: "[",
  BracketRight: "]",
  Backslash: "\\",
  Backquote: "`",
  NumpadAdd: "=",
  NumpadSubtract: "-",
  NumpadDecimal: ".",
  NumpadDivide: "/",
  NumpadEnter: "enter",
};

export const is_mac = () => /^(Mac|iP)/.test(navigator.platform ?? "");

// The name of the key; "" for one that the tool has no name for. `mac`: Command is ctrl.
export function key_name(event, mac = false) {
  const { key, code } = event;
  if (mac && (key === "Meta" || key === "OS")) return "ctrl";
  if (NAMED[key]) return NAMED[key];
  if (/^F([1-9]|1[0-2])$/.test(key)) return key.toLowerCase();
  if (/^[a-z]$/i.test(key)) return key.toLowerCase();
  if (/^[0-9]$/.test(key)) return key;
  if (PLACED[code]) return PLACED[code];
  // Another alphabet, or a digit with shift: what is printed there on a US keyboard.
  const place = /^(?:Key([A-Z])|(?:Digit|Numpad)([0-9]))$/.exec(code ?? "");
  return place ? (place[1] ?? place[2]).toLowerCase() : "";
}

const KEPT_WITH_CTRL = new Set(["r", "w", "t", "n", "q", "tab", "=", "-", "0", "page_up", "page_down"]);
const KEPT_WITH_CTRL_SHIFT = new Set(["r", "w", "t", "n", "q", "i", "j", "tab", "delete", "="]);
const KEPT_WITH_ALT = new Set(["left", "right", "home", "f4", "tab"]);
const KEPT = new Set(["f5", "f6", "f11", "f12"]);

// What people expect of the browser stays the browser's: reload, tabs, zoom, its tools. F6 leads to the bar.
export function left_to_browser(event, name, mac = false) {
  const ctrl = mac ? event.metaKey : event.ctrlKey;
  if (mac && event.metaKey && (name === "h" || name === "m")) return true;
  if (KEPT.has(name)) return true;
  if (ctrl && event.shiftKey) return KEPT_WITH_CTRL_SHIFT.has(name);
  if (ctrl) return KEPT_WITH_CTRL.has(name);
  return event.altKey && KEPT_WITH_ALT.has(name);
}

// The text that a key types; "" for keys and chords that type none.
export function typed_text(event) {
  const chord = (event.ctrlKey || event.altKey || event.metaKey) && !event.getModifierState("AltGraph");
  return !chord && [...event.key].length === 1 ? event.key : "";
}
