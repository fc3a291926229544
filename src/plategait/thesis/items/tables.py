"""Tables 4.1 and 5.1 to 5.9, appendices A and B, and the regressions of estimated on real values."""

from __future__ import annotations

import math

import numpy as np

from plategait import published
from plategait.model.presets import preset
from plategait.published import Number
from plategait.thesis import draw
from plategait.thesis.cases import Case
from plategait.thesis.fits import ensemble_spread, published_curves, simulated_fits
from plategait.thesis.item import Cell, Check, Comparison, Item, Spec, Table, verdict
from plategait.thesis.runs import Results, value_of


def table_4_1(spec: Spec, results: Results) -> Item:
    """Parameters of the object, as printed and as the preset has them."""
    cheese = preset("cheese").scenario
    comparisons: list[Comparison] = []
    rows: list[tuple[Cell, ...]] = []
    for symbol, path, value, unit, factor in published.numbers()["object"]["rows"]:
        own: object = cheese
        for name in path.split("."):
            own = getattr(own, name)
        number = float(own) / factor  # type: ignore[arg-type]
        rows.append((symbol, value, number, unit))
        if symbol != "c_b":
            comparisons.append(Comparison(f"{symbol} ({unit})", Number(value, "Table 4.1"), number, 0.005))
    nodes = cheese.sheet.lattice.n_nodes
    checks = (Check("nodes of the lattice", "52", str(nodes), nodes == 52),)
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons, checks, "c_b is ten times the printed one by choice."),
        tables=(Table("table4.1", ("symbol", "published", "here", "unit"), tuple(rows)),),
        comparisons=tuple(comparisons),
        checks=checks,
    )


def table_estimates(spec: Spec, results: Results) -> Item:
    """One of Tables 5.1 to 5.8: stiffness and friction estimated by our own p and q."""
    name = spec.name.removeprefix("table")
    angle = next(c.angle_deg for c in published.curves() if c.table == name)
    fits = simulated_fits(results, angle)
    rows: list[tuple[Cell, ...]] = []
    errors: list[tuple[float, float]] = []
    for i, curve in enumerate(published_curves(angle)):
        if curve.table != name:
            continue
        omega, alpha = float(fits.omega_estimate[i]), float(fits.alpha_estimate[i])
        errors.append((abs(omega - curve.omega_pi), abs(alpha - curve.alpha_deg)))
        rows.append(
            (
                curve.omega_pi,
                curve.omega_estimate_pi,
                omega,
                curve.omega_error_pi,
                errors[-1][0],
                curve.alpha_deg,
                curve.alpha_estimate_deg,
                alpha,
                curve.alpha_error_deg,
                errors[-1][1],
            )
        )
    means = np.nanmean(np.array(errors), axis=0)
    known = published.numbers()["average_errors"][name]
    comparisons = tuple(
        Comparison(
            f"mean error of {symbol}", Number(known[j], f"Table {name}", unit), float(means[j]), allowed, absolute=True
        )
        for j, (symbol, unit, allowed) in enumerate((("ω_n", "π rad/s", 2.0), ("α", "deg", 3.0)))
    )
    columns = (
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
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons),
        tables=(Table(spec.name, columns, tuple(rows)),),
        comparisons=comparisons,
        notes=("Estimates use the p and q of our own regressions, as the source's use its own.",),
    )


def table_5_9(spec: Spec, results: Results) -> Item:
    """Bending and rotation frequency of each object."""
    rows: list[tuple[Cell, ...]] = []
    comparisons: list[Comparison] = []
    for angle, omega, f_n, peak, f_b in published.numbers()["rotation"]["rows"]:
        cases = [Case(angle, omega, c.alpha_deg) for c in published_curves(angle) if c.omega_pi == omega]
        best = max(cases, key=lambda c: np.nan_to_num(value_of(results[c].fit, "peak"), nan=-1.0))
        ours = value_of(results[best].fit, "peak")
        rows.append((angle, omega, f_n, peak, ours, f_b, ours / 360, best.alpha_deg))
        comparisons.append(
            Comparison(
                f"ω_Br max, {angle} deg, {omega:g}π (deg/s)",
                Number(peak, "Table 5.9"),
                ours,
                0.15,
                spread=results[best].member_spread("peak"),
                half_step=results.effect(best, "half step", "peak"),
            )
        )
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
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons),
        tables=(Table("table5.9", columns, tuple(rows)),),
        comparisons=tuple(comparisons),
        notes=("The largest over the friction angles; a fitted peak, not the highest point.",),
    )


