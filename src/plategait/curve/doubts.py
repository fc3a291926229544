"""What speaks against the peak that a curve's fit tells: what was measured beside it, beyond it and above it."""

from __future__ import annotations

import numpy as np

from plategait.curve.curve import Curve

# A line that peaks higher than all that was measured by more than this, or misses a point by more, as shares.
_ABOVE, _BESIDE = 0.05, 0.12


def doubts(curve: Curve) -> tuple[str, ...]:
    """What speaks against the peak of a curve's fit, a sentence each; none where there is no fit.

    Section 5.3 fits what was measured below the run-off by a line that has a peak, whether or not one was seen.
    """
    fit, fastest = curve.fit, curve.fastest
    if fit is None or fastest is None:
        return ()
    fitted = curve.fitted
    f, rate = curve.frequency_hz[fitted], np.abs(curve.spin_rate_deg_s[fitted])
    most = rate.max()
    said = []
    if rate[f == f.max()].mean() >= most:
        said.append(f"no peak was seen: the spin rate still rises at {f.max():g} Hz, the last frequency below the "
                    "run-off, and f0 is where the fitted line turns")  # fmt: skip
    if abs(fit.peak) > (1 + _ABOVE) * most:
        said.append(f"the fitted line peaks at {abs(fit.peak):.0f} deg/s, higher than anything measured "
                    f"({most:.0f} deg/s)")  # fmt: skip
    if not fitted[curve.frequency_hz == fastest[0]].all() and abs(fastest[1]) > most:
        said.append(f"beyond frequencies at which it fails it spins faster, {abs(fastest[1]):.0f} deg/s at "
                    f"{fastest[0]:g} Hz, which is no part of the fit")  # fmt: skip
    off = np.abs(np.abs(fit(f)) - rate)
    if off.max() > _BESIDE * most:
        said.append(f"the fitted line misses the point at {f[np.argmax(off)]:g} Hz by {off.max():.0f} deg/s: the "
                    "curve has another shape")  # fmt: skip
    return tuple(said)
