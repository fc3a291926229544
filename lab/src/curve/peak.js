// Whether the samples of a curve show the peak that a fit claims: the package's curve/peak.py.

// Frequencies that must lie within the half width of a peak: it has a height, a place and a width.
const LEAST_SAMPLES = 3;

/** A number with so many significant digits, without needless zeros. */
export const digits = (value, count = 6) =>
  Number.isFinite(value) ? String(Number(value.toPrecision(count))) : String(value).replace("Infinity", "inf");

/** Where something lies that the samples leave open, Hz; an end that they do not bound at all goes without words. */
export const anywhere = (low, high, count) => {
  const [start, end] = [low, high].map((value) => digits(value, count));
  if (!Number.isFinite(low)) return Number.isFinite(high) ? `anywhere up to ${end} Hz` : "at any frequency";
  return Number.isFinite(high) ? `anywhere from ${start} to ${end} Hz` : `anywhere from ${start} Hz on`;
};

/** Distinct frequencies, rising. */
export const distinct = (frequency) => [...new Set(frequency)].sort((a, b) => a - b);

/** Distinct frequencies, rising, and the mean rate at each, positive where it has the sense of the largest. */
const heightsOf = (frequency, rate) => {
  const f = distinct(frequency);
  const largest = rate.reduce((best, value) => (Math.abs(value) > Math.abs(best) ? value : best), rate[0]);
  const heights = f.map((each) => {
    const own = rate.filter((_, i) => frequency[i] === each);
    return (Math.sign(largest) * own.reduce((sum, value) => sum + value, 0)) / own.length;
  });
  return { f, heights };
};

/** Why the samples show no top, whatever its shape; null where they rise to their highest rate and fall after it. */
export const unseenTop = (frequency, rate, endsInFailure = false) => {
  const { f, heights } = heightsOf(frequency, rate);
  const highest = Math.max(...heights);
  if (heights[0] === highest) return `rates that are highest at the first frequency, ${digits(f[0])} Hz`;
  if (heights.at(-1) === highest && !endsInFailure) {
    return `rates that are highest at the last frequency, ${digits(f.at(-1))} Hz`;
  }
  return null;
};

/**
 * Why the samples do not show a fitted peak, though a line through them may have it; null where they do: a top, f0
 * among their frequencies, and three of these at least within the half width of it.
 */
export const unseenPeak = (frequency, rate, f0, halfWidth, endsInFailure = false) => {
  const fault = unseenTop(frequency, rate, endsInFailure);
  if (fault) return fault;
  const f = distinct(frequency);
  const beyond = endsInFailure ? (f.at(-1) - f.at(-2)) / 2 : 0;
  if (!(f[0] <= f0 && f0 <= f.at(-1) + beyond)) return `a line that peaks at ${digits(f0, 4)} Hz, where nothing was measured`;
  const within = f.filter((each) => Math.abs(each - f0) <= halfWidth).length;
  if (within >= LEAST_SAMPLES) return null;
  const samples = within === 0 ? "none" : `only ${within}`;
  return `a peak of half width ${digits(halfWidth, 2)} Hz at ${digits(f0, 4)} Hz with ${samples} of the frequencies within it`;
};
