// SPDX-License-Identifier: MIT
// The key of the link and the identity of this tab. Both live in memory and in sessionStorage, nowhere else: the key
// is taken out of the address at once, so that neither a bookmark nor a shared screen carries it.

const KEY = "pabd.key";
const ID = "pabd.id";

function stored(name) {
  try {
    return sessionStorage.getItem(name) ?? "";
  } catch {
    return ""; // storage is refused to embedded pages by some browsers
  }
}

function store(name, value) {
  try {
    sessionStorage.setItem(name, value);
    return true;
  } catch {
    return false;
  }
}

function random_id() {
  return Array.from(crypto.getRandomValues(new Uint8Array(8)), (b) => b.toString(16).padStart(2, "0")).join("");
}

// The key in "http://…/#k=<32 hex>", "#k=…", "k=…" or by itself; "" when there is none.
export function key_in(text) {
  const found = /(?:^|[#&]|k=)([0-9a-f]{32})(?:$|[&\s])/i.exec(text.trim());
  return found ? found[1].toLowerCase() : "";
}

// The key that this tab has, from the address first.
export function take_key() {
  const fragment = new URLSearchParams(location.hash.slice(1));
  const given = key_in(fragment.get("k") ?? "");
  if (given === "") return stored(KEY);
  if (store(KEY, given)) {
    fragment.delete("k");
    const rest = fragment.toString();
    history.replaceState(history.state, "", location.pathname + location.search + (rest ? "#" + rest : ""));
  }
  return given;
}

export function keep_key(key) {
  store(KEY, key);
}

export function forget_key() {
  store(KEY, "");
}

// 16 hex digits by which the server knows this tab again. A duplicated tab copies its storage: the one that holds the
// lock keeps the name, the other takes a new one.
export async function take_id() {
  let id = stored(ID);
  if (!/^[0-9a-f]{16}$/.test(id)) id = random_id();
  if (navigator.locks && !(await locked(id))) {
    id = random_id();
    await locked(id);
  }
  store(ID, id);
  return id;
}

function locked(id) {
  return new Promise((resolve) => {
    navigator.locks
      .request("pabd-" + id, { ifAvailable: true }, (lock) => {
        resolve(lock !== null);
        return lock ? new Promise(() => {}) : undefined; // held until the tab ends
      })
      .catch(() => resolve(true));
  });
}
