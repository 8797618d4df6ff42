// SPDX-License-Identifier: MIT
// The page against `pabd serve`.
import assert from "node:assert/strict";
import test from "node:test";

import { Server } from "./server.mjs";
import { canvas_size, close_browser, difference, pixel, remember, require_module, stage, until } from "./support.mjs";
import { TEST_LIMIT, wait_frame, wait_role, wait_state, with_visitor } from "./support.mjs";

const BAR = 35; // px of the page's bar: with it the window has 1280×720 in a page of 1280×755
const SIZE = [1280, 720 + BAR];
const HANDLE = [1036, 199]; // of κ on the barrier plot, as in tests/gui/scripts/barrier.json
const LOST = /WebSocket connection to .* failed|ERR_CONNECTION_REFUSED/;

// Who comes back is the same visitor and controls at once; another one would wait until the role is free.
const same_visitor = () => sessionStorage.setItem("pabd.id", "00112233445566aa");

const skip = process.env.PABD_PROGRAM ? false : "no program was named";
const server = new Server();
test.before(async () => {
  if (!skip) await server.start("two_boxes", "--port", "0");
});
test.after(async () => {
  await close_browser();
  if (!skip) assert.equal(await server.stop(), 0, "SIGTERM: exit code 0");
});

// A visitor who controls and has seen the window; the scene as it begins.
const serve_test = (name, options, act) =>
  test(name, { skip, timeout: TEST_LIMIT }, () =>
    with_visitor(server.link, { size: SIZE, init: same_visitor, colorScheme: "dark", ...options }, async (page) => {
      await wait_role(page, "control");
      await server.act({ do: "pause" }, { do: "load", scene: "two_boxes", force: true });
      await wait_frame(page, 1);
      await act(page, await stage(page));
    }),
  );

const length = (a, b) => Math.hypot(...a.map((v, k) => v - b[k]));
const quiet = (page) => page.waitForTimeout(600); // until the lossless frame of a still window is there

serve_test("loads: the window is there, in the pixels of the page", {}, async (page, box) => {
  assert.deepEqual([box.w, box.h], [1280, 720]);
  await until("the size", async () => (await canvas_size(page)).join() === "1280,720");
  await quiet(page);
  const file = await server.request("frame.png?width=1280&height=720");
  assert.equal(file.status, 200);
  const png = Buffer.from(await file.arrayBuffer());
  // A still window is shown without loss: the same pixels as the file has.
  const different = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const read = (source) => {
      const copy = new OffscreenCanvas(1280, 720).getContext("2d", { willReadFrequently: true });
      copy.drawImage(source, 0, 0);
      return copy.getImageData(0, 0, 1280, 720).data;
    };
    const [shown, wanted] = [read(document.getElementById("picture")), read(image)];
    let count = 0;
    for (let k = 0; k < shown.length; k += 4) {
      if (shown[k] !== wanted[k] || shown[k + 1] !== wanted[k + 1] || shown[k + 2] !== wanted[k + 2]) ++count;
    }
    return count;
  }, png.toString("base64"));
  assert.ok(different < 0.001 * 1280 * 720, `${different} pixels differ`);
  const colors = await Promise.all([[40, 19], [640, 300], [1100, 500]].map(([x, y]) => pixel(page, x, y)));
  assert.ok(new Set(colors.map(String)).size > 1, "it is not one colour");
  assert.match(await page.title(), /^two.boxes – pabd$/);
});

serve_test("κ is dragged on the barrier plot", {}, async (page, box) => {
  await server.act({ do: "step", steps: 60 });
  const before = (await server.state()).a.kappa;
  await quiet(page);
  await remember(page);
  const at = (x, y) => [box.x + x, box.y + y];
  await page.mouse.move(...at(...HANDLE));
  await page.waitForTimeout(100);
  await page.mouse.down();
  await page.mouse.move(...at(HANDLE[0], HANDLE[1] + 24), { steps: 12 });
  await until("a smaller κ", async () => (await server.state()).a.kappa < 0.7 * before);
  const lower = (await server.state()).a.kappa;
  await page.mouse.move(...at(HANDLE[0], HANDLE[1] - 30), { steps: 12 });
  await until("a larger κ", async () => (await server.state()).a.kappa > 1.2 * before);
  await page.mouse.up();
  const after = (await server.state()).a.kappa;
  assert.ok(lower > 0 && after > lower, `${before}, ${lower}, ${after}`);
  await quiet(page);
  const changed = await difference(page, 904, 120, 364, 160); // the plot
  assert.ok(changed > 0.5, `the plot changed by ${changed} of 255`);
  await page.keyboard.press("Control+z");
  await until("the old κ", async () => (await server.state()).a.kappa === before);
});

