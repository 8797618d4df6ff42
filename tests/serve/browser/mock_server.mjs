// SPDX-License-Identifier: MIT
// Speaks pabd.1 (app/serve/README.md) without a simulation behind it: what the page sends is kept, and a test says
// what it gets. Pictures are plain colours, so that a pixel says which rectangle it came from.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join } from "node:path";
import { deflateSync, crc32 } from "node:zlib";

import { page_folder, require_module } from "./support.mjs";

const TYPES = { ".html": "text/html; charset=utf-8", ".css": "text/css; charset=utf-8", ".js": "text/javascript; charset=utf-8", ".svg": "image/svg+xml" };
const SAFE = {
  "Content-Security-Policy":
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; " +
    "frame-ancestors 'none'; base-uri 'none'; form-action 'none'",
  "X-Content-Type-Options": "nosniff",
  "Referrer-Policy": "no-referrer",
  "Cache-Control": "no-store",
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Resource-Policy": "same-origin",
};
export const KEY = "0123456789abcdef0123456789abcdef";
export const WATCH_KEY = "fedcba9876543210fedcba9876543210";

const crc_table = Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n >>> 0;
});
function crc(bytes) {
  if (crc32) return crc32(bytes); // newer versions of node have it
  let c = 0xffffffff;
  for (const byte of bytes) c = crc_table[(c ^ byte) & 255] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

// A PNG of one colour, [r, g, b] of 0 … 255.
export function plain_png(width, height, color) {
  const chunk = (type, data) => {
    const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
    const out = Buffer.alloc(body.length + 8);
    out.writeUInt32BE(data.length, 0);
    body.copy(out, 4);
    out.writeUInt32BE(crc(body), body.length + 4);
    return out;
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 2, 0, 0, 0], 8);
  const row = Buffer.concat([Buffer.from([0]), Buffer.alloc(3 * width, Buffer.from(color))]);
  const rows = Buffer.concat(Array.from({ length: height }, () => row));
  return Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]),
    chunk("IHDR", head),
    chunk("IDAT", deflateSync(rows, { level: 1 })),
    chunk("IEND", Buffer.alloc(0)),
  ]);
}

// A binary message: kind 1 JPEG, 2 PNG, 3 H.264; flags 1 last, 2 lossless, 4 key frame.
export function frame_message({ kind = 2, flags = 1, left = 0, frame, at = [0, 0], size, whole, stamp = 0, payload }) {
  const head = Buffer.alloc(32);
  head.writeUInt8(kind, 0);
  head.writeUInt8(flags, 1);
  head.writeUInt16LE(left, 2);
  head.writeUInt32LE(frame, 4);
  [...at, ...size, ...whole].forEach((v, k) => head.writeUInt16LE(v, 8 + 2 * k));
  head.writeUInt32LE(stamp, 20);
  head.writeUInt32LE(7100, 24); // µs of drawing
  head.writeUInt32LE(4200, 28); // µs of encoding
  return Buffer.concat([head, payload]);
}

export class MockServer {
  received = []; // all text messages of the page, parsed, in their order
  hellos = [];
  uploads = new Map();
  requests = [];
  socket = null; // the latest visitor
  size = [0, 0];
  frames = 0;
  welcome = { role: "control", visitors: 1, scene: "mock", version: "0", id: 1 };
  refuse = null; // [code, reason] instead of a welcome
  color = [40, 60, 80];
  mute = false; // answers no pings
  paints = true; // a whole frame for every hello and size

