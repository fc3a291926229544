// Workers, and questions shared over them.

const PATIENCE = 300; // ms that a worker may go on with what nobody waits for; then another takes its place

const failed = (message, name = "Error") => Object.assign(new Error(message), { name });

/** A worker that is asked one thing after another. */
class Asked {
  /** @param {() => Worker} makeWorker */
  constructor(makeWorker) {
    this.waiting = new Map();
    this.last = 0;
    /** Why it answers no more, or null. */
    this.ended = null;
    this.worker = makeWorker();
    this.worker.onmessage = ({ data }) => this.#hear(data);
    this.worker.onerror = (event) => {
      event.preventDefault?.();
      this.#end(failed("the engine's worker stopped"));
    };
    this.worker.onmessageerror = () => this.#end(failed("what the engine's worker said cannot be read"));
  }

  get busy() {
    return this.waiting.size > 0;
  }

  /**
   * @param {object} message
   * @param {(fraction: number) => void} [onProgress]
   * @returns {Promise<any>}
   */
  ask(message, onProgress) {
    if (this.ended) return Promise.reject(this.ended);
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, onProgress });
      try {
        this.worker.postMessage({ id, ...message });
      } catch (error) {
        // A message that cannot be copied never went.
        this.waiting.delete(id);
        reject(error);
      }
    });
  }

  #hear(data) {
    const { id, told, fraction, refused } = data;
    if (id === null) return this.#end(Object.assign(failed(refused.message), refused));
    const asked = this.waiting.get(id);
    if (!asked) return undefined;
    if (told === "progress") return asked.onProgress?.(fraction);
    this.waiting.delete(id);
    return refused ? asked.reject(Object.assign(failed(refused.message), refused)) : asked.resolve(data);
  }

  #end(error) {
    this.ended ??= error;
    for (const { reject } of this.waiting.values()) reject(error);
    this.waiting.clear();
    this.worker.terminate();
  }

  close() {
    this.#end(failed("closed"));
  }
}

/** One worker for a sheet that lives. */
export const openLive = (makeWorker) => new Asked(makeWorker);

export class Pool {
  /** @param {() => Worker} makeWorker @param {number} size workers at most; each is made when it is first needed */
  constructor(makeWorker, size) {
    Object.assign(this, { makeWorker, size, workers: [], queue: [] });
  }

  /**
   * Ask whichever worker is free; first asked, first begun.
   *
   * @param {object} message
   * @param {{signal?: AbortSignal, onProgress?: (fraction: number) => void}} [how]
   * @returns {Promise<any>}
   */
  ask(message, { signal, onProgress } = {}) {
    return new Promise((resolve, reject) => {
      if (signal?.aborted) return reject(failed("stopped", "AbortError"));
      const job = { message, onProgress, resolve, reject, worker: null };
      job.stop = () => this.#stop(job);
      job.forget = () => signal?.removeEventListener("abort", job.stop);
      signal?.addEventListener("abort", job.stop);
      this.queue.push(job);
      return this.#next();
    });
  }

  #stop(job) {
    job.forget();
    this.queue = this.queue.filter((other) => other !== job);
    job.reject(failed("stopped", "AbortError"));
    const { worker } = job;
    if (!worker) return;
    const patience = setTimeout(() => worker.close(), PATIENCE);
    worker.doing.finally(() => clearTimeout(patience));
  }

  #next() {
    this.workers = this.workers.filter(({ ended }) => !ended);
    while (this.queue.length) {
      let free = this.workers.find((worker) => !worker.busy);
      if (!free && this.workers.length < this.size) this.workers.push((free = new Asked(this.makeWorker)));
      if (!free) return;
      this.#begin(this.queue.shift(), free);
    }
  }

  #begin(job, worker) {
    job.worker = worker;
    worker.doing = worker
      .ask(job.message, job.onProgress)
      .then(job.resolve, job.reject)
      .finally(() => {
        job.forget();
        this.#next();
      });
  }

  close() {
    const left = this.queue;
    this.queue = [];
    for (const { reject } of left) reject(failed("closed"));
    for (const worker of this.workers) worker.close();
    this.workers = [];
  }
}
