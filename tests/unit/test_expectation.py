"""What gait to expect: Γ and softness by hand, where the laws say nothing, and what the command says."""

from __future__ import annotations

import json
import math
import sys

import pytest

from plategait.cli import main
from plategait.model.outline import Rectangle
from plategait.model.presets import preset
from plategait.simulation.expectation import expect, softness

CHEESE = preset("cheese").scenario


def test_gamma_and_softness_are_what_they_say():
    told = expect(CHEESE)
    omega = math.tau * 24
    assert told is not None
    assert told.gamma == pytest.approx(0.04 * math.radians(3) * omega**2 / 9.81)
    sheet = CHEESE.sheet
    undamped = CHEESE.replace(**{"sheet.bending_damping": 0.0})
    assert softness(undamped) == pytest.approx(omega / sheet.natural_frequency)
    loss = omega * sheet.bending_damping / sheet.bending_stiffness
    assert told.softness == pytest.approx(omega / sheet.natural_frequency / (1 + loss**2) ** 0.25)
    # 52 squares for a disk: 2 % from 3π/4.
    assert told.rigid_limit == pytest.approx(0.75 * math.pi, rel=0.03)
    assert told.rigid_limit < told.sliding_ends < told.runs_off
    assert told.top_spin == pytest.approx(0.003 * omega / 0.04)
    assert "top_spin" not in told.summary()
    assert told.summary()["top_spin_deg_s"] == pytest.approx(math.degrees(told.top_spin))


def test_gaits_follow_each_other():
    stiff = CHEESE.sheet.with_natural_frequency(40 * math.pi)
    wide = CHEESE.replace(**{"sheet": stiff, "motion.angle": math.radians(12)})
    gaits = [expect(wide.replace(**{"motion.frequency": f})) for f in (7.7, 9.4, 12.2, 15.4)]
    assert [g.gait for g in gaits if g] == ["sliding", "walking", "running", "run-off"]
    assert [g.words.split("expect ")[1].split(" (")[0] for g in gaits if g] == [g.gait for g in gaits if g]


def test_a_rectangle_counts_at_every_angle():
    across = CHEESE.replace(**{"sheet.outline": Rectangle(length=0.04, width=0.08)})
    along = CHEESE.replace(**{"sheet.outline": Rectangle(length=0.08, width=0.04)})
    one, other = expect(across), expect(along)
    assert one is not None
    assert other is not None
    assert one.gamma == pytest.approx(other.gamma)
    assert one.sliding_ends == pytest.approx(other.sliding_ends)


@pytest.mark.parametrize("changes", [
    {"motion.angle": 0.0}, {"sheet.bending_stiffness": 0.0},
    {"motion.waves": [{"axis": "z", "amplitude": 1e-3}]},
])  # fmt: skip
def test_where_the_laws_say_nothing_nothing_is_said(changes):
    assert expect(CHEESE.replace(**changes)) is None


@pytest.mark.parametrize("extra", [[], ["--json"]])
def test_the_command_says_what_to_expect(extra, capsys, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["plategait", "simulate", "--duration", "0.2 s", *extra])
    with pytest.raises(SystemExit):
        main()
    printed = capsys.readouterr().out
    if extra:
        assert json.loads(printed)["expected"]["gait"] == "walking"
    else:
        assert "Γ = 4.9 at the rim: expect walking" in printed
