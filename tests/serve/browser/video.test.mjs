// SPDX-License-Identifier: MIT
// H.264 from `pabd serve` in the browser: what moves is decoded to the pixels of the window.
import assert from "node:assert/strict";
import test from "node:test";

import { Server } from "./server.mjs";
import { TEST_LIMIT, close_browser, page_data, stage, until, wait_frame, wait_role, with_visitor } from "./support.mjs";

const skip = process.env.PABD_PROGRAM ? false : "no program was named";
const server = new Server();
test.before(async () => {
  if (!skip) await server.start("pyramid", "--port", "0", "--codec", "h264");
});
test.after(async () => {
  await close_browser();
  if (!skip) assert.equal(await server.stop(), 0, "SIGTERM: exit code 0");
});

const codec = async (page) => (await page_data(page)).codec;
// The same visitor after a reload of the test, so that the role is his at once.
// "Fine": else a slow machine would make the picture smaller.
const same_visitor = () => {
  sessionStorage.setItem("pabd.id", "00112233445566bb");
  localStorage.setItem("pabd.quality", "fine");
};

// In the page: of every frame that came as H.264 and then lossless, both pictures. Parts of the lossless one come one
// by one under the same number: the last copy counts.
const watch_frames = () => {
  const copy = () => {
    const canvas = document.getElementById("picture");
    const out = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
    out.drawImage(canvas, 0, 0);
    return out;
  };
  window.seen = { video: null, at: "", pairs: new Map() };
  const look = () => {
    const { seen } = window;
    const { codec, frame } = document.documentElement.dataset;
    if (codec === "h264" && seen.at !== frame) Object.assign(seen, { video: copy(), at: frame });
    if (codec === "png" && seen.at === frame) seen.pairs.set(frame, [seen.video, copy()]);
    requestAnimationFrame(look);
  };
  look();
  // Of each such frame: the mean error, and how far each colour is shifted.
  window.errors_of_video = () =>
    [...window.seen.pairs.values()].map((pair) => {
      const { width, height } = pair[0].canvas;
      const [a, b] = pair.map((of) => of.getImageData(0, 0, width, height).data);
      let sum = 0;
      const shift = [0, 0, 0];
      for (let k = 0; k < a.length; ++k) {
        if (k % 4 === 3) continue;
        shift[k % 4] += a[k] - b[k];
        sum += Math.abs(a[k] - b[k]);
      }
      const pixels = width * height;
      return { mean: sum / (3 * pixels), shift: shift.map((s) => s / pixels) };
    });
};

const video_test = (name, size, act) =>
  test(name, { skip, timeout: TEST_LIMIT }, () =>
    with_visitor(server.link, { size, init: same_visitor }, async (page) => {
      await wait_role(page, "control");
      await server.act({ do: "pause" }, { do: "load", scene: "pyramid", force: true });
      await wait_frame(page, 1);
      assert.equal((await server.state()).ui.dark, false, "the window is light, as the browser prefers");
      await page.evaluate(watch_frames);
      await act(page, await stage(page));
    }),
  );

// The window's side is odd in one of them.
for (const size of [
  [1280, 755],
  [901, 600],
]) {
  video_test(`what moves is H.264, and its pixels are the window's: ${size}`, size, async (page) => {
    await server.act({ do: "play" });
    await until("H.264", async () => (await codec(page)) === "h264");
    const from = Number((await page_data(page)).frame);
    await wait_frame(page, from + 20);
    await server.act({ do: "pause" });
    // What changes last may be a small part of the window, in colours that H.264 keeps exactly: every frame is held to
    // the window's pixels, and one of them is the moving scene.
    await until("a still window", () => page.evaluate(() => window.seen.pairs.has(document.documentElement.dataset.frame)));
    await page.waitForTimeout(500); // all parts of the lossless frame
    const errors = await page.evaluate(() => window.errors_of_video());
    assert.ok(errors.some(({ mean }) => mean > 0), "none of the frames was coded with losses");
    for (const { mean, shift } of errors) {
      assert.ok(mean < 2.5, `mean ${mean} of 255`);
      for (const by of shift) assert.ok(Math.abs(by) < 1, `colours are shifted by ${by}`);
    }
  });
}

video_test("after a new size there are frames at once, and H.264 again", [1000, 700], async (page) => {
  await server.act({ do: "play" });
  await until("H.264", async () => (await codec(page)) === "h264");
  await page.setViewportSize({ width: 800, height: 600 });
  const size = () => page.evaluate(() => document.getElementById("picture").width);
  await until("the new size", async () => (await size()) === 800);
  await until("H.264 of it", async () => (await codec(page)) === "h264");
  await page.click("#show-link");
  await page.waitForFunction(() => /^H\.264/.test(document.getElementById("stat-codec").textContent));
  assert.ok(await page.isHidden("#stat-no-video"));
  // Who watches gets JPEG, and is told why.
  await with_visitor(server.watch, { size: [700, 500] }, async (watcher) => {
    await wait_role(watcher, "watch");
    await until("a moving frame", async () => (await codec(watcher)) === "jpeg");
    await watcher.click("#show-link");
    await watcher.waitForFunction(() => document.getElementById("stat-no-video").textContent === "H.264 is for who controls");
  });
});

test("a browser without WebCodecs gets JPEG, and says why", { skip, timeout: TEST_LIMIT }, () =>
  with_visitor(server.link, { size: [800, 600], init: () => delete window.VideoDecoder }, async (page) => {
    await wait_role(page, "control");
    await server.act({ do: "play" });
    const from = Number((await page_data(page)).frame ?? 0);
    await wait_frame(page, from + 30);
    assert.equal(await codec(page), "jpeg");
    await page.click("#show-link");
    await page.waitForFunction(() => document.getElementById("stat-no-video").textContent === "this browser has no H.264");
  }),
);
