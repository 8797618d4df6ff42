// SPDX-License-Identifier: MIT
// Short notes at the edge of the page.

import { el, icon } from "./dom.js";

const SHOWN_FOR = 5000; // ms
const MOST = 4;

// toasts(place)(text, {action, act, bad, stay, progress}) -> {close(), progress(0…1)}
export function toasts(place) {
  return (text, { action = "", act = () => {}, bad = false, stay = false, progress = false } = {}) => {
    const bar = progress ? el("progress", { max: 1, value: 0, "aria-label": text }) : null;
    const shut = el("button", { type: "button", class: "plain", "aria-label": "Dismiss" }, [icon("close")]);
    const note = el("div", { class: bad ? "toast bad" : "toast" }, [el("span", { text })]);
    if (bar) note.append(bar);
    const close = () => note.remove();
    if (action !== "") {
      const button = el("button", { type: "button", class: "small", text: action });
      button.addEventListener("click", () => {
        act();
        close();
      });
      note.append(button);
    }
    shut.addEventListener("click", close);
    note.append(shut);
    while (place.children.length >= MOST) place.firstElementChild.remove();
    place.append(note);
    if (!stay) setTimeout(close, bad ? 2 * SHOWN_FOR : SHOWN_FOR);
    return {
      close,
      progress: (done) => {
        if (bar) bar.value = done;
      },
    };
  };
}
