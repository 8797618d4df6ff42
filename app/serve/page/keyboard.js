// SPDX-License-Identifier: MIT
// Keyboard, text and paste. The picture has the focus; while the window on the server wants text a hidden field has
// it, so that input methods and on-screen keyboards work.

import { is_mac, key_name, left_to_browser, typed_text } from "./keys.js";
import { MODIFIER, TYPED_AT_ONCE, fits, modifiers_of } from "./protocol.js";

const SENTINEL = "\u200b"; // something to delete, so that on-screen keyboards report a backspace
const PASTE_WITHIN = 150; // ms

export class Keyboard {
  #canvas;
  #field;
  #send;
  #mac = is_mac();
  #down = new Map(); // code -> name
  #composing = false;
  #named_at = 0; // when a key with a name was last pressed, ms
  #paste = 0;

  to_bar = () => {};
  on_refused = () => {}; // (why)

  constructor(canvas, field, send) {
    this.#canvas = canvas;
    this.#field = field;
    this.#send = send;
    for (const target of [canvas, field]) {
      target.addEventListener("keydown", (event) => this.#pressed(event));
      target.addEventListener("keyup", (event) => this.#released(event));
      target.addEventListener("paste", (event) => this.#pasted(event));
      target.addEventListener("blur", () => this.release());
    }
    field.addEventListener("compositionstart", () => (this.#composing = true));
    field.addEventListener("compositionend", (event) => {
      this.#composing = false;
      this.#type(event.data);
      this.#empty();
    });
    field.addEventListener("input", (event) => this.#typed(event));
    this.#empty();
  }

  get focused() {
    return document.activeElement === this.#canvas || document.activeElement === this.#field;
  }

  // The window wants text, or no longer.
  text_input(on) {
    this.#field.disabled = !on;
    if (on && document.activeElement === this.#canvas) this.#field.focus({ preventScroll: true });
    if (!on && document.activeElement !== this.#canvas && this.#field.matches(":focus, :disabled")) this.focus();
  }

  focus() {
    const target = this.#field.disabled ? this.#canvas : this.#field;
    target.focus({ preventScroll: true });
  }

  // For the button that brings up the keyboard of the screen.
  show() {
    this.#field.disabled = false;
    this.#field.focus({ preventScroll: true });
  }

  // Presses a key as a button of the page.
  press(name, mods = 0) {
    this.#send({ t: "key", key: name, down: true, mods, repeat: false });
    this.#send({ t: "key", key: name, down: false, mods });
  }

  // Everything that is down is let go: the focus left.
  release() {
    for (const name of this.#down.values()) this.#send({ t: "key", key: name, down: false, mods: 0 });
    this.#down.clear();
  }

  #mods(event) {
    const mods = modifiers_of(event);
    if (event.getModifierState("AltGraph")) return mods & ~(MODIFIER.ctrl | MODIFIER.alt);
    if (!this.#mac || !(mods & MODIFIER.meta)) return mods;
    return (mods & ~MODIFIER.meta) | MODIFIER.ctrl;
  }

  #pressed(event) {
    if (event.isComposing || this.#composing || event.keyCode === 229) return;
    const name = key_name(event, this.#mac);
    if (event.key === "F6" && !event.ctrlKey) {
      event.preventDefault();
      this.to_bar();
      return;
    }
    if (name === "" && typed_text(event) === "") return;
    if (left_to_browser(event, name, this.#mac)) return;
    this.#named_at = performance.now();
    const mods = this.#mods(event);
    const writes = event.currentTarget === this.#field;
    if (name === "v" && mods === MODIFIER.ctrl) {
      // What the person copied elsewhere goes first; the key follows it (paste, below).
      if (!event.repeat) this.#paste = setTimeout(() => this.#press_v(), PASTE_WITHIN);
      return;
    }
    if (name !== "") {
      this.#down.set(event.code || name, name);
      this.#send({ t: "key", key: name, down: true, mods, repeat: event.repeat });
    }
    const text = typed_text(event);
    if (writes && text !== "") return; // the field tells what was typed
    event.preventDefault();
    if (text !== "") this.#type(text);
  }

  #released(event) {
    const place = event.code || key_name(event, this.#mac);
    const name = this.#down.get(place);
    if (name === undefined) return;
    this.#down.delete(place);
    this.#send({ t: "key", key: name, down: false, mods: this.#mods(event) });
    // A Mac tells nothing of keys let go while Command is held.
    if (this.#mac && event.key === "Meta") this.release();
  }

  #press_v() {
    this.press("v", MODIFIER.ctrl);
  }

  #pasted(event) {
    event.preventDefault();
    clearTimeout(this.#paste);
    const text = event.clipboardData?.getData("text/plain") ?? "";
    const message = { t: "clipboard", text };
    if (!fits(message)) return this.on_refused("What you paste is too long: the most is 64 KiB");
    if (text !== "") this.#send(message);
    this.#press_v();
  }

  #typed(event) {
    if (this.#composing || event.isComposing) return;
    const on_screen = performance.now() - this.#named_at > 50;
    if (event.inputType === "deleteContentBackward" && on_screen) this.press("backspace");
    else if (event.inputType === "insertLineBreak" && on_screen) this.press("enter");
    else if (event.data) this.#type(event.data);
    this.#empty();
  }

  #type(text) {
    const characters = [...(text ?? "")];
    for (let k = 0; k < characters.length; k += TYPED_AT_ONCE) {
      this.#send({ t: "text", text: characters.slice(k, k + TYPED_AT_ONCE).join("") });
    }
  }

  #empty() {
    this.#field.value = SENTINEL;
    this.#field.setSelectionRange(1, 1);
  }
}