serve_test("space plays and pauses", {}, async (page) => {
  const start = (await server.state()).a.step;
  await page.keyboard.press("Space");
  await until("it plays", async () => (await server.state()).a.step > start + 5);
  assert.equal((await server.state()).playing, true);
  await page.keyboard.press("Space");
  await until("it pauses", async () => !(await server.state()).playing);
  const { step } = (await server.state()).a;
  await page.waitForTimeout(300);
  assert.equal((await server.state()).a.step, step);
  await page.keyboard.press("ArrowRight");
  await until("one more step", async () => (await server.state()).a.step === step + 1);
});

serve_test("size and pixel ratio 2", { deviceScaleFactor: 2, size: [800, 500] }, async (page, box) => {
  await until("the size", async () => (await canvas_size(page)).join() === [1600, 2 * box.h].join());
  await page.setViewportSize({ width: 1000, height: 640 });
  await until("the new size", async () => (await canvas_size(page)).join() === [2000, 2 * (640 - BAR)].join());
  await page.click("#fold");
  await until("without the bar", async () => (await canvas_size(page)).join() === "2000,1280");
  await quiet(page);
  // Text twice as large: the toolbar ends at 38 px of the page, and the picture begins there.
  const [panel, picture] = await Promise.all([pixel(page, 4, 70), pixel(page, 1000, 90)]);
  assert.ok(length(panel, picture) > 40, `${panel} and ${picture}`);
});

const touch_screen = { hasTouch: true, isMobile: true, deviceScaleFactor: 2, size: [844, 390] };
serve_test("touch: a finger turns the view, a pinch brings it nearer", touch_screen, async (page, box) => {
  const devtools = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    devtools.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map(([x, y], id) => ({ x: box.x + x, y: box.y + y, id })),
    });
  await page.tap("#panels"); // all of it is the picture
  await until("no panels", async () => (await server.state()).ui.hidden);
  const view = async () => (await server.state()).ui;
  const before = await view();
  await touch("touchStart", [400, 180]);
  for (let k = 1; k <= 15; ++k) await touch("touchMove", [400 + 6 * k, 180]);
  await touch("touchEnd");
  const distance = (ui) => length(ui.eye, ui.target);
  const turned = await until("a turned view", async () => {
    const now = await view();
    return length(now.eye, before.eye) > 0.2 * distance(before) && now;
  });
  assert.ok(Math.abs(distance(turned) / distance(before) - 1) < 0.01, "turned, not nearer");
  await touch("touchStart", [370, 180], [430, 180]);
  for (let k = 1; k <= 15; ++k) await touch("touchMove", [370 - 6 * k, 180], [430 + 6 * k, 180]);
  await touch("touchEnd");
  await until("nearer", async () => distance(await view()) < 0.5 * distance(turned));
  await page.tap("#panels");
  await until("panels", async () => !(await server.state()).ui.hidden);
});

serve_test("a server that is stopped for 3 s goes on where it was", {}, async (page) => {
  await server.act({ do: "step", steps: 7 });
  const { hash } = (await server.state()).a;
  server.signal("SIGSTOP");
  try {
    await page.waitForTimeout(3000);
    await wait_state(page, "silent");
    assert.ok(await page.isVisible("#veil"));
  } finally {
    server.signal("SIGCONT");
  }
  await wait_state(page, "open");
  assert.equal((await server.state()).a.hash, hash);
  await page.keyboard.press("ArrowRight");
  await until("a step", async () => (await server.state()).a.step === 8);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.role), "control");
});

serve_test("a reload comes back to the same state and to control", {}, async (page) => {
  await server.act({ do: "step", steps: 5 });
  await page.reload();
  await wait_role(page, "control");
  await wait_frame(page, 1);
  assert.equal((await server.state()).a.step, 5);
});

