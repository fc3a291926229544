// The core as a WebAssembly module: its names, its memory, and the calls that a page makes of it.

// Memory that one module may come to hold; a page has several.
const MOST_BYTES = 1 << 30;

/**
 * An instance of the module.
 *
 * @param {BufferSource | WebAssembly.Module} source
 */
export async function loadEngine(source) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  return new Engine(module);
}

export class Engine {
  /** @param {WebAssembly.Module} module */
  constructor(module) {
    this.module = module;
    const { exports } = new WebAssembly.Instance(module, {});
    exports._initialize();
    this.core = exports;
    const [words, parameters, layer, channels] = [0, 1, 2, 3].map((which) => this.#names(which));
    this.names = { words, parameters, layer, channels };
    [this.tallies, this.clocks, this.lanes] = [0, 1, 2].map((which) => exports.plategait_count(which));
    this.channel = Object.fromEntries(channels.map((name, k) => [name, k]));
  }

  /** A fresh instance: after a trap nothing in the old one's memory can be trusted. */
  anew() {
    return new Engine(this.module);
  }

  #names(which) {
    const length = this.core.plategait_names(which, 0);
    const at = this.core.plategait_allocate(length);
    this.core.plategait_names(which, at);
    const text = String.fromCharCode(...new Uint8Array(this.core.memory.buffer, at, length));
    this.core.plategait_release(at);
    return text.trimEnd().split("\n");
  }

  /**
   * Lay arrays into the module's memory, call it, and give back what is wanted of them, copied.
   *
   * @param {Record<string, number>} counts words that are no address
   * @param {Record<string, ArrayBufferView | {bytes: number}>} arrays by the names of the table's words
   * @param {(table: number, address: Record<string, number>) => void} call
   * @param {(view: <T>(kind: new (...args: any[]) => T, name: string, length: number) => T) => any} take
   */
  with(counts, arrays, call, take) {
    const { core } = this;
    const taken = [];
    const allocate = (bytes) => {
      if (core.memory.buffer.byteLength + bytes > MOST_BYTES)
        throw new Error("more memory than a page may take: fewer nodes, or less at once");
      const at = core.plategait_allocate(Math.max(bytes, 16));
      if (!at) throw new Error("there is no memory for it: fewer nodes, or less at once");
      taken.push(at);
      return at;
    };
    try {
      const address = {};
      for (const [name, array] of Object.entries(arrays)) {
        address[name] = allocate(array.bytes ?? array.byteLength);
        if (array.buffer)
          new Uint8Array(core.memory.buffer, address[name], array.byteLength).set(
            new Uint8Array(array.buffer, array.byteOffset, array.byteLength),
          );
      }
      const table = allocate(4 * this.names.words.length);
      const words = new Int32Array(core.memory.buffer, table, this.names.words.length);
      this.names.words.forEach((name, k) => (words[k] = counts[name] ?? address[name] ?? 0));
      call(table, address);
      return take((Kind, name, length) => new Kind(core.memory.buffer, address[name], length).slice());
    } finally {
      for (const at of taken) core.plategait_release(at);
    }
  }
}
