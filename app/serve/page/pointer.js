// SPDX-License-Identifier: MIT
// Mouse, pen, touch and wheel on the picture.

import { Gestures } from "./gestures.js";
import { modifiers_of } from "./protocol.js";

const BUTTONS = [
  [1, "left"],
  [2, "right"],
  [4, "middle"],
];
const WHEEL_PIXELS = 100; // of a notch
const WHEEL_LINES = 3;
const PINCH_PIXELS = 14; // a trackpad's pinch comes as wheel with ctrl: exp(-y/100) is the factor, 1.15 a notch
const MOST_NOTCHES = 10; // an event
const TOUCH_LEAVES_AFTER = 600; // ms: what a finger left hovered lets go

// Notches of the wheel, y > 0 away from the person, x > 0 to the left, as window systems count.
export function notches(event) {
  const by = (delta, wheel_delta) => {
    let n;
    if (event.deltaMode === 1) n = -delta / WHEEL_LINES;
    else if (event.deltaMode === 2) n = -Math.sign(delta) * 3;
    else if (event.ctrlKey && Math.abs(delta) < 50) n = -delta / PINCH_PIXELS;
    else if (wheel_delta && wheel_delta % 120 === 0) n = wheel_delta / 120;
    else n = -delta / WHEEL_PIXELS;
    return Math.max(-MOST_NOTCHES, Math.min(MOST_NOTCHES, n)) || 0;
  };
  return { x: by(event.deltaX, event.wheelDeltaX), y: by(event.deltaY, event.wheelDeltaY) };
}

export class Pointer {
  #canvas;
  #picture;
  #send;
  #down = 0; // bits of the mouse's buttons that are pressed on the server
  #last = { x: 0, y: 0 };
  #gestures;
  #long_press = 0;
  #settles = 0; // the frame at which two fingers are looked at
  #leave = 0;

  before_press = () => {}; // focus goes to the picture

  // send(message): input for the server; nothing is sent while it says that we only watch.
  constructor(canvas, picture, send) {
    this.#canvas = canvas;
    this.#picture = picture;
    this.#send = send;
    this.#gestures = new Gestures((message) => this.#touch(message));
    const on = (type, act, options) => canvas.addEventListener(type, act, options);
    on("pointerdown", (event) => this.#pressed(event));
    on("pointermove", (event) => this.#moved(event));
    on("pointerup", (event) => this.#released(event));
    on("pointercancel", (event) => this.#cancelled(event));
    // Chromium ends the capture with the first of several buttons that is let go: the others are followed here.
    for (const type of ["pointermove", "pointerup"]) {
      addEventListener(type, (event) => {
        if (this.#down === 0 || event.target === canvas || event.pointerType === "touch") return;
        this.#mouse(event);
        if (this.#down !== 0) this.#capture(event.pointerId);
      });
    }
    on("pointerleave", (event) => {
      if (event.pointerType !== "touch" && this.#down === 0) send({ t: "leave" });
    });
    on("wheel", (event) => this.#wheel(event), { passive: false });
    on("contextmenu", (event) => event.preventDefault());
    on("mousedown", (event) => event.preventDefault()); // no selection, no scrolling by the middle button
    on("auxclick", (event) => event.preventDefault());
    on("dragstart", (event) => event.preventDefault());
  }

  // Everything that is pressed is let go: the page lost the focus.
  release() {
    this.#gestures.cancel();
    for (const [bit, b] of BUTTONS) {
      if (this.#down & bit) this.#send({ t: "button", b, down: false, ...this.#last, mods: 0 });
    }
    this.#down = 0;
  }

  #mouse(event) {
    this.#last = this.#picture.at(event.clientX, event.clientY);
    const changed = this.#down ^ event.buttons;
    if ((changed & 7) === 0) {
      this.#send({ t: "move", ...this.#last });
      return;
    }
    for (const [bit, b] of BUTTONS) {
      if (!(changed & bit)) continue;
      const down = (event.buttons & bit) !== 0;
      this.#send({ t: "button", b, down, ...this.#last, mods: modifiers_of(event) });
    }
    this.#down = event.buttons & 7;
  }

  #capture(pointer) {
    try {
      this.#canvas.setPointerCapture(pointer);
    } catch {
      // the pointer is gone already
    }
  }

  #pressed(event) {
    this.before_press();
    this.#capture(event.pointerId);
    if (event.pointerType !== "touch") return this.#mouse(event);
    clearTimeout(this.#leave);
    this.#gestures.down(event.pointerId, event.clientX, event.clientY, performance.now());
    clearTimeout(this.#long_press);
    const due = this.#gestures.due - performance.now();
    if (Number.isFinite(due)) this.#long_press = setTimeout(() => this.#held_long(), due + 1);
  }

  #moved(event) {
    if (event.pointerType !== "touch") return this.#mouse(event);
    this.#gestures.move(event.pointerId, event.clientX, event.clientY);
    // A browser hands over all fingers' moves before a frame.
    this.#settles ||= requestAnimationFrame(() => {
      this.#settles = 0;
      this.#gestures.settle();
    });
  }

  #released(event) {
    if (event.pointerType !== "touch") return this.#mouse(event);
    this.#gestures.up(event.pointerId);
    if (this.#gestures.fingers > 0) return;
    clearTimeout(this.#leave);
    this.#leave = setTimeout(() => this.#send({ t: "leave" }), TOUCH_LEAVES_AFTER);
  }

  #cancelled(event) {
    if (event.pointerType === "touch") this.#gestures.cancel();
    else this.release();
  }

  #held_long() {
    if (this.#gestures.tick(performance.now())) navigator.vibrate?.(12);
  }

  #touch(message) {
    if (message.t === "wheel") {
      this.#send(message);
      return;
    }
    const { x, y, ...rest } = message;
    this.#send({ ...rest, ...this.#picture.at(x, y), ...(message.t === "button" ? { mods: 0 } : {}) });
  }

  #wheel(event) {
    event.preventDefault(); // no scrolling, no zoom of the page
    const { x, y } = notches(event);
    if (x !== 0 || y !== 0) this.#send({ t: "wheel", x, y });
  }
}