  async start(port = 0) {
    const { WebSocketServer } = require_module("ws");
    this.http = createServer((request, answer) => this.#answer(request, answer));
    this.sockets = new WebSocketServer({ server: this.http, path: "/socket", handleProtocols: () => "pabd.1" });
    this.sockets.on("connection", (socket) => this.#visit(socket));
    await new Promise((resolve) => this.http.listen(port, "127.0.0.1", resolve));
    this.port = this.http.address().port;
    this.url = `http://127.0.0.1:${this.port}/`;
    this.link = this.url + "#k=" + KEY;
    return this;
  }

  async stop(code = 1001) {
    for (const socket of this.sockets.clients) socket.close(code);
    this.http.closeAllConnections();
    await new Promise((resolve) => this.http.close(resolve));
  }

  send(message) {
    this.socket.send(JSON.stringify(message));
  }

  // A whole frame of one colour, or rectangles: [{at, size, color}]. Its number.
  frame({ color = this.color, rectangles = null, whole = this.size, stamp = 0, lossless = false } = {}) {
    this.frames += 1;
    const list = rectangles ?? [{ at: [0, 0], size: whole, color }];
    list.forEach((r, k) => {
      const last = k === list.length - 1;
      const flags = (last ? 1 : 0) | (lossless ? 2 : 0);
      const payload = r.payload ?? plain_png(...r.size, r.color);
      const part = { kind: r.kind ?? 2, flags: flags | (r.flags ?? 0), left: list.length - 1 - k, frame: this.frames };
      this.socket.send(frame_message({ ...part, at: r.at, size: r.size, whole, stamp, payload }));
    });
    return this.frames;
  }

  of(type) {
    return this.received.filter((message) => message.t === type);
  }

  // The first message that fits, from now on or before; fails after a while.
  async wait(what, fits, limit = 5000) {
    const until = Date.now() + limit;
    for (;;) {
      const found = this.received.find(fits);
      if (found) return found;
      if (Date.now() > until) throw new Error(`${what} did not come; last: ${JSON.stringify(this.received.slice(-6))}`);
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
  }

  #visit(socket) {
    socket.on("message", (data, binary) => {
      if (binary) return;
      const message = JSON.parse(data.toString());
      if (message.t === "ping" && this.mute) return;
      if (message.t === "ping") return socket.send(JSON.stringify({ t: "pong", at: message.at }));
      this.received.push(message);
      if (message.t === "hello") {
        this.hellos.push(message);
        if (this.refuse) return socket.close(...this.refuse);
        if (message.token !== KEY && message.token !== WATCH_KEY) return socket.close(4401, "wrong token");
        this.socket = socket;
        this.size = message.size;
        const role = message.token === KEY ? this.welcome.role : "watch";
        socket.send(JSON.stringify({ t: "welcome", ...this.welcome, role }));
        if (this.paints) this.frame();
      }
      if (message.t === "size") {
        const changed = String(this.size) !== String(message.size);
        this.size = message.size;
        if (changed && this.paints) this.frame();
      }
    });
  }

  async #answer(request, answer) {
    const { pathname } = new URL(request.url, this.url);
    const bearer = request.headers.authorization;
    this.requests.push({ method: request.method, url: request.url, bearer });
    const end = (status, type, body) => {
      answer.writeHead(status, { ...SAFE, "Content-Type": type });
      answer.end(body);
    };
    const json = (status, value) => end(status, "application/json", JSON.stringify(value));
    if (pathname === "/files" || pathname.startsWith("/files/") || pathname === "/frame.png") {
      if (bearer !== "Bearer " + KEY && bearer !== "Bearer " + WATCH_KEY) return json(401, { error: "no token" });
      if (pathname === "/frame.png") return end(200, "image/png", plain_png(4, 4, this.color));
      const name = decodeURIComponent(pathname.slice("/files/".length));
      if (request.method === "PUT") {
        const parts = [];
        for await (const part of request) parts.push(part);
        if (name.includes("bad")) return json(422, { error: "the scene has no bodies" });
        this.uploads.set(name, Buffer.concat(parts));
        return json(201, { name });
      }
      if (name === "") {
        return json(200, { files: [...this.uploads].map(([n, data]) => ({ name: n, bytes: data.length })) });
      }
      const data = this.uploads.get(name);
      return data ? end(200, "application/octet-stream", data) : json(404, { error: "no such file" });
    }
    const file = pathname === "/" ? "index.html" : pathname.slice(1);
    if (!/^[a-z_]+\.[a-z]+$/.test(file) || !TYPES[extname(file)]) return json(404, { error: "no such page" });
    try {
      end(200, TYPES[extname(file)], await readFile(join(page_folder, file)));
    } catch {
      json(404, { error: "no such page" });
    }
  }
}
