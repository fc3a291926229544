// What several starts of one scenario show together: the rule of the package's simulation/ensemble.py.
//
// A point has failed when at least half of its runs did. Rate, spread, gait and means are over the runs that did not.
// The gait is that of most of these, of equals the livelier; the failure is the commonest, with the median of its times.
import { FAILURES, GAITS } from "./observables.js";
import { OBSERVABLES } from "./registry.js";
import { mean, median, placeOfLargest, student95 } from "./samples.js";

// Spread of the starts of an ensemble: a tenth of a millimetre and a degree are what a hand cannot place better.
const START_SPREAD = 1e-4;
const START_TURN = Math.PI / 180;

/** Whether a point has failed: at least half of its runs did, and one at least. */
export const fails = (failedRuns, runs) => failedRuns > 0 && 2 * failedRuns >= runs;

/**
 * What points show over their runs.
 *
 * @param observations of each point's runs, as `observe` gives them
 * @returns one {runs, failedRuns, countedRuns, failed, partlyFailed, rate, spread, low, high, settled, gait, failure,
 *   failureTime, values} for each point, SI; `failure` empty where no run failed
 */
export const together = (observations) => observations.map(pointOf);

const pointOf = (runs) => {
  const sound = runs.filter(({ failure }) => !failure);
  const counted = sound.filter(({ spin }) => Number.isFinite(spin.rate));
  const failedRuns = runs.length - sound.length;
  const failed = fails(failedRuns, runs.length);
  return {
    runs: runs.length,
    failedRuns,
    countedRuns: counted.length,
    failed,
    partlyFailed: failedRuns > 0 && failedRuns < runs.length,
    ...rateOf(counted.map(({ spin }) => spin)),
    settled: !failed && sound.every(({ spin }) => spin.settled),
    gait: gaitOf(sound),
    ...failureOf(runs),
    values: Object.fromEntries(OBSERVABLES.map((observable) => [observable.name, valueOf(observable, runs)])),
  };
};

/** Mean rate, standard deviation over the runs and 95 % interval of the mean; of a single run those of its blocks. */
const rateOf = (spins) => {
  const n = spins.length;
  if (!n) return { rate: NaN, spread: NaN, low: NaN, high: NaN };
  const rate = mean(spins.map((spin) => spin.rate));
  if (n === 1) return { rate, spread: spins[0].sd, low: spins[0].low, high: spins[0].high };
  const spread = Math.sqrt(spins.reduce((sum, spin) => sum + (spin.rate - rate) ** 2, 0) / (n - 1));
  const half = (student95(n - 1) * spread) / Math.sqrt(n);
  return { rate, spread, low: rate - half, high: rate + half };
};

const gaitOf = (sound) => {
  const livelierFirst = [...GAITS].reverse();
  const counts = livelierFirst.map((kind) => sound.filter(({ gait }) => gait === kind).length);
  return counts.some(Boolean) ? livelierFirst[placeOfLargest(counts)] : "";
};

const failureOf = (runs) => {
  const failures = runs.map(({ failure }) => failure).filter(Boolean);
  if (!failures.length) return { failure: "", failureTime: NaN };
  const timesOf = (kind) => failures.filter((failure) => failure.kind === kind).map(({ time }) => time);
  const kind = FAILURES[placeOfLargest(FAILURES.map((each) => timesOf(each).length))];
  return { failure: kind, failureTime: median(timesOf(kind)) };
};

/** What runs show of an observable: the mean over those that did not fail, or of all the one furthest from zero. */
const valueOf = ({ name, overRuns }, runs) => {
  if (overRuns === "worst") {
    return runs.map(({ values }) => values[name]).reduce((worst, value) => (furthest(value) > furthest(worst) ? value : worst));
  }
  const finite = runs.filter(({ failure }) => !failure).map(({ values }) => values[name]).filter(Number.isFinite);
  return finite.length ? mean(finite) : NaN;
};

const furthest = (value) => (Number.isNaN(value) ? Infinity : Math.abs(value));

/** [x, y, angle] added to the start of each run of an ensemble, m and rad; the first is the nominal start. */
export const starts = (repeats, seed) => {
  const normal = normals(seed);
  return Array.from({ length: repeats }, (_, i) =>
    i === 0 ? [0, 0, 0] : [START_SPREAD * normal(), START_SPREAD * normal(), START_TURN * normal()],
  );
};

/** Standard normal numbers from a seed: Box and Muller's, of the generator SplitMix32. */
const normals = (seed) => {
  let state = mixed(seed | 0);
  const uniform = () => {
    state = (state + 0x9e3779b9) | 0;
    return (mixed(state) >>> 0) / 2 ** 32;
  };
  return () => Math.sqrt(-2 * Math.log(1 - uniform())) * Math.cos(2 * Math.PI * uniform());
};

const mixed = (bits) => {
  const once = Math.imul(bits ^ (bits >>> 16), 0x21f0aaad);
  const twice = Math.imul(once ^ (once >>> 15), 0x735a2d97);
  return twice ^ (twice >>> 15);
};
