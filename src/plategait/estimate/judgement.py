"""What a posterior may claim: which parameters the data determine, and whether any explain the data."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from plategait.arrays import Array
from plategait.estimate.likelihood import SURPRISE
from plategait.estimate.posterior import Posterior
from plategait.estimate.unknowns import Parameter

CONFIDENCE = 0.9
# A parameter counts as determined when the data leave at most this share of the prior's standard deviation.
DETERMINED = 0.5
# An interval that ends this near an end of the prior is open to that side.
AT_THE_END = 0.02
UNIFORM_SD = 1 / math.sqrt(12)
# The data are not explained where chance alone would give so bad a fit less often than this.
SIGNIFICANCE = 0.01
# Points whose odds of being outliers exceed this are named.
OUTLIER_ODDS = 0.5
# A noise that had to be taken larger than this explains nothing.
LARGEST_NOISE = 0.15

Verdict = Literal["determined", "at most", "at least", "not determined"]


@dataclass(frozen=True)
class Finding:
    """What the data say of one parameter.

    Attributes
    ----------
    parameter : Parameter
    verdict : str
        "determined": `median` and the interval `low` to `high` may be used. "at most" or "at least": only `high` or
        only `low`. "not determined": none.
    median, sd, low, high : float
        SI.
    contraction : float
        Standard deviation left, as a share of the prior's.
    """

    parameter: Parameter
    verdict: Verdict
    median: float
    sd: float
    low: float
    high: float
    contraction: float

    @property
    def _digits(self) -> int:
        """Decimals that the standard deviation is worth, two of its own."""
        return max(0, 1 - math.floor(math.log10(max(self.sd / self.parameter.scale, 1e-9))))

    @property
    def interval_text(self) -> str:
        """Interval for people; a dash where there is none."""
        scale = self.parameter.scale
        shown = f"{self.low / scale:.{self._digits}f} to {self.high / scale:.{self._digits}f}"
        return shown if self.verdict == "determined" else "–"

    @property
    def text(self) -> str:
        """For people."""
        scale, unit = self.parameter.scale, f" {self.parameter.unit}" if self.parameter.unit else ""
        if self.verdict == "determined":
            return f"{self.median / scale:.{self._digits}f} ± {self.sd / scale:.{self._digits}f}{unit}"
        if self.verdict == "at most":
            return f"at most {self.high / scale:.3g}{unit}"
        if self.verdict == "at least":
            return f"at least {self.low / scale:.3g}{unit}"
        return "not determined by these data"


def judge(parameter: Parameter, u: Array, confidence: float = CONFIDENCE) -> Finding:
    """Gate for one parameter, from its samples (n,) as shares of the prior."""
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
    return Finding(parameter, verdict, median, float(np.std(parameter.value(u))), low, high, contraction)


@dataclass(frozen=True)
class FitCheck:
    """Whether the best parameters explain the data.

    Attributes
    ----------
    chi2 : float
        Squared deviations of the sound points from the best prediction, in units of their spread.
    freedom : int
        Points less parameters.
    p : float
        Probability of a fit as bad by chance.
    run : float
        Probability by chance of residuals that hang together as much over the plate frequency.
    outliers : tuple of float
        Plate frequencies (Hz) of the points that are probably outliers.
    run_off_missed : bool
        Whether no parameters run off where the object did.
    noise : float
        Median relative noise that was needed; NaN where the data came with theirs.
    complaints : tuple of str
        What is wrong; empty where the data are explained.
    """

    chi2: float
    freedom: int
    p: float
    run: float
    outliers: tuple[float, ...]
    run_off_missed: bool
    noise: float
    complaints: tuple[str, ...]

    @property
    def explained(self) -> bool:
        """Whether the data are explained."""
        return not self.complaints


def check_fit(posterior: Posterior) -> FitCheck:
    """Compare the data with the best of the samples."""
    from scipy.special import chdtrc

    likelihood, data = posterior.likelihood, posterior.data
    best = posterior.full[[int(np.argmax(likelihood(posterior.full)))]]
    parameters, noise = likelihood.split(best)
    predicted = likelihood.predicted(parameters)
    deviation = (data.rate[data.rated] - predicted)[0] / likelihood.spread(predicted, noise)[0]
    sound, odd = likelihood.point_terms(posterior.full[:: max(1, len(posterior.full) // 500)])
    outlying = np.mean(1 / (1 + np.exp(np.clip(sound - odd, -50, 50))), axis=0) > OUTLIER_ODDS
    frequency = data.frequency[data.rated]
    kept = np.where(outlying, 0.0, deviation)
    freedom = int((~outlying).sum()) - best.shape[1]
    chi2 = float(np.sum(kept**2))
    p = float(chdtrc(freedom, chi2)) if freedom > 0 else 1.0
    together = _runs_together(kept[np.argsort(frequency, kind="stable")])
    missed = bool(likelihood.run_off_terms(best).min() < math.log(2 * SURPRISE))
    unknown_noise = likelihood.noise_is_unknown
    needed = float(np.median(posterior.noise)) if unknown_noise else math.nan
    complaints = []
    if p < SIGNIFICANCE:
        complaints.append(f"the rates lie further from every prediction than their noise allows (p = {p:.1g})")
    if together < SIGNIFICANCE:
        complaints.append(f"the rates lie above and below the best prediction in stretches (p = {together:.1g})")
    if outlying.sum() > max(1, 0.25 * len(outlying)):
        complaints.append(f"{int(outlying.sum())} of {len(outlying)} rates would have to be outliers")
    if missed:
        complaints.append("no parameters that fit the rates run off where the object did")
    if needed > LARGEST_NOISE:
        complaints.append(f"only a noise of {100 * needed:.0f} % would explain the rates")
    outliers = tuple(float(f) for f in np.unique(frequency[outlying]))
    return FitCheck(chi2, freedom, p, together, outliers, missed, needed, tuple(complaints))


def _runs_together(deviation: Array) -> float:
    """Probability by chance of neighbouring residuals as alike as these: a permutation test, one-sided."""
    if len(deviation) < 6:
        return 1.0
    generator = np.random.default_rng(0)
    shuffled = generator.permuted(np.tile(deviation, (4000, 1)), axis=1)
    alike = np.sum(shuffled[:, 1:] * shuffled[:, :-1], axis=1)
    return float((1 + np.sum(alike >= np.sum(deviation[1:] * deviation[:-1]))) / (1 + len(alike)))
