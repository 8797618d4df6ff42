// SPDX-License-Identifier: MIT
// Modules of the page that need no browser.
import assert from "node:assert/strict";
import test from "node:test";

import { frame_message } from "./mock_server.mjs";
import { page_module } from "./support.mjs";

const { key_name, left_to_browser, typed_text } = await page_module("keys.js");
const { Gestures } = await page_module("gestures.js");
const { parse_frame, window_for } = await page_module("protocol.js");
const { quantile } = await page_module("statistics.js");
const { notches } = await page_module("pointer.js");
const { key_in } = await page_module("token.js");

const pressed = (key, code, more = {}) => ({ key, code, getModifierState: () => false, ...more });

test("keys have the names of scripts", () => {
  const cases = [
    ["a", "KeyA", "a"],
    ["A", "KeyA", "a"],
    ["q", "KeyA", "q"], // a French keyboard: what is printed
    ["ф", "KeyA", "a"], // another alphabet: the place
    ["&", "Digit1", "1"],
    ["7", "Numpad7", "7"],
    ["Home", "Numpad7", "home"],
    [" ", "Space", "space"],
    ["Enter", "NumpadEnter", "enter"],
    ["+", "NumpadAdd", "="],
    ["?", "Slash", "/"],
    ["ö", "Semicolon", ";"],
    ["'", "Quote", "'"],
    ["PageUp", "PageUp", "page_up"],
    ["Delete", "Delete", "delete"],
    ["ArrowLeft", "ArrowLeft", "left"],
    ["F12", "F12", "f12"],
    ["F13", "F13", ""],
    ["Control", "ControlLeft", "ctrl"],
    ["Meta", "MetaLeft", "super"],
    ["Dead", "Backquote", "`"],
    ["AltGraph", "AltRight", ""],
    ["Unidentified", "", ""],
  ];
  for (const [key, code, name] of cases) assert.equal(key_name(pressed(key, code)), name, `${key} at ${code}`);
  assert.equal(key_name(pressed("Meta", "MetaLeft"), true), "ctrl");
});

test("the browser keeps its own shortcuts, the window gets the others", () => {
  const kept = (name, more = {}, mac = false) => left_to_browser(pressed("", "", more), name, mac);
  const ctrl = { ctrlKey: true };
  for (const name of ["r", "w", "t", "tab", "=", "-", "0"]) assert.ok(kept(name, ctrl), name);
  for (const name of ["f5", "f11", "f12"]) assert.ok(kept(name), name);
  for (const name of ["s", "o", "z", "y", "e", "l", "c", "v"]) assert.ok(!kept(name, ctrl), name);
  for (const name of ["r", "w", "tab", "space", "f1", "escape", "-"]) assert.ok(!kept(name), name);
  assert.ok(!kept("p", { ctrlKey: true, shiftKey: true }));
  assert.ok(!kept("c", { ctrlKey: true, shiftKey: true }));
  assert.ok(kept("left", { altKey: true }));
  assert.ok(kept("r", { metaKey: true }, true));
  assert.ok(!kept("r", { metaKey: true }, false));
});

test("only keys without a chord type text", () => {
  assert.equal(typed_text(pressed("é", "Digit2")), "é");
  assert.equal(typed_text(pressed("Enter", "Enter")), "");
  assert.equal(typed_text(pressed("s", "KeyS", { ctrlKey: true })), "");
  const alt_graph = { ctrlKey: true, altKey: true, getModifierState: (what) => what === "AltGraph" };
  assert.equal(typed_text({ key: "@", code: "KeyQ", ...alt_graph }), "@");
});

function gestures() {
  const sent = [];
  const g = new Gestures((message) => sent.push(message));
  const words = () => sent.map((m) => m.t + (m.b ? ` ${m.b} ${m.down ? "down" : "up"}` : "")).filter((w) => w !== "move");
  return { g, sent, words };
}

test("a tap is a click where the finger was put", () => {
  const { g, sent, words } = gestures();
  g.down(1, 100, 50, 0);
  g.move(1, 103, 52);
  g.up(1);
  assert.deepEqual(words(), ["button left down", "button left up"]);
  assert.deepEqual([sent.at(-1).x, sent.at(-1).y], [100, 50]);
});

test("a drag presses where it began and lets go where it ends", () => {
  const { g, sent, words } = gestures();
  g.down(1, 100, 50, 0);
  for (let k = 1; k <= 40; ++k) g.move(1, 100 + k, 50);
  g.up(1);
  const buttons = sent.filter((m) => m.t === "button");
  assert.deepEqual(words(), ["button left down", "button left up"]);
  assert.deepEqual([buttons[0].x, buttons[1].x], [100, 140]);
  assert.equal(g.tick(10000), false);
});

test("a long press is a right click, and nothing after it", () => {
  const { g, words } = gestures();
  g.down(1, 10, 10, 0);
  assert.equal(g.tick(300), false);
  assert.equal(g.tick(g.due), true);
  g.move(1, 90, 90);
  g.up(1);
  assert.deepEqual(words(), ["button right down", "button right up"]);
});

test("a pinch to twice the distance turns the wheel by ln 2 / ln 1.15, and drags nothing", () => {
  const { g, sent, words } = gestures();
  g.down(1, 100, 100, 0);
  g.down(2, 200, 100, 5);
  // From 116 px on, after the slack, to 232 px, the middle in its place.
  g.move(1, 91, 100);
  g.move(2, 209, 100);
  g.settle();
  const begun = 209 - 91;
  for (let k = 0; k <= begun / 2; ++k) {
    g.move(1, 91 - k, 100);
    g.move(2, 209 + k, 100);
    g.settle();
  }
  g.up(1);
  g.up(2);
  const sum = sent.filter((m) => m.t === "wheel").reduce((s, m) => s + m.y, 0);
  assert.ok(Math.abs(sum - Math.log(2) / Math.log(1.15)) < 0.05, `${sum} notches`);
  assert.ok(words().every((w) => w === "wheel"), words().join());
});

