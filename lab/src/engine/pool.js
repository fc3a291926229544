// Workers, and questions shared over them.

/** A worker that is asked one thing after another. */
class Asked {
  constructor(makeWorker) {
    this.waiting = new Map();
    this.last = 0;
    this.worker = makeWorker();
    this.worker.onmessage = ({ data }) => this.#hear(data);
    this.worker.onerror = (event) => {
      event.preventDefault?.();
      this.#end(new Error("the engine's worker stopped"));
    };
  }

  get busy() {
    return this.waiting.size;
  }

  ask(message, onProgress) {
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, onProgress });
      this.worker.postMessage({ id, ...message });
    });
  }

  #hear(data) {
    if (data.id === null) return this.#end(Object.assign(new Error(data.refused.message), data.refused));
    const asked = this.waiting.get(data.id);
    if (!asked) return undefined;
    if (data.told === "progress") return asked.onProgress?.(data.fraction);
    this.waiting.delete(data.id);
    if (!data.refused) return asked.resolve(data);
    const { field, message, anew } = data.refused;
    return asked.reject(Object.assign(new Error(message), { field, anew }));
  }

  #end(error) {
    for (const { reject } of this.waiting.values()) reject(error);
    this.waiting.clear();
  }

  close() {
    this.#end(new Error("closed"));
    this.worker.terminate();
  }
}

/** One worker for a sheet that lives. */
export const openLive = (makeWorker) => new Asked(makeWorker);

export class Pool {
  /** @param {() => Worker} makeWorker @param {number} n workers at most; each is made when it is first needed */
  constructor(makeWorker, n) {
    Object.assign(this, { makeWorker, size: n, workers: [], queue: [] });
  }

  /**
   * Ask whichever worker is free; first asked, first answered.
   *
   * @param {object} message
   * @param {{signal?: AbortSignal, onProgress?: (fraction: number) => void}} [how]
   */
  ask(message, { signal, onProgress } = {}) {
    return new Promise((resolve, reject) => {
      if (signal?.aborted) return reject(stopped());
      const job = { message, onProgress, resolve, reject, signal };
      signal?.addEventListener("abort", () => {
        const at = this.queue.indexOf(job);
        if (at >= 0) this.queue.splice(at, 1);
        reject(stopped());
      }, { once: true });
      this.queue.push(job);
      return this.#next();
    });
  }

  #next() {
    while (this.queue.length) {
      let free = this.workers.find((worker) => !worker.busy);
      if (!free && this.workers.length < this.size) {
        free = new Asked(this.makeWorker);
        this.workers.push(free);
      }
      if (!free) return;
      const { message, onProgress, resolve, reject } = this.queue.shift();
      free.ask(message, onProgress).then(resolve, reject).finally(() => this.#next());
    }
  }

  close() {
    for (const worker of this.workers) worker.close();
    this.workers = [];
    this.queue = [];
  }
}

const stopped = () => Object.assign(new Error("stopped"), { name: "AbortError" });
