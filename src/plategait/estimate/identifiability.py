"""Which parameters the data determine: the marginal posterior of each, and the gate that its numbers must pass."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from plategait.arrays import Array
from plategait.estimate.unknowns import Unknown

CONFIDENCE = 0.9
# A parameter counts as determined when the data leave at most this share of the prior's standard deviation.
DETERMINED = 0.5
# An interval that ends this near an end of the prior is open to that side.
AT_THE_END = 0.02
UNIFORM_SD = 1 / math.sqrt(12)

Verdict = Literal["determined", "at most", "at least", "not determined"]


@dataclass(frozen=True)
class Marginal:
    """Posterior of one parameter by itself, and whether the data determine it.

    Attributes
    ----------
    parameter : Unknown
    verdict : str
        "determined": `median` and the interval `low` to `high` may be used. "at most" or "at least": only `high` or
        only `low`. "not determined": none.
    median, sd, low, high : float
        SI.
    contraction : float
        Standard deviation left, as a share of the prior's.
    """

    parameter: Unknown
    verdict: Verdict
    median: float
    sd: float
    low: float
    high: float
    contraction: float

    @property
    def determined(self) -> bool:
        """Whether `median` and the interval may be used."""
        return self.verdict == "determined"

    def summary(self) -> dict[str, Any]:
        """Plain numbers for `--json`; None where the gate withholds them."""
        scale, verdict = self.parameter.scale, self.verdict
        return {
            "verdict": verdict,
            "unit": self.parameter.unit or None,
            "median": self.median / scale if self.determined else None,
            "sd": self.sd / scale if self.determined else None,
            "low": self.low / scale if verdict in ("determined", "at least") else None,
            "high": self.high / scale if verdict in ("determined", "at most") else None,
            "sd_over_prior": self.contraction,
        }

    @property
    def _digits(self) -> int:
        """Decimals that the standard deviation is worth, two of its own."""
        return max(0, 1 - math.floor(math.log10(max(self.sd / self.parameter.scale, 1e-9))))

    @property
    def interval_text(self) -> str:
        """Interval for people; a dash where there is none."""
        if not self.determined:
            return "–"
        scale = self.parameter.scale
        return f"{self.low / scale:.{self._digits}f} to {self.high / scale:.{self._digits}f}"

    @property
    def text(self) -> str:
        """For people."""
        scale, unit = self.parameter.scale, f" {self.parameter.unit}" if self.parameter.unit else ""
        if self.determined:
            return f"{self.median / scale:.{self._digits}f} ± {self.sd / scale:.{self._digits}f}{unit}"
        if self.verdict == "at most":
            return f"at most {self.high / scale:.3g}{unit}"
        if self.verdict == "at least":
            return f"at least {self.low / scale:.3g}{unit}"
        return "not determined by these data"


def marginal_of(parameter: Unknown, u: Array, confidence: float = CONFIDENCE) -> Marginal:
    """Marginal posterior of one parameter, from its samples (n,) as shares of the prior."""
    tail = (1 - confidence) / 2
    ends = np.quantile(u, [tail, 0.5, 1 - tail])
    low, median, high = (float(parameter.value(e)) for e in ends)
    contraction = float(np.std(u)) / UNIFORM_SD
    open_below, open_above = bool(ends[0] < AT_THE_END), bool(ends[2] > 1 - AT_THE_END)
    verdict: Verdict = "determined"
    if contraction > DETERMINED or (open_below and open_above):
        verdict = "not determined"
    elif open_below:
        verdict, high = "at most", float(parameter.value(np.quantile(u, confidence)))
    elif open_above:
        verdict, low = "at least", float(parameter.value(np.quantile(u, 1 - confidence)))
    return Marginal(parameter, verdict, median, float(np.std(parameter.value(u))), low, high, contraction)
