// SPDX-License-Identifier: MIT
// The page of `pabd serve`: puts its parts together. Each part is a module of its own and says what it does.

import { Bar } from "./bar.js";
import { by_id, copy, preferences } from "./dom.js";
import { Files } from "./files.js";
import { Keyboard } from "./keyboard.js";
import { Link } from "./link.js";
import { Notice } from "./notice.js";
import { People } from "./people.js";
import { Picture } from "./picture.js";
import { Pointer } from "./pointer.js";
import { LARGEST_SCALE, LEAST_SCALE, MODIFIER, clamp, window_for } from "./protocol.js";
import { Statistics } from "./statistics.js";
import { toasts } from "./toasts.js";
import { take_id, take_key } from "./token.js";

const NARROW = 480; // CSS pixels: the window's text becomes smaller there, as its panels have a least width
const CURSORS = {
  arrow: "default",
  hand: "pointer",
  ibeam: "text",
  cross: "crosshair",
  resize_ew: "ew-resize",
  resize_ns: "ns-resize",
};

let key = take_key();
const id = await take_id();

const prefers_dark = () => !matchMedia("(prefers-color-scheme: light)").matches;

const canvas = by_id("picture");
const toast = toasts(by_id("toasts"));
const picture = new Picture(canvas);
const statistics = new Statistics(by_id("readout"));
const link = new Link(() => ({ token: key, size: window_size(), scale: window_scale(), id, dark: prefers_dark() }));
const people = new People(link, toast);
const input = (message) => {
  if (people.controls) link.input(message);
};
const pointer = new Pointer(canvas, picture, input);
const keyboard = new Keyboard(canvas, by_id("text"), input);
const bar = new Bar(() => keyboard.focus());
const notice = new Notice(link, (given) => {
  key = given;
  link.restart();
});
const files = new Files({
  key: () => key,
  list: by_id("file-list"),
  toast,
  open: (name) => link.send({ t: "open", name }),
  may_upload: () => people.controls,
});

// ---- size

let box = window_for(1, 1); // the window that suits the stage's device pixels
let text_size = Number(preferences.get("text_size", "0")) || 0; // 0: by the width of the page

function window_size() {
  return box.size;
}

const text_scale = () => text_size || (innerWidth < NARROW ? 0.8 : 1);

function window_scale() {
  const scale = devicePixelRatio * box.share * text_scale();
  return clamp(Math.round(1000 * scale) / 1000, LEAST_SCALE, LARGEST_SCALE);
}

let resize_due = 0;
function resized(entries) {
  const entry = entries?.[0];
  const exact = entry?.devicePixelContentBoxSize?.[0];
  const stage = by_id("stage").getBoundingClientRect();
  const by_ratio = [stage.width, stage.height].map((length) => Math.round(length * devicePixelRatio));
  // Exact where it can be that: emulated screens tell CSS pixels there.
  const told = exact ? [exact.inlineSize, exact.blockSize] : by_ratio;
  const exact_enough = told.every((length, k) => Math.abs(length - by_ratio[k]) <= 2);
  box = window_for(...(exact_enough ? told : by_ratio));
  if (people.controls || people.role === "") picture.asked_for(...box.size);
  cancelAnimationFrame(resize_due);
  resize_due = requestAnimationFrame(tell_size);
}

function tell_size() {
  by_id("size-now").textContent = `${Math.round(100 * text_scale())} %`;
  link.send({ t: "size", size: window_size(), scale: window_scale() });
}

const observer = new ResizeObserver(resized);
try {
  observer.observe(canvas, { box: "device-pixel-content-box" });
} catch {
  observer.observe(canvas);
}
addEventListener("resize", () => tell_size()); // another pixel ratio alone changes no box

for (const [button, step] of [
  ["smaller", -0.1],
  ["larger", 0.1],
]) {
  by_id(button).addEventListener("click", () => {
    text_size = clamp(Math.round(10 * (text_scale() + step)) / 10, 0.5, 2);
    preferences.set("text_size", String(text_size));
    tell_size();
  });
}

// ---- frames

link.addEventListener("frame", (event) => picture.add(event.detail));
picture.on_shown = (frame) => {
  link.send({ t: "ack", frame: frame.frame, shown_ms: Math.round(10 * (frame.shown - frame.arrived)) / 10 });
  const sent = link.take_stamp(frame.stamp);
  // The lossless frame comes after the picture has come to rest: it shows no input for the first time.
  statistics.shown(frame, sent !== undefined && !frame.lossless ? frame.shown - sent : undefined);
  Object.assign(document.documentElement.dataset, { frame: frame.frame, codec: frame.codec });
};
picture.on_broken = () => tell_size(); // the server answers with a whole frame
setInterval(() => statistics.tick(link.rtt, bar.is_open("card-link")), 1000);
bar.on_open("card-link", () => statistics.tick(link.rtt, true));
by_id("quality").addEventListener("change", (event) => {
  link.send({ t: "quality", mode: event.target.value });
  preferences.set("quality", event.target.value);
});

// ---- messages

