// SPDX-License-Identifier: MIT
// H.264 by WebCodecs, where the browser has it (nowhere but on https and localhost): access units in Annex B, no
// reordering, so that each one gives its picture at once.

// The name of the codec, "avc1.42C01F", from the sequence parameters in an access unit; "" when it has none.
export function codec_of(unit) {
  for (let k = 0; k + 7 < unit.length; ++k) {
    if (unit[k] !== 0 || unit[k + 1] !== 0 || unit[k + 2] !== 1) continue;
    if ((unit[k + 3] & 31) !== 7) continue;
    const hex = (byte) => byte.toString(16).padStart(2, "0").toUpperCase();
    return "avc1." + hex(unit[k + 4]) + hex(unit[k + 5]) + hex(unit[k + 6]);
  }
  return "";
}

export async function video_works() {
  if (typeof VideoDecoder === "undefined") return false;
  try {
    const answer = await VideoDecoder.isConfigSupported({ codec: "avc1.42C028", optimizeForLatency: true });
    return answer.supported === true;
  } catch {
    return false;
  }
}

export class VideoPart {
  #decoder = null;
  #codec = "";
  #waiting = []; // {resolve, reject} in the order of the units
  #units = 0;

  // The picture of one access unit, a VideoFrame.
  decode(part) {
    const codec = part.key ? codec_of(part.payload) : "";
    if (codec !== "" && codec !== this.#codec) this.#open(codec);
    if (!this.#decoder || this.#decoder.state !== "configured") return Promise.reject(new Error("no key frame yet"));
    return new Promise((resolve, reject) => {
      this.#waiting.push({ resolve, reject });
      this.#decoder.decode(
        new EncodedVideoChunk({ type: part.key ? "key" : "delta", timestamp: 1000 * ++this.#units, data: part.payload }),
      );
    });
  }

  close() {
    if (this.#decoder && this.#decoder.state !== "closed") this.#decoder.close();
    this.#decoder = null;
    this.#codec = "";
    for (const { reject } of this.#waiting.splice(0)) reject(new Error("closed"));
  }

  #open(codec) {
    this.close();
    this.#codec = codec;
    this.#decoder = new VideoDecoder({
      output: (frame) => {
        const next = this.#waiting.shift();
        if (next) next.resolve(frame);
        else frame.close();
      },
      error: () => this.close(),
    });
    this.#decoder.configure({ codec, optimizeForLatency: true });
  }
}
