// Many runs over all workers: in groups that fill a module's lanes, a few ahead of the workers, stopped at a word.

const LANES = 4;

const greatestCommonDivisor = (a, b) => (b === 0 ? a : greatestCommonDivisor(b, a % b));

/** Items in groups whose runs, `repeats` of each, fill whole blocks of lanes. */
export const groupsOf = (items, repeats) => {
  const size = LANES / greatestCommonDivisor(LANES, repeats);
  const groups = [];
  for (let i = 0; i < items.length; i += size) groups.push(items.slice(i, i + size));
  return groups;
};

/** Order from coarse to fine: every eighth place, every fourth of what is left, every second, the rest. */
export const coarseFirst = (count, coarsest = 8) => {
  const seen = new Set();
  for (let step = coarsest; step >= 1; step /= 2) for (let i = 0; i < count; i += step) seen.add(i);
  return [...seen];
};

/**
 * Observe scenarios over all workers; resolves when all are done or refused, or `signal` has stopped it.
 *
 * @param {object} given
 * @param {{ask: (message: object, options?: object) => Promise<any>, size?: number}} given.pool
 * @param {any[]} given.items in the order in which they are wanted
 * @param {(item: any) => object} given.scenarioOf
 * @param {(item: any, observations: object[]) => void} given.onObserved
 * @param {(item: any, message: string) => void} given.onRefused
 * @param {AbortSignal} given.signal
 */
export const observeAll = async ({ pool, items, scenarioOf, repeats, seed, onObserved, onRefused, signal }) => {
  const groups = groupsOf(items, repeats);
  const ask = async (group) => {
    try {
      const scenarios = group.map(scenarioOf);
      const { observations } = await pool.ask({ ask: "observe", scenarios, repeats, seed }, { signal });
      if (!signal.aborted) group.forEach((item, i) => onObserved(item, observations[i]));
    } catch (error) {
      if (signal.aborted) return;
      // One of them cannot be run; the others can.
      if (group.length > 1) for (const item of group) await ask([item]);
      else onRefused(group[0], error.field ? `${error.field}: ${error.message}` : String(error.message ?? error));
    }
  };
  const next = async () => {
    while (groups.length && !signal.aborted) await ask(groups.shift());
  };
  // Each worker has one group to go on with while it tells of the last.
  const ahead = 2 * (pool.size ?? navigator.hardwareConcurrency ?? 2);
  await Promise.all(Array.from({ length: Math.min(ahead, groups.length) }, next));
};

/** Calls `draw` at the next picture, once however often it is asked for. */
export const oncePerPicture = (draw) => {
  let waiting = false;
  return () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      draw();
    });
  };
};

/** A name that files may have. */
export const fileName = (text) => text.replace(/[^\p{L}\p{N}_-]+/gu, "-").slice(0, 60) || "lab";
