// SPDX-License-Identifier: MIT
// The page against a server that only speaks the protocol: visitors, files, statistics.
import assert from "node:assert/strict";

import { KEY } from "./mock_server.mjs";
import { BLUE, page_test } from "./page_support.mjs";
import { canvas_size, stage, until, wait_frame, wait_role } from "./support.mjs";

page_test("who watches sends nothing; control is asked for and given", {}, async (page, mock) => {
  mock.send({ t: "role", role: "watch", visitors: 2, asks: false });
  await wait_role(page, "watch");
  mock.received.length = 0;
  const box = await stage(page);
  await page.mouse.click(box.x + 300, box.y + 300);
  await page.keyboard.press("Space");
  await page.click("#ask");
  await mock.wait("the question", (m) => m.t === "ask_control");
  assert.deepEqual(mock.received.filter((m) => m.s !== undefined), []);
  mock.send({ t: "role", role: "control", visitors: 2, asks: false });
  await wait_role(page, "control");
  await page.keyboard.press("Space");
  await mock.wait("space", (m) => m.t === "key" && m.key === "space");
  mock.send({ t: "role", role: "control", visitors: 2, asks: true });
  await page.click("#toasts button:has-text('Give')");
  await mock.wait("control given", (m) => m.t === "give_control");
});

page_test("a watcher sees the whole window of who controls, in its shape", { size: [800, 800] }, async (page, mock) => {
  mock.send({ t: "role", role: "watch", visitors: 2, asks: false });
  await wait_role(page, "watch");
  await wait_frame(page, mock.frame({ color: BLUE, whole: [1600, 400] }));
  assert.deepEqual(await canvas_size(page), [1600, 400]);
  const fit = await page.evaluate(() => getComputedStyle(document.getElementById("picture")).objectFit);
  assert.equal(fit, "contain");
});

const refused = { expected: [/status of 422/] };
page_test("uploads: meshes before the scene, which is opened; what is refused is said", refused, async (page, mock) => {
  await page.click("#show-files");
  const json = (name) => ({ name, mimeType: "application/json", buffer: Buffer.from(`{"name": "${name}"}`) });
  await page.setInputFiles("#picker", [json("tower.json"), { name: "a b.obj", mimeType: "", buffer: Buffer.from("v 0 0 0") }]);
  const open = await mock.wait("open", (m) => m.t === "open");
  assert.equal(open.name, "tower.json");
  assert.deepEqual([...mock.uploads.keys()], ["a b.obj", "tower.json"]);
  assert.equal(mock.uploads.get("tower.json").toString(), '{"name": "tower.json"}');
  await page.waitForSelector("#file-list .name:has-text('a b.obj')");
  await page.setInputFiles("#picker", [json("bad.json")]);
  await page.waitForSelector(".toast.bad:has-text('the scene has no bodies')");
  assert.equal(mock.of("open").length, 1);
  // What the window saves later under such a name is news.
  mock.send({ t: "file", name: "bad.json", bytes: 5 });
  await page.waitForSelector(".toast:has-text('Saved bad.json')");
  await page.waitForTimeout(1200);
  mock.send({ t: "file", name: "tower.json", bytes: 5 });
  await page.waitForSelector(".toast:has-text('Saved tower.json')");
  assert.ok(mock.requests.filter((r) => /^\/files(\/|$)/.test(r.url)).every((r) => r.bearer === "Bearer " + KEY));
  // Dropped anywhere.
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.items.add(new File(['{"dropped": 1}'], "dropped.json"));
    const send = (type) => document.getElementById("picture").dispatchEvent(new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }));
    send("dragenter");
    window.drop_was_shown = !document.getElementById("drop").hidden;
    send("dragover");
    send("drop");
  });
  assert.ok(await page.evaluate(() => window.drop_was_shown));
  await mock.wait("the dropped one", (m) => m.t === "open" && m.name === "dropped.json");
  assert.equal(mock.uploads.get("dropped.json").toString(), '{"dropped": 1}');
});

