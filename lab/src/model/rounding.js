// Rounding as Python rounds.

/** Nearest whole number, halves to the even one. */
export const roundHalfEven = (x) => {
  const below = Math.floor(x);
  if (x - below !== 0.5) return Math.round(x);
  return below % 2 === 0 ? below : below + 1;
};
