"""What `estimate` does with a curve that no object makes: it says so wherever its numbers go, and advises nothing."""

from __future__ import annotations

import json

import pytest

from plategait.estimate.result import estimate_parameters

pytestmark = pytest.mark.linear_algebra

# Rates that fall where every sheet's rise.
FALLING = "frequency_hz,spin_rate_deg_s\n14,500\n17,350\n20,200\n23,60\n"
COMMAND = ("estimate", "falling.csv", "--next", "--noise", "0.01", "--beta", "0.6", "--duration", "0.5 s")


def test_an_unexplained_fit_is_told_in_the_file_and_gives_no_advice(tmp_path, called, monkeypatch):
    made = []

    def made_once(*given, **named):
        """The estimate, which both commands ask for with the same seed."""
        made.append(made[0] if made else estimate_parameters(*given, **named))
        return made[-1]

    monkeypatch.setattr("plategait.estimate.result.estimate_parameters", made_once)
    (tmp_path / "falling.csv").write_text(FALLING, encoding="utf-8")
    done = called(*COMMAND, "--out", "object.toml", cwd=tmp_path, check=1)
    assert "not explained by any parameters" in done.stdout
    assert "not to be relied on" in done.stdout
    assert "measure next at" not in done.stdout
    assert "no advice on what to measure next" in done.stdout
    told = json.loads(called(*COMMAND, "--json", cwd=tmp_path, check=1).stdout)
    assert len(made) == 2
    assert not told["explained"]
    assert told["next"] is None
    determined = [name for name, m in told["parameters"].items() if m["verdict"] == "determined"]
    if determined:
        assert "NOT TO BE RELIED ON" in (tmp_path / "object.toml").read_text(encoding="utf-8").splitlines()[0]
    else:
        assert not (tmp_path / "object.toml").exists()