page_test("what was saved is offered, and downloaded as it is", {}, async (page, mock) => {
  const bytes = Buffer.from(Array.from({ length: 3000 }, (_, k) => (k * 7) & 255));
  mock.uploads.set("run 1.pabd", bytes);
  mock.send({ t: "file", name: "run 1.pabd", bytes: bytes.length });
  await page.waitForSelector(".toast:has-text('Saved run 1.pabd, 3.00 kB')");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(".toast button:has-text('Download')")]);
  assert.equal(download.suggestedFilename(), "run 1.pabd");
  const got = [];
  for await (const part of await download.createReadStream()) got.push(part);
  assert.ok(Buffer.concat(got).equals(bytes));
});

page_test("statistics: latency from input to picture, bytes, times", {}, async (page, mock) => {
  await page.click("#show-link");
  const box = await stage(page);
  await until("the smaller window", async () => (await canvas_size(page))[1] === box.h);
  const late = 120; // ms that the server takes
  for (let k = 0; k < 12; ++k) {
    await page.mouse.move(box.x + 100 + k, box.y + 100);
    const move = await mock.wait("the move", (m) => m.t === "move" && m.x === 100 + k);
    await page.waitForTimeout(late);
    await wait_frame(page, mock.frame({ stamp: move.s, color: [k, 0, 0] }));
  }
  await page.waitForFunction(() => Number(document.getElementById("stat-p50").textContent) > 0);
  const text = (id) => page.textContent("#stat-" + id);
  const [p50, p99] = [Number(await text("p50")), Number(await text("p99"))];
  // How much longer it takes is the machine's business.
  assert.ok(p50 >= late, `p50 ${p50} ms`);
  assert.ok(p99 >= p50, `p99 ${p99} ms`);
  await until("frames a second", async () => Number(await text("fps")) > 0 || (mock.frame(), false));
  assert.equal(await text("draw"), "7.1 ms");
  assert.equal(await text("encode"), "4.2 ms");
  assert.match(await text("frame"), /^[\d.]+ kB$/);
  assert.match(await text("rtt"), /^[\d.]+ ms$/);
  mock.send({ t: "stats", fps: 30, quality: 80, scale: 0.5 });
  await page.waitForFunction(() => document.getElementById("stat-codec").textContent === "PNG, quality 80"); // as it came
  await page.click("#quality label:has-text('Fine')");
  await mock.wait("quality", (m) => m.t === "quality" && m.mode === "fine");
});

page_test("the page is as light or dark as the window, and says at the start what it prefers", {}, async (page, mock) => {
  const style = () => page.evaluate(() => getComputedStyle(document.getElementById("bar")).backgroundColor);
  assert.equal(mock.hellos[0].dark, false);
  const light = await style();
  mock.send({ t: "scheme", dark: true });
  await until("a dark bar", async () => (await style()) !== light);
  const dark = await style();
  mock.send({ t: "scheme", dark: false });
  await until("a light bar", async () => (await style()) === light);
  const sum = (color) => color.match(/\d+/g).slice(0, 3).reduce((all, v) => all + Number(v), 0);
  assert.ok(sum(light) > 3 * 230 && sum(dark) < 3 * 60, `${light}, ${dark}`);
  const theme = () => page.evaluate(() => document.querySelector("meta[name=theme-color]").content);
  assert.equal(await theme(), light);
});

page_test("who prefers dark says so", { colorScheme: "dark" }, async (page, mock) => {
  assert.equal(mock.hellos[0].dark, true);
});

page_test("the statistics hide nothing of the window", {}, async (page, mock) => {
  await page.click("#show-link");
  const height = (id) => page.evaluate((of) => document.getElementById(of).getBoundingClientRect().height, id);
  const [bar, dock, stage] = [await height("bar"), await height("card-link"), await height("stage")];
  assert.equal(bar + dock + stage, 720);
  assert.ok(dock > 40 && dock < 70, `${dock} px`);
  await mock.wait("the smaller window", (m) => m.t === "size" && m.size[1] === Math.floor(stage));
  await page.click("#show-link");
  assert.equal(await height("stage"), 720 - bar);
});
