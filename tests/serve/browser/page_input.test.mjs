// SPDX-License-Identifier: MIT
// The page against a server that only speaks the protocol: the input: mouse, keys, text, clipboard, touch.
import assert from "node:assert/strict";

import { page_test, settled } from "./page_support.mjs";
import { stage, until } from "./support.mjs";

page_test("mouse: every button, its place, modifiers, and the wheel", {}, async (page, mock) => {
  const box = await stage(page);
  for (const button of ["left", "middle", "right"]) {
    await page.mouse.move(box.x + 200, box.y + 100);
    await page.mouse.down({ button });
    await page.mouse.move(box.x + 260, box.y + 140, { steps: 3 });
    await page.mouse.up({ button });
    const down = await mock.wait(button, (m) => m.t === "button" && m.b === button && m.down);
    const up = await mock.wait(button, (m) => m.t === "button" && m.b === button && !m.down);
    assert.deepEqual([down.x, down.y, up.x, up.y, down.mods], [200, 100, 260, 140, 0]);
  }
  // A second button while the first is held, and a drag that ends outside the window.
  mock.received.length = 0;
  await page.mouse.move(box.x + 200, box.y + 100);
  await page.keyboard.down("Shift");
  await page.mouse.down({ button: "left" });
  await page.mouse.down({ button: "right" });
  await page.mouse.up({ button: "right" });
  await page.mouse.move(box.x + 200, 2);
  await page.mouse.move(box.x + 260, 4);
  await page.mouse.up({ button: "left" });
  await page.keyboard.up("Shift");
  const words = () => mock.of("button").map((m) => `${m.b} ${m.down} ${m.mods}`);
  await until("four changes of buttons", () => words().length === 4);
  assert.deepEqual(words(), ["left true 2", "right true 2", "right false 2", "left false 2"]);
  assert.ok(mock.of("move").some((m) => m.x === 260 && m.y < 0), "the drag goes on outside");
  await page.mouse.move(box.x + 300, box.y + 300);
  await page.mouse.wheel(0, -120);
  const wheel = await mock.wait("the wheel", (m) => m.t === "wheel");
  assert.ok(wheel.y > 0.5 && wheel.y < 3 && wheel.x === 0, JSON.stringify(wheel));
  const stamps = mock.received.filter((m) => m.s !== undefined).map((m) => m.s);
  assert.ok(stamps.every((s, k) => k === 0 || s > stamps[k - 1]), "stamps grow");
  const menu = await page.evaluate(() =>
    document.getElementById("picture").dispatchEvent(new MouseEvent("contextmenu", { cancelable: true, bubbles: true })),
  );
  assert.equal(menu, false, "no menu of the browser on the picture");
});

page_test("keys go to the window, those of the browser do not", {}, async (page, mock) => {
  for (const chord of ["Space", "Shift+ArrowRight", "Control+z", "F1", "F11", "Control+Shift+P", "Tab", "7"]) {
    await page.keyboard.press(chord);
  }
  await mock.wait("7", (m) => m.t === "key" && m.key === "7" && !m.down);
  const downs = mock.of("key").filter((m) => m.down && !["shift", "ctrl"].includes(m.key));
  assert.deepEqual(
    downs.map((m) => `${m.key} ${m.mods}`),
    ["space 0", "right 2", "z 1", "f1 0", "p 3", "tab 0", "7 0"],
  );
  const held = new Set();
  for (const m of mock.of("key")) held[m.down ? "add" : "delete"](m.key);
  assert.deepEqual([...held], []);
  // What is held when the focus leaves is let go.
  await page.keyboard.down("w");
  await page.keyboard.press("F6");
  await mock.wait("w let go", (m) => m.t === "key" && m.key === "w" && !m.down);
  const focus = () => page.evaluate(() => document.activeElement.closest("#bar") !== null);
  assert.ok(await focus(), "F6 leads to the bar");
  mock.received.length = 0;
  await page.keyboard.press("Enter"); // opens the first card
  await page.keyboard.press("Escape");
  assert.ok(!(await focus()), "escape leads back");
  await page.keyboard.up("w");
  await page.keyboard.press("a");
  await mock.wait("a", (m) => m.t === "key" && m.key === "a" && m.down);
  assert.ok(!mock.of("key").some((m) => ["enter", "escape", "f6"].includes(m.key)), "the bar's keys are its own");
});

