// SPDX-License-Identifier: MIT
// A running `pabd serve`.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { until } from "./support.mjs";

export class Server {
  #child = null;
  #said = "";
  link = "";
  watch = "";

  // args: of `pabd serve`. Its settings are in a folder of their own.
  async start(...args) {
    this.folder = mkdtempSync(join(tmpdir(), "pabd-browser-"));
    const env = { ...process.env, XDG_CONFIG_HOME: this.folder, XDG_CACHE_HOME: this.folder };
    this.#child = spawn(process.env.PABD_PROGRAM, ["serve", ...args], { env, stdio: ["ignore", "pipe", "pipe"] });
    const hear = (data) => (this.#said += data.toString());
    this.#child.stdout.on("data", hear);
    this.#child.stderr.on("data", hear);
    this.ended = new Promise((resolve) => this.#child.on("exit", (code, signal) => resolve(code ?? signal)));
    await until("the link", () => /#k=[0-9a-f]{32}[^]*open the link/.test(this.#said));
    const links = this.#said.match(/https?:\/\/\S+#k=[0-9a-f]{32}/g);
    [this.link, this.watch] = links;
    this.url = this.link.split("#")[0];
    this.port = Number(new URL(this.url).port);
    this.key = this.link.split("#k=")[1];
    return this;
  }

  get said() {
    return this.#said;
  }

  signal(name) {
    this.#child.kill(name);
  }

  async stop(name = "SIGTERM") {
    this.signal("SIGCONT");
    this.signal(name);
    const code = await this.ended;
    rmSync(this.folder, { recursive: true, force: true });
    return code;
  }

  request(path, { method = "GET", key = this.key, body, session } = {}) {
    const headers = { Authorization: "Bearer " + key, ...(session ? { "Pabd-Session": session } : {}) };
    return fetch(new URL(path, this.url), { method, body, headers });
  }

  // session: with --sessions, whose.
  async state(session) {
    const answer = await this.request("state", { session });
    if (!answer.ok) throw new Error(`GET /state: ${answer.status} ${await answer.text()}`);
    return answer.json();
  }

  // A script; fails if it is refused.
  async act(...actions) {
    const answer = await this.request("actions", { method: "POST", body: JSON.stringify(actions) });
    const said = await answer.text();
    if (!answer.ok) throw new Error(`POST /actions: ${answer.status} ${said}`);
    return JSON.parse(said);
  }
}
