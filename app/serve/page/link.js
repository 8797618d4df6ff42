// SPDX-License-Identifier: MIT
// The connection: hello, messages both ways, stamps of input, and coming back after it broke.
//
// Events: "state" (what the person should know), "message" (text messages, parsed), "frame" (binary ones).
// States: connecting · open · silent (open, but no answer for a while) · lost (tries again at `retry_at`) · ended
// (`reason`: refused, gone, left, version, malformed; only the person can go on).

import { CLOSE, SUBPROTOCOL } from "./protocol.js";

const FIRST_WAIT = 500; // ms; doubles up to the longest
const LONGEST_WAIT = 8000;
const SILENT_AFTER = 2500;
const BROKEN_AFTER = 15000;
const PING_EVERY = 1000;
const KEPT_STAMPS = 2048;
const MOVES_HELD_ABOVE = 64 * 1024; // bytes that wait to be sent

export class Link extends EventTarget {
  #socket = null;
  #hello;
  #wait = FIRST_WAIT;
  #retry = 0;
  #beat = 0;
  #heard = 0;
  #stamp = 0;
  #sent = new Map(); // stamp -> when, ms
  #held_move = null;
  #was_welcome = false;

  state = "connecting";
  reason = "";
  detail = "";
  retry_at = 0;
  rtt = 0; // ms, of the page's own pings
  tries = 0;

  // hello(): what to say first, asked anew at every try.
  constructor(hello) {
    super();
    this.#hello = hello;
  }

  start() {
    clearTimeout(this.#retry);
    this.#drop();
    this.#change(this.#was_welcome ? "lost" : "connecting");
    this.tries += 1;
    const url = new URL("socket", location.href);
    url.protocol = url.protocol === "https:" ? "wss:" : "ws:";
    url.search = url.hash = "";
    const socket = new WebSocket(url, SUBPROTOCOL);
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    socket.onopen = () => socket.send(JSON.stringify({ t: "hello", ...this.#hello() }));
    socket.onmessage = (event) => this.#receive(event.data);
    socket.onclose = (event) => {
      if (socket === this.#socket) this.#closed(event.code, event.reason);
    };
  }

  // For the button "now".
  retry_now() {
    this.#wait = FIRST_WAIT;
    this.start();
  }

  // A new key: nothing of the old session counts.
  restart() {
    this.#was_welcome = false;
    this.retry_now();
  }

  get ready() {
    return this.#socket?.readyState === WebSocket.OPEN && (this.state === "open" || this.state === "silent");
  }

  send(message) {
    if (this.ready) this.#socket.send(JSON.stringify(message));
  }

  // Input carries a stamp that comes back with the first frame that shows it. While the link is congested only the
  // newest place of the pointer is kept.
  input(message) {
    if (!this.ready) return;
    if (message.t === "move") {
      if (this.#socket.bufferedAmount > MOVES_HELD_ABOVE) {
        this.#held_move = message;
        return;
      }
    } else if (this.#held_move) {
      const held = this.#held_move;
      this.#held_move = null;
      this.#stamped(held);
    }
    this.#stamped(message);
  }

  #stamped(message) {
    this.#stamp = (this.#stamp + 1) >>> 0 || 1;
    this.#sent.set(this.#stamp, performance.now());
    if (this.#sent.size > KEPT_STAMPS) this.#sent.delete(this.#sent.keys().next().value);
    this.#socket.send(JSON.stringify({ ...message, s: this.#stamp }));
  }

  // When the input of that stamp was sent, ms; undefined if it was asked for before. Forgets it and all before.
  take_stamp(stamp) {
    const when = this.#sent.get(stamp);
    if (when === undefined) return undefined;
    for (const older of this.#sent.keys()) {
      this.#sent.delete(older);
      if (older === stamp) break;
    }
    return when;
  }

  #receive(data) {
    this.#heard = performance.now();
    if (this.state === "silent") this.#change("open");
    if (typeof data !== "string") {
      this.dispatchEvent(new CustomEvent("frame", { detail: data }));
      return;
    }
    let message;
    try {
      message = JSON.parse(data);
    } catch {
      return;
    }
    if (message.t === "pong") {
      if (Number.isFinite(message.at)) this.rtt = performance.now() - message.at;
      return;
    }
    if (message.t === "welcome") {
      this.#was_welcome = true;
      this.#wait = FIRST_WAIT;
      this.#change("open");
      this.#beat = setInterval(() => this.#check(), PING_EVERY);
    }
    this.dispatchEvent(new CustomEvent("message", { detail: message }));
  }

  #check() {
    // A hidden tab's clock is slowed down: silence proves nothing there.
    const quiet = document.hidden ? 0 : performance.now() - this.#heard;
    if (quiet > BROKEN_AFTER) {
      this.#drop();
      this.#later("no answer from the server");
    } else {
      if (quiet > SILENT_AFTER && this.state === "open") this.#change("silent");
      if (this.#socket.bufferedAmount < MOVES_HELD_ABOVE) this.send({ t: "ping", at: performance.now() });
    }
  }

  #drop() {
    clearInterval(this.#beat);
    const old = this.#socket;
    this.#socket = null;
    if (old) {
      old.onopen = old.onmessage = old.onclose = null;
      old.close();
    }
    this.#sent.clear();
    this.#held_move = null;
  }

  #closed(code, why) {
    this.#drop();
    if (code === CLOSE.refused) return this.#end(this.#was_welcome ? "gone" : "refused", why);
    if (code === CLOSE.gone) return this.#end("left", why);
    if (code === CLOSE.version) return this.#end("version", why);
    if (code === CLOSE.malformed) return this.#end("malformed", why);
    if (code === CLOSE.too_many) {
      this.#wait = LONGEST_WAIT;
      return this.#later(why || "too many visitors at the moment");
    }
    this.#later(code === CLOSE.going_away ? "the server was stopped" : why);
  }

  #end(reason, detail) {
    this.reason = reason;
    this.detail = detail;
    this.#change("ended");
  }

  #later(detail) {
    this.detail = detail;
    const wait = this.#wait;
    this.#wait = Math.min(2 * wait, LONGEST_WAIT);
    this.retry_at = performance.now() + wait;
    this.#retry = setTimeout(() => this.start(), wait);
    this.#change("lost");
  }

  #change(state) {
    this.state = state;
    this.dispatchEvent(new Event("state"));
  }
}
