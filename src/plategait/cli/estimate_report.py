"""What the estimate command prints for people."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from plategait.cli import report

if TYPE_CHECKING:
    from pathlib import Path

    from plategait.estimate.linear import LinearEstimate
    from plategait.estimate.planning import Plan
    from plategait.estimate.result import Estimate


def print_linear(result: LinearEstimate) -> None:
    """Print an estimate by the source's method, or why there is none."""
    if result.refused:
        print("no estimate: outside the method's domain")
        for reason in result.refused:
            print(f"  {reason}")
        print("try --method posterior, which has no such bounds")
        return
    numbers = result.summary()["parameters"]
    from plategait.estimate.result import LABELS

    rows = [
        [LABELS[n], f"{v['median']:.2f} ± {v['sd']:.2f} {v['unit']}", f"{v['low']:.2f} to {v['high']:.2f}"]
        for n, v in numbers.items()
    ]
    title = f"{result.method} method, {result.coefficients} coefficients"
    report.print_table(title, ["", "± one sd", "90 % interval"], rows)


def print_estimate(result: Estimate, plan: Plan | None) -> None:
    """Print a posterior's marginals, what to know of the fit, and what to measure next."""
    from plategait.estimate.result import LABELS, correlated

    shown = (*result.marginals, *result.stiffness)
    rows = [[LABELS[m.parameter.name], m.text, m.interval_text] for m in shown]
    read = "".join(f", {len(r.value)} of {r.observable.label}" for r in result.posterior.data.readings)
    title = f"{len(result.posterior.data.which)} points{read}, {result.posterior.runs.rates.size} runs of the engine"
    report.print_table(title, ["", "± one sd", f"{100 * result.confidence:g} % interval"], rows)
    for a, b, r in correlated(result):
        print(f"{LABELS[a]} and {LABELS[b]} are correlated: {r:+.2f}")
    report.print_table("assumed of the set-up", ["", "taken as"], [[a.label, a.text] for a in result.assumed])
    report.print_notes(result.posterior.data.notes)
    if result.model_error is not None:
        print(_model_error_text(result.model_error))
    outliers = [f"{f:g} Hz" for f in result.goodness.outliers] + list(result.goodness.outlying_readings)
    if outliers:
        print(f"probably outliers, left out in effect: {', '.join(outliers)}")
    for complaint in result.goodness.complaints:
        print(f"warning: not explained by any parameters: {complaint}")
    if plan is not None:
        _print_plan(result, plan)


def _model_error_text(error: dict[str, Any]) -> str:
    """What the model may be off by, in a line."""
    parts = [
        f"{c['label']} ({100 * c['rates']:.1f} % of the rates; the data take {c['taken']:+.1f} of it)"
        for c in error["changes"]
    ]
    return f"the model may be off, which the intervals hold: {', '.join(parts)}, {100 * error['own']:.2g} % at random"


def print_unexplained(written: Path | None, *, planned: bool) -> None:
    """Print what to do about data that no parameters explain, and what is withheld for it."""
    print("  the numbers above are not to be relied on: check the radius, the mass, A_p, B_p, the height, the duration "
          "and the slip limit told, and the points named")  # fmt: skip
    if written is not None:
        print(f"  {written} says so too")
    if planned:
        print("  no advice on what to measure next, as it would follow from these numbers")


def _print_plan(result: Estimate, plan: Plan) -> None:
    from plategait.estimate.planning import MOST_MEASUREMENTS
    from plategait.estimate.result import LABELS

    print(f"measure next at {plan.text_of(plan.condition)} "
          f"(runs off with a probability of {100 * plan.runs_off:.0f} %)")  # fmt: skip
    for p in (m.parameter for m in result.marginals):
        now, after = plan.sd_now[p.name] / p.scale, plan.sd_after[p.name] / p.scale
        unit = f" {p.unit}".rstrip()
        print(f"  {LABELS[p.name]}: sd {now:.2g}{unit} now, {after:.2g}{unit} expected after it")
    if plan.needed:
        least, median, most = (f"{n}{' or more' if n >= MOST_MEASUREMENTS else ''}" for n in plan.needed)
        print("  the precision wanted is there" if plan.needed[1] == 0 else
              f"  measurements for the precision wanted: about {median} ({least} to {most})")  # fmt: skip
    if plan.programme:
        print(f"or, to measure {len(plan.programme)} motions before the next estimate:")
        for condition, sd in plan.programme:
            left = ", ".join(f"{LABELS[p.name]} to {sd[p.name] / p.scale:.2g} {p.unit}".rstrip()
                             for p in (m.parameter for m in result.marginals[:2]))  # fmt: skip
            print(f"  {plan.text_of(condition)} ({left})")
