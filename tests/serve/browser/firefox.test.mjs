// SPDX-License-Identifier: MIT
// The page in Firefox, through WebDriver BiDi: it loads, κ is dragged, the number and the pixels change, it comes back
// after its connection broke.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { connect, createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";

import { Server } from "./server.mjs";
import { TEST_LIMIT, difference, page_data, remember, require_module, until } from "./support.mjs";

const BAR = 35;
const HANDLE = [1036, 199]; // of κ, as in serve.test.mjs

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));
const skip =
  (!process.env.PABD_PROGRAM && "no program was named") || (!process.env.PABD_FIREFOX && "firefox-esr is missing");

// Between browser and server, to break what they have.
class Wire {
  #ends = new Set();
  to = 0; // the server's port
  async start() {
    this.server = createServer((near) => {
      const far = connect(this.to, "127.0.0.1");
      for (const end of [near, far]) {
        this.#ends.add(end);
        end.on("error", () => {});
        end.on("close", () => this.#ends.delete(end));
      }
      near.pipe(far).pipe(near);
    });
    await new Promise((done) => this.server.listen(0, "127.0.0.1", done));
    this.port = this.server.address().port;
    return this;
  }
  cut() {
    for (const end of this.#ends) end.destroy();
  }
  stop() {
    this.server.close();
    this.cut();
  }
}

test("Firefox: loads, drags κ, sees it change, comes back", { skip, timeout: TEST_LIMIT }, async () => {
  const wire = await new Wire().start();
  // The first name is in the link that is printed, and has the server's port.
  const server = await new Server().start("two_boxes", "--port", "0", "--host", "127.0.0.1", "--host", `127.0.0.1:${wire.port}`);
  wire.to = server.port;
  const profile = mkdtempSync(join(tmpdir(), "pabd-firefox-"));
  const browser = await require_module("puppeteer-core").launch({
    browser: "firefox",
    executablePath: process.env.PABD_FIREFOX,
    headless: true,
    userDataDir: profile,
  });
  try {
    const page = await browser.newPage();
    const complaints = [];
    page.on("pageerror", (error) => complaints.push(error.message));
    page.on("console", (message) => message.type() === "error" && complaints.push(message.text()));
    await page.setViewport({ width: 1280, height: 720 + BAR });
    await page.goto(server.link.replace(`:${server.port}/`, `:${wire.port}/`));
    await until("control", async () => (await page_data(page)).role === "control");
    await until("a frame", async () => Number((await page_data(page)).frame) > 0);
    const size = () => page.evaluate(() => [document.getElementById("picture").width, document.getElementById("picture").height].join());
    await until("the size", async () => (await size()) === "1280,720");

    await server.act({ do: "step", steps: 60 });
    const before = (await server.state()).a.kappa;
    await pause(600);
    await remember(page);
    const at = (x, y) => [x, BAR + y];
    await page.mouse.move(...at(...HANDLE));
    await pause(100);
    await page.mouse.down();
    await page.mouse.move(...at(HANDLE[0], HANDLE[1] + 24), { steps: 12 });
    await until("a smaller κ", async () => (await server.state()).a.kappa < 0.7 * before);
    await page.mouse.up();
    const kappa = (await server.state()).a.kappa;
    await pause(600);
    const changed = await difference(page, 904, 120, 364, 160); // the plot
    assert.ok(changed > 0.5, `the plot changed by ${changed} of 255`);

    wire.cut();
    await until("it is lost", async () => (await page_data(page)).state === "lost");
    await until("it is back", async () => (await page_data(page)).state === "open");
    await until("control again", async () => (await page_data(page)).role === "control");
    await page.keyboard.press("ArrowRight");
    await until("a step", async () => (await server.state()).a.step === 61);
    assert.equal((await server.state()).a.kappa, kappa);
    assert.deepEqual(complaints.filter((text) => !/connection to ws:.*(interrupted|can.t establish)/.test(text)), []);
  } finally {
    await browser.close();
    rmSync(profile, { recursive: true, force: true });
    await server.stop();
    wire.stop();
  }
});
