"""Pictures of an estimate: the predictive curve over the data, and the parameters that the data allow."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.estimate.observations import Condition
from plategait.estimate.prediction import Prediction, predict
from plategait.estimate.readings import Readings
from plategait.estimate.result import Estimate
from plategait.plots.failures import Failures, draw_failures, failure_handles
from plategait.plots.style import BLUE, GREY, ORANGE, RED, label_axes, legend_below, new_figure, plain_text
from plategait.plots.symbols import FREQUENCY, SPIN_RATE, typeset
from plategait.simulation.ensemble import fails

if TYPE_CHECKING:
    from matplotlib.axes import Axes

AXIS_LABELS = {
    "natural_frequency": "$\\omega_n$ (π rad/s)", "friction_angle": "$\\alpha$ (deg)",
    "friction_ratio": "$\\beta$ = $\\mu_k/\\mu_s$", "mass": "mass over that told",
    "bending_damping": "$c_b$ over that told", "plate_height": "plate above its axis (mm)",
    "contact_damping": "contact damping over that told",
}  # fmt: skip


def plot_estimate(estimate: Estimate, predictions: Sequence[Prediction] | None = None) -> Figure:
    """Predicted spin curves over the data, one panel an amplitude, and below them each parameter's posterior.

    Motions that make no curve share a panel. Between them a row for each of the readings, if there are any. Without
    predictions the engine is run for them, which takes seconds.
    """
    predictions = predict(estimate.posterior) if predictions is None else predictions
    d = len(estimate.marginals)
    readings = estimate.posterior.data.readings
    columns = max(len(predictions), d, 2)
    figure = new_figure(3.3 * columns, 6.6 + 3.0 * len(readings))
    grid = figure.add_gridspec(2 + len(readings), columns, height_ratios=[1.25, *(1.0 for _ in readings), 1])
    share = columns // len(predictions)
    for i, prediction in enumerate(predictions):
        place = slice(i * share, (i + 1) * share if i + 1 < len(predictions) else columns)
        _draw_curve(figure.add_subplot(grid[0, place]), estimate, prediction)
        for row, reading in enumerate(readings, start=1):
            _draw_reading(figure.add_subplot(grid[row, place]), estimate, prediction, reading)
    values = estimate.posterior.values
    for i in range(d):
        _draw_parameter(figure.add_subplot(grid[-1, i]), estimate, i, values)
    if not estimate.goodness.explained:
        lines = textwrap.wrap(
            "not explained: " + "; ".join(estimate.goodness.complaints), int(13 * figure.get_figwidth())
        )
        figure.suptitle(plain_text("\n".join(lines)), color=RED, fontsize=9, x=0.01, ha="left")
    _legend(figure, ran_off=bool(estimate.posterior.data.failed.any()))
    return figure


def _legend(figure: Figure, ran_off: bool) -> None:
    handles: dict[str, Any] = {}
    for axes in figure.axes:
        for handle, label in zip(*axes.get_legend_handles_labels(), strict=True):
            handles.setdefault(label, handle)
    legend_below(figure, [*handles.values(), *(failure_handles(["ran off"]) if ran_off else [])], columns=7)


def _draw_curve(axes: Axes, estimate: Estimate, prediction: Prediction) -> None:
    """Predicted spin rates of one amplitude or of mixed motions, and the points measured under them."""
    data = estimate.posterior.data
    _draw_prediction(axes, prediction, prediction.rates)
    where, place = _places(prediction, data.conditions, data.which)
    outlier = np.isin(data.frequency, estimate.goodness.outliers) & data.rated
    groups = ((~outlier, "black", "o", "measured"), (outlier, ORANGE, "D", "probably an outlier"))
    for group, colour, marker, label in groups:
        points = where & data.rated & group
        if points.any():
            bars = np.where(np.isfinite(data.sd), data.sd, 0.0)[points]
            style: dict[str, Any] = {
                "fmt": marker,
                "mfc": "white",
                "mec": colour,
                "ecolor": colour,
                "ms": 5.5,
                "mew": 1.3,
            }
            axes.errorbar(place[points], data.rate[points], bars, label=label, **style)
    failed = where & data.failed
    title = "mixed motions" if prediction.amplitude is None else prediction.amplitude.text
    axes.set_title(typeset(title), loc="left", fontsize=10)
    # Only a spin rate out of phase is below zero.
    axes.set_ylim(bottom=min(0.0, 1.1 * float(np.nanmin(data.rate[data.rated], initial=0.0))))
    label_axes(axes, _across(prediction), SPIN_RATE)
    draw_failures(axes, [Failures(place[failed], ["ran off"] * int(failed.sum()))])


def _draw_reading(axes: Axes, estimate: Estimate, prediction: Prediction, reading: Readings) -> None:
    """What is predicted of one observable at one amplitude, and the readings of it."""
    observable, conditions = reading.observable, estimate.posterior.data.conditions
    _draw_prediction(axes, prediction, observable.scale * prediction.values[reading.name])
    where, place = _places(prediction, conditions, reading.which)
    value, sd = (observable.scale * x[where] for x in (reading.value, reading.sd))
    axes.errorbar(place[where], value, sd, fmt="o", mfc="white", mec="black", ecolor="black", ms=5.5, mew=1.3)
    axes.set_ylim(bottom=0)
    unit = "" if observable.heading == reading.name else f" ({observable.read_in})"
    label_axes(axes, _across(prediction), f"{observable.label}{unit}")


def _places(
    prediction: Prediction, conditions: Sequence[Condition], which: NDArray[np.int64]
) -> tuple[NDArray[np.bool_], Array]:
    """Which points belong to a prediction, and where they are drawn: at their frequency, or their motion's number."""
    if prediction.amplitude is None:
        number = {c: i + 1.0 for i, c in enumerate(prediction.conditions)}
        place = np.array([number.get(conditions[i], math.nan) for i in which])
        return np.isfinite(place), place
    where = np.array([conditions[i].amplitude == prediction.amplitude for i in which], dtype=bool)
    return where, np.array([conditions[i].frequency for i in which])


