// SPDX-License-Identifier: MIT
// H.264 from `pabd serve` in the browser: what moves is decoded to the pixels of the window.
import assert from "node:assert/strict";
import test from "node:test";

import { Server } from "./server.mjs";
import { close_browser, page_data, stage, until, wait_frame, wait_role, with_visitor } from "./support.mjs";

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

// In the page: a copy of the last frame that came as H.264, and of the lossless one of the same number.
const watch_frames = () => {
  const copy = () => {
    const canvas = document.getElementById("picture");
    const out = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
    out.drawImage(canvas, 0, 0);
    return out;
  };
  window.seen = { video: null, at: "" };
  const look = () => {
    const { codec, frame } = document.documentElement.dataset;
    if (codec === "h264" && window.seen.at !== frame) window.seen = { video: copy(), at: frame };
    requestAnimationFrame(look);
  };
  look();
  window.error_of_video = () => {
    const { video } = window.seen;
    const { width, height } = video.canvas;
    const [a, b] = [video, copy()].map((of) => of.getImageData(0, 0, width, height).data);
    let [sum, most] = [0, 0];
    const means = [0, 0, 0];
    for (let k = 0; k < a.length; ++k) {
      if (k % 4 === 3) continue;
      means[k % 4] += a[k] - b[k];
      const off = Math.abs(a[k] - b[k]);
      sum += off;
      most = Math.max(most, off);
    }
    const pixels = width * height;
    return { mean: sum / (3 * pixels), most, shift: means.map((m) => m / pixels) };
  };
};

const video_test = (name, size, act) =>
  test(name, { skip, timeout: 90000 }, () =>
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
    await until("H.264", async () => (await codec(page)) === "h264", 30000);
    const from = Number((await page_data(page)).frame);
    await wait_frame(page, from + 20);
    await server.act({ do: "pause" });
    await until("a still window", async () => {
      const data = await page_data(page);
      return data.codec === "png" && (await page.evaluate(() => window.seen.at)) === data.frame;
    });
    await page.waitForTimeout(500); // all parts of the lossless frame
    const error = await page.evaluate(() => window.error_of_video());
    assert.ok(error.mean > 0 && error.mean < 2.5, `mean ${error.mean} of 255`);
    for (const shift of error.shift) assert.ok(Math.abs(shift) < 1, `colours are shifted by ${error.shift}`);
  });
}

video_test("after a new size there are frames at once, and H.264 again", [1000, 700], async (page) => {
  await server.act({ do: "play" });
  await until("H.264", async () => (await codec(page)) === "h264", 30000);
  await page.setViewportSize({ width: 800, height: 600 });
  const size = () => page.evaluate(() => document.getElementById("picture").width);
  await until("the new size", async () => (await size()) === 800);
  await until("H.264 of it", async () => (await codec(page)) === "h264", 30000);
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

test("a browser without WebCodecs gets JPEG, and says why", { skip, timeout: 60000 }, () =>
  with_visitor(server.link, { size: [800, 600], init: () => delete window.VideoDecoder }, async (page) => {
    await wait_role(page, "control", 30000);
    await server.act({ do: "play" });
    const from = Number((await page_data(page)).frame ?? 0);
    await wait_frame(page, from + 30);
    assert.equal(await codec(page), "jpeg");
    await page.click("#show-link");
    await page.waitForFunction(() => document.getElementById("stat-no-video").textContent === "this browser has no H.264");
  }),
);
