"""`plategait study`: questions that the dissertation leaves open, answered with numbers."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from plategait.cli import options, report
from plategait.cli.command import Command, Group
from plategait.files.output import write_whole
from plategait.study.catalogue import QUESTIONS, Question
from plategait.study.defaults import FIRST, GENERATIONS, SEEDS

if TYPE_CHECKING:
    from plategait.study.source import SourceStudy

FOLDER = Path("studies")
Out = Annotated[
    Path,
    typer.Option("--out", metavar="FOLDER", help="Folder for report.html, its figures, tables and JSON, and the runs."),
]

study = typer.Typer(
    cls=Group, help="Studies: what the dissertation leaves open, answered with numbers and their uncertainty."
)


@study.callback(invoke_without_command=True)
def _studies(context: typer.Context) -> None:
    """Studies: what the dissertation leaves open, answered with numbers and their uncertainty.

    By itself it is `plategait study all`.
    """
    if context.invoked_subcommand is None:
        _answered((), FOLDER, False)


@study.command("all", cls=Command)
def all_of_them(out: Out = FOLDER, as_json: options.Json = False) -> None:
    """Answer every question but `source`, which searches for long, in one report.

    Interrupted, the same command goes on where it was, and gives the same numbers.
    """
    _answered((), out, as_json)


def _add_question(question: Question) -> None:
    """Make a command of a question."""

    def answer(out: Out = FOLDER, as_json: options.Json = False) -> None:
        _answered((question.name,), out, as_json)

    text = f"{question.asks}\n\nInterrupted, the same command goes on where it was, and gives the same numbers."
    study.command(question.name, cls=Command, help=text)(answer)


for _question in QUESTIONS:
    _add_question(_question)


def _answered(names: tuple[str, ...], out: Path, as_json: bool) -> None:
    """Answer questions, write their report and print what they say; one by its name prints one JSON object."""
    from plategait.study import answers
    from plategait.study.report import claims_table, write_answers
    from plategait.thesis.page import prepare_folder

    prepare_folder(out, str(FOLDER))
    with report.progress_bar("answering") as progress, report.going_on_in(out):
        found = answers.answer_questions(names, out / "runs", progress)
    page = write_answers(found, out)
    if as_json:
        summaries = [answer.summary() for answer in found]
        report.print_json(summaries[0] if names else {"studies": summaries})
        return
    for answer in found:
        table = claims_table(answer)
        rows = [[str(cell) for cell in row[:7]] for row in table.rows]
        report.print_table(f"{answer.name}: {answer.question}", list(table.columns[:7]), rows)
        print(answer.verdict + "\n")
    print(f"report: {page}")


@study.command(cls=Command)
def source(
    out: Annotated[
        Path, typer.Option("--out", metavar="FOLDER", help="Folder for stores, figures and source.json.")
    ] = Path("source"),
    seeds: Annotated[int, typer.Option("--seeds", help="Independent searches.", min=1)] = SEEDS,
    evaluations: Annotated[int, typer.Option("--evaluations", help="Of each search over the priors.", min=32)] = FIRST,
    generations: Annotated[
        int, typer.Option("--generations", help="Of 16 evaluations each, from the best of them.", min=0)
    ] = GENERATIONS,
    dask: options.Dask = None,
    as_json: options.Json = False,
) -> None:
    """Search everything that the source's simulations leave open, against all that it published.

    Interrupted, the same command goes on where it was.
    """
    from plategait.plots.style import save
    from plategait.study import figures
    from plategait.study.source import study_source
    from plategait.thesis.page import prepare_folder

    prepare_folder(out, "source")
    with report.progress_bar("searching") as progress:
        found = study_source(
            out / "stores", seeds=seeds, first=evaluations, generations=generations, dask=dask, progress=progress
        )
    for name in ("departures", "unknowns", "curves", "trades", "front"):
        save(getattr(figures, f"draw_{name}")(found), out / f"{name}.png")
    summary = found.summary()
    write_whole(json.dumps(summary, indent=2, ensure_ascii=False).encode(), out / "source.json", (".json",))
    report.print_json(summary) if as_json else _print(found)


def _print(found: SourceStudy) -> None:
    rows = []
    for name, told in found.summary()["unknowns"].items():
        low, middle, high = told["interval"]
        rows.append([name, f"{middle:.3g}", f"{low:.3g} to {high:.3g}", "yes" if told["determined"] else "no"])
    report.print_table("what the published data say of each unknown", ["", "median", "90 %", "determined"], rows)
    departures = ", ".join(f"{name} {found.chosen.choice[name]:.3g}" for name in found.chosen.free) or "none"
    print(f"departures that pay for themselves, with the {found.chosen.law} law: {departures}\n")
    rows = [
        [t["name"], f"{t['loss'][0]:.0f}", f"{100 * t['median_f0']:.1f}", f"{100 * t['largest_f0']:.1f}",
         f"{100 * t['median_b_over_f0']:.1f}", f"{t['rate_at_12_hz_deg_s']:.0f}", str(t["without_fit"])]
        for t in found.summary()["told"]
    ]  # fmt: skip
    columns = ["", "loss", "median |Δf0| %", "largest %", "median |Δ(b/f0)| %", "deg/s at 12 Hz", "no fit"]
    report.print_table("choices, simulated with four starts", columns, rows)
    rows = [
        [t.name, f"{t.findings.loss():.0f}", f"{f['objects_with_one_best_acceleration']} of 8",
         ", ".join("none" if a is None else f"{a:.0f}" for a in f["best_friction_deg"].values()),
         f"{100 * f['change_of_b_over_f0_with_damping']:+.1f}", f"{f['stroke_exponent']:.2f}"]
        for t in found.told for f in [t.findings.summary()]
    ]  # fmt: skip
    columns = ["", "loss", "one best acceleration", "best α sliding, walking, running", "Δ(b/f0) with damping %",
               "power of B_p"]  # fmt: skip
    report.print_table("what the search does not look at", columns, rows)