test("two fingers side by side move the view with the middle button, and end the first one's drag", () => {
  const { g, sent, words } = gestures();
  g.down(1, 100, 100, 0);
  g.move(1, 130, 100);
  g.down(2, 230, 100, 50);
  for (let k = 1; k <= 60; ++k) {
    g.move(1, 130, 100 + k);
    g.move(2, 230, 100 + k);
    g.settle();
  }
  g.up(2);
  g.move(1, 300, 300);
  g.up(1);
  const order = ["button left down", "button left up", "button middle down", "button middle up"];
  assert.deepEqual(words(), order);
  assert.ok(Math.abs(sent.at(-1).y - 160) <= 1, `ends at ${sent.at(-1).y}`);
});

test("two fingers side by side pinch nothing, however far they went between two frames", () => {
  const { g, words } = gestures();
  g.down(1, 150, 300, 0);
  g.down(2, 250, 300, 5);
  for (const y of [396, 300]) {
    g.move(1, 150, y); // alone it would be a pinch
    g.move(2, 250, y);
    g.settle();
  }
  g.up(1);
  g.up(2);
  assert.deepEqual(words(), ["button middle down", "button middle up"]);
});

test("what is held is let go when a gesture is cancelled", () => {
  const { g, words } = gestures();
  g.down(1, 0, 0, 0);
  g.move(1, 50, 0);
  g.cancel();
  assert.deepEqual(words(), ["button left down", "button left up"]);
  assert.equal(g.fingers, 0);
});

test("the wheel counts in notches, away from the person is positive", () => {
  const wheel = (more) => notches({ deltaX: 0, deltaY: 0, deltaMode: 0, ctrlKey: false, ...more });
  assert.deepEqual(wheel({ deltaY: 100 }), { x: 0, y: -1 });
  assert.deepEqual(wheel({ deltaY: -53, wheelDeltaY: 120 }), { x: 0, y: 1 });
  assert.deepEqual(wheel({ deltaY: 3, deltaMode: 1 }), { x: 0, y: -1 });
  assert.deepEqual(wheel({ deltaY: -1, deltaMode: 2 }), { x: 0, y: 3 });
  assert.deepEqual(wheel({ deltaX: 50 }), { x: -0.5, y: 0 });
  // A trackpad's pinch by exp(0.14) is one notch of 15 %.
  assert.ok(Math.abs(wheel({ deltaY: -14, ctrlKey: true }).y - 1) < 1e-9);
  assert.equal(wheel({ deltaY: -1e6 }).y, 10);
});

test("the head of a frame is read as it is written", () => {
  const message = frame_message({
    kind: 1,
    flags: 5,
    left: 2,
    frame: 4000000000,
    at: [64, 128],
    size: [320, 200],
    whole: [1280, 720],
    stamp: 77,
    payload: Buffer.from([1, 2, 3]),
  });
  const buffer = message.buffer.slice(message.byteOffset, message.byteOffset + message.length);
  const part = parse_frame(buffer);
  const { codec, last, lossless, left, frame, x, y, w, h, W, H, stamp, draw_ms, encode_ms, bytes } = part;
  assert.deepEqual([codec, last, lossless, left, frame], ["jpeg", true, false, 2, 4000000000]);
  assert.deepEqual([x, y, w, h, W, H, stamp, draw_ms, encode_ms, bytes], [64, 128, 320, 200, 1280, 720, 77, 7.1, 4.2, 35]);
  assert.deepEqual([...part.payload], [1, 2, 3]);
  assert.equal(parse_frame(buffer.slice(0, 32)), null, "no payload");
  const outside = buffer.slice(0);
  new DataView(outside).setUint16(8, 1000, true);
  assert.equal(parse_frame(outside), null, "a rectangle beyond the frame");
  new DataView(buffer).setUint8(0, 9);
  assert.equal(parse_frame(buffer), null, "an unknown codec");
});

test("the window has the page's pixels as far as the server draws them", () => {
  assert.deepEqual(window_for(1280, 686), { size: [1280, 686], share: 1 });
  assert.deepEqual(window_for(3840, 2400), { size: [3840, 2400], share: 1 });
  const { size, share } = window_for(5120, 2880);
  assert.ok(size[0] * size[1] <= 3840 * 2400 && size[0] <= 4096, size.join());
  assert.ok(Math.abs(size[0] / size[1] - 16 / 9) < 2e-3 && Math.abs(share - size[0] / 5120) < 1e-3);
  assert.deepEqual(window_for(0, 0).size, [320, 240]);
});

test("quantiles are values that were measured", () => {
  const values = Array.from({ length: 100 }, (_, k) => 100 - k);
  assert.equal(quantile(values, 0.5), 51);
  assert.equal(quantile(values, 0.99), 100);
  assert.ok(Number.isNaN(quantile([], 0.5)));
});

test("a key is found in what people paste", () => {
  const key = "0123456789abcdef0123456789abcdef";
  for (const text of [key, ` ${key}\n`, "#k=" + key, "http://127.0.0.1:8472/#k=" + key, "k=" + key.toUpperCase()]) {
    assert.equal(key_in(text), key, text);
  }
  for (const text of ["", "#k=", key.slice(1), key + "0", "x" + key.slice(1)]) assert.equal(key_in(text), "", text);
});
