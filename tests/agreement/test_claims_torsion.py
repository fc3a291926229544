"""The study of torsion, small: what it claims of the isotropic plate fails here if it fails there."""

from __future__ import annotations

import numpy as np

from plategait.study.questions.torsion import CASES, sheet_with
from plategait.study.runs import Runs


def test_torsion_changes_the_spin_rates_little_and_the_dish_mode_more():
    cases, frequencies = [CASES[0], CASES[3], CASES[4]], (20.0, 22.0, 24.0)
    scenarios = [sheet_with(*case, motion__frequency=f, duration=1.2) for case in cases for f in frequencies]
    spin = Runs().measure(scenarios).means["spin_rate"].reshape(3, -1)
    change = spin / spin[0] - 1
    # As claimed: less than 8 and 10 % at the peak; 4 and 6 % are found.
    assert 0.01 < change[1].max() < 0.08
    assert change[2].max() < 0.10
    # The rising side stays: 0.3 Hz are 6 % of the rate at 20 Hz.
    assert np.abs(change[:, :2]).max() < 0.06
    dish = [sheet_with(*case).sheet.natural_frequency for case in cases[:2]]
    assert 1.10 < dish[1] / dish[0] < 1.14
