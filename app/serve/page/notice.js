// SPDX-License-Identifier: MIT
// What the page says about the connection: a card over the picture, which stays, dimmed.

import { by_id } from "./dom.js";
import { forget_key, keep_key, key_in } from "./token.js";

const WORDS = {
  no_key: [
    "This page needs its link",
    "Open the whole line that “pabd serve” printed: what comes after # is the key. Or paste it here.",
  ],
  refused: ["The key was refused", "It does not belong to this server, or not any more. Paste the line that “pabd serve” printed last."],
  gone: ["The session has ended", "The server was started again and has a new link. Paste the line that it printed."],
  left: ["The connection was ended", "The session was ended by the server."],
  version: ["Another version", "The page and the server do not speak the same language: reload the page."],
  malformed: ["The server did not understand this page", "Reload the page."],
};
const NEEDS_KEY = new Set(["refused", "gone"]);

const sentence = (text) => (text ? text[0].toUpperCase() + text.slice(1).replace(/\.$/, "") + "." : "");

export class Notice {
  #link;
  #timer = 0;

  // use_key(key): connects with another one.
  constructor(link, use_key) {
    this.#link = link;
    by_id("key-form").addEventListener("submit", (event) => {
      event.preventDefault();
      const key = key_in(by_id("key").value);
      by_id("key-wrong").textContent = key === "" ? "There is no key of 32 hexadecimal digits in it." : "";
      if (key === "") return;
      by_id("key").value = "";
      keep_key(key);
      use_key(key);
    });
    by_id("now").addEventListener("click", () => {
      if (link.state !== "ended") link.retry_now();
      else if (link.reason === "left") link.restart();
      else location.reload();
    });
  }

  // has_picture: there is something behind it to dim.
  show(has_picture) {
    clearInterval(this.#timer);
    const { state, reason } = this.#link;
    document.documentElement.dataset.state = state;
    by_id("notice").hidden = state === "open";
    by_id("veil").hidden = state === "open" || !has_picture;
    if (state === "open") return this.#say("Connected");
    if (state === "ended") return this.#ended(reason);
    if (state === "silent") return this.#write(["No answer from the server", "Waiting for it to go on."], { spins: true });
    if (state === "connecting") return this.#write(["Connecting", ""], { spins: true });
    this.#count();
    this.#timer = setInterval(() => this.#count(), 250);
  }

  no_key() {
    document.documentElement.dataset.state = "ended";
    by_id("notice").hidden = false;
    this.#write(WORDS.no_key, { asks: true });
  }

  #ended(reason) {
    const [title, text] = WORDS[reason] ?? WORDS.malformed;
    const asks = NEEDS_KEY.has(reason);
    if (asks) forget_key();
    const now = asks ? "" : reason === "left" ? "Connect again" : "Reload";
    const why = reason === "gone" ? "" : sentence(this.#link.detail);
    this.#write([title, reason === "left" ? why || text : reason === "malformed" ? `${why} ${text}` : text], { asks, now });
  }

  #count() {
    const seconds = Math.ceil((this.#link.retry_at - performance.now()) / 1000);
    const lost = this.#link.detail ? sentence(this.#link.detail) + " " : "";
    const next = seconds > 0 ? `Connecting again in ${seconds} s.` : "Connecting again.";
    this.#write(["The connection was lost", lost + next], { spins: seconds <= 0, now: "Try now" });
  }

  #write([title, text], { asks = false, spins = false, now = "" } = {}) {
    if (by_id("notice-title").textContent !== title) this.#say(title);
    by_id("notice-title").textContent = title;
    by_id("notice-text").textContent = text;
    by_id("spinner").hidden = !spins;
    by_id("now").hidden = now === "";
    by_id("now").textContent = now;
    const was_hidden = by_id("key-form").hidden;
    by_id("key-form").hidden = !asks;
    if (asks && was_hidden) by_id("key").focus();
  }

  #say(text) {
    by_id("say").textContent = text;
  }
}