def table_a(spec: Spec, results: Results) -> Item:
    """R² of the Lorentz fits, Table A.1 or A.2."""
    name = spec.name.removeprefix("table")
    rows: list[tuple[Cell, ...]] = []
    ours: list[float] = []
    for curve in published.curves():
        if curve.r2_table == name:
            runs = results[Case(curve.angle_deg, curve.omega_pi, curve.alpha_deg)]
            ours.append(value_of(runs.fit, "r2"))
            rows.append((curve.omega_pi, curve.alpha_deg, curve.r2, ours[-1], runs.member_spread("r2")))
    least = min(c.r2 for c in published.curves() if c.r2_table == name)
    middle, worst = float(np.nanmedian(ours)), float(np.nanmin(ours))
    checks = (
        Check("median R²", f"at least {least:g}, the lowest published", f"{middle:.3f}", middle >= least),
        Check("every R²", "at least 0.9", f"lowest {worst:.3f}", worst >= 0.9 and not np.isnan(ours).any()),
    )
    columns = ("ω_n (π rad/s)", "α (deg)", "published R²", "R²", "sd over the starts")
    return Item(
        spec.name,
        spec.title,
        verdict(checks=checks),
        tables=(Table(spec.name, columns, tuple(rows)),),
        checks=checks,
        notes=("Our curves start with a plateau of slow sliding and are flatter on top than a Lorentzian.",),
    )


def fig_estimates(spec: Spec, results: Results) -> Item:
    """Estimated against real values with the 95 % band, Fig. 5.11 or 5.12."""
    omega = spec.name == "fig5.11"
    quantity, unit = ("omega", "π rad/s") if omega else ("alpha", "deg")
    figure, panels = draw.panels(2)
    comparisons: list[Comparison] = []
    for axes, angle, letter in zip(panels, published.AMPLITUDES, "ab", strict=True):
        fits = simulated_fits(results, angle)
        line = fits.omega_check if omega else fits.alpha_check
        real, estimate = (fits.omega_pi, fits.omega_estimate) if omega else (fits.alpha_deg, fits.alpha_estimate)
        known = [c.omega_estimate_pi if omega else c.alpha_estimate_deg for c in published_curves(angle)]
        axes.plot(real, known, **draw.PUBLISHED)
        axes.plot(real, estimate, "o", mfc="white", color=draw.COLOURS[0], ms=4, label="ours")
        draw.line(axes, line, real, band=True)
        axes.plot(real, real, color=draw.COLOURS[6], lw=0.8)
        axes.legend(frameon=False, fontsize=8)
        draw.plain(axes, f"real ({unit})", f"estimated ({unit})", f"({letter}) A_p = {angle} deg")
        for attribute, allowed in (("r2", 0.05), ("slope", 0.05), ("intercept", 2.0)):
            comparisons.append(
                Comparison(
                    f"{'R²' if attribute == 'r2' else attribute}, A_p = {angle} deg",
                    published.regression(angle)[f"{attribute}_{quantity}"],
                    getattr(line, attribute),
                    allowed,
                    absolute=True,
                    spread=ensemble_spread(
                        results,
                        angle,
                        lambda f, a=attribute: float(getattr(f.omega_check if omega else f.alpha_check, a)),
                    ),
                )
            )
    return Item(
        spec.name,
        spec.title,
        verdict(comparisons),
        ((spec.name, figure),),
        comparisons=tuple(comparisons),
        notes=(
            "For a regression on its own data the slope equals R², and the intercept follows from the mean: "
            "these are one number, not three.",
        ),
    )


def appendix_b(spec: Spec, results: Results) -> Item:
    """Do slope and intercept of α̂ on α differ from 1 and 0? Tables B.1 and B.2."""
    rows: list[tuple[Cell, ...]] = []
    checks: list[Check] = []
    for angle in published.AMPLITUDES:
        known, line = published.regression(angle), simulated_fits(results, angle).alpha_check
        tests = {
            "t_slope": line.t_slope()[0],
            "t_intercept": line.t_intercept()[0],
            "p_intercept": line.t_intercept()[1],
            "t_unit_slope": line.t_slope(1.0)[0],
            "p_unit_slope": line.t_slope(1.0)[1],
            "slope_alpha": line.slope,
            "intercept_alpha": line.intercept,
            "freedom": float(line.freedom),
        }
        for name, value in tests.items():
            spread = math.nan
            if name in ("slope_alpha", "intercept_alpha"):
                attribute = name.removesuffix("_alpha")
                spread = ensemble_spread(results, angle, lambda f, a=attribute: float(getattr(f.alpha_check, a)))
            rows.append((angle, name.replace("_", " "), known[name].value, value, spread, known[name].where))
        for what, p in (
            ("slope does not differ from 1", tests["p_unit_slope"]),
            ("intercept does not differ from 0", tests["p_intercept"]),
        ):
            checks.append(Check(f"{what}, A_p = {angle} deg", "p above 0.05", f"p = {p:.3f}", p > 0.05))
    columns = ("A_p (deg)", "number", "published", "ours", "sd over the starts", "where")
    note = (
        "In-sample the slope equals R² whatever the truth: the test then asks only whether R² is near enough 1 for "
        "so few points, and a lower R² fails it."
    )
    return Item(
        spec.name,
        spec.title,
        verdict(checks=checks),
        tables=(Table("appendixB", columns, tuple(rows)),),
        checks=tuple(checks),
        notes=(note,),
    )
