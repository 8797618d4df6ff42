// SPDX-License-Identifier: MIT
// Names and numbers of the subprotocol pabd.1 (app/serve/README.md).

export const SUBPROTOCOL = "pabd.1";
export const HEADER_BYTES = 32;
export const CODECS = { 1: "jpeg", 2: "png" };
export const MODIFIER = { ctrl: 1, shift: 2, alt: 4, meta: 8 };
const LEAST = [320, 240]; // pixels of a window
const MOST_SIDE = 4096;
const MOST_PIXELS = 3840 * 2400;
export const LEAST_SCALE = 0.5;
export const LARGEST_SCALE = 4;
export const TYPED_AT_ONCE = 200; // characters in a message "text", which may have 1 KiB
const MESSAGE_BYTES = 64 * 1024;

// Whether the server takes a message of that size.
export function fits(message) {
  return new TextEncoder().encode(JSON.stringify(message)).length < MESSAGE_BYTES - 64;
}

// What the server can draw for a page of so many pixels: {size, share}, `share` of them in each direction.
export function window_for(width, height) {
  const w = Math.max(1, width);
  const h = Math.max(1, height);
  const share = Math.min(1, MOST_SIDE / w, MOST_SIDE / h, Math.sqrt(MOST_PIXELS / (w * h)));
  return { size: [w, h].map((length, k) => Math.max(LEAST[k], Math.floor(share * length))), share };
}

export const clamp = (value, least, most) => Math.min(most, Math.max(least, value));

export const CLOSE = {
  going_away: 1001,
  malformed: 4400,
  refused: 4401,
  version: 4406,
  gone: 4410,
  too_many: 4429,
};

// One rectangle of a frame out of a binary message; null when it cannot be one. Times in ms.
export function parse_frame(buffer) {
  if (buffer.byteLength < HEADER_BYTES) return null;
  const view = new DataView(buffer, 0, HEADER_BYTES);
  const codec = CODECS[view.getUint8(0)];
  if (codec === undefined) return null;
  const flags = view.getUint8(1);
  const part = {
    codec,
    last: (flags & 1) !== 0,
    lossless: (flags & 2) !== 0,
    left: view.getUint16(2, true),
    frame: view.getUint32(4, true),
    x: view.getUint16(8, true),
    y: view.getUint16(10, true),
    w: view.getUint16(12, true),
    h: view.getUint16(14, true),
    W: view.getUint16(16, true),
    H: view.getUint16(18, true),
    stamp: view.getUint32(20, true),
    draw_ms: view.getUint32(24, true) / 1000,
    encode_ms: view.getUint32(28, true) / 1000,
    bytes: buffer.byteLength,
    payload: new Uint8Array(buffer, HEADER_BYTES),
  };
  if (part.payload.length === 0) return null;
  const inside = part.w > 0 && part.h > 0 && part.x + part.w <= part.W && part.y + part.h <= part.H;
  return inside ? part : null;
}

export function modifiers_of(event) {
  return (
    (event.ctrlKey ? MODIFIER.ctrl : 0) |
    (event.shiftKey ? MODIFIER.shift : 0) |
    (event.altKey ? MODIFIER.alt : 0) |
    (event.metaKey ? MODIFIER.meta : 0)
  );
}
