"""Studies that answer questions: errors of numbers, runs that are kept, the catalogue, the report, the command."""

from __future__ import annotations

import json
import math
import sys

import pytest

from plategait.cli import main
from plategait.errors import InputError
from plategait.model.presets import preset
from plategait.study import answers, catalogue
from plategait.study.answers import answer_questions
from plategait.study.catalogue import QUESTIONS, Question, find_questions
from plategait.study.claims import Answer, Claim, Number, number_of
from plategait.study.measured import Measured
from plategait.study.report import write_answers
from plategait.study.runs import Runs, open_runs
from plategait.thesis.item import Table

CHEESE = preset("cheese").scenario.replace(duration=0.2)


def some(*frequencies: float):
    return [CHEESE.replace(**{"motion.frequency": f}) for f in frequencies]


def test_a_number_has_the_error_of_its_starts_and_of_its_step():
    rows = (({"a": 1.0}, {"a": 3.0}), ({"a": 5.0}, {"a": math.nan}))
    half = (({"a": 2.5}, {"a": 2.5}), ({"a": 5.0}, {"a": 5.0}))
    number = number_of(Measured(rows, half), lambda c: c["a"][1] - c["a"][0])
    assert number.value == 5 - 2
    assert number.step_error == 2.5 - 3
    # One start has no second point, so that one is left, and one has no spread.
    assert math.isnan(number.ensemble_error)
    number = number_of(Measured(rows), lambda c: c["a"][0])
    assert number.ensemble_error == pytest.approx(math.sqrt(2) / math.sqrt(2))
    assert math.isnan(number.step_error)
    assert number.interval == pytest.approx((0.0, 4.0))
    assert Number(1.0).interval is None
    assert Number(2.0, 0.3, 0.2).interval == pytest.approx((1.5, 2.5))


def test_runs_that_are_kept_are_found_to_the_same_bits(tmp_path):
    whole = Runs().measure(some(18, 24), repeats=2, half_step=True)
    with open_runs(tmp_path / "runs") as runs:
        runs.measure(some(24), repeats=1)
    # Killed within a line: what it held is run again.
    journal = tmp_path / "runs" / "runs.jsonl"
    journal.write_bytes(journal.read_bytes()[:-20])
    told = []
    with open_runs(tmp_path / "runs", told.append, 2 * 2 * 2 * 0.2) as runs:
        again = runs.measure(some(18, 24), repeats=2, half_step=True)
    assert told[-1] == pytest.approx(1.0)
    with open_runs(tmp_path / "runs") as runs:
        size = journal.stat().st_size
        kept = runs.measure(some(18, 24), repeats=2, half_step=True)
        assert journal.stat().st_size == size
    assert str(whole.rows) == str(again.rows) == str(kept.rows)
    assert str(whole.half) == str(kept.half)
    assert whole.column("spin_rate").shape == (2, 2)
    assert whole.part([1]).rows == whole.rows[1:]


def test_other_work_is_done_once():
    runs, calls = Runs(), []

    def work():
        calls.append(1)
        return {"x": 2.0}

    assert [runs.once({"what": "it"}, work)["x"] for _ in range(3)] == [2.0] * 3
    assert calls == [1]
    runs.once({"what": "another"}, work)
    assert calls == [1, 1]


def test_a_folder_of_something_else_is_refused(tmp_path):
    (tmp_path / "runs").mkdir()
    (tmp_path / "runs" / "letter.txt").write_text("dear")
    with pytest.raises(InputError, match=r"--out: .*other files"), open_runs(tmp_path / "runs"):
        pass


def test_every_question_of_the_catalogue_has_who_answers():
    assert [q.name for q in find_questions([])] == [q.name for q in QUESTIONS]
    with pytest.raises(InputError, match=r"study: got 'tortion'.*torsion"):
        find_questions(["tortion"])
    assert all(q.asks.endswith("?") and q.simulated > 0 for q in QUESTIONS)


@pytest.fixture
def answered(monkeypatch):
    """A question that is answered at once, by one claim that holds and one that is refuted."""
    from plategait.plots.style import new_figure

    claims = (
        Claim("two is below three", True, Number(2.0, 0.1, 0.05), "Hz", "at 3 deg"),
        Claim("two is above three", False, Number(2.0)),
    )
    table = Table("toy-table", ("a",), ((1.0,), (math.nan,)))
    answer = Answer("torsion", "Is it?", "It is.", claims, (table,), (("toy", new_figure(2, 2)),), ("A note.",))
    monkeypatch.setattr(Question, "answer", lambda self, runs: answer)
    monkeypatch.setattr(catalogue, "QUESTIONS", tuple(q for q in QUESTIONS if q.name == "torsion"))
    return answer


def test_the_report_holds_everything_and_fetches_nothing(answered, tmp_path):
    page = write_answers(answer_questions(), tmp_path).read_text()
    assert "It is." in page
    assert "two is above three" in page
    assert "A note." in page
    assert "data:image/png" in page
    assert 'class="no"' in page
    assert "src=" in page
    assert "http" not in page
    assert {p.name for p in tmp_path.iterdir()} == {
        "report.html", "toy.png", "toy-table.csv", "torsion-claims.csv", "torsion.json"
    }  # fmt: skip
    told = json.loads((tmp_path / "torsion.json").read_text())
    assert told["claims"][0] == {
        "claim": "two is below three", "holds": True, "number": 2.0, "unit": "Hz", "note": "at 3 deg",
        "interval": pytest.approx([2 - math.hypot(0.1, 0.1), 2 + math.hypot(0.1, 0.1)]),
        "step_error": 0.1, "ensemble_error": 0.05,
    }  # fmt: skip
    assert told["claims"][1]["interval"] is None
    assert told["claims"][1]["step_error"] is None
    assert answered.claim("two is above").holds is False


@pytest.mark.parametrize("typed", [["study", "torsion", "--json"], ["study", "all", "--json"], ["study"]])
def test_the_command_answers(answered, typed, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", ["plategait", *typed])
    with pytest.raises(SystemExit) as end:
        main()
    assert not end.value.code
    printed = capsys.readouterr().out
    if "--json" in typed:
        told = json.loads(printed)
        one = told if typed[1] == "torsion" else told["studies"][0]
        assert one["verdict"] == "It is."
        assert one["claims"][0]["holds"]
    else:
        assert "It is." in printed
        assert "two is above three" in printed
    assert (tmp_path / "studies" / "report.html").is_file()
    assert (tmp_path / "studies" / "runs").is_dir()
    assert answers.answer_questions(["torsion"])[0] is answered
