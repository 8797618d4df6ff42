// SPDX-License-Identifier: MIT
// The page against a server that only speaks the protocol: the connection: hello, coming back, silence, keys, tabs.
import assert from "node:assert/strict";

import { KEY, MockServer } from "./mock_server.mjs";
import { GREEN, RED, page_test } from "./page_support.mjs";
import { pixel, stage, state_of, until, wait_frame, wait_state } from "./support.mjs";

const LOST = /WebSocket connection to .* failed|ERR_CONNECTION_REFUSED/;

page_test("says hello, hides its key, and is the same visitor after a reload", {}, async (page, mock) => {
  const [hello] = mock.hellos;
  const box = await stage(page);
  assert.equal(hello.token, KEY);
  assert.deepEqual(hello.size, [box.w, box.h]);
  assert.equal(box.w, 1280);
  assert.ok(box.h > 660, `the bar is slim: ${box.h} px are left`);
  assert.equal(hello.scale, 1);
  assert.match(hello.id, /^[0-9a-f]{16}$/);
  assert.ok(!page.url().includes(KEY), page.url());
  assert.equal(await page.title(), "mock – pabd");
  await page.reload();
  await until("a second hello", () => mock.hellos.length === 2);
  assert.equal(mock.hellos[1].token, KEY);
  assert.equal(mock.hellos[1].id, hello.id);
  const urls = mock.requests.map((request) => request.url).join(" ");
  assert.ok(!urls.includes(KEY), "the key is in no address");
});

page_test("a lost connection comes back, and the picture stays meanwhile", { expected: [LOST] }, async (page, mock) => {
  const [x, y] = mock.size.map((v) => Math.floor(v / 2));
  await wait_frame(page, mock.frame({ color: RED }));
  await mock.stop();
  await wait_state(page, "lost");
  assert.deepEqual(await pixel(page, x, y), RED);
  assert.ok(await page.isVisible("#veil"), "dimmed");
  await page.waitForFunction(() => /again in \d+ s/.test(document.getElementById("notice-text").textContent));
  await page.waitForTimeout(2500);
  assert.equal(await state_of(page), "lost");
  const other = await Object.assign(new MockServer(), { color: GREEN }).start(mock.port);
  try {
    await page.click("#now");
    await wait_state(page, "open");
    await until("its picture", async () => (await pixel(page, x, y)).join() === GREEN.join());
    assert.equal(other.hellos[0].id, mock.hellos[0].id);
    assert.equal(other.hellos[0].token, KEY);
    assert.ok(await page.isHidden("#veil"));
  } finally {
    await other.stop();
  }
  await wait_state(page, "lost");
});

page_test("waits longer after every try", { mock: { refuse: [4429, "16 visitors are the most"] } }, async (page, mock) => {
  await wait_state(page, "lost");
  assert.match(await page.textContent("#notice-text"), /16 visitors are the most/);
  mock.refuse = [1001, ""];
  const gaps = [];
  await page.click("#now");
  for (let k = 0, last = 0; k < 4; ++k) {
    await until("a try", () => mock.hellos.length >= 2 + k, 9000);
    if (last) gaps.push(Date.now() - last);
    last = Date.now();
  }
  for (const [k, wanted] of [500, 1000, 2000].entries()) {
    assert.ok(gaps[k] > 0.8 * wanted, `${gaps[k]} ms instead of ${wanted}`);
  }
});

page_test("a server that does not answer is told from one that is still", {}, async (page, mock) => {
  await page.waitForTimeout(3500);
  assert.equal(await state_of(page), "open", "a picture that does not change is no silence");
  mock.mute = true;
  await wait_state(page, "silent", 8000);
  mock.mute = false;
  await wait_state(page, "open", 8000);
  assert.equal(mock.hellos.length, 1);
});

page_test("without a key it asks for one", { no_key: true }, async (page, mock) => {
  await page.waitForSelector("#key-form:not([hidden])");
  assert.equal(mock.hellos.length, 0);
  await page.fill("#key", "nonsense");
  await page.click("#key-form button");
  assert.match(await page.textContent("#key-wrong"), /no key/);
  await page.fill("#key", "f".repeat(32));
  await page.click("#key-form button");
  await page.waitForFunction(() => document.getElementById("notice-title").textContent === "The key was refused");
  await page.fill("#key", mock.link);
  await page.click("#key-form button");
  await wait_state(page, "open");
  assert.deepEqual(mock.hellos.map((hello) => hello.token), ["f".repeat(32), KEY]);
});

page_test("a key that was good and is refused later: the session has ended", {}, async (page, mock) => {
  mock.refuse = [4401, "wrong token"];
  mock.socket.close(1011);
  await page.waitForFunction(() => document.getElementById("notice-title").textContent === "The session has ended");
  const tries = mock.hellos.length;
  await page.waitForTimeout(1500);
  assert.equal(mock.hellos.length, tries, "it does not try again");
});

page_test("the same page in another tab: said, and taken back by a click", {}, async (page, mock) => {
  mock.socket.close(4410, "opened in another tab");
  await page.waitForFunction(() => /^Opened in another tab\.$/.test(document.getElementById("notice-text").textContent));
  assert.ok(await page.isHidden("#key-form"));
  await page.waitForTimeout(700);
  assert.equal(mock.hellos.length, 1, "the two do not fight");
  await page.click("#now");
  await wait_state(page, "open");
  assert.equal(mock.hellos[1].token, KEY);
});