page_test("text: typed, composed, pasted, deleted", {}, async (page, mock) => {
  const typed = () => mock.of("text").map((m) => m.text).join("");
  await page.keyboard.type("ab");
  await until("text without a field", () => typed() === "ab");
  const active = () => page.evaluate(() => document.activeElement.id);
  assert.equal(await active(), "picture");
  mock.send({ t: "text_input", on: true });
  await until("the field", async () => (await active()) === "text");
  await page.keyboard.type("1.5e-3 µ");
  await until("the text", () => typed() === "ab1.5e-3 µ");
  const devtools = await page.context().newCDPSession(page);
  await devtools.send("Input.imeSetComposition", { text: "かん", selectionStart: 2, selectionEnd: 2 });
  await settled(page);
  assert.equal(typed(), "ab1.5e-3 µ", "nothing before it is chosen");
  await devtools.send("Input.insertText", { text: "感" });
  await until("the composed text", () => typed() === "ab1.5e-3 µ感");
  await page.keyboard.press("Backspace");
  const backspaces = () => mock.of("key").filter((m) => m.key === "backspace" && m.down).length;
  await until("a backspace", () => backspaces() === 1);
  // A keyboard on a screen tells no keys: the field shrinks.
  await settled(page);
  await page.evaluate(() => document.execCommand("delete"));
  await until("the screen's backspace", () => backspaces() === 2);
  await page.evaluate(() => {
    const data = new DataTransfer();
    data.setData("text/plain", "κ = 12 345");
    document.activeElement.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
  });
  await until("ctrl+v", () => mock.of("key").filter((m) => m.key === "v").length === 2);
  assert.ok(mock.of("key").some((m) => m.key === "v" && m.mods === 1 && m.down));
  const order = mock.received.filter((m) => m.t === "clipboard" || (m.t === "key" && m.key === "v")).map((m) => m.t);
  assert.deepEqual(order, ["clipboard", "key", "key"]);
  assert.equal(mock.of("clipboard")[0].text, "κ = 12 345");
  mock.send({ t: "text_input", on: false });
  await until("the picture", async () => (await active()) === "picture");
});

const clipboard = {
  permissions: ["clipboard-read", "clipboard-write"],
  init: () => {
    window.really_write = navigator.clipboard.writeText;
    navigator.clipboard.writeText = () => Promise.reject(new Error("refused"));
  },
};
page_test("what the window copies is in the clipboard, else in a box", clipboard, async (page, mock) => {
  mock.send({ t: "clipboard", text: "pabd view pyramid" });
  await page.waitForSelector("#copy-box:not([hidden])"); // the browser refused
  assert.equal(await page.inputValue("#copy-text"), "pabd view pyramid");
  await page.click("#copy-now");
  const read = () => page.evaluate(() => navigator.clipboard.readText());
  assert.equal(await read(), "pabd view pyramid");
  assert.ok(await page.isHidden("#copy-box"));
  await page.evaluate(() => (navigator.clipboard.writeText = window.really_write));
  const box = await stage(page);
  await page.mouse.click(box.x + 50, box.y + 50);
  mock.send({ t: "clipboard", text: "--set contact.kappa=50" });
  await until("the clipboard", async () => (await read()) === "--set contact.kappa=50");
  assert.ok(await page.isHidden("#copy-box"));
});

const phone = { size: [390, 844], deviceScaleFactor: 2, hasTouch: true, isMobile: true };
page_test("touch: drag, tap, pinch, two fingers, long press", phone, async (page, mock) => {
  const box = await stage(page);
  const devtools = await page.context().newCDPSession(page);
  const touch = (type, ...points) =>
    devtools.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map(([x, y], id) => ({ x: box.x + x, y: box.y + y, id })),
    });
  const words = () => mock.received.filter((m) => m.t === "button").map((m) => `${m.b} ${m.down}`);
  assert.deepEqual(mock.size, [780, 2 * box.h]);

  await touch("touchStart", [100, 200]);
  for (let k = 1; k <= 10; ++k) await touch("touchMove", [100 + 10 * k, 200]);
  await touch("touchEnd");
  await until("a drag", () => words().join() === "left true,left false");
  assert.deepEqual(mock.of("button").map((m) => [m.x, m.y]), [[200, 400], [400, 400]]);

  mock.received.length = 0;
  await touch("touchStart", [50, 60]);
  await touch("touchEnd");
  await until("a tap", () => words().join() === "left true,left false");
  assert.deepEqual(mock.of("button").map((m) => [m.x, m.y]), [[100, 120], [100, 120]]);

  mock.received.length = 0;
  await touch("touchStart", [150, 300], [250, 300]);
  for (let k = 1; k <= 20; ++k) await touch("touchMove", [150 - 4 * k, 300], [250 + 4 * k, 300]);
  await touch("touchEnd");
  const notches = () => mock.of("wheel").reduce((sum, m) => sum + m.y, 0);
  await until("a pinch", () => notches() > 4);
  assert.ok(notches() < Math.log(2.6) / Math.log(1.15), `${notches()} notches`);
  assert.deepEqual(words(), []);

  await settled(page); // its last notches may still be on their way
  mock.received.length = 0;
  await touch("touchStart", [150, 300], [250, 300]);
  for (let k = 1; k <= 12; ++k) await touch("touchMove", [150, 300 + 8 * k], [250, 300 + 8 * k]);
  await touch("touchEnd");
  await until("two fingers", () => words().join() === "middle true,middle false");
  assert.deepEqual(mock.of("wheel"), []);

  mock.received.length = 0;
  await touch("touchStart", [200, 400]);
  await until("a long press", () => words().join() === "right true,right false");
  await touch("touchEnd");
  await mock.wait("the pointer leaves", (m) => m.t === "leave");
  // Buttons for what a phone has no keys for.
  await page.tap("#play");
  await mock.wait("space", (m) => m.t === "key" && m.key === "space" && m.down);
});
