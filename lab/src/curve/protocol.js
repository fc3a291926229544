// How a spin curve is measured: the package's curve/protocol.py.

/** How long each point runs, what of it is not measured (s), and the slip at which it has failed (m). */
export const USUAL = { duration: 2, transient: 0.6, slip_limit: 0.02 };

/** Scenario run for as long, and failing at the same slip, as the measurement. */
export const measuredAs = (scenario, protocol = USUAL) => ({
  ...scenario,
  duration: protocol.duration,
  transient: Math.min(protocol.transient, 0.5 * protocol.duration),
  slip_limit: protocol.slip_limit,
});
