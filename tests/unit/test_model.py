"""The descriptions: frozen, validated, plain about what is wrong, and stable where they say so."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import ValidationError

from plategait.engine import cpu
from plategait.engine.recording import RunRequest
from plategait.errors import InputError
from plategait.model.contact import Contact, Friction
from plategait.model.motion import PlateMotion, Samples, Wave, read_samples
from plategait.model.outline import SHAPES, Disk, Rectangle
from plategait.model.presets import PRESETS, preset
from plategait.model.scenario import Plate, Scenario, Start
from plategait.model.sheet import Sheet
from plategait.simulation.run import simulate

CHEESE = preset("cheese").scenario
MINIMAL = {"outline": Disk(radius=0.04), "mass": 0.0136, "bending_stiffness": 1.56e-4, "axial_stiffness": 790.0}
MODELS = {
    "Sheet": CHEESE.sheet,
    "PlateMotion": CHEESE.motion,
    "Contact": CHEESE.contact,
    "Friction": CHEESE.friction,
    "Start": CHEESE.start,
    "Plate": Plate(),
    "Scenario": CHEESE,
    "Disk": Disk(radius=0.04),
    "Wave": Wave(axis="x", amplitude=0.01),
}


def numbers_of(model) -> list[str]:
    return [name for name in type(model).model_fields if isinstance(getattr(model, name), float)]


NUMBERS = [(kind, name) for kind, model in MODELS.items() for name in numbers_of(model)]


@pytest.mark.parametrize("kind", MODELS)
def test_models_are_frozen(kind):
    model = MODELS[kind]
    name = next(iter(type(model).model_fields))
    with pytest.raises((InputError, ValidationError), match="frozen"):
        setattr(model, name, getattr(model, name))


def refusal(kind: str, name: str, bad: object) -> InputError:
    try:
        MODELS[kind].replace(**{name: bad})
    except InputError as error:
        return error
    pytest.fail(f"{kind} takes {bad!r} as {name}")


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, "nan", True, "twelve", "3 kelvin", (), b"1"], ids=repr)
def test_no_number_takes_anything_else(bad):
    for kind, name in NUMBERS:
        error = refusal(kind, name, bad)
        assert error.field == name, kind
        assert "\n" not in str(error)


def test_the_suggested_number_works():
    hang_on_others = (("Scenario", "time_step"), ("Friction", "kinetic"))
    for kind, name in (each for each in NUMBERS if each not in hang_on_others):
        suggested = refusal(kind, name, math.nan).hint.strip('"')
        try:
            MODELS[kind].replace(**{name: suggested})
        except InputError as error:
            # Allowed only where another field has to follow.
            assert error.field != name, f"{name}: {suggested} was suggested, then refused: {error}"  # noqa: PT017


@pytest.mark.parametrize(
    ("make", "wrong", "right"),
    [
        (lambda: Sheet(**MINIMAL, bending_stifness=1), "bending_stifness", "bending_stiffness"),
        (lambda: Sheet(**{**MINIMAL, "outline": {"shape": "disk", "radus": 0.04}}), "outline.radus", "radius"),
        (lambda: Disk(radus=0.04), "radus", "radius"),
        (lambda: PlateMotion(frequenzy=24), "frequenzy", "frequency"),
        (lambda: PlateMotion(waves=[{"axis": "x", "amplitud": 1}]), "waves.0.amplitud", "amplitude"),
        (lambda: Contact(stifness=1), "stifness", "stiffness"),
        (lambda: Friction(statik=0.3), "statik", "static"),
        (lambda: CHEESE.replace(durration=3), "durration", "duration"),
        (lambda: CHEESE.replace(**{"motion.strok": 3}), "motion.strok", "stroke"),
        (lambda: CHEESE.replace(**{"sheet.outline.radus": 3}), "sheet.outline.radus", "radius"),
        (lambda: CHEESE.replace(**{"moton.stroke": 3}), "moton", "motion"),
    ],
)
def test_an_unknown_field_is_named_with_the_right_one(make, wrong, right):
    with pytest.raises(InputError) as caught:
        make()
    assert caught.value.field == wrong
    assert right in caught.value.hint


@pytest.mark.parametrize("name", SHAPES)
def test_a_field_named_like_a_shape_is_unknown_all_the_same(name):
    with pytest.raises(InputError) as caught:
        Sheet(**MINIMAL, **{name: 1})
    assert caught.value.field == name
    assert "Extra inputs" not in str(caught.value)


@pytest.mark.parametrize(
    ("make", "field"),
    [
        (lambda: Sheet(**{**MINIMAL, "outline": "disk"}), "outline"),
        (lambda: Sheet(**{**MINIMAL, "outline": None}), "outline"),
        (lambda: Sheet(**{**MINIMAL, "outline": {"shape": "circle", "radius": 1}}), "outline.shape"),
        (lambda: Sheet(**{**MINIMAL, "outline": {"shape": "disk", "radius": -1}}), "outline.radius"),
        (lambda: Sheet(**MINIMAL, name=5), "name"),
        (lambda: Scenario(), "sheet"),
        (lambda: Scenario(sheet=Contact()), "sheet"),
        (lambda: PlateMotion(waves=3), "waves"),
        (lambda: PlateMotion(samples=5), "samples"),
        (lambda: Friction(law="coulomb"), "law"),
        (lambda: Wave(axis="q", amplitude=1), "axis"),
        (lambda: Wave(axis="x", amplitude="3 deg"), "amplitude"),
        (lambda: Wave(axis="rx", amplitude="3 mm"), "amplitude"),
    ],
)
def test_the_wrong_kind_is_refused_by_name(make, field):
    with pytest.raises(InputError) as caught:
        make()
    assert caught.value.field == field
    assert "a value of that kind" not in caught.value.hint, "a suggestion must be something to type"


@pytest.mark.parametrize("name", ["mass", "pitch", "axial_stiffness", "shear_ratio"])
@pytest.mark.parametrize("bad", [-1, 0, "0 g", -0.0])
def test_mass_pitch_and_in_plane_stiffness_are_positive(name, bad):
    with pytest.raises(InputError) as caught:
        Sheet(**{**MINIMAL, name: bad})
    assert caught.value.field == name


@pytest.mark.parametrize("extreme", [{"pitch": 1e-320}, {"axial_stiffness": 1e308}, {"axial_damping": 1e200},
                                     {"mass": 1e-320}, {"bending_stiffness": 1e300},
                                     {"shear_ratio": 1e300}, {"shear_ratio": 1e-320}])  # fmt: skip
def test_numbers_beyond_floating_point_are_refused_too(extreme):
    with pytest.raises(InputError):
        Scenario(sheet=Sheet(**{**MINIMAL, **extreme}))


def test_kinetic_friction_is_at_most_static():
    with pytest.raises(InputError) as caught:
        Friction(static=0.3)
    assert caught.value.field == "kinetic"
    assert Friction(static=0.3, kinetic=caught.value.hint).ratio < 1
    assert Friction(static=0.3, kinetic=0.3).ratio == 1
    assert Friction(static=0, kinetic=0).ratio == 1
    with pytest.raises(InputError, match="kinetic_speed_ratio"):
        Friction(kinetic_speed_ratio=1)


@given(angle=st.floats(0, 89.9), ratio=st.floats(0, 1))
def test_the_friction_angle_keeps_the_ratio(angle, ratio):
    friction = Friction(static=0.8, kinetic=0.8 * ratio).with_angle(f"{angle!r} deg")
    assert math.degrees(friction.angle) == pytest.approx(angle, abs=1e-12)  # tan and atan, a few roundings
    assert friction.kinetic == pytest.approx(friction.static * ratio, rel=1e-14)


@pytest.mark.parametrize("angle", ["90 deg", "-1 deg", "nan", "12 mm", None])
def test_a_friction_angle_outside_is_refused(angle):
    with pytest.raises(InputError) as caught:
        Friction().with_angle(angle)
    assert caught.value.field == "angle"
    Friction().with_angle(caught.value.hint.strip('"'))


def test_replace_reaches_inside_and_leaves_the_rest():
    changed = CHEESE.replace(duration="2 s", **{"sheet.pitch": "5 mm", "sheet.outline.radius": "30 mm",
                                                "motion.angle": "12 deg"})  # fmt: skip
    assert (changed.duration, changed.sheet.pitch, changed.sheet.outline.radius) == (2.0, 0.005, 0.03)
    assert changed.motion.angle == pytest.approx(math.radians(12), rel=1e-15)
    assert changed.sheet.lattice.n_nodes > CHEESE.sheet.lattice.n_nodes, "what hangs on a field follows it"
    assert changed.sheet.mass == CHEESE.sheet.mass
    assert preset("cheese").scenario == CHEESE, "the original stays"
    back = changed.replace(duration=4.0, sheet=CHEESE.sheet, motion=CHEESE.motion)
    assert back == CHEESE


def test_replace_takes_a_part_and_a_change_to_it():
    pancake = preset("pancake").scenario.sheet
    changed = CHEESE.replace(sheet=pancake, **{"sheet.mass": "20 g"})
    assert changed.sheet == pancake.replace(mass="20 g")


@pytest.mark.parametrize("name", ["plate.length", "name.first", "duration.x", "motion.samples.x"])
def test_replace_does_not_suggest_what_it_was_given(name):
    with pytest.raises(InputError) as caught:
        CHEESE.replace(**{name: 0.2})
    assert caught.value.hint != name.split(".")[0], "that name is known: what is wrong is that there is nothing inside"


@given(mass=st.floats(1e-3, 1), pitch=st.floats(4e-3, 2e-2), duration=st.floats(0.1, 9))
def test_replace_with_the_same_values_changes_nothing(mass, pitch, duration):
    scenario = CHEESE.replace(duration=duration, **{"sheet.mass": mass, "sheet.pitch": pitch})
    assert scenario.replace() == scenario
    assert scenario.replace(**{"sheet.mass": scenario.sheet.mass}) == scenario
    assert scenario.sheet.node_mass * scenario.sheet.lattice.n_nodes == pytest.approx(mass, rel=1e-14)


# Physics of the sheet


@pytest.mark.parametrize("pitch", [0.005, 0.0025])
def test_a_finer_pitch_keeps_mass_and_stiffness(pitch):
    coarse, fine = CHEESE.sheet, CHEESE.sheet.replace(pitch=pitch)
    assert fine.mass == coarse.mass
    assert fine.bending_stiffness == coarse.bending_stiffness
    # Halving the pitch gives the disk four nodes for each, give or take its edge.
    per_area = fine.lattice.n_nodes * pitch**2 / (coarse.lattice.n_nodes * coarse.pitch**2)
    assert per_area == pytest.approx(1, abs=0.05)


@pytest.mark.slow
def test_the_natural_frequency_converges_with_the_pitch():
    # The staircase edge makes each pitch's own error ragged, so ask for a shrinking band and not for an order.
    frequencies = [CHEESE.sheet.replace(pitch=0.01 / n).natural_frequency for n in (1, 2, 3, 4, 5)]
    last = frequencies[-1]
    assert abs(frequencies[0] / last - 1) < 0.12
    assert abs(frequencies[2] / last - 1) < 0.05
    assert abs(frequencies[3] / last - 1) < 0.03


@pytest.mark.linear_algebra
def test_the_natural_frequency_of_a_square_converges_with_the_pitch():
    square = Sheet(**{**MINIMAL, "outline": Rectangle(length=0.06, width=0.06)})
    omega = [square.replace(pitch=0.06 / n).natural_frequency for n in (6, 12, 24)]
    assert abs(omega[2] - omega[1]) < 0.6 * abs(omega[1] - omega[0])  # at least first order, no raggedness here


def test_the_cheese_has_the_natural_frequency_of_the_source():
    assert CHEESE.sheet.natural_frequency == pytest.approx(10 * math.pi, rel=0.04)  # its dish mode is 10.3π
    assert CHEESE.sheet.free_modes.twist.omega == pytest.approx(0, abs=1e-3 * CHEESE.sheet.natural_frequency)


@settings(deadline=None)
@given(hertz=st.floats(0.5, 500))
def test_with_natural_frequency_gives_that_dish_mode(hertz):
    sheet = CHEESE.sheet.with_natural_frequency(f"{hertz!r} Hz")
    assert sheet.natural_frequency == pytest.approx(2 * math.pi * hertz, rel=1e-9)  # an eigensolver's round-off
    assert sheet.mass == CHEESE.sheet.mass
    assert sheet.axial_stiffness == CHEESE.sheet.axial_stiffness


def test_with_natural_frequency_scales_torsion_alike():
    sheet = CHEESE.sheet.replace(torsion_stiffness=5e-5)
    scaled = sheet.with_natural_frequency(2 * sheet.natural_frequency)
    assert scaled.bending_stiffness == pytest.approx(4 * sheet.bending_stiffness, rel=1e-12)
    assert scaled.torsion_stiffness == pytest.approx(4 * sheet.torsion_stiffness, rel=1e-12)
    by_name = CHEESE.sheet.with_natural_frequency("20 pi rad/s", nominal=10 * math.pi)
    assert by_name.bending_stiffness == pytest.approx(4 * CHEESE.sheet.bending_stiffness, rel=1e-12)


@pytest.mark.parametrize("omega", [0, -1, "nan", "3 mm", None, True])
def test_a_natural_frequency_of_the_wrong_kind_is_refused(omega):
    with pytest.raises(InputError) as caught:
        CHEESE.sheet.with_natural_frequency(omega)
    assert caught.value.field == "natural_frequency"


def test_a_sheet_without_bending_stiffness_cannot_be_scaled():
    limp = CHEESE.sheet.replace(bending_stiffness=0)
    assert limp.natural_frequency == 0
    with pytest.raises(InputError):
        limp.with_natural_frequency("10 pi rad/s")
    with pytest.raises(InputError):
        CHEESE.sheet.with_natural_frequency("10 pi rad/s", nominal=0)


@pytest.mark.linear_algebra
@pytest.mark.parametrize("torsion", [0.0, 5e-5, 1.56e-4])
def test_the_modes_are_named_by_their_shape(torsion):
    sheet = CHEESE.sheet.replace(torsion_stiffness=torsion)
    x, y = sheet.lattice.rest.T
    for name, ideal in (("dish", x**2 + y**2), ("saddle", x**2 - y**2), ("twist", x * y)):
        mode = getattr(sheet.free_modes, name)
        ideal = ideal - ideal.mean()
        likeness = abs(ideal @ mode.shape) / np.linalg.norm(ideal) / np.linalg.norm(mode.shape)
        assert likeness > 0.9, name  # a disk's lattice mixes them little
        assert np.abs(mode.shape).max() == 1.0
        assert mode.frequency == mode.omega / (2 * math.pi)
    omegas = [mode.omega for mode in sheet.free_modes.modes]
    assert omegas == sorted(omegas)
    assert len(omegas) == sheet.lattice.n_nodes - 3
    assert sheet.free_modes.twist.omega < sheet.free_modes.dish.omega


@pytest.mark.linear_algebra
def test_a_sheet_without_a_dish_mode_says_so_and_counts_its_lowest():
    strip = Sheet(**{**MINIMAL, "outline": Rectangle(length=0.08, width=0.01)})
    with pytest.raises(InputError, match="dish"):
        _ = strip.free_modes.dish
    omega = strip.natural_frequency
    assert omega == strip.free_modes.modes[0].omega > 0
    assert strip.with_natural_frequency(2 * omega).natural_frequency == pytest.approx(2 * omega, rel=1e-9)


@pytest.mark.parametrize("cut", [{"outline": Rectangle(length=0.02, width=0.02)}, {"bending_stiffness": 0.0}])
def test_a_sheet_that_nothing_bends_has_no_natural_frequency(cut):
    stiff = Sheet(**{**MINIMAL, "outline": Rectangle(length=0.08, width=0.01), **cut})
    with pytest.raises(InputError, match="bends the sheet"):
        _ = stiff.natural_frequency


def test_a_sheet_of_one_node_slides_as_a_block():
    dot = Sheet(**{**MINIMAL, "outline": Disk(radius=0.004), "mass": 1e-3})
    assert dot.lattice.n_nodes == 1
    summary = simulate(Scenario(sheet=dot, duration=0.3)).summary()
    assert summary["spin_rate_deg_s"] in (0.0, None)


# Time step


def test_the_default_step_of_the_cheese_is_about_a_tenth_of_a_millisecond():
    assert 6e-5 <= CHEESE.dt <= 1e-4
    assert CHEESE.sheet.stable_time_step > CHEESE.dt
    for name in PRESETS:
        scenario = preset(name).scenario
        assert 0 < scenario.dt <= min(1e-4, 0.86 * scenario.sheet.stable_time_step)


@given(factor=st.floats(1.0001, 1e6))
def test_too_large_a_step_is_refused_with_one_that_works(factor):
    with pytest.raises(InputError) as caught:
        CHEESE.replace(time_step=factor * CHEESE.sheet.stable_time_step)
    assert caught.value.field == "time_step"
    suggested = caught.value.hint.split('"')[1]
    assert CHEESE.replace(time_step=suggested).dt < CHEESE.sheet.stable_time_step


def test_too_small_a_step_is_refused_with_one_that_works():
    with pytest.raises(InputError) as caught:
        CHEESE.replace(time_step="1e-10 s")
    assert caught.value.field == "time_step", "the step is what is out of the ordinary, not the 4 s"
    CHEESE.replace(time_step=caught.value.hint.split('"')[1])


def test_too_long_a_duration_is_refused_with_one_that_works():
    with pytest.raises(InputError) as caught:
        CHEESE.replace(duration="1e9 s")
    assert caught.value.field == "duration"
    CHEESE.replace(duration=caught.value.hint.strip('"'))


def test_a_transient_beyond_the_duration_is_refused_with_one_that_works():
    with pytest.raises(InputError) as caught:
        CHEESE.replace(transient="4 s")
    assert caught.value.field == "transient"
    assert CHEESE.replace(transient=caught.value.hint.strip('"')).measured_from == pytest.approx(1.2, rel=1e-9)
    assert CHEESE.replace(transient=0).measured_from == 0


@pytest.mark.parametrize("frequency", ["10 kHz", "3 kHz", "1 MHz"])
def test_a_plate_faster_than_the_step_is_not_simulated_as_if_it_were_slower(frequency):
    # At 10 kHz a step of 1e-4 s sees the sine always at the same phase: the plate would seem to stand still.
    try:
        scenario = CHEESE.replace(**{"motion.frequency": frequency, "duration": 0.01})
    except InputError as error:
        assert error.field in ("motion.frequency", "time_step", "duration")  # noqa: PT017 - refusing it is right too
    else:
        assert scenario.dt <= scenario.motion.period / 10


# Where the step's limit lies: the same sheet, thrown free, just below and well above it.
EDGES = {
    "cheese": {},
    "fine": {"pitch": 0.005},
    "stiff in torsion": {"torsion_stiffness": 1.56e-4, "torsion_damping": 2.4e-7},
    "stiff in shear": {"shear_ratio": 16.0},
    "loose in shear": {"shear_ratio": 0.1},
    "undamped": {"axial_damping": 0.0, "bending_damping": 0.0},
    "stiff": {"bending_stiffness": 0.02},
    "overdamped": {"axial_damping": 3.0, "bending_damping": 1e-5},
}


def thrown(sheet: Sheet, factor: float, precision, monkeypatch):
    """Run a shaken free sheet at a multiple of its stable step, past the validation."""
    dt = factor * sheet.stable_time_step
    with monkeypatch.context() as patch:
        patch.setattr(Sheet, "stable_time_step", property(lambda sheet: 1.0))
        scenario = Scenario(sheet=sheet, gravity=0, duration=3000 * dt, time_step=dt,
                            motion=PlateMotion(angle=0, stroke=0, ramp=0))  # fmt: skip
    rng = np.random.default_rng(3)
    rest = sheet.lattice.rest * sheet.pitch
    positions = np.column_stack([rest, np.ones(len(rest))]) + rng.normal(0, 1e-6 * sheet.pitch, (len(rest), 3))
    return cpu.run([RunRequest(scenario, initial=(positions, np.zeros_like(positions)))], precision)[0]


@pytest.mark.parametrize("name", EDGES)
def test_just_below_the_stable_step_a_sheet_stays_whole(name, monkeypatch):
    sheet = CHEESE.sheet.replace(**EDGES[name])
    recording = thrown(sheet, 0.99, "float64", monkeypatch)
    assert not recording.diverged
    energy = recording["kinetic_energy"] + recording["axial_energy"] + recording["bending_energy"]
    energy = energy + recording["torsion_energy"]
    # Semi-implicit Euler swings about the energy by up to ω dt/2 of it near the edge; an instability would have grown
    # by many powers of ten in 3000 steps.
    assert energy[1:].max() < 20 * energy[0]


@pytest.mark.parametrize("precision", ["float32", "float64"])
@pytest.mark.parametrize("name", EDGES)
def test_well_above_the_stable_step_a_sheet_flies_apart(name, precision, monkeypatch):
    # The limit adds what stretching and bending damp; it is sharp where one of them is small, as in Table 4.1. A strong
    # axial damper is implicit: what it adds hardly grows with the step any more.
    printed = preset("cheese-as-printed").scenario.sheet
    recording = thrown(printed.replace(**EDGES[name]), 1.8 if name == "overdamped" else 1.4, precision, monkeypatch)
    worst = max(np.abs(recording["kinetic_energy"][np.isfinite(recording["kinetic_energy"])]).max(), 0)
    assert recording.diverged or worst > 1e-3, "the limit leaves more than 40 % unused"


@pytest.mark.parametrize("engine", ["cpu", "cpu64"])
def test_a_run_that_flies_apart_has_a_status_and_no_number(engine, monkeypatch):
    dt = 1.6 * CHEESE.sheet.stable_time_step
    with monkeypatch.context() as patch:
        patch.setattr(Sheet, "stable_time_step", property(lambda sheet: 1.0))
        scenario = CHEESE.replace(time_step=dt, duration=0.5)
    result = simulate(scenario, engine=engine)
    assert result.failed
    assert result.failure is not None
    assert 0 < result.failure.time < 0.5
    assert result.summary()["spin_rate_deg_s"] is None
    assert not result.settled
    assert result.recordings[0].diverged
    assert result.recordings[0].steps < 0.5 / dt


# Plate motion


def test_the_short_form_is_two_sines():
    motion = PlateMotion(frequency="12 Hz", angle="12 deg", stroke="3 mm")
    assert motion.terms() == ((0, 0.003, 12.0, 0.0), (3, -math.radians(12), 12.0, 0.0))
    assert motion.period == pytest.approx(1 / 12, rel=1e-15)
    assert PlateMotion(angle=0, stroke=0).terms() == ()


@pytest.mark.parametrize(("ratios", "periods"), [((1,), 1), ((2, 3), 1), ((0.5,), 2), ((1.5, 2 / 3), 6), ((0.25,), 4)])
def test_the_period_covers_every_wave(ratios, periods):
    motion = PlateMotion(frequency=10, waves=[{"axis": "y", "amplitude": "1 mm", "ratio": r} for r in ratios])
    assert motion.period == pytest.approx(periods / 10, rel=1e-12)
    for ratio in ratios:
        assert (motion.period * 10 * ratio) % 1 == pytest.approx(0, abs=1e-9)


SAMPLES = "time_s,x_mm,rx_deg\n0,0,0\n0.01,1,90\n0.02,0,-90\n"


def test_samples_are_read_in_their_units(tmp_path):
    path = tmp_path / "motion.csv"
    path.write_text(SAMPLES)
    samples = read_samples(path)
    assert samples.time == (0, 0.01, 0.02)
    assert samples.x == pytest.approx((0, 1e-3, 0))
    assert samples.rx == pytest.approx((0, math.pi / 2, -math.pi / 2))
    assert samples.y == ()
    assert PlateMotion(samples=path).samples == samples == PlateMotion(samples=str(path)).samples


def test_samples_with_a_byte_order_mark_are_read(tmp_path):
    path = tmp_path / "motion.csv"
    path.write_text(SAMPLES, encoding="utf-8-sig")  # what spreadsheets write
    assert read_samples(path).x == pytest.approx((0, 1e-3, 0))


@pytest.mark.parametrize(
    "text",
    ["", "time_s,x_mm\n", "x_mm\n1\n", "time_s,x\n0,0\n1,1\n", "time_s,x_mm\n0,0\n1,\n", "time_s,x_mm\n0,0\n1,a\n",
     "time_s,x_mm\n0,0\n1,nan\n", "time_s,x_mm\n0,0\n", "time_s,x_mm\n0,0\n0,1\n", "time_s,x_mm\n1,0\n2,1\n",
     "time_s,x_mm\n0,0\n1,1,5\n", "time_s,x_mm\n0\n1,1\n", "time_s,x_mm,x_mm_s\n0,0,0\n1,1\n",
     'time_s,x_mm\n0,"' + "1" * 200_000 + '"\n'],
    ids=["empty", "no rows", "no time", "wrong column", "gap", "text", "nan", "one row", "standing time", "late start",
         "extra cell", "missing cell", "missing speed",
         "endless cell"],
)  # fmt: skip
def test_bad_samples_are_refused(tmp_path, text):
    path = tmp_path / "motion.csv"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        PlateMotion(samples=path)
    assert caught.value.field.startswith("samples")
    assert not caught.value.field.startswith("samples.samples")
    assert len(str(caught.value)) < 1000


@pytest.mark.parametrize("spoil", ["missing", "binary", "folder"])
def test_samples_that_cannot_be_read_are_refused(tmp_path, spoil):
    path = tmp_path / "motion.csv"
    if spoil == "binary":
        path.write_bytes(bytes(range(256)))
    elif spoil == "folder":
        path.mkdir()
    with pytest.raises(InputError, match="a CSV file that can be read"):
        read_samples(path)


def test_knots_follow_the_samples():
    time = np.linspace(0, 1, 201)
    samples = Samples(time=tuple(time), x=tuple(np.sin(2 * np.pi * time)))
    step = 1e-3
    knots = samples.knots(step)
    t = np.arange(len(knots)) * step
    within = t < 1
    # A natural cubic spline of 200 points a period: errors of h² at the ends, where the second derivative is 0 anyway.
    np.testing.assert_allclose(knots[within, 0], np.sin(2 * np.pi * t[within]), atol=1e-6)
    np.testing.assert_allclose(knots[within, 1], 2 * np.pi * np.cos(2 * np.pi * t[within]), atol=1e-3)
    assert (knots[~within, 1] == 0).all(), "past the end the plate stands"
    assert not knots[:, 2:].any()


def test_the_start_and_plate_take_units():
    assert Start(x="10 mm", angle="90 deg").angle == pytest.approx(math.pi / 2)
    assert Plate(length="200 mm").length == pytest.approx(0.2)


def test_the_static_depth_carries_the_weight():
    contact = Contact()
    depth = contact.static_depth(2.6e-4, 0.01, 9.81)
    assert contact.stiffness * 1e-3 * (1e3 * depth) ** 2.2 == pytest.approx(2.6e-4 * 9.81, rel=1e-12)
    # A finer pitch carries its share of the weight at the same depth.
    assert contact.static_depth(2.6e-4 / 4, 0.005, 9.81) == pytest.approx(depth, rel=1e-12)
    assert contact.static_depth(2.6e-4, 0.01, 0.0) == 0


@pytest.mark.parametrize("name", PRESETS)
def test_every_number_of_a_preset_is_accounted_for(name):
    found = preset(name)
    known = {*found.published, *found.inferred}
    assert not set(found.published) & set(found.inferred), "a number is published or inferred, not both"
    for dotted in known:
        value = found.scenario
        for part in dotted.split("."):
            value = getattr(value, part)
    assert {"sheet.mass", "sheet.bending_stiffness", "friction.static", "motion.angle", "motion.stroke"} <= known


@pytest.mark.parametrize("name", ["chees", "", None, 5, []])
def test_an_unknown_preset_is_refused(name):
    with pytest.raises(InputError) as caught:
        preset(name)
    assert caught.value.field == "preset"
    preset(caught.value.hint)
