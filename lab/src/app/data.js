// What the command laid into the page: facts about the model, and what is to be shown.

/** @param {string} id of a script element that holds JSON; its value, or null where it holds none */
export function jsonOf(id) {
  const text = document.getElementById(id)?.textContent;
  if (!text) return null;
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}

export const readFacts = () => jsonOf("facts");

/** What is to be shown, or a word on what is wrong with it. */
export function readPayload() {
  const element = document.getElementById("payload");
  const payload = jsonOf("payload");
  if (payload && typeof payload === "object" && typeof payload.kind === "string") return payload;
  return element?.textContent ? { kind: "spoilt" } : { kind: "none" };
}

/** Numbers that travelled as base64 of little-endian floats. */
export function floatsOf(base64) {
  const text = atob(base64);
  const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  return new Float32Array(bytes.buffer, 0, Math.floor(bytes.length / 4));
}

/** The engine's module, as it travelled. */
export function engineBytes() {
  const text = atob(document.getElementById("engine").textContent.trim());
  return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
}

/** A maker of the engine's workers: from text, so that a page without a server can. */
export function workerMaker() {
  const source = document.getElementById("worker").textContent;
  const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
  const bytes = engineBytes();
  return () => {
    const worker = new Worker(address);
    worker.postMessage({ engine: bytes.buffer.slice(0) });
    return worker;
  };
}
