// SPDX-License-Identifier: MIT
// Fingers made into a mouse. No browser in here: times in ms and places in CSS pixels go in, moves, buttons and wheel
// come out through `send`.
//
//   one finger    drag = left drag · tap = click · long press = right click
//   two fingers   pinch = wheel (in notches) · drag = middle drag, which moves the view

const SLACK = 8; // px that a tap may wander
const LONG_PRESS = 550; // ms
const NOTCH = Math.log(1.15); // a notch of the wheel brings the picture nearer by 15 %

export class Gestures {
  #send;
  #fingers = new Map(); // id -> {x, y}
  #mode = "none"; // none, wait, drag, two, done
  #start = null; // of the first finger: {x, y, t}
  #held = ""; // the button that is down
  #two = null; // {x, y, distance, pans, pinches} at the start or last
  #moved = false; // one of two fingers, since settle()

  // send(message): {t: "move", x, y}, {t: "button", b, down, x, y}, {t: "wheel", y}
  constructor(send) {
    this.#send = send;
  }

  get fingers() {
    return this.#fingers.size;
  }

  // When tick() is due, ms; Infinity when nothing waits.
  get due() {
    return this.#mode === "wait" ? this.#start.t + LONG_PRESS : Infinity;
  }

  down(id, x, y, t) {
    this.#fingers.set(id, { x, y });
    if (this.#fingers.size === 1) {
      this.#mode = "wait";
      this.#start = { x, y, t };
      this.#send({ t: "move", x, y });
    } else if (this.#fingers.size === 2 && this.#mode !== "done") {
      this.#release(this.#fingers.values().next().value);
      this.#mode = "two";
      this.#two = { ...this.#middle(), pans: false, pinches: false, rest: 0 };
    } else {
      this.#finish();
    }
  }

  move(id, x, y) {
    const finger = this.#fingers.get(id);
    if (!finger) return;
    finger.x = x;
    finger.y = y;
    if (this.#mode === "wait" && Math.hypot(x - this.#start.x, y - this.#start.y) > SLACK) {
      this.#mode = "drag";
      this.#press("left", this.#start);
    }
    if (this.#mode === "drag") this.#send({ t: "move", x, y });
    if (this.#mode === "two") this.#moved = true;
  }

  // Two fingers that move side by side come one after the other: what they mean is asked when both have come.
  settle() {
    if (this.#mode === "two" && this.#moved) this.#move_two();
    this.#moved = false;
  }

  up(id) {
    this.settle();
    const finger = this.#fingers.get(id);
    if (!finger) return;
    if (this.#mode === "wait") {
      this.#press("left", this.#start);
      this.#release(this.#start);
    } else {
      this.#release(this.#mode === "two" ? this.#two : finger);
    }
    this.#fingers.delete(id);
    this.#mode = this.#fingers.size > 0 ? "done" : "none";
  }

  cancel() {
    this.#finish();
    this.#fingers.clear();
    this.#mode = "none";
  }

  // True when a long press became a right click.
  tick(t) {
    if (t < this.due) return false;
    this.#mode = "done";
    this.#press("right", this.#start);
    this.#release(this.#start);
    return true;
  }

  #finish() {
    const any = this.#fingers.values().next().value;
    if (any) this.#release(any);
    this.#mode = "done";
  }

  #press(button, { x, y }) {
    this.#held = button;
    this.#send({ t: "move", x, y });
    this.#send({ t: "button", b: button, down: true, x, y });
  }

  #release({ x, y }) {
    if (this.#held === "") return;
    this.#send({ t: "button", b: this.#held, down: false, x, y });
    this.#held = "";
  }

  #middle() {
    const [a, b] = [...this.#fingers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, distance: Math.max(1, Math.hypot(a.x - b.x, a.y - b.y)) };
  }

  #move_two() {
    const now = this.#middle();
    const two = this.#two;
    if (!two.pinches && Math.abs(now.distance - two.distance) > 2 * SLACK) {
      two.pinches = true;
      two.distance = now.distance;
      if (!two.pans) this.#send({ t: "move", x: now.x, y: now.y });
    }
    if (!two.pans && Math.hypot(now.x - two.x, now.y - two.y) > 2 * SLACK) {
      two.pans = true;
      this.#press("middle", now);
    }
    if (two.pinches) {
      const notches = Math.log(now.distance / two.distance) / NOTCH;
      if (Math.abs(notches) > 0.02) {
        this.#send({ t: "wheel", x: 0, y: notches });
        two.distance = now.distance;
      }
    }
    if (two.pans) {
      this.#send({ t: "move", x: now.x, y: now.y });
      two.x = now.x;
      two.y = now.y;
    }
  }
}
