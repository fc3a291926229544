"""Tables 4.1, 5.1 to 5.9, A.1 and A.2: parameters, estimates, highest peaks, R² of the fits."""

from __future__ import annotations

from operator import attrgetter

import numpy as np

from plategait import published
from plategait.model.inferred import NOTES
from plategait.model.presets import preset
from plategait.published import Number
from plategait.thesis.cases import Case
from plategait.thesis.fits import published_curves, simulated_fits
from plategait.thesis.item import Cell, Check, Comparison, Item, Spec, Table
from plategait.thesis.runs import CaseRuns, Results, value_of


def table_4_1(spec: Spec, results: Results) -> Item:
    """Parameters of the object, as printed and as the preset has them."""
    cheese = preset("cheese").scenario
    rows: list[tuple[str, float, float, str]] = []
    inferred: list[str] = []
    for symbol, path, value, unit, factor in published.numbers()["object"]["rows"]:
        inferred += [symbol] * (path in NOTES)
        rows.append((symbol, value, float(attrgetter(path)(cheese)) / factor, unit))
    nodes = cheese.sheet.lattice.n_nodes
    return spec.item(
        tables=[Table(spec.name, ("symbol", "published", "here", "unit"), tuple(rows))],
        comparisons=[
            Comparison(f"{symbol} ({unit})", Number(value, "Table 4.1"), number, 0.005)
            for symbol, value, number, unit in rows
            if symbol not in inferred
        ],
        checks=[Check("nodes of the lattice", "52", str(nodes), nodes == 52)],
        remark=f"Inferred instead of printed: {', '.join(inferred)}.",
    )


_ESTIMATE_COLUMNS = (
    "ω_n (π rad/s)",
    "published estimate",
    "estimate",
    "published error",
    "error",
    "α (deg)",
    "published estimate of α",
    "estimate of α",
    "published error of α",
    "error of α",
)


def table_estimates(spec: Spec, results: Results) -> Item:
    """One of Tables 5.1 to 5.8: stiffness and friction estimated by our own p and q."""
    name = spec.name.removeprefix("table")
    rows = _estimate_rows(results, name)
    return spec.item(
        tables=[Table(spec.name, _ESTIMATE_COLUMNS, tuple(rows))],
        comparisons=_compare_errors(name, rows),
        notes=["Estimates use the p and q of our own regressions, as the source's use its own."],
    )


def _estimate_rows(results: Results, name: str) -> list[tuple[float, ...]]:
    """Rows of one of the tables, in `_ESTIMATE_COLUMNS`."""
    angle = next(c.angle_deg for c in published.curves() if c.table == name)
    fits = simulated_fits(results, angle)
    estimates = zip(published_curves(angle), fits.omega_estimate, fits.alpha_estimate, strict=True)
    return [
        (
            *(c.omega_pi, c.omega_estimate_pi, float(omega), c.omega_error_pi, abs(float(omega) - c.omega_pi)),
            *(c.alpha_deg, c.alpha_estimate_deg, float(alpha), c.alpha_error_deg, abs(float(alpha) - c.alpha_deg)),
        )
        for c, omega, alpha in estimates
        if c.table == name
    ]


def _compare_errors(name: str, rows: list[tuple[float, ...]]) -> list[Comparison]:
    """Mean errors of ω_n and α beside the printed ones."""
    of_omega, of_alpha = np.nanmean(np.array([(row[4], row[9]) for row in rows]), axis=0).tolist()
    printed_omega, printed_alpha = published.numbers()["average_errors"][name]
    return [
        Comparison(
            f"mean error of {symbol}", Number(printed, f"Table {name}", unit), float(mean), allowed, absolute=True
        )
        for symbol, unit, printed, mean, allowed in (
            ("ω_n", "π rad/s", printed_omega, of_omega, 2.0),
            ("α", "deg", printed_alpha, of_alpha, 3.0),
        )
    ]


def table_5_9(spec: Spec, results: Results) -> Item:
    """Bending and rotation frequency of each object."""
    columns = (
        "A_p (deg)",
        "ω_n (π rad/s)",
        "f_n (Hz)",
        "published ω_Br max (deg/s)",
        "ω_Br max (deg/s)",
        "published f_B (Hz)",
        "f_B (Hz)",
        "α of ours (deg)",
    )
    rows: list[tuple[Cell, ...]] = []
    for angle, omega, f_n, peak, f_b in _rotation_rows():
        fastest = _fastest(results, angle, omega)
        ours = value_of(fastest.fit, "peak")
        rows.append((angle, omega, f_n, peak, ours, f_b, ours / 360, fastest.case.alpha_deg))
    return spec.item(
        tables=[Table(spec.name, columns, tuple(rows))],
        comparisons=peak_comparisons(results),
        notes=["The largest over the friction angles; a fitted peak, not the highest point."],
    )


def _rotation_rows() -> list[tuple[int, float, float, float, float]]:
    """Printed A_p (deg), ω_n (π rad/s), f_n (Hz), ω_Br max (deg/s) and f_B (Hz) of each object."""
    return [tuple(row) for row in published.numbers()["rotation"]["rows"]]


def _fastest(results: Results, angle: int, omega: float) -> CaseRuns:
    """Runs of one object at the friction angle of its highest fitted peak."""
    runs = [results[Case(angle, omega, c.alpha_deg)] for c in published_curves(angle) if c.omega_pi == omega]
    return max(runs, key=lambda r: np.nan_to_num(value_of(r.fit, "peak"), nan=-1.0))


def peak_comparisons(results: Results) -> list[Comparison]:
    """Highest peak of each object of Table 5.9 beside the published one."""
    comparisons = []
    for angle, omega, _, peak, _ in _rotation_rows():
        fastest = _fastest(results, angle, omega)
        comparisons.append(
            Comparison(
                f"ω_Br max, {angle} deg, {omega:g}π (deg/s)",
                Number(peak, "Table 5.9"),
                value_of(fastest.fit, "peak"),
                0.15,
                spread=fastest.member_spread("peak"),
                half_step=results.effect(fastest.case, "half step", "peak"),
            )
        )
    return comparisons


def table_a(spec: Spec, results: Results) -> Item:
    """R² of the Lorentz fits, Table A.1 or A.2."""
    curves = [c for c in published.curves() if c.r2_table == spec.name.removeprefix("table")]
    runs = [results[Case(c.angle_deg, c.omega_pi, c.alpha_deg)] for c in curves]
    ours = [value_of(r.fit, "r2") for r in runs]
    rows = tuple(
        (c.omega_pi, c.alpha_deg, c.r2, r2, r.member_spread("r2")) for c, r, r2 in zip(curves, runs, ours, strict=True)
    )
    columns = ("ω_n (π rad/s)", "α (deg)", "published R²", "R²", "sd over the starts")
    least, middle, worst = min(c.r2 for c in curves), float(np.nanmedian(ours)), float(np.nanmin(ours))
    return spec.item(
        tables=[Table(spec.name, columns, rows)],
        checks=[
            Check("median R²", f"at least {least:g}, the lowest published", f"{middle:.3f}", middle >= least),
            Check("every R²", "at least 0.9", f"lowest {worst:.3f}", worst >= 0.9 and not np.isnan(ours).any()),
        ],
        notes=["Our curves start with a plateau of slow sliding and are flatter on top than a Lorentzian."],
    )
