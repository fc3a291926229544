// Quantiles of the distributions that a fit's tests and intervals lean on, to ten digits.

/** Logarithm of the gamma function above 0 (Lanczos, g = 7). */
const logGamma = (x) => {
  const [first, ...others] = LANCZOS;
  const sum = others.reduce((total, c, i) => total + c / (x + i), first);
  const t = x + 6.5;
  return 0.5 * Math.log(2 * Math.PI) + (x - 0.5) * Math.log(t) - t + Math.log(sum);
};

const LANCZOS = [
  0.99999999999980993, 676.5203681218851, -1259.1392167224028, 771.32342877765313, -176.61502916214059,
  12.507343278686905, -0.13857109526572012, 9.9843695780195716e-6, 1.5056327351493116e-7,
];

const TINY = 1e-300;
const away = (x) => (Math.abs(x) < TINY ? TINY : x);

/** Continued fraction b0 + a1 / (b1 + a2 / (b2 + …)), by Lentz; `term(i)` is [a_i, b_i]. */
const continuedFraction = (b0, term) => {
  let [value, c, d] = [away(b0), away(b0), 0];
  for (let i = 1; i < 1000; i++) {
    const [a, b] = term(i);
    d = 1 / away(b + a * d);
    c = away(b + a / c);
    value *= c * d;
    if (Math.abs(c * d - 1) < 1e-15) break;
  }
  return value;
};

/** Regularised incomplete beta function I_x(a, b). */
export const incompleteBeta = (a, b, x) => {
  if (x <= 0 || x >= 1) return x <= 0 ? 0 : 1;
  if (x > (a + 1) / (a + b + 2)) return 1 - incompleteBeta(b, a, 1 - x);
  const front = Math.exp(logGamma(a + b) - logGamma(a) - logGamma(b) + a * Math.log(x) + b * Math.log(1 - x)) / a;
  const fraction = continuedFraction(1, (i) => {
    const m = i >> 1;
    const numerator = i % 2 ? -(a + m) * (a + b + m) * x : m * (b - m) * x;
    return [numerator / ((a + i - 1) * (a + i)), 1];
  });
  return front / fraction;
};

/** Upper regularised incomplete gamma function Q(a, x). */
export const upperGamma = (a, x) => {
  if (x <= 0) return 1;
  const front = Math.exp(a * Math.log(x) - x - logGamma(a));
  if (x < a + 1) {
    let [term, sum] = [1 / a, 1 / a];
    for (let n = 1; Math.abs(term) > 1e-17 * sum && n < 1000; n++) {
      term *= x / (a + n);
      sum += term;
    }
    return 1 - front * sum;
  }
  return front / continuedFraction(x + 1 - a, (i) => [-i * (i - a), x + 2 * i + 1 - a]);
};

/** Where a rising function of a positive number is 0, by halving. */
const crossing = (rising) => {
  let [low, high] = [0, 1];
  while (rising(high) < 0) [low, high] = [high, 2 * high];
  for (let i = 0; i < 200 && high - low > 1e-13 * high; i++) {
    const middle = (low + high) / 2;
    if (rising(middle) < 0) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
};

/** Student's t below which `share` (above a half) of its distribution lies. */
export const studentQuantile = (freedom, share) =>
  crossing((t) => 2 * (1 - share) - incompleteBeta(freedom / 2, 0.5, freedom / (freedom + t * t)));

/** Fisher's F below which `share` of its distribution lies. */
export const fisherQuantile = (above, below, share) =>
  crossing((f) => incompleteBeta(above / 2, below / 2, (above * f) / (above * f + below)) - share);

/** χ² above which `share` of its distribution lies. */
export const chiSquareUpper = (freedom, share) => crossing((x) => share - upperGamma(freedom / 2, x / 2));