def _across(prediction: Prediction) -> str:
    return "motion" if prediction.amplitude is None else FREQUENCY


def _draw_prediction(axes: Axes, prediction: Prediction, values: Array) -> None:
    with np.errstate(all="ignore"):
        stays = ~fails(prediction.failed.sum(axis=0), len(prediction.failed))
        low, middle, high = (_quantile(values, q) for q in (0.05, 0.5, 0.95))
    if prediction.amplitude is None:
        place = 1.0 + np.arange(len(prediction.conditions))
        axes.vlines(place, low, high, color=BLUE, alpha=0.3, lw=8, label="90 % of predictions")
        axes.plot(place, middle, "_", color=BLUE, ms=10, label="median prediction")
        return
    f = prediction.frequency
    axes.fill_between(f[stays], low[stays], high[stays], color=BLUE, alpha=0.2, lw=0, label="90 % of predictions")
    axes.plot(f[stays], middle[stays], color=BLUE, lw=1.4, label="median prediction")
    runs_off = ~stays & (f > f[stays].max(initial=0.0))
    if runs_off.any():
        axes.axvspan(
            f[runs_off].min(),
            f.max(),
            color=GREY,
            alpha=0.25,
            lw=0,
            hatch="//",
            fill=False,
            label="predicted to run off",
        )


def _quantile(rates: Array, q: float) -> Array:
    """Quantile of the runs that stayed, column by column; NaN where none did."""
    return np.array([np.quantile(c[np.isfinite(c)], q) if np.isfinite(c).any() else math.nan for c in rates.T])


def _draw_parameter(axes: Axes, estimate: Estimate, i: int, values: Array) -> None:
    marginal = estimate.marginals[i]
    p = marginal.parameter
    x = values[:, i] / p.scale
    low, high = np.quantile(x, [0.001, 0.999])
    bins = np.linspace(low, high, 40)
    axes.hist(x, bins=bins, color=BLUE if marginal.determined else GREY, alpha=0.75, density=True)
    if marginal.determined:
        for end in (marginal.low, marginal.high):
            axes.axvline(end / p.scale, color="black", lw=0.9, ls=":")
    axes.set_title(marginal.text, loc="left", fontsize=9)
    axes.set_yticks([])
    label_axes(axes, AXIS_LABELS[p.name], "")
    axes.spines["left"].set_visible(False)
