// Shapes of the plate's swing beside the sine: the first terms of their Fourier series, as further sines on the axes.

/** Terms [ratio, share] of a unit swing in sine; the first is the fundamental's. */
const SERIES = {
  sine: [[1, 1]],
  triangle: [1, 3, 5, 7].map((n, i) => [n, ((8 / Math.PI ** 2) * (i % 2 ? -1 : 1)) / n ** 2]),
  trapezoid: [1, 3, 5].map((n) => [n, (4 / Math.PI) * (Math.sin((n * Math.PI) / 6) / ((n * Math.PI) / 6)) * (1 / n)]),
  sawtooth: [1, 2, 3, 4].map((n) => [n, ((2 / Math.PI) * (n % 2 ? 1 : -1)) / n]),
};

export const WAVEFORMS = Object.keys(SERIES);

/** The motion with both of its sines in another shape: swing about the bar, and stroke along it. */
export function shaped(motion, kind) {
  const others = motion.waves.filter((wave) => !isHarmonic(wave));
  const further = SERIES[kind].slice(1).flatMap(([ratio, share]) => {
    const first = SERIES[kind][0][1];
    return [
      { axis: "rx", amplitude: (-motion.angle * share) / first, ratio, phase: 0 },
      { axis: "x", amplitude: (motion.stroke * share) / first, ratio, phase: 0 },
    ].filter((wave) => wave.amplitude !== 0);
  });
  return { ...motion, waves: [...others, ...further] };
}

/** Which shape a motion has, as far as `shaped` makes them; "own" for any other. */
export function shapeOf(motion) {
  const harmonics = motion.waves.filter(isHarmonic).length;
  if (harmonics === 0) return "sine";
  const same = (kind) => {
    const wanted = shaped(motion, kind).waves.filter(isHarmonic);
    const own = motion.waves.filter(isHarmonic);
    const key = (wave) => `${wave.axis} ${wave.ratio} ${wave.amplitude.toPrecision(6)}`;
    return wanted.length === own.length && wanted.map(key).sort().join() === own.map(key).sort().join();
  };
  return WAVEFORMS.find((kind) => kind !== "sine" && same(kind)) ?? "own";
}

const isHarmonic = (wave) => ["rx", "x"].includes(wave.axis) && wave.ratio > 1 && Number.isInteger(wave.ratio) && wave.phase === 0;
