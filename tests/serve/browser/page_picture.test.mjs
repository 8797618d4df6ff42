// SPDX-License-Identifier: MIT
// The page against a server that only speaks the protocol: the picture: frames, sizes, H.264, full screen.
import assert from "node:assert/strict";

import { BLUE, GREEN, RED, page_test, settled } from "./page_support.mjs";
import { canvas_size, pixel, shown_frame, stage, until, wait_frame } from "./support.mjs";

page_test("draws rectangles when their frame is complete, and acknowledges frames in order", {}, async (page, mock) => {
  const [w, h] = mock.size;
  await wait_frame(page, mock.frame({ color: RED }));
  assert.deepEqual(await pixel(page, 5, 5), RED);
  assert.deepEqual(await pixel(page, w - 1, h - 1), RED);
  const two = [
    { at: [64, 64], size: [128, 64], color: BLUE },
    { at: [w - 100, h - 50], size: [100, 50], color: GREEN },
  ];
  const n = mock.frame({ rectangles: two });
  await wait_frame(page, n);
  assert.deepEqual(await pixel(page, 64, 64), BLUE);
  assert.deepEqual(await pixel(page, 191, 127), BLUE);
  assert.deepEqual(await pixel(page, 63, 64), RED);
  assert.deepEqual(await pixel(page, 192, 127), RED);
  assert.deepEqual(await pixel(page, w - 1, h - 1), GREEN);
  await mock.wait("the ack", (m) => m.t === "ack" && m.frame === n);
  assert.deepEqual(mock.of("ack").map((m) => m.frame), [1, 2, 3]);
  assert.ok(mock.of("ack").every((m) => m.shown_ms >= 0 && m.shown_ms < 5000));
  // The first half of a frame shows nothing, and what cannot be one harms nothing.
  const part = { at: [0, 0], size: [64, 64], color: GREEN };
  mock.socket.send(Buffer.from([1, 2, 3]));
  mock.frame({ rectangles: [{ ...part, flags: 0 }, { ...part, at: [2 * w, 0] }] });
  await settled(page);
  assert.deepEqual(await pixel(page, 5, 5), RED);
  assert.equal(mock.of("ack").length, 3);
  await wait_frame(page, mock.frame({ color: BLUE }));
  assert.deepEqual(await pixel(page, 5, 5), BLUE);
});

page_test("a frame of reduced size fills the window; the pointer keeps the window's pixels", {}, async (page, mock) => {
  const [w, h] = mock.size;
  const half = [Math.round(w / 2), Math.round(h / 2)];
  await wait_frame(page, mock.frame({ color: GREEN, whole: half }));
  assert.deepEqual(await canvas_size(page), [w, h]);
  assert.deepEqual(await pixel(page, w - 2, h - 2), GREEN);
  const box = await stage(page);
  await page.mouse.move(box.x + 1000, box.y + 500);
  await mock.wait("the move", (m) => m.t === "move" && m.x === 1000 && m.y === 500);
});

page_test("size and pixel ratio", { deviceScaleFactor: 2 }, async (page, mock) => {
  const box = await stage(page);
  assert.deepEqual(mock.hellos[0].size, [2560, 2 * box.h]);
  assert.equal(mock.hellos[0].scale, 2);
  assert.deepEqual(await canvas_size(page), [2560, 2 * box.h]);
  await page.setViewportSize({ width: 900, height: 600 });
  const size = await mock.wait("the new size", (m) => m.t === "size" && m.size[0] === 1800);
  assert.equal(size.scale, 2);
  await until("a frame of that size", async () => (await canvas_size(page)).join() === size.size.join());
  await page.click("#fold");
  await mock.wait("all of the height", (m) => m.t === "size" && m.size[1] === 1200);
  await until("the picture has it", async () => (await canvas_size(page))[1] === 1200);
  await page.mouse.move(450, 300);
  await mock.wait("the move in pixels of the window", (m) => m.t === "move" && m.x === 900 && m.y === 600);
  await page.click("#unfold");
  await page.click("#show-help");
  await page.click("#larger");
  await mock.wait("larger text", (m) => m.t === "size" && Math.abs(m.scale - 2.2) < 1e-9);
});

page_test("full screen hides the bar, and its edge brings it back", {}, async (page) => {
  await page.click("#full");
  await page.waitForFunction(() => document.fullscreenElement !== null);
  await page.mouse.move(600, 400);
  const seen = () => page.evaluate(() => getComputedStyle(document.getElementById("bar")).visibility === "visible");
  await until("the bar hides", async () => !(await seen()));
  const box = await stage(page);
  assert.equal(box.h, 720, "the picture has all of it");
  await page.mouse.move(600, 1);
  await until("the bar is back", seen);
  await page.click("#full");
  await page.waitForFunction(() => document.fullscreenElement === null);
});