serve_test("a second visitor watches, and takes over when control is given", {}, async (page, box) => {
  await with_visitor(server.link, { size: [900, 600] }, async (second) => {
    await wait_role(second, "watch");
    await wait_frame(second, 1);
    await until("the other's window", async () => (await canvas_size(second)).join() === "1280,720");
    const step = async () => (await server.state()).a.step;
    await second.keyboard.press("ArrowRight");
    await second.waitForTimeout(300);
    assert.equal(await step(), 0, "who watches changes nothing");
    await second.click("#ask");
    await page.click("#toasts button:has-text('Give')");
    await wait_role(second, "control");
    await wait_role(page, "watch");
    await second.keyboard.press("ArrowRight");
    await until("his step", async () => (await step()) === 1);
    await page.mouse.click(box.x + 600, box.y + 300);
    await page.keyboard.press("ArrowRight");
    await page.waitForTimeout(300);
    assert.equal(await step(), 1);
    await second.click("#show-people");
    await second.click("#give-control");
    await wait_role(page, "control");
  });
});

serve_test("the link for watchers only watches", {}, async () => {
  await with_visitor(server.watch, { size: [900, 600] }, async (watcher) => {
    await wait_role(watcher, "watch");
    await wait_frame(watcher, 1);
    assert.ok(await watcher.isHidden("#ask"), "nothing to ask for");
    await watcher.keyboard.press("ArrowRight");
    const key = server.watch.split("#k=")[1];
    assert.equal((await server.request("state", { key })).status, 200);
    const refused = await server.request("actions", { key, method: "POST", body: '[{"do": "step"}]' });
    assert.ok([401, 403].includes(refused.status), `POST /actions: ${refused.status}`);
    assert.equal((await server.state()).a.step, 0);
  });
});

test("a wrong key is refused, in words", { skip, timeout: TEST_LIMIT }, () =>
  with_visitor(server.url + "#k=" + "0".repeat(32), {}, async (page) => {
    await page.waitForFunction(() => document.getElementById("notice-title").textContent === "The key was refused");
    await page.fill("#key", server.link);
    await page.click("#key-form button");
    await wait_state(page, "open");
  }),
);

test("another origin or host gets no socket", { skip, timeout: TEST_LIMIT }, async () => {
  const { WebSocket } = require_module("ws");
  const url = server.url.replace("http", "ws") + "socket";
  const attempt = (headers) =>
    new Promise((resolve) => {
      const socket = new WebSocket(url, "pabd.1", { headers });
      socket.on("unexpected-response", (request, answer) => {
        resolve(answer.statusCode);
        request.destroy();
      });
      socket.on("open", () => {
        resolve("open");
        socket.close();
      });
      socket.on("error", () => {});
    });
  const origin = server.url.slice(0, -1);
  assert.equal(await attempt({ Origin: origin }), "open");
  assert.equal(await attempt({ Origin: "http://evil.example" }), 403);
  assert.equal(await attempt({ Origin: origin + "1" }), 403);
  assert.equal(await attempt({ Origin: "null" }), 403);
  assert.equal(await attempt({}), 403);
  assert.equal(await attempt({ Origin: origin, Host: "evil.example" }), 421);
});

serve_test("a scene that is uploaded is shown", {}, async (page) => {
  await quiet(page);
  await remember(page);
  const box = (name, y) => ({ name, shape: { type: "box", size: [1.2, 0.6, 1.2] }, position: [0, y, 0] });
  const scene = JSON.stringify({
    format: "pabd-scene",
    version: 1,
    name: "tower",
    bodies: [
      { name: "ground", shape: { type: "plane", normal: [0, 1, 0], offset: 0 } },
      ...[0.3, 0.92, 1.54, 2.16].map((y, k) => box("floor " + k, y)),
    ],
    camera: { eye: [3, 2.5, 5], target: [0, 1.2, 0], fov: 38 },
  });
  await page.click("#show-files");
  await page.setInputFiles("#picker", { name: "tower.json", mimeType: "application/json", buffer: Buffer.from(scene) });
  await until("its bodies", async () => (await server.state()).a.bodies.length === 5);
  await page.click("#show-files");
  await quiet(page);
  const changed = await difference(page, 340, 50, 540, 580);
  assert.ok(changed > 1, `the picture changed by ${changed} of 255`);
  assert.match(await page.title(), /^tower – pabd$/);
});

