// SPDX-License-Identifier: MIT
// The browser, and pages that fail a test for anything that the browser complains about.
//   PABD_BROWSER_WORK   folder with node_modules and page/ (run.sh makes it)
//   PABD_CHROMIUM       the browser
//   PABD_PROGRAM        pabd
//   PABD_FIREFOX        Firefox
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const work = process.env.PABD_BROWSER_WORK;
if (!work) throw new Error("PABD_BROWSER_WORK is not set: run tests/serve/browser/run.sh");
const here = dirname(fileURLToPath(import.meta.url));

// A deadline is for what never comes: with sanitizers, two cores and two simulations a frame may take a second.
export const PATIENCE = 60000; // ms, for one thing
export const TEST_LIMIT = 180000; // ms, for a test of several

export const page_folder = join(here, "../../../app/serve/page");
export const require_module = createRequire(join(work, "package.json"));
// A module of the page, for tests of its own.
export const page_module = (name) => import(pathToFileURL(join(work, "page", name)).href);

let browser = null;

export async function the_browser() {
  if (!browser) {
    browser = await require_module("playwright-core").chromium.launch({
      executablePath: process.env.PABD_CHROMIUM,
      args: [
        ...(process.getuid() === 0 ? ["--no-sandbox"] : []), // it refuses to run as root otherwise
        "--disable-dev-shm-usage",
        "--force-color-profile=srgb",
      ],
    });
  }
  return browser;
}

export async function close_browser() {
  await browser?.close();
  browser = null;
}

// A page of its own visitor. Its complaints() are errors of scripts and of the console and what the
// Content-Security-Policy refused; close() fails for any that `expected` does not name.
export async function visitor(url, { size = [1280, 720], expected = [], init, ...options } = {}) {
  const context = await (await the_browser()).newContext({
    viewport: { width: size[0], height: size[1] },
    acceptDownloads: true,
    ...options,
  });
  context.setDefaultTimeout(PATIENCE);
  const page = await context.newPage();
  const complaints = [];
  page.on("pageerror", (error) => complaints.push("exception: " + (error.stack ?? error.message)));
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning") complaints.push("console: " + message.text());
  });
  await page.exposeFunction("tell_of_violation", (text) => complaints.push("policy: " + text));
  await page.addInitScript(() => {
    addEventListener("securitypolicyviolation", (event) =>
      window.tell_of_violation(`${event.violatedDirective} ${event.blockedURI}`),
    );
  });
  if (init) await page.addInitScript(init);
  await page.goto(url);
  page.expect_complaint = (pattern) => expected.push(pattern);
  page.close_visitor = async () => {
    await context.close();
    const unexpected = complaints.filter((text) => !expected.some((pattern) => pattern.test(text)));
    assert.deepEqual(unexpected, []);
  };
  return page;
}

// test(name, with_visitor(…)): the visitor leaves whatever happens, and his complaints count.
export async function with_visitor(url, options, act) {
  const page = await visitor(url, options);
  let done = false;
  try {
    await act(page);
    done = true;
  } finally {
    await page.close_visitor().catch((error) => {
      if (done) throw error;
      console.error(error.message);
    });
  }
}

// What the page says of itself: state, role, frame, codec.
export const page_data = (page) => page.evaluate(() => ({ ...document.documentElement.dataset }));
export const state_of = (page) => page.evaluate(() => document.documentElement.dataset.state);
export const wait_state = (page, state, timeout = PATIENCE) =>
  page.waitForFunction((wanted) => document.documentElement.dataset.state === wanted, state, { timeout, polling: 50 });
export const wait_role = (page, role, timeout = PATIENCE) =>
  page.waitForFunction((wanted) => document.documentElement.dataset.role === wanted, role, { timeout, polling: 50 });
export const shown_frame = (page) => page.evaluate(() => Number(document.documentElement.dataset.frame ?? 0));
export const wait_frame = (page, least, timeout = PATIENCE) =>
  page.waitForFunction((n) => Number(document.documentElement.dataset.frame ?? 0) >= n, least, { timeout, polling: 50 });

// Reads the canvas of the page through a copy, so that its own stays where the browser likes it: read(x, y, w, h).
const copy_of_canvas = `(() => {
  const canvas = document.getElementById("picture");
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  return copy;
})()`;

// [r, g, b] of a pixel of the canvas.
export const pixel = (page, x, y) =>
  page.evaluate(`[...${copy_of_canvas}.getImageData(${x}, ${y}, 1, 1).data.slice(0, 3)]`);

// Mean difference of the canvas from what it was at remember(), 0 … 255, over a rectangle.
export const remember = (page) => page.evaluate(`{ window.remembered = ${copy_of_canvas}; }`);
export const difference = (page, x, y, w, h) =>
  page.evaluate(`{
    const now = ${copy_of_canvas}.getImageData(${x}, ${y}, ${w}, ${h}).data;
    const before = window.remembered.getImageData(${x}, ${y}, ${w}, ${h}).data;
    now.reduce((sum, value, k) => sum + Math.abs(value - before[k]), 0) / (0.75 * now.length);
  }`);

export const canvas_size = (page) =>
  page.evaluate(() => [document.getElementById("picture").width, document.getElementById("picture").height]);

// The stage on the page, CSS pixels.
export const stage = (page) =>
  page.evaluate(() => {
    const box = document.getElementById("stage").getBoundingClientRect();
    return { x: box.x, y: box.y, w: box.width, h: box.height };
  });

export async function until(what, holds, limit = PATIENCE) {
  const end = Date.now() + limit;
  for (;;) {
    const value = await holds();
    if (value) return value;
    if (Date.now() > end) throw new Error("waited in vain: " + what);
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
}
