// SPDX-License-Identifier: MIT
// Who controls, who watches, and the link for those who only watch.

import { by_id, copy } from "./dom.js";

export class People {
  #link;
  #toast;
  #request = null; // the note that somebody asks
  #watch_key = "";
  #may_control = true; // by the key that was given

  role = "";

  constructor(link, toast) {
    this.#link = link;
    this.#toast = toast;
    const ask = () => {
      link.send({ t: "ask_control" });
      toast("Asked for control");
    };
    by_id("ask").addEventListener("click", ask);
    by_id("ask-control").addEventListener("click", ask);
    by_id("give-control").addEventListener("click", () => this.#give());
    by_id("copy-watch").addEventListener("click", async () => {
      const field = by_id("watch-link");
      if (await copy(field.value)) toast("Copied the link for watchers");
      else field.select();
    });
  }

  get controls() {
    return this.role === "control";
  }

  // The messages "welcome" and "role".
  told({ role, visitors, asks, watch, may_control }) {
    const before = this.role;
    this.role = role;
    if (may_control !== undefined) this.#may_control = may_control;
    if (watch) this.#watch_key = watch;
    document.documentElement.dataset.role = role;
    const control = role === "control";
    const others = Math.max(0, visitors - 1);
    by_id("visitors").textContent = `${visitors}`;
    by_id("role").textContent = control ? "You control" : "Watching";
    by_id("role").hidden = control && others === 0;
    by_id("ask").hidden = control || !this.#may_control;
    by_id("ask-control").hidden = control || !this.#may_control;
    by_id("give-control").hidden = !control || others === 0;
    by_id("who").textContent =
      (control ? "You control the session" : "You watch") +
      (others === 0 ? " and are alone." : `; ${others} other${others === 1 ? " is" : "s are"} here.`);
    by_id("watch-part").hidden = this.#watch_key === "";
    by_id("watch-link").value = location.href.split(/[?#]/)[0] + "#k=" + this.#watch_key;
    if (before !== "" && before !== role) this.#toast(control ? "You control now" : "Another visitor controls now");
    this.#asked(control && asks === true);
  }

  #asked(asks) {
    this.#request?.close();
    this.#request = null;
    if (!asks) return;
    this.#request = this.#toast("Another visitor asks for control", { action: "Give", act: () => this.#give(), stay: true });
  }

  #give() {
    this.#link.send({ t: "give_control" });
  }
}