serve_test("a screenshot is saved and downloaded as a PNG", {}, async (page) => {
  await page.click("#show-help");
  await page.click("[data-key='f12']");
  await until("the dialog", async () => (await server.state()).ui.dialog === "screenshot");
  await page.waitForTimeout(200);
  await page.keyboard.press("Enter");
  await page.waitForSelector(".toast:has-text('.png')");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(".toast:has-text('.png') button:has-text('Download')")]);
  assert.match(download.suggestedFilename(), /\.png$/);
  const parts = [];
  for await (const part of await download.createReadStream()) parts.push(part);
  const png = Buffer.concat(parts);
  assert.deepEqual([...png.subarray(0, 8)], [137, 80, 78, 71, 13, 10, 26, 10]);
  assert.ok(png.readUInt32BE(16) >= 64 && png.length > 2000, `${png.length} bytes`);
});

const permissions = ["clipboard-read", "clipboard-write"];
serve_test("the command is copied into the clipboard", { permissions }, async (page) => {
  await server.act({ do: "set", key: "contact.N", value: 5 });
  await page.keyboard.press("Control+Shift+c");
  const text = await until("the clipboard", () => page.evaluate(() => navigator.clipboard.readText()));
  assert.match(text, /^pabd .*two_boxes.*contact\.N=5/);
});

serve_test("the numbers of the link are numbers", {}, async (page, box) => {
  await page.click("#show-link");
  await until("the smaller window", async () => (await canvas_size(page))[1] < 720);
  await page.keyboard.press("Space");
  for (let k = 0; k < 40; ++k) {
    await page.mouse.move(box.x + 500 + 3 * k, box.y + 300);
    await page.waitForTimeout(50);
  }
  await page.waitForFunction(() => Number(document.getElementById("stat-p50").textContent) > 0);
  const text = (id) => page.textContent("#stat-" + id);
  const fps = Number(await text("fps"));
  const [p50, p99] = [Number(await text("p50")), Number(await text("p99"))];
  assert.ok(fps >= 1 && fps < 200, `${fps} frames a second`);
  assert.ok(p50 > 0 && p50 <= p99 && p99 < 5000, `p50 ${p50} ms, p99 ${p99} ms`);
  for (const id of ["draw", "encode", "decode", "rtt"]) assert.match(await text(id), /^[\d.]+ ms$/, id);
  assert.match(await text("frame"), /^[\d.]+ kB$/);
  assert.match(await text("codec"), /^(JPEG|PNG)/);
  console.log(`${fps} frames a second, latency p50 ${p50} ms, p99 ${p99} ms`);
  await page.keyboard.press("Space");
});

test("with --sessions every visitor has a simulation and files of their own", { skip, timeout: TEST_LIMIT }, async () => {
  const own = await new Server().start("two_boxes", "--port", "0", "--sessions", "2");
  try {
    await with_visitor(own.link, { size: SIZE }, async (one) => {
      await with_visitor(own.link, { size: SIZE }, async (two) => {
        for (const page of [one, two]) {
          await wait_role(page, "control");
          await wait_frame(page, 1);
          await page.click("#show-files");
        }
        const names = (page) => page.locator("#file-list .name").allTextContents();
        await one.setInputFiles("#picker", { name: "mine.obj", mimeType: "", buffer: Buffer.from("v 0 0 0\n") });
        await until("the first one's file", async () => (await names(one)).includes("mine.obj"));
        await two.click("#show-files");
        await two.click("#show-files");
        await two.waitForSelector("#file-list .none");
        const step = async (page) => {
          const session = await page.evaluate(() => sessionStorage.getItem("pabd.id"));
          return (await own.state(session)).a.step;
        };
        await one.click("#scene"); // the keyboard goes to the window
        for (let k = 0; k < 5; ++k) await one.keyboard.press("ArrowRight");
        await until("five steps", async () => (await step(one)) === 5);
        assert.equal(await step(two), 0);
      });
    });
  } finally {
    await own.stop();
  }
});

test("after a new start the page says that the session has ended", { skip, timeout: TEST_LIMIT }, async () => {
  const first = await new Server().start("two_boxes", "--port", "0");
  const args = ["two_boxes", "--port", String(first.port)];
  let second = null;
  try {
    await with_visitor(first.link, { size: SIZE, expected: [LOST] }, async (page) => {
      await wait_frame(page, 1);
      await first.stop("SIGKILL");
      await wait_state(page, "lost");
      assert.ok(await page.isVisible("#veil"), "the last picture stays, dimmed");
      second = await new Server().start(...args);
      await page.waitForFunction(() => document.getElementById("notice-title").textContent === "The session has ended");
      await page.fill("#key", second.link);
      await page.click("#key-form button");
      await wait_state(page, "open");
    });
  } finally {
    await second?.stop();
  }
});
