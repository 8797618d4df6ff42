// SPDX-License-Identifier: MIT
// The picture: rectangles are decoded as they come and drawn together when their frame is complete, then the frame is
// reported as shown. Frames are shown in the order in which they came.

import { parse_frame } from "./protocol.js";

const same_shape = (w, h, W, H) => Math.abs(w * H - W * h) <= 2 * (W + H); // a reduced frame's sizes are rounded

export class Picture {
  #canvas;
  #context;
  #parts = []; // of the frame that is still coming
  #first_at = 0;
  #queue = Promise.resolve();
  #life = 0; // a new connection begins anew
  #asked = [0, 0]; // pixels of the window that the server was asked for

  on_shown = () => {}; // what was shown: numbers of the frame, `arrived` and `shown` in ms
  on_broken = () => {}; // a frame could not be decoded
  has_picture = false;

  constructor(canvas) {
    this.#canvas = canvas;
    this.#context = canvas.getContext("2d", { alpha: false });
  }

  // Pixels of the window on the server, to which the pointer's place belongs.
  get size() {
    const { width, height } = this.#canvas;
    return this.#asked[0] > 0 && same_shape(width, height, ...this.#asked) ? this.#asked : [width, height];
  }

  asked_for(width, height) {
    this.#asked = [width, height];
  }

  reset() {
    this.#life += 1;
    this.#parts = [];
    this.#queue = Promise.resolve();
  }

  add(buffer) {
    const now = performance.now();
    const part = parse_frame(buffer);
    if (part === null) {
      this.on_broken();
      return;
    }
    if (this.#parts.length > 0 && this.#parts[0].frame !== part.frame) this.#parts = [];
    if (this.#parts.length === 0) this.#first_at = now;
    part.image = this.#decode(part).catch(() => null);
    this.#parts.push(part);
    if (!part.last) return;
    const parts = this.#parts;
    const arrived = this.#first_at;
    const life = this.#life;
    this.#parts = [];
    this.#queue = this.#queue.then(() => this.#show(parts, arrived, life));
  }

  #decode(part) {
    const blob = new Blob([part.payload], { type: "image/" + part.codec });
    return createImageBitmap(blob, { colorSpaceConversion: "none", premultiplyAlpha: "none" });
  }

  async #show(parts, arrived, life) {
    const images = await Promise.all(parts.map((part) => part.image));
    const decoded = performance.now();
    await new Promise(requestAnimationFrame);
    if (life !== this.#life) {
      for (const image of images) image?.close();
      return;
    }
    const whole = parts[parts.length - 1];
    this.#fit(whole.W, whole.H, whole.lossless);
    const { width, height } = this.#canvas;
    const sx = width / whole.W;
    const sy = height / whole.H;
    let broken = false;
    parts.forEach((part, k) => {
      const image = images[k];
      if (!image) {
        broken = true;
        return;
      }
      this.#context.imageSmoothingEnabled = sx !== 1 || sy !== 1 || image.width !== part.w;
      this.#context.drawImage(image, part.x * sx, part.y * sy, part.w * sx, part.h * sy);
    });
    for (const image of images) image?.close();
    this.has_picture = true;
    this.on_shown({
      ...whole,
      payload: undefined,
      image: undefined,
      rectangles: parts.length,
      bytes: parts.reduce((sum, part) => sum + part.bytes, 0),
      arrived,
      decode_ms: decoded - arrived,
      shown: performance.now(),
    });
    if (broken) this.on_broken();
  }

  // The canvas has the pixels of the window; a reduced frame is drawn larger. What is there stays until it is drawn over.
  // Only moving pictures are reduced. Who watches does not know the window's size: it is the largest of that shape.
  #fit(W, H, lossless) {
    const canvas = this.#canvas;
    const [w, h] = this.#asked[0] > 0 ? this.#asked : [canvas.width, canvas.height];
    const reduced = !lossless && w > W && same_shape(W, H, w, h);
    const [width, height] = reduced ? [w, h] : [W, H];
    if (canvas.width === width && canvas.height === height) return;
    let old = null;
    if (this.has_picture) {
      old = new OffscreenCanvas(canvas.width, canvas.height);
      old.getContext("2d", { alpha: false }).drawImage(canvas, 0, 0);
    }
    canvas.width = width;
    canvas.height = height;
    if (old) this.#context.drawImage(old, 0, 0, width, height);
  }

  // Where the picture is on the page: the canvas keeps its shape inside its box. CSS pixels.
  get place() {
    const box = this.#canvas.getBoundingClientRect();
    const { width, height } = this.#canvas;
    const scale = Math.min(box.width / width, box.height / height);
    const w = width * scale;
    const h = height * scale;
    return { x: box.left + (box.width - w) / 2, y: box.top + (box.height - h) / 2, w, h };
  }

  // A point of the page in pixels of the window.
  at(client_x, client_y) {
    const { x, y, w, h } = this.place;
    const [W, H] = this.size;
    if (!(w > 0 && h > 0)) return { x: 0, y: 0 }; // the page has no room at all
    const round = (v) => Math.round(v * 4) / 4;
    return { x: round(((client_x - x) / w) * W), y: round(((client_y - y) / h) * H) };
  }
}
