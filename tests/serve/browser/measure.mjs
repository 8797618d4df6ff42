// SPDX-License-Identifier: MIT
// What a link bears: node measure.mjs LINK [seconds], after run.sh has installed the packages. A client that
// shows nothing and acknowledges at once moves the pointer, plays the scene, and prints the table of app/serve/README.md.
// No test: times depend on the machine.
import { join } from "node:path";
import { createRequire } from "node:module";

import { parse_frame } from "../../../app/serve/page/protocol.js";

const [link, seconds = "15"] = process.argv.slice(2);
if (!link || !process.env.PABD_BROWSER_WORK) {
  console.error("PABD_BROWSER_WORK=FOLDER node measure.mjs LINK [seconds]");
  process.exit(2);
}
const { WebSocket } = createRequire(join(process.env.PABD_BROWSER_WORK, "package.json"))("ws");

const SIZE = [1280, 720];
const MOVE_EVERY = 25; // ms
const [base, token] = link.split("#k=");
const url = new URL("socket", base);
url.protocol = url.protocol.replace("http", "ws");
const socket = new WebSocket(url, "pabd.1", { origin: new URL(base).origin });
socket.binaryType = "arraybuffer";
const say = (message) => socket.send(JSON.stringify(message));
const now = () => performance.now();

const sent = new Map(); // stamp -> when
const seen = { latency: [], draw: [], encode: [], frames: 0, bytes: 0 };
let stamp = 0;
let from = Infinity; // the first seconds do not count

function hear(part) {
  const counts = now() > from;
  if (part.last) say({ t: "ack", frame: part.frame, shown_ms: 0 });
  if (!counts) return;
  seen.bytes += part.bytes;
  if (!part.last) return;
  seen.frames += 1;
  seen.draw.push(part.draw_ms);
  seen.encode.push(part.encode_ms);
  for (const [known, when] of sent) {
    if (known > part.stamp) break;
    seen.latency.push(now() - when);
    sent.delete(known);
  }
}

const of = (list, share) => [...list].sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(share * list.length))];
const both = (list) => `${of(list, 0.5)?.toFixed(1)} and ${of(list, 0.99)?.toFixed(1)} ms`;

socket.on("error", (error) => {
  console.error(error.message);
  process.exit(1);
});
socket.on("open", () => {
  say({ t: "hello", token, id: "6d65617375726521", size: SIZE, scale: 1 });
  const play = [{ do: "play" }];
  setTimeout(() => say({ t: "script", actions: play }), 1000);
  setTimeout(() => (from = now()), 4000);
  setInterval(() => {
    stamp += 1;
    if (now() > from) sent.set(stamp, now());
    const angle = stamp / 20;
    say({ t: "move", x: 640 + 200 * Math.cos(angle), y: 360 + 150 * Math.sin(angle), mods: 0, s: stamp });
  }, MOVE_EVERY);
  setTimeout(
    () => {
      const span = (now() - from) / 1000;
      console.log(`frames a second       ${(seen.frames / span).toFixed(1)}`);
      console.log(`input to its frame    ${both(seen.latency)} (p50, p99 of ${seen.latency.length})`);
      console.log(`drawing a frame       ${both(seen.draw)}`);
      console.log(`encoding a frame      ${both(seen.encode)}`);
      console.log(`a frame               ${(seen.bytes / seen.frames / 1000).toFixed(1)} kB`);
      console.log(`rate                  ${((8 * seen.bytes) / span / 1e6).toFixed(2)} Mbit/s`);
      process.exit(0);
    },
    4000 + 1000 * Number(seconds),
  );
});
socket.on("close", (code, reason) => {
  console.error(`closed: ${code} ${reason}`);
  process.exit(1);
});
socket.on("message", (data, binary) => {
  if (binary) hear(parse_frame(data));
});