const on_message = {
  welcome(message) {
    by_id("scene").textContent = message.scene || "pabd";
    document.title = message.scene ? `${message.scene} – pabd` : "pabd";
    by_id("version").textContent = message.version ? `pabd ${message.version}` : "";
    files.session = message.session ?? "";
    on_message.role(message);
    const mode = preferences.get("quality", "auto");
    const choice = document.querySelector(`#quality input[value="${CSS.escape(mode)}"]`);
    if (choice) choice.checked = true;
    if (choice && mode !== "auto") link.send({ t: "quality", mode });
    tell_size();
  },
  role(message) {
    people.told(message);
    picture.asked_for(...(people.controls ? box.size : [0, 0]));
    by_id("pick").hidden = !people.controls;
    by_id("files-hint").hidden = !people.controls;
    for (const button of document.querySelectorAll("#play, #panels, #keyboard, [data-key]")) {
      button.disabled = !people.controls;
    }
    if (!people.controls) canvas.style.cursor = "default";
  },
  cursor(message) {
    if (people.controls) canvas.style.cursor = CURSORS[message.cursor] ?? "default";
  },
  async clipboard({ text }) {
    if (typeof text !== "string") return;
    if (document.hasFocus() && (await copied(text))) toast("Copied");
    else show_copy_box(text);
  },
  file: ({ name, bytes }) => files.saved(String(name), bytes),
  scene({ scene }) {
    by_id("scene").textContent = scene;
    document.title = `${scene} – pabd`;
  },
  // The window's own theme is the page's: bar and panels are one.
  scheme({ dark }) {
    document.documentElement.dataset.scheme = dark ? "dark" : "light";
    const { backgroundColor } = getComputedStyle(by_id("bar"));
    for (const meta of document.querySelectorAll("meta[name=theme-color]")) meta.content = backgroundColor;
  },
  text_input: ({ on }) => people.controls && keyboard.text_input(on === true),
  stats: (message) => statistics.told(message),
  error: ({ text }) => toast(String(text), { bad: true }),
};

link.addEventListener("message", (event) => on_message[event.detail.t]?.(event.detail));
link.addEventListener("state", () => {
  if (link.state !== "open" && link.state !== "silent") {
    picture.reset();
    pointer.release();
  }
  notice.show(picture.has_picture);
  if (link.state === "open" && !document.activeElement?.closest?.("#bar, .card")) keyboard.focus();
});

// ---- clipboard

async function copied(text) {
  if (!navigator.clipboard || !navigator.userActivation?.isActive) return false;
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

function show_copy_box(text) {
  by_id("copy-text").value = text;
  by_id("copy-box").hidden = false;
  by_id("copy-now").focus();
}

function close_copy_box() {
  by_id("copy-box").hidden = true;
  keyboard.focus();
}

by_id("copy-now").addEventListener("click", async () => {
  if (await copy(by_id("copy-text").value)) {
    close_copy_box();
    toast("Copied");
  } else {
    by_id("copy-text").select();
  }
});
by_id("copy-close").addEventListener("click", close_copy_box);
by_id("copy-box").addEventListener("keydown", (event) => {
  if (event.key === "Escape") close_copy_box();
});

// ---- focus

pointer.before_press = () => {
  keyboard.focus();
  bar.settle();
};
keyboard.to_bar = () => bar.enter();
keyboard.on_refused = (why) => toast(why, { bad: true });
for (const away of ["blur", "pagehide"]) {
  addEventListener(away, () => {
    pointer.release();
    keyboard.release();
  });
}

// ---- buttons that press keys

by_id("play").addEventListener("click", () => keyboard.press("space"));
by_id("panels").addEventListener("click", () => keyboard.press("tab"));
by_id("keyboard").addEventListener("click", () => keyboard.show());
for (const button of document.querySelectorAll("[data-key]")) {
  button.addEventListener("click", () => {
    const name = button.dataset.key;
    const ctrl = name.startsWith("ctrl+");
    keyboard.press(ctrl ? name.slice(5) : name, ctrl ? MODIFIER.ctrl : 0);
    bar.close();
    keyboard.focus();
  });
}

// ---- files

bar.on_open("card-files", () => files.refresh());
by_id("pick").addEventListener("click", () => by_id("picker").click());
by_id("picker").addEventListener("change", (event) => {
  files.upload(event.target.files).then(() => (event.target.value = ""));
});
by_id("grab").addEventListener("click", () => {
  const [width, height] = [canvas.width, canvas.height];
  files.picture(width, height, `${by_id("scene").textContent.replace(/[^\w.-]+/g, "_")}.png`);
});
const has_files = (event) => event.dataTransfer?.types.includes("Files");
let over = 0;
addEventListener("dragenter", (event) => {
  if (!has_files(event)) return;
  over += 1;
  by_id("drop").hidden = !people.controls;
});
addEventListener("dragover", (event) => {
  if (has_files(event)) event.preventDefault();
});
addEventListener("dragleave", (event) => {
  if (has_files(event)) over = Math.max(0, over - 1);
  by_id("drop").hidden = over === 0;
});
addEventListener("drop", (event) => {
  if (!has_files(event)) return;
  event.preventDefault(); // else the browser would leave the page for the file
  over = 0;
  by_id("drop").hidden = true;
  files.upload(event.dataTransfer.files);
});

// ---- begin

resized();
notice.show(false);
if (key === "") notice.no_key();
else link.start();
