// SPDX-License-Identifier: MIT
// The bar, its cards, folding and full screen.

import { by_id, preferences } from "./dom.js";

const PEEK_EDGE = 4; // px from the top that bring the bar back in full screen
const PEEK_FOR = 1800; // ms

export class Bar {
  #back; // gives the focus to the picture
  #opened = {}; // card -> what to do when it opens
  #hide = 0;

  constructor(back) {
    this.#back = back;
    for (const button of document.querySelectorAll("[data-card]")) {
      button.setAttribute("aria-controls", button.dataset.card);
      button.addEventListener("click", () => this.toggle(button.dataset.card));
    }
    by_id("fold").addEventListener("click", () => {
      if (document.fullscreenElement) this.#peek(false);
      else this.fold(true);
      back();
    });
    by_id("unfold").addEventListener("click", () => {
      this.fold(false);
      this.#peek(true);
    });
    by_id("more").addEventListener("click", () => this.#more(!document.body.classList.contains("more")));
    this.#set_up_full_screen();
    document.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || event.target.closest?.("#stage")) return;
      this.close();
      this.#more(false);
      back();
    });
    // A click leaves the keyboard to the window: space after it plays.
    by_id("bar").addEventListener("click", (event) => {
      if (event.detail > 0) back();
    });
    // So does one in a card, but for what is written there.
    for (const card of document.querySelectorAll(".card")) {
      card.addEventListener("click", (event) => {
        if (event.detail > 0 && !event.target.closest("input[type=text], input[type=file]")) setTimeout(back);
      });
    }
    this.fold(preferences.get("folded", "no") === "yes");
  }

  on_open(card, act) {
    this.#opened[card] = act;
  }

  is_open(card) {
    return !by_id(card).hidden;
  }

  toggle(card) {
    const was_open = this.is_open(card);
    this.close();
    if (was_open) return this.#back();
    by_id(card).hidden = false;
    this.#button(card).setAttribute("aria-expanded", "true");
    this.#opened[card]?.();
  }

  // keep: a card that stays, because it is looked at while one works in the window.
  close(keep = "") {
    for (const card of document.querySelectorAll(".card")) {
      if (card.id === keep) continue;
      card.hidden = true;
      this.#button(card.id).setAttribute("aria-expanded", "false");
    }
  }

  // The picture was clicked.
  settle() {
    this.close("card-link");
    this.#more(false);
  }

  // By the keyboard: F6.
  enter() {
    this.fold(false);
    this.#peek(true);
    [...by_id("bar").querySelectorAll("button")].find((button) => button.offsetParent !== null)?.focus();
  }

  fold(folded) {
    document.body.classList.toggle("folded", folded);
    by_id("unfold").hidden = !folded && !document.fullscreenElement;
    if (folded) this.close("card-link");
    preferences.set("folded", folded ? "yes" : "no");
  }

  #button(card) {
    return document.querySelector(`[data-card="${card}"]`);
  }

  #more(shown) {
    document.body.classList.toggle("more", shown);
    by_id("more").setAttribute("aria-expanded", String(shown));
  }

  #peek(shown) {
    clearTimeout(this.#hide);
    document.body.classList.toggle("peek", shown);
    if (shown) this.#hide_later();
  }

  #hide_later() {
    clearTimeout(this.#hide);
    this.#hide = setTimeout(() => {
      const busy = by_id("bar").matches(":hover, :focus-within") || document.querySelector(".card:not([hidden]):hover");
      if (busy) this.#hide_later();
      else this.#peek(false);
    }, PEEK_FOR);
  }

  #set_up_full_screen() {
    const root = document.documentElement;
    const button = by_id("full");
    button.hidden = !document.fullscreenEnabled;
    button.addEventListener("click", async () => {
      if (document.fullscreenElement) {
        document.exitFullscreen();
        return;
      }
      try {
        await root.requestFullscreen({ navigationUI: "hide" });
        await navigator.keyboard?.lock?.(["Escape"]); // escape goes to the window; held down it leaves full screen
      } catch {
        // refused: the page stays as it is
      }
    });
    document.addEventListener("fullscreenchange", () => {
      const full = document.fullscreenElement !== null;
      if (!full) navigator.keyboard?.unlock?.();
      document.body.classList.toggle("full", full);
      button.setAttribute("aria-label", full ? "Leave full screen" : "Full screen");
      button.title = button.getAttribute("aria-label");
      if (full) document.body.classList.remove("folded");
      by_id("unfold").hidden = !full && !document.body.classList.contains("folded");
      this.#peek(full);
      this.#back();
    });
    document.addEventListener("pointermove", (event) => {
      if (document.fullscreenElement && event.pointerType !== "touch" && event.clientY < PEEK_EDGE && !event.buttons) {
        this.#peek(true);
      }
    });
  }
}
