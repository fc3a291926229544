"""The estimator's parts, each against what is known without it."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import norm

from plategait.curve.curve import Curve
from plategait.curve.lorentz import LorentzFit
from plategait.curve.protocol import measured_as
from plategait.errors import InputError
from plategait.estimate import unknowns as parameters
from plategait.estimate.assumptions import assumptions
from plategait.estimate.candidates import reach_of
from plategait.estimate.emulator import brackets, fit_rates, fit_run_off, log_between
from plategait.estimate.handling import Handling
from plategait.estimate.identifiability import marginal_of
from plategait.estimate.linear import estimate_linear, line
from plategait.estimate.observations import Condition, observe_curves
from plategait.estimate.stiffness import stiffness_of
from plategait.estimate.unknowns import FRICTION_ANGLE, NATURAL_FREQUENCY, unknowns
from plategait.model.machine import Machine, Sliding, Turning
from plategait.model.presets import preset

pytestmark = pytest.mark.linear_algebra

CHEESE = measured_as(preset("cheese").scenario)
MOTION = CHEESE.motion


def curve(frequency, rate, failure=None, sd=None, angle=None, values=None, value_sds=None, **motion) -> Curve:
    n = len(frequency)
    of = {name: {k: np.array(x, float) for k, x in (given or {}).items()}
          for name, given in (("values", values), ("value_sds", value_sds))}  # fmt: skip
    return Curve("c", np.array(frequency, float), np.array(rate, float),
                 np.full(n, math.nan) if sd is None else np.array(sd, float), ("",) * n,
                 tuple(failure or ("",) * n), **of, **{name: np.array(x, float) for name, x in motion.items()},
                 angle_deg=None if angle is None else np.array(angle, float))  # fmt: skip


# Parameters


MEASURED = (parameters.BENDING_DAMPING.measured(1.0, 0.1), parameters.PLATE_HEIGHT.measured(6e-3, 1e-3))


@given(st.floats(0, 1), st.sampled_from([*parameters.ALL, *MEASURED]))
def test_share_is_the_inverse_of_value(u, parameter):
    assert parameter.share(float(parameter.value(u))) == pytest.approx(u, abs=1e-12)
    slack = 1e-12 * abs(parameter.high)
    assert parameter.low - slack <= parameter.value(u) <= parameter.high + slack


def test_a_measured_parameter_has_its_own_spread_for_a_prior():
    """Even shares are draws of the prior: normal, cut at three standard deviations, which takes 1.3 % of its width."""
    u = (np.arange(20000) + 0.5) / 20000
    height = MEASURED[1].value(u)
    assert height.mean() == pytest.approx(6e-3, rel=1e-6)
    assert height.std() == pytest.approx(1e-3, rel=0.02)
    factor = np.log(MEASURED[0].value(u))
    assert factor.std() == pytest.approx(0.1, rel=0.02)


def test_the_scenario_has_the_values_asked_for():
    sought = unknowns(CHEESE, free=("mass", "contact_damping"))
    by_name = {"natural_frequency": 20 * math.pi, "friction_angle": math.radians(40), "friction_ratio": 0.7,
               "bending_damping": 2.0, "plate_height": 8e-3, "mass": 1.1, "contact_damping": 0.5}  # fmt: skip
    scenario = sought.scenario([by_name[name] for name in sought.names])
    assert scenario.sheet.natural_frequency == pytest.approx(20 * math.pi, rel=1e-9)
    assert scenario.sheet.mass == pytest.approx(1.1 * CHEESE.sheet.mass)
    assert scenario.friction.angle == pytest.approx(math.radians(40))
    assert scenario.friction.ratio == pytest.approx(0.7)
    assert scenario.sheet.bending_damping == pytest.approx(2 * CHEESE.sheet.bending_damping)
    assert scenario.contact.damping == pytest.approx(0.5 * CHEESE.contact.damping)
    assert scenario.motion.height == 8e-3


def test_what_nobody_knows_of_the_setup_is_sought_unless_it_is_known():
    told = CHEESE.replace(**{"motion.height": "20 mm"})
    sought = unknowns(told)
    assert sought.names[3:] == ["bending_damping", "plate_height"]
    height = sought.parameters[-1]
    assert (height.low, height.high) == pytest.approx((15e-3, 25e-3))
    assert unknowns(told, fixed=("bending_damping", "plate_height")).names == sought.names[:3]
    measured = unknowns(told, measured={"plate_height": (7e-3, 1e-3)}).parameters[-1]
    assert (measured.low, measured.high) == pytest.approx((4e-3, 10e-3))
    # No factor frees what is zero.
    assert "bending_damping" not in unknowns(CHEESE.replace(**{"sheet.bending_damping": 0.0})).names


def test_a_known_ratio_is_no_unknown_and_holds():
    sought = unknowns(CHEESE, friction_ratio=0.8, fixed=parameters_of_the_setup())
    assert sought.names == ["natural_frequency", "friction_angle"]
    assert sought.scenario([30.0, 0.6]).friction.ratio == pytest.approx(0.8)


def parameters_of_the_setup() -> tuple[str, ...]:
    return tuple(p.name for p in parameters.OF_THE_SETUP)


@pytest.mark.parametrize(
    "bad",
    [{"free": ("colour",)}, {"friction_ratio": 0.0}, {"friction_ratio": 1.2}, {"free": ("bending_damping",)},
     {"measured": {"plate_height": (5e-3, 0.0)}}, {"free": ("mass",), "fixed": ("mass",)},
     {"measured": {"plate_height": (5e-3, 1e-3)}, "fixed": ("plate_height",)}],
)  # fmt: skip
def test_unknown_unknowns_are_refused(bad):
    with pytest.raises(InputError):
        unknowns(CHEESE, **bad)


def test_what_is_assumed_is_said():
    """Every number of the set-up that the estimate rests on, and how far those that it leaves open are left so."""
    conditions = [Condition(0.05, 0.003, 20.0), Condition(0.05, 0.002, 20.0)]
    sought = unknowns(CHEESE, measured={"plate_height": (5e-3, 1e-3)})
    said = {a.name: a for a in assumptions(sought, conditions, thickness_sd=1e-4)}
    assert said["sheet.thickness"].text == "2.5 mm ± 0.1 mm"
    assert said["motion.height"].text == "sought, about 2 to 8 mm"
    assert said["sheet.bending_damping"].text.startswith("sought, from 0.1 to 10 times 2.538e-05")
    assert said["motion.stroke"].text == "2 mm and 3 mm"
    assert said["duration"].value == CHEESE.duration
    assert said["slip_limit"].text == "20 mm"
    assert said["motion.ramp"].text == "not known, up to 0.3 s"
    told = {a.name: a for a in assumptions(sought, conditions, handling=Handling(ramp=0.2))}
    assert (told["motion.ramp"].value, told["motion.ramp"].text) == (0.2, "0.2 s")
    known = {a.name: a for a in assumptions(unknowns(CHEESE, fixed=parameters_of_the_setup()), conditions)}
    assert known["motion.height"].text == "5 mm"
    assert not known["motion.height"].sought


def test_stiffness_in_the_units_of_the_material():
    """D = k_b, E = 12 D/d³: a sheet of Table 4.1, and what a thickness known to 2 % adds, 6 %."""
    sought = unknowns(CHEESE, fixed=("friction_angle", "friction_ratio", *parameters_of_the_setup()))
    omega = CHEESE.sheet.natural_frequency
    u = np.full((4000, 1), sought.parameters[0].share(omega))
    marginal = marginal_of(sought.parameters[0], u[:, 0])
    thickness = CHEESE.sheet.thickness
    k_b, plate, modulus = stiffness_of(sought, sought.values(u), marginal, 0.9, 0.02 * thickness)
    assert k_b.median == pytest.approx(CHEESE.sheet.bending_stiffness, rel=1e-9)
    assert plate.median == k_b.median
    assert k_b.sd < 1e-9 * k_b.median
    assert modulus.median == pytest.approx(12 * k_b.median / thickness**3, rel=0.005)
    assert modulus.sd / modulus.median == pytest.approx(0.06, rel=0.05)  # of 4000 draws
    assert "kPa" in modulus.text


# Observations


def test_points_beyond_the_first_failure_say_nothing():
    data = observe_curves([curve([14, 18, 22, 26, 27, 28], [70, 200, 450, math.nan, 480, math.nan],
                                 ["", "", "", "slipped", "", "folded"])], [MOTION])  # fmt: skip
    assert data.frequency.tolist() == [14, 18, 22, 26]
    assert data.failed.tolist() == [False, False, False, True]
    assert "27" in data.notes[0]
    assert list(data.brackets().values()) == [(22, 26)]


def test_a_frequency_at_which_both_happened_is_the_run_off_itself():
    data = observe_curves([curve([14, 18, 22, 22], [70, 200, 450, math.nan], ["", "", "", "slipped"])], [MOTION])
    ((low, high),) = data.brackets().values()
    assert low < 22 < high
    assert high - low == pytest.approx(0.1)


def test_repeated_points_are_all_kept_and_share_a_condition():
    data = observe_curves([curve([14, 14, 18, 22], [70, 72, 200, 450])], [MOTION])
    assert len(data.conditions) == 3
    assert data.which.tolist().count(0) == 2


def test_an_object_that_spins_the_other_way_counts_positive():
    data = observe_curves([curve([14, 18, 22], [-70, -200, -450])], [MOTION])
    assert data.rate.tolist() == [70, 200, 450]


def test_amplitudes_may_stand_in_the_file_or_come_with_each_curve():
    both = observe_curves([curve([14, 18, 12], [70, 200, 150], angle=[3, 3, 12])], [MOTION])
    apart = observe_curves([curve([14, 18], [70, 200]), curve([12], [150])],
                           [MOTION, MOTION.replace(angle="12 deg")])  # fmt: skip
    assert [c.frequency for c in both.conditions] == [c.frequency for c in apart.conditions] == [14, 18, 12]
    assert len(both.brackets()) == 2


def test_points_of_one_file_may_differ_in_every_number_of_the_motion():
    data = observe_curves([curve([14, 18, 22], [70, 200, 450], angle=[3, math.nan, 5], stroke=[math.nan, 2e-3, 3e-3],
                                 height=[5e-3, 5e-3, 9e-3], phase=[0, 0.5, math.nan])], [MOTION])  # fmt: skip
    first, second, third = (data.conditions[i].motion(MOTION) for i in data.which)
    assert first == MOTION.replace(frequency=14.0)
    assert (third.angle, third.stroke, third.height) == pytest.approx((math.radians(5), 3e-3, 9e-3))
    # A stroke out of phase is a wave along the bar that begins that far into its sine, before the turning.
    assert second.terms()[-1] == pytest.approx((0, 2e-3, 18.0, 0.5 / math.tau))
    assert len(second.terms()) == 2
    assert len(data.brackets()) == 3  # each is a curve of its own


def test_a_failure_under_one_motion_says_nothing_of_another():
    data = observe_curves([curve([12, 14, 13, 18], [70, 90, math.nan, 200], ["", "", "slipped", ""],
                                 angle=[3, 3, 12, 3])], [MOTION])  # fmt: skip
    assert not any("beyond" in note for note in data.notes)
    assert sorted(data.frequency[data.rated]) == [12, 14, 18]


def test_a_stroke_out_of_phase_may_turn_the_spin():
    """The sense that counts as positive is that of the points in phase."""
    for phase in (3.0, math.pi / 2):
        data = observe_curves([curve([14, 16, 18, 20], [70, -90, -100, -110], phase=[0, *[phase] * 3])], [MOTION])
        assert sorted(data.rate[data.rated]) == [-110, -100, -90, 70]
    alone = observe_curves([curve([14, 16, 18], [-70, -90, 100], phase=[1.5] * 3)], [MOTION])
    assert sorted(alone.rate) == [-90, -70, 100]


# Candidates


def test_nothing_that_the_plate_cannot_make_is_a_candidate():
    """What was measured, where nothing is told: its amplitudes, up to the highest frequency."""
    measured = [Condition(0.05, 0.003, f) for f in (14.0, 18.0, 22.0)]
    reach = reach_of(measured, MOTION)
    grid = reach.grid()
    assert {c.amplitude for c in grid} == {measured[0].amplitude}
    assert max(c.frequency for c in grid) == 22
    assert not reach.allows(Condition(0.05, 0.003, 22.1))
    assert not reach.allows(Condition(0.06, 0.003, 20.0))


def test_candidates_fill_the_ranges_that_are_told():
    angle, height = (math.radians(2), math.radians(6)), (0.0, 0.02)
    reach = reach_of([Condition(0.05, 0.003, 22.0)], MOTION, angle=[angle], height=[height],
                     phase=[(0.0, 0.0), (math.pi / 2, math.pi / 2)], frequency=(10.0, 30.0))  # fmt: skip
    grid = reach.grid()
    assert all(reach.allows(c) for c in grid)
    assert len(grid) > 40
    angles = [c.angle for c in grid]
    assert min(angles) < 0.045
    assert max(angles) > 0.095
    heights = [c.motion(MOTION).height for c in grid]  # absolute, as they were told
    assert min(heights) < 3e-3
    assert max(heights) > 17e-3
    assert {c.phase for c in grid} == {0.0, math.pi / 2}


def test_a_machine_leaves_out_what_it_cannot_do():
    machine = Machine(x=Sliding(stroke="3 mm"), rx=Turning(angle="4 deg", acceleration="1000 rad/s^2"))
    reach = reach_of([Condition(0.05, 0.003, 22.0)], MOTION, angle=[(0.05, 0.05), (0.06, 0.06), (0.08, 0.08)],
                     frequency=(5.0, 40.0), machine=machine)  # fmt: skip
    assert {c.angle for c in reach.grid()} == {0.05, 0.06}  # 0.08 rad is 4.6 deg
    fastest = max(c.frequency for c in reach.grid() if c.angle == 0.05)
    # A ω² at the limit: 22.5 Hz; the smooth start asks for more than the sine.
    assert 18 < fastest <= math.sqrt(1000 / 0.05) / math.tau
    with pytest.raises(InputError, match="no motion"):
        reach_of([Condition(0.05, 0.003, 22.0)], MOTION, angle=[(0.08, 0.08)], machine=machine).grid()


def test_readings_count_where_they_and_their_spread_are_known():
    """Not where the object failed, nor beyond; a point may have a reading and no rate."""
    read = {"bending_amplitude": [0.01, 0.02, 0.03, 0.04, 0.05], "drift": [1e-3] * 5}
    known = {"bending_amplitude": [1e-3, math.nan, 3e-3, 4e-3, 5e-3]}
    data = observe_curves([curve([14, 18, 22, 26, 30], [70, 200, 450, math.nan, math.nan],
                                 ["", "", "", "", "slipped"], values=read, value_sds=known)], [MOTION])  # fmt: skip
    (bending,) = data.readings
    assert [data.conditions[i].frequency for i in bending.which] == [14, 22, 26]
    assert bending.value.tolist() == [0.01, 0.03, 0.04]
    assert any("drift_mm" in note and "drift_sd_mm" in note for note in data.notes)
    assert bending.relative == 0.1
    compared = data.compared
    assert compared.quantity.tolist() == [0, 0, 0, 1, 1, 1]
    assert [data.conditions[i].frequency for i in compared.condition] == [14, 18, 22, 14, 22, 26]


@pytest.mark.parametrize("rates", [[70, 200, math.nan], [math.nan] * 3])
def test_too_few_rates_are_refused(rates):
    with pytest.raises(InputError, match="at least 3"):
        observe_curves([curve([14, 18, 22], rates)], [MOTION])


def test_too_many_frequencies_are_refused():
    f = np.linspace(10, 30, 5000)
    with pytest.raises(InputError, match="averaging"):
        observe_curves([curve(f, f)], [MOTION])


# Emulators


def test_rates_that_are_quadratic_are_learnt_exactly():
    u = np.random.default_rng(0).random((40, 3))
    rates = np.stack([1 + u @ [1, 2, 3], (u @ [1, -1, 2]) ** 2], axis=1)
    emulator = fit_rates(u, rates, np.ones(40, bool))
    # A quadratic trend is part of the spline: only rounding and the smoothing of 1e-3 are left.
    at = np.random.default_rng(1).random((50, 3))
    expected = np.stack([1 + at @ [1, 2, 3], (at @ [1, -1, 2]) ** 2], axis=1)
    assert np.abs(emulator(at) - expected).max() < 1e-6
    assert emulator.error.max() < 1e-6


def test_a_condition_at_which_too_few_runs_stayed_is_not_learnt():
    u = np.random.default_rng(0).random((40, 3))
    rates = np.stack([u[:, 0], np.where(np.arange(40) < 5, 1.0, math.nan)], axis=1)
    emulator = fit_rates(u, rates, np.ones(40, bool))
    assert np.isfinite(emulator.error[0])
    assert np.isinf(emulator.error[1])


def test_left_out_errors_are_those_of_new_points():
    """Rates with a scatter of 2: the error says so, within what 60 runs know of it (10 %) and the spline adds."""
    generator = np.random.default_rng(0)
    u = generator.random((80, 2))
    emulator = fit_rates(u, (np.sin(3 * u[:, :1]) * 10) + generator.normal(0, 2, (80, 1)), np.ones(80, bool))
    fresh = generator.random((400, 2))
    new = np.sqrt(np.mean((emulator(fresh)[:, 0] - np.sin(3 * fresh[:, 0]) * 10 - generator.normal(0, 2, 400)) ** 2))
    assert emulator.error[0] == pytest.approx(new, rel=0.35)


def test_a_run_off_is_learnt_from_brackets():
    u = np.random.default_rng(0).random((60, 2))
    truth = 24 + 3 * u[:, 0] + u[:, 1] ** 2
    grid = np.arange(20, 31, 0.5)
    low, high = brackets(grid[None, :] > truth[:, None], grid)
    assert ((low < truth) & (truth < high)).all()
    emulator = fit_run_off(u, low, high, np.ones(60, bool))
    assert emulator is not None
    # Brackets half a hertz wide, sixty of them for ten coefficients: within a fifth of their width on average.
    assert np.mean(np.abs(emulator(u) - truth)) < 0.1


def test_runs_that_never_fail_teach_no_run_off():
    u = np.random.default_rng(0).random((30, 2))
    assert fit_run_off(u, np.full(30, 25.0), np.full(30, math.inf), np.ones(30, bool)) is None


@given(st.floats(20, 30), st.floats(0.03, 2), st.floats(15, 30), st.floats(0.01, 5))
def test_probability_of_a_bracket(centre, width, low, span):
    probability = math.exp(log_between(np.array([centre]), width, np.array([low]), np.array([low + span]))[0])
    # A difference of two probabilities keeps 1e-12 of them in scipy too.
    expected = norm.cdf(low + span, centre, width) - norm.cdf(low, centre, width)
    assert probability == pytest.approx(expected, rel=1e-6, abs=1e-12)


def test_probabilities_of_all_brackets_add_up_to_one():
    ends = np.array([0.0, 20.0, 24.0, 25.0, 26.0, math.inf])
    p = np.exp(log_between(np.full(5, 24.7), 0.3, ends[:-1], ends[1:]))
    assert p.sum() == pytest.approx(1, abs=1e-9)


def test_a_parameter_that_hardly_matters_does_not_tell_runs_apart():
    """Rates of one steep direction among five, seventy runs: a plain spline is off by a tenth of their spread."""
    u = np.random.default_rng(0).random((70, 5))
    emulator = fit_rates(u, np.sin(5 * u[:, :1]) + 0.05 * u[:, 1:2], np.ones(70, bool))
    at = np.random.default_rng(1).random((200, 5))
    error = emulator(at)[:, 0] - np.sin(5 * at[:, 0]) - 0.05 * at[:, 1]
    assert np.quantile(np.abs(error), 0.68) < 0.03  # of a spread of 0.6


# Identifiability


def test_the_gate():
    generator = np.random.default_rng(0)
    assert marginal_of(NATURAL_FREQUENCY, generator.random(4000)).verdict == "not determined"
    narrow = marginal_of(FRICTION_ANGLE, generator.normal(0.5, 0.02, 4000))
    assert narrow.verdict == "determined"
    assert narrow.low < math.radians(40) < narrow.high
    assert marginal_of(NATURAL_FREQUENCY, generator.random(4000) * 0.2).verdict == "at most"
    assert marginal_of(NATURAL_FREQUENCY, 1 - generator.random(4000) * 0.2).verdict == "at least"
    assert "at most" in marginal_of(NATURAL_FREQUENCY, generator.random(4000) * 0.2).text


# Linear


def fit_of(f0: float, ratio: float) -> LorentzFit:
    near = (0.999, 1.001)
    return LorentzFit(500.0, f0, ratio * f0, 0.99, 12, 0.95, (499.0, 501.0), (f0 * near[0], f0 * near[1]),
                      (ratio * f0 * near[0], ratio * f0 * near[1]), "profile likelihood", "residual")  # fmt: skip


def test_published_tables_are_reproduced():
    """Table 5.2: f0 and b/f0 of the 10π, 36.87 deg object give 11.20π and 35.52 deg back."""
    estimate = estimate_linear(fit_of(25.06, 0.2022), CHEESE)
    assert estimate.natural_frequency / math.pi == pytest.approx(11.20, abs=0.01)
    assert math.degrees(estimate.friction_angle) == pytest.approx(35.52, abs=0.06)  # b/f0 is known to four digits
    assert not estimate.refused


@pytest.mark.parametrize(
    ("angle", "f0", "ratio", "named"),
    [("3 deg", 25.0, 0.15, "α"), ("3 deg", 25.0, 0.27, "α"), ("12 deg", 13.9, 0.22, "ω_n"), ("12 deg", 12.5, 0.27, "α"),
     ("3 deg", 21.0, 0.2, "ω_n")],
)  # fmt: skip
def test_outside_its_domain_it_refuses(angle, f0, ratio, named):
    estimate = estimate_linear(fit_of(f0, ratio), CHEESE.replace(**{"motion.angle": angle}))
    assert named in " ".join(estimate.refused)
    assert estimate.summary()["parameters"]["friction_angle"]["median"] is None
    with pytest.raises(InputError):
        estimate.to_fragment(CHEESE)


@pytest.mark.parametrize(
    "change",
    [{"motion.angle": "6 deg"}, {"motion.stroke": "2 mm"}, {"sheet.outline": {"shape": "disk", "radius": "50 mm"}}],
)
def test_a_plate_or_object_that_it_was_not_made_for_is_refused(change):
    with pytest.raises(InputError, match="posterior"):
        estimate_linear(fit_of(25.0, 0.2), CHEESE.replace(**change))


def test_shipped_coefficients_are_whole():
    for angle in (3, 12):
        for of in ("omega", "alpha"):
            assert line("linear", "published", angle, of).powers
            assert len(line("quadratic", "refitted", angle, of).powers) == 3
            # The refitted lines rise as the published ones do.
            assert line("linear", "refitted", angle, of).powers[1] > 0


def test_conditions_sort_by_amplitude_then_frequency():
    assert Condition(0.05, 0.003, 30.0) < Condition(0.2, 0.003, 10.0)
