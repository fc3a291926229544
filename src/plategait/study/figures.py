"""Pictures of the study of the source's unknowns, one for each finding. They draw and compute nothing new."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from plategait.plots.style import BLUE, GREEN, GREY, ORANGE, label_axes, legend_below, new_figure
from plategait.study.aims import HAS_FIT, KIND, OF_CURVE, PUBLISHED_F0, PUBLISHED_RATIO, residuals_of
from plategait.study.evaluation import FITS_FROM
from plategait.study.source import QUANTILES, SourceStudy
from plategait.study.unknowns import NAMES

_TOLD = {"as printed": (GREY, "x"), "one factor at a time": (ORANGE, "s"), "found on all curves": (GREEN, "o")}


def draw_departures(study: SourceStudy) -> Figure:
    """What each departure buys, and what the number of them costs."""
    figure = new_figure(6.4, 4.2)
    axes = figure.add_subplot()
    count = range(len(study.steps))
    axes.plot(count, [s.misfit for s in study.steps], "o--", color=BLUE, mfc="white", ms=5, label="misfit")
    axes.plot(count, [s.criterion for s in study.steps], "o-", color=BLUE, ms=5, label="misfit and $k\\,\\ln n$")
    for number, (less, more) in enumerate(zip(study.steps, study.steps[1:], strict=False), start=1):
        names = ", ".join(sorted({*more.free} - {*less.free}))
        axes.annotate(names, (number, more.criterion), (0, 8), textcoords="offset points", rotation=60, fontsize=7)
    axes.plot(len(study.chosen.free), study.chosen.criterion, "*", color="black", ms=13, label="chosen")
    label_axes(axes, "departures from what is printed", "sum of squared deviations")
    axes.set_ylim(bottom=0)
    legend_below(figure)
    return figure


def draw_unknowns(study: SourceStudy) -> Figure:
    """Posterior of each unknown, in standard deviations of its prior."""
    figure = new_figure(6.4, 4.6)
    axes = figure.add_subplot()
    low, middle, high = np.quantile(study.samples, QUANTILES, axis=0)
    places = np.arange(len(NAMES))[::-1]
    axes.hlines(places, low, high, color=BLUE, lw=3)
    axes.plot(middle, places, "o", color=BLUE, mfc="white", ms=6, label="posterior, 90 %")
    for step in study.by_seed:
        free = [NAMES.index(name) for name in step.free]
        axes.plot(step.deviations[free], places[free], "|", color=GREEN, ms=11, mew=1.5)
    axes.plot([], [], "|", color=GREEN, ms=11, mew=1.5, label="chosen departures, by seed")
    axes.axvline(0, color=GREY, lw=0.8)
    axes.set_yticks(places, NAMES)
    label_axes(axes, "standard deviations of the prior from the printed value", "")
    legend_below(figure)
    return figure


def draw_curves(study: SourceStudy) -> Figure:
    """Fits of all 44 curves against the published ones."""
    figure = new_figure(9.0, 4.2)
    panels = figure.subplots(1, 2)
    for axes, column, printed, label in (
        (panels[0], 0, PUBLISHED_F0, "$f_0$ (Hz)"),
        (panels[1], 1, PUBLISHED_RATIO, "$b/f_0$"),
    ):
        ends = [printed.min(), printed.max()]
        axes.plot(ends, ends, color=GREY, lw=0.8)
        for told in study.told:
            if told.name in _TOLD:
                colour, marker = _TOLD[told.name]
                axes.plot(printed, told.fits[0, :, column], marker, color=colour, mfc="none", ms=5, label=told.name)
        label_axes(axes, f"published {label}", f"simulated {label}")
    legend_below(figure)
    return figure


def draw_front(study: SourceStudy) -> Figure:
    """What cannot be had together: the single curves, the regressions on α, and 350 deg/s at 12 Hz."""
    made = study.learnt.evaluation
    squares = np.mean([residuals_of(made, k).values ** 2 for k in range(len(FITS_FROM))], axis=0)
    curves = squares[:, OF_CURVE | HAS_FIT].sum(axis=1)
    figure = new_figure(9.0, 4.2)
    panels = figure.subplots(1, 2)
    for axes, kind, label in (
        (panels[0], "R² of α", "$R^2$ of $\\alpha$ on $b/f_0$"),
        (panels[1], "12 Hz", "rate at 12 deg, 12 Hz"),
    ):
        other = squares[:, kind == KIND].sum(axis=1)
        axes.plot(curves, other, ".", color=GREY, ms=4)
        order = np.argsort(curves)
        front = order[other[order] <= np.minimum.accumulate(other[order])]
        axes.plot(curves[front], other[front], "o-", color=BLUE, ms=5, drawstyle="steps-post", label="cannot be beaten")
        label_axes(axes, "squared deviations of the 44 curves", f"squared deviations of {label}")
        axes.set_xscale("log")
        axes.set_yscale("log")
    legend_below(figure)
    return figure


def draw_trades(study: SourceStudy) -> Figure:
    """Which unknowns trade against each other: correlations of the posterior."""
    figure = new_figure(6.4, 5.6)
    axes = figure.add_subplot()
    image = axes.imshow(np.corrcoef(study.samples.T), cmap="RdBu", vmin=-1, vmax=1)
    axes.set_xticks(range(len(NAMES)), NAMES, rotation=45, ha="right", fontsize=8)
    axes.set_yticks(range(len(NAMES)), NAMES, fontsize=8)
    figure.colorbar(image, ax=axes, label="correlation")
    return figure
