// SPDX-License-Identifier: MIT
// Files of the session: the list, downloads and uploads. The key goes into the header of the request, never into an
// address.

import { bytes_text, el, icon } from "./dom.js";

const OPENS = /\.(json|pabdrec|rec)$/i; // scenes and recordings; meshes only lie beside them
const LARGEST = 64 * 1024 * 1024;
const LATE = 1000; // ms that the server may take to tell of what came from here

export class Files {
  #key;
  #list;
  #toast;
  #open;
  #may_upload = () => false;
  #known = new Map(); // name -> bytes
  #saved = new Set(); // said by the server to have been saved
  #uploading = new Set(); // from here, now or just before: no news should the server tell of them

  session = ""; // with `--sessions`: whose files

  // key(): the bearer's; open(name): opens what was uploaded.
  constructor({ key, list, toast, open, may_upload }) {
    this.#key = key;
    this.#list = list;
    this.#toast = toast;
    this.#open = open;
    this.#may_upload = may_upload;
  }

  #headers() {
    const session = this.session ? { "Pabd-Session": this.session } : {};
    return { Authorization: "Bearer " + this.#key(), ...session };
  }

  static url(name) {
    return new URL("files/" + encodeURIComponent(name), location.href.split(/[?#]/)[0]);
  }

  // {"t": "file"}: the window saved one.
  saved(name, bytes) {
    this.#known.set(name, bytes);
    if (!this.#uploading.delete(name)) this.#offer(name, bytes);
    this.#draw();
  }

  #offer(name, bytes) {
    this.#saved.add(name);
    this.#toast(`Saved ${name}, ${bytes_text(bytes)}`, { action: "Download", act: () => this.download(name), stay: true });
  }

  async refresh() {
    try {
      const answer = await fetch(new URL("files", location.href), { headers: this.#headers() });
      if (!answer.ok) throw new Error(await error_of(answer));
      const listed = await answer.json();
      this.#known.clear();
      for (const { name, bytes } of listed.files ?? listed) this.#known.set(name, bytes);
    } catch (error) {
      this.#toast("The list of files did not come: " + error.message, { bad: true });
    }
    this.#draw();
  }

  async download(name) {
    await this.#download(Files.url(name), name);
  }

  // What the window shows now, as PNG.
  async picture(width, height, name) {
    const url = new URL("frame.png", location.href.split(/[?#]/)[0]);
    url.search = new URLSearchParams({ width, height }).toString();
    await this.#download(url, name);
  }

  async #download(url, name) {
    try {
      const answer = await fetch(url, { headers: this.#headers() });
      if (!answer.ok) throw new Error(await error_of(answer));
      const blob_url = URL.createObjectURL(await answer.blob());
      const link = el("a", { href: blob_url, download: name, class: "unseen" });
      document.body.append(link);
      link.click();
      link.remove();
      setTimeout(() => URL.revokeObjectURL(blob_url), 60000);
    } catch (error) {
      this.#toast(`${name} was not downloaded: ${error.message}`, { bad: true });
    }
  }

  // Meshes first, so that they are there when the scene is opened.
  async upload(files) {
    if (!this.#may_upload()) {
      this.#toast("Only who controls the session can upload", { bad: true });
      return;
    }
    const ordered = [...files].sort((a, b) => OPENS.test(a.name) - OPENS.test(b.name));
    let last = "";
    for (const file of ordered) {
      if (!(await this.#put(file))) return;
      if (OPENS.test(file.name)) last = file.name;
    }
    if (last !== "") this.#open(last);
    await this.refresh();
  }

  #put(file) {
    if (file.size > LARGEST) {
      this.#toast(`${file.name} has ${bytes_text(file.size)}: the most is ${bytes_text(LARGEST)}`, { bad: true });
      return Promise.resolve(false);
    }
    this.#uploading.add(file.name);
    const note = this.#toast(`Uploading ${file.name}`, { progress: true, stay: true });
    return new Promise((resolve) => {
      const request = new XMLHttpRequest(); // fetch tells nothing of the progress of an upload
      request.open("PUT", Files.url(file.name));
      for (const [name, value] of Object.entries(this.#headers())) request.setRequestHeader(name, value);
      request.setRequestHeader("Content-Type", "application/octet-stream");
      request.upload.onprogress = (event) => note.progress(event.loaded / Math.max(1, event.total));
      request.onload = () => {
        note.close();
        if (request.status >= 200 && request.status < 300) {
          this.#toast(`Uploaded ${file.name}, ${bytes_text(file.size)}`);
          setTimeout(() => this.#uploading.delete(file.name), LATE);
          return resolve(true);
        }
        this.#uploading.delete(file.name);
        let why = "status " + request.status;
        try {
          why = JSON.parse(request.responseText).error ?? why;
        } catch {
          // not JSON: the status says enough
        }
        this.#toast(`${file.name} was not uploaded: ${why}`, { bad: true });
        resolve(false);
      };
      request.onerror = () => {
        note.close();
        this.#uploading.delete(file.name);
        this.#toast(`${file.name} was not uploaded: the connection broke`, { bad: true });
        resolve(false);
      };
      request.send(file);
    });
  }

  #draw() {
    const names = [...this.#known.keys()].sort((a, b) => this.#saved.has(b) - this.#saved.has(a) || a.localeCompare(b));
    this.#list.replaceChildren(
      ...names.map((name) => {
        const buttons = [];
        if (this.#may_upload() && OPENS.test(name)) {
          const button = el("button", { type: "button", class: "small", text: "Open", "aria-label": "Open " + name });
          button.addEventListener("click", () => this.#open(name));
          buttons.push(button);
        }
        const get = el("button", { type: "button", class: "small", "aria-label": "Download " + name, title: "Download" }, [
          icon("download"),
        ]);
        get.addEventListener("click", () => this.download(name));
        buttons.push(get);
        return el("li", {}, [
          el("span", { class: "name", text: name, title: name }),
          el("span", { class: "size", text: bytes_text(this.#known.get(name)) }),
          ...buttons,
        ]);
      }),
    );
    if (names.length === 0) this.#list.append(el("li", { class: "none", text: "No files yet" }));
  }
}

async function error_of(answer) {
  try {
    return (await answer.json()).error ?? "status " + answer.status;
  } catch {
    return "status " + answer.status;
  }
}
