// SPDX-License-Identifier: MIT
// What the link bears: measured here from the frames and stamps, and told by the server once a second.

import { by_id } from "./dom.js";

const LATENCIES = 240; // kept
const HISTORY = 60; // s in a sparkline
const SILENT = "–";

export function quantile(values, q) {
  if (values.length === 0) return NaN;
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))];
}

const number = (value, digits = 0) => (Number.isFinite(value) ? value.toFixed(digits) : SILENT);
const short = (value) => number(value, value < 9.95 ? 1 : 0);

export class Statistics {
  #frames = []; // of the last second
  #latencies = []; // ms, newest last
  #second_latencies = [];
  #history = { fps: [], latency: [] };
  #server = {};
  #last = null;
  #moving = null; // the codec of the last frame that was not lossless
  #readout;

  constructor(readout) {
    this.#readout = readout;
  }

  // latency: ms from the input to this frame; undefined when it shows none for the first time.
  shown(frame, latency) {
    this.#last = frame;
    if (!frame.lossless) this.#moving = frame.codec;
    this.#frames.push(frame);
    if (latency === undefined) return;
    this.#latencies.push(latency);
    this.#second_latencies.push(latency);
    if (this.#latencies.length > LATENCIES) this.#latencies.shift();
  }

  told(stats) {
    this.#server = stats;
  }

  get numbers() {
    const frames = this.#frames;
    const mean = (what) => (frames.length > 0 ? frames.reduce((sum, f) => sum + f[what], 0) / frames.length : NaN);
    return {
      fps: frames.length,
      p50: quantile(this.#latencies, 0.5),
      p99: quantile(this.#latencies, 0.99),
      samples: this.#latencies.length,
      kilobytes: mean("bytes") / 1000,
      kilobytes_a_second: frames.reduce((sum, f) => sum + f.bytes, 0) / 1000,
      draw: mean("draw_ms"),
      encode: mean("encode_ms"),
      decode: mean("decode_ms"),
    };
  }

  // Once a second. `rtt`: ms of the page's own pings; `open`: whether the panel is seen.
  tick(rtt, open) {
    const now = performance.now();
    this.#frames = this.#frames.filter((frame) => now - frame.shown < 1000);
    const n = this.numbers;
    const push = (list, value) => {
      list.push(value);
      if (list.length > HISTORY) list.shift();
    };
    push(this.#history.fps, n.fps);
    push(this.#history.latency, quantile(this.#second_latencies, 0.5));
    this.#second_latencies = [];
    const still = n.fps === 0 || this.#frames.every((frame) => frame.lossless);
    this.#readout.textContent = still
      ? this.#last
        ? "still"
        : ""
      : `${n.fps} fps` + (Number.isFinite(n.p50) ? ` · ${number(n.p50)} ms` : "");
    if (open) this.#draw(n, rtt);
  }

  #draw(n, rtt) {
    const set = (id, text) => {
      const place = by_id("stat-" + id);
      if (place.textContent !== text) place.textContent = text;
    };
    const { quality, scale } = this.#server;
    const last = this.#last;
    set("fps", `${n.fps}`);
    set("p50", number(n.p50));
    set("p99", number(n.p99));
    set("frame", Number.isFinite(n.kilobytes) ? short(n.kilobytes) + " kB" : SILENT);
    set("rate", short(n.kilobytes_a_second) + " kB/s");
    set("draw", Number.isFinite(n.draw) ? short(n.draw) + " ms" : SILENT);
    set("encode", Number.isFinite(n.encode) ? short(n.encode) + " ms" : SILENT);
    set("decode", Number.isFinite(n.decode) ? short(n.decode) + " ms" : SILENT);
    set("rtt", short(rtt) + " ms");
    const name = (this.#moving ?? "").toUpperCase();
    set("codec", last?.lossless ? "PNG, lossless" : name + (quality ? `, quality ${Math.round(quality)}` : ""));
    set("size", last ? `${last.W} × ${last.H}` + (scale < 1 && !last.lossless ? `, ${Math.round(100 * scale)} %` : "") : SILENT);
    sparkline(by_id("spark-fps"), this.#history.fps, 30);
    sparkline(by_id("spark-latency"), this.#history.latency, 50);
  }
}

// A curve of the last minute, from 0 to the largest value, at least to `least`.
function sparkline(canvas, values, least) {
  const scale = devicePixelRatio;
  const width = Math.round(canvas.clientWidth * scale);
  const height = Math.round(canvas.clientHeight * scale);
  if (width === 0 || height === 0) return;
  canvas.width = width;
  canvas.height = height;
  const context = canvas.getContext("2d");
  const style = getComputedStyle(canvas);
  const known = values.filter(Number.isFinite);
  const top = Math.max(least, ...known);
  const x = (k) => ((HISTORY - values.length + k) / (HISTORY - 1)) * (width - 2 * scale) + scale;
  const y = (value) => height - scale - (value / top) * (height - 3 * scale);
  context.strokeStyle = style.borderTopColor;
  context.lineWidth = scale;
  context.beginPath();
  context.moveTo(0, y(0));
  context.lineTo(width, y(0));
  context.stroke();
  context.strokeStyle = style.color;
  context.lineWidth = 1.5 * scale;
  context.lineJoin = "round";
  context.beginPath();
  let pen = false;
  values.forEach((value, k) => {
    if (!Number.isFinite(value)) {
      pen = false;
      return;
    }
    if (pen) context.lineTo(x(k), y(value));
    else context.moveTo(x(k) - (values.length === 1 ? scale : 0.01), y(value));
    pen = true;
  });
  context.stroke();
}
