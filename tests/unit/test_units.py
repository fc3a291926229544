"""Numbers with units: what is read, what is refused, and that what is suggested instead works."""

from __future__ import annotations

import math
import re
import time
from decimal import Decimal
from fractions import Fraction
from typing import get_args

import numpy as np
import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plategait import units
from plategait.errors import InputError, printable
from plategait.units import (
    ANGLE,
    ANGULAR_FREQUENCY,
    FREQUENCY,
    PLATE_ANGLE,
    PLATE_STROKE,
    STROKE,
    Quantity,
    parse,
    show,
)

BENDING = Quantity("N*m/rad", "N*mm/deg", "2.72e-3 N*mm/deg", at_least=0)
LENGTH = get_args(units.Length)[1]
COEFFICIENT = get_args(units.Coefficient)[1]
QUANTITIES = {
    name: found
    for name, value in vars(units).items()
    for found in (value, *get_args(value)[1:])
    if isinstance(found, Quantity) and not name.startswith("PLATE_")  # which refuse large bare numbers on purpose
}


REGISTRY = pint.UnitRegistry()


def pint_text(unit: str) -> str:
    return unit.replace("^", "**").replace("²", "**2")


def refused(quantity: Quantity, value: object) -> InputError:
    try:
        read = quantity.read(value, "the_field")
    except InputError as caught:
        error = caught
    else:
        pytest.fail(f"{quantity} reads {value!r} as {read}")
    assert str(error).startswith("the_field: got ")
    assert "\n" not in str(error)
    # The suggestion is not decoration: it is read, and lies within the limits.
    quantity.read(error.hint.strip('"'), "the_field")
    return error


def test_a_plate_s_amplitude_typed_without_its_unit_is_caught():
    for quantity, text in ((units.PLATE_ANGLE, "3"), (units.PLATE_STROKE, "3")):
        assert refused(quantity, text).hint.startswith('"3 ')
    assert units.PLATE_ANGLE.read("-12 deg", "f") == pytest.approx(-math.radians(12), rel=1e-15)


def test_every_quantity_of_the_module_is_found():
    assert len(QUANTITIES) >= 20


@pytest.mark.parametrize("unit", units.COMMON_UNITS)
def test_a_common_unit_is_what_pint_says(unit):
    factor, si = units.COMMON_UNITS[unit]
    expected = REGISTRY.parse_expression(pint_text(unit)).to(pint_text(si)).magnitude
    assert factor == pytest.approx(expected, rel=1e-14)  # a few products of floats apart
    assert parse(f"3 {unit}", si) == pytest.approx(3 * expected, rel=1e-14)


@pytest.mark.parametrize(
    ("text", "quantity", "expected"),
    [
        ("12 deg", ANGLE, math.radians(12)),
        ("12deg", ANGLE, math.radians(12)),
        ("  12   deg ", ANGLE, math.radians(12)),
        ("12°", ANGLE, math.radians(12)),
        ("-1.5e1 deg", ANGLE, math.radians(-15)),
        ("0.2", ANGLE, 0.2),
        (".5 rad", ANGLE, 0.5),
        ("3 mm", STROKE, 3e-3),
        ("3000 µm", STROKE, 3e-3),
        ("0.5 inch", STROKE, 0.0127),  # by way of pint
        ("24 Hz", FREQUENCY, 24.0),
        ("0.024 kHz", FREQUENCY, 24.0),
        ("10 pi rad/s", ANGULAR_FREQUENCY, 10 * math.pi),
        ("10 π rad/s", ANGULAR_FREQUENCY, 10 * math.pi),
        ("10pi rad/s", ANGULAR_FREQUENCY, 10 * math.pi),
        ("10 pi*rad/s", ANGULAR_FREQUENCY, 10 * math.pi),
        ("5 Hz", ANGULAR_FREQUENCY, 10 * math.pi),
        ("0.005 kHz", ANGULAR_FREQUENCY, 10 * math.pi),
        ("360 deg/s", ANGULAR_FREQUENCY, 2 * math.pi),
        ("2.72e-3 N*mm/deg", BENDING, 2.72e-6 * 180 / math.pi),
        ("2.72e-3 N·mm/deg", BENDING, 2.72e-6 * 180 / math.pi),
        ("0.75", COEFFICIENT, 0.75),
    ],
)
def test_text_becomes_si(text, quantity, expected):
    assert quantity.read(text, "f") == pytest.approx(expected, rel=1e-14)  # rounding of a few factors


@pytest.mark.parametrize(
    "number", [0.5, np.float64(0.5), np.float32(0.5), Fraction(1, 2), Decimal("0.5"), "0.5", " .50 "]
)
def test_a_bare_number_is_si(number):
    # A modulus of 0.5 Pa, a density of 0.5 kg/m³ and a sheet half a metre thick are refused on purpose.
    allowing = {name: quantity for name, quantity in QUANTITIES.items() if quantity.at_least <= 0.5 <= quantity.at_most}
    assert set(QUANTITIES) - set(allowing) == {"YoungModulus", "Density", "Thickness"}
    assert {name: quantity.read(number, "f") for name, quantity in allowing.items()} == dict.fromkeys(allowing, 0.5)


@pytest.mark.parametrize("number", [2, np.int32(2), "2", " 2.0 "])
def test_two_metres_kilograms_or_radians_say_their_unit(number):
    # Whoever leaves the unit out means 2 mm, 2 g, 2 deg; a float, such as what np.radians gives, is SI all the same.
    small = {name for name, q in QUANTITIES.items() if q.unit in ("m", "kg", "rad", "m/s") and q.at_most >= 2}
    assert small == {"Angle", "ANGLE", "Length", "Mass", "Offset", "Depth", "Speed", "STROKE"}
    for name, quantity in QUANTITIES.items():
        if quantity.at_least <= 2 <= quantity.at_most:
            if name in small:
                with pytest.raises(InputError, match=rf'as a bare number is SI.*; try "2 {quantity.display}"$'):
                    quantity.read(number, "f")
                assert quantity.read(2.0, "f") == quantity.read(f"2 {quantity.unit}", "f") == 2
            else:
                assert quantity.read(number, "f") == 2


@pytest.mark.parametrize(("typed", "meant"), [("24,5 Hz", "24.5 Hz"), ("13,6g", "13.6g"), ("0,75", "0.75")])
def test_a_decimal_comma_is_pointed_at(typed, meant):
    quantity = {"z": FREQUENCY, "g": QUANTITIES["Mass"]}.get(typed[-1], COEFFICIENT)
    with pytest.raises(InputError, match=re.escape(f'try "{meant}"')):
        quantity.read(typed, "f")


@given(value=st.floats(1e-12, 1e12) | st.floats(-1e12, -1e-12) | st.just(0.0), name=st.sampled_from(sorted(QUANTITIES)))
def test_shown_text_reads_back(value, name):
    quantity = QUANTITIES[name]
    back = parse(show(value, quantity.unit, quantity.display), quantity.unit)
    assert back == pytest.approx(value, rel=1e-9, abs=0)  # ten digits, as `show` promises


def test_every_example_works():
    for name, quantity in QUANTITIES.items():
        assert quantity.read(quantity.example, "f") == parse(quantity.example, quantity.unit), name


@pytest.mark.parametrize(
    "value",
    [math.nan, math.inf, -math.inf, "nan", "inf", "-inf", "1e400", True, False, None, [], [1.0], (1.0,), {}, b"3",
     object, 1j, "", " ", "--", "abc", "12 deg3", "12 furlongs^3", "mm 12", "deg", "1 2", "0x10", "12 m/0", "3 kelvin"],
    ids=repr,
)  # fmt: skip
def test_what_is_no_such_number_is_refused(value):
    for name, quantity in QUANTITIES.items():
        assert refused(quantity, value).got is value, name


@pytest.mark.parametrize(
    "value",
    [10**400, np.array([1.0, 2.0]), np.array([0.5]), np.True_, np.complex128(1), 3 * REGISTRY.second],
    ids=["huge integer", "array", "array of one", "numpy bool", "numpy complex", "pint quantity"],
)
def test_what_only_looks_like_a_number_is_refused(value):
    refused(LENGTH, value)


@pytest.mark.parametrize(
    ("quantity", "text"),
    [(LENGTH, "3 deg"), (LENGTH, "3 s"), (LENGTH, "3 mm^2"), (ANGLE, "3 mm"), (FREQUENCY, "3 s"), (FREQUENCY, "3 rad"),
     (FREQUENCY, "150 rad/s"), (BENDING, "3 N/mm"), (ANGULAR_FREQUENCY, "3 rad"), (COEFFICIENT, "3 mm"),
     (COEFFICIENT, "3 deg")],
)  # fmt: skip
def test_the_wrong_dimension_is_refused(quantity, text):
    refused(quantity, text)


def test_a_negative_value_is_refused_where_the_least_is_zero():
    for quantity in (q for q in QUANTITIES.values() if max(q.above, q.at_least) >= 0):
        refused(quantity, -1.0)
        refused(quantity, f"-1 {quantity.display}")
        if quantity.above == 0 or quantity.at_least > 0:
            refused(quantity, 0)
        else:
            assert quantity.read(0, "f") == 0.0


@pytest.mark.parametrize("text", ["12,5 mm", "1 2 mm", "12 2mm", "1,000 mm", "12+3 mm", "12%mm", "12 mm # x"])
def test_text_with_more_than_a_number_and_a_unit_is_refused(text):
    # A decimal comma must not be read as a product: 12,5 mm is neither 60 mm nor 12 mm.
    refused(LENGTH, text)


@given(
    first=st.integers(1, 999),
    second=st.integers(1, 999),
    joint=st.sampled_from([",", ", ", " ", "+", " + ", "-", "*", " * ", "/", "^", "**", "_", "'", ";", ":", "e "]),
)
def test_two_numbers_are_no_number(first, second, joint):
    refused(LENGTH, f"{first}{joint}{second} mm")


@pytest.mark.parametrize(
    ("quantity", "text", "right"),
    [
        (ANGULAR_FREQUENCY, "5 hertz", 10 * math.pi),
        (ANGULAR_FREQUENCY, "5000 mHz", 10 * math.pi),
        (ANGULAR_FREQUENCY, "60 rpm", 2 * math.pi),
        (ANGULAR_FREQUENCY, "0.5 turn/s", math.pi),
        (ANGULAR_FREQUENCY, "60 turn/min", 2 * math.pi),
        (FREQUENCY, "60 rpm", 1.0),
        (FREQUENCY, "360 deg/s", 1.0),
        (FREQUENCY, "24 turn/s", 24.0),
    ],
)
def test_turns_and_radians_are_not_mixed_up(quantity, text, right):
    # A unit of turns may be refused, but never be wrong by 2π.
    try:
        value = quantity.read(text, "f")
    except InputError:
        return
    assert value == pytest.approx(right, rel=1e-14)


@pytest.mark.parametrize(
    "text",
    [
        "24 " + "Hz" * 5000, "24" + " " * 100_000 + "Hz", " " * 100_000 + "24 Hz", "24 Hz" + " " * 100_000,
        "9" * 100_000, "24 " + "m*" * 50_000 + "m", "24 " + "(" * 100_000, "2" + "4 " * 50_000,
    ],
    ids=lambda text: text[:8],
)  # fmt: skip
def test_text_without_end_is_refused_at_once_and_told_in_short(text):
    begun = time.process_time()
    with pytest.raises(InputError) as caught:
        FREQUENCY.read(text, "motion.frequency")
    assert len(str(caught.value)) < 500
    assert time.process_time() - begun < 1, "what grows with the square of the length takes minutes"


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("plain", "plain"),
        ("\x1b[2J", "\\x1b[2J"),
        ("a\nb\tc\x7f\x9b", "a\\nb\\tc\\x7f\\x9b"),
        ("\u202egnp.exe", "\\u202egnp.exe"),
        ("\udcff", "\\udcff"),
        ("µ ω é π 漢 –", "µ ω é π 漢 –"),
    ],
)
def test_a_message_shows_control_characters_as_text(text, shown):
    assert printable(text) == shown
    for error in (InputError(text, 1, "x", "y"), InputError("f", 1, text, "y"), InputError("f", 1, "x", text)):
        assert shown in str(error)
        assert str(error).isprintable()
    assert str(InputError("f", f"nothing {text}", "x", "y")).isprintable()
    assert str(InputError("f", text, "x", "y")).isprintable()


def test_a_message_keeps_both_ends_of_what_is_long():
    said = str(InputError("f" * 10_000, "start" + "x" * 10_000 + "end", "y" * 10_000, "\x00" * 10_000))
    assert len(said) < 2000
    assert "'start" in said
    assert "end'" in said


def test_the_message_names_field_value_range_and_a_way_out():
    assert str(refused(LENGTH, -1)) == (
        'the_field: got -1, must be a number in mm or another unit of m above 0 mm and at most 10000 mm; try "10 mm"'
    )
    limited = Quantity("m", "mm", "3 mm", at_least=1e-3, at_most=5e-3)
    assert "at least 1 mm and at most 5 mm" in str(refused(limited, "6 mm"))
    assert limited.read("5 mm", "f") == limited.at_most


@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [("24 hz", "Hz", 24.0), ("24 HZ", "Hz", 24.0), ("2 khz", "Hz", 2000.0), ("3 MM", "m", 0.003),
     ("180 Deg", "rad", math.pi), ("5 hz", "rad/s", 10 * math.pi), ("10 pi RAD/S", "rad/s", 10 * math.pi),
     ("2.72 n*MM/deg", "N*m/rad", 2.72e-3 * 180 / math.pi)],
)  # fmt: skip
def test_a_unit_may_be_of_another_case_where_that_says_which(text, unit, value):
    assert parse(text, unit) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(("text", "unit", "value"), [("1 Mm", "m", 1e6), ("1 Mg", "kg", 1e3), ("1 mHz", "Hz", 1e-3)])
def test_a_prefix_is_what_its_case_says(text, unit, value):
    assert parse(text, unit) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(("text", "unit"), [("24 mhz", "Hz"), ("24 MM", "Hz"), ("3 HZ", "m"), ("3 MM", "")])
def test_a_case_that_does_not_say_which_unit_is_refused(text, unit):
    with pytest.raises(ValueError, match=r"unit|measure|turns"):
        parse(text, unit)


@pytest.mark.parametrize(
    ("quantity", "typed", "read", "meant"),
    [(PLATE_ANGLE, "3", "3 rad", "3 deg"), (PLATE_ANGLE, -12, "-12 rad", "-12 deg"), (PLATE_STROKE, "3", "3 m", "3 mm"),
     (LENGTH, 40.0, "40 m", "40 mm"), (LENGTH, "4e1", "40 m", "40 mm"), (LENGTH, np.float32(40), "40 m", "40 mm")],
)  # fmt: skip
def test_a_bare_number_too_large_is_told_how_it_was_read(quantity, typed, read, meant):
    error = refused(quantity, typed)
    assert str(error.got).startswith(f"{read}, ")
    assert error.hint == f'"{meant}"'


@pytest.mark.parametrize("typed", ["300 deg", 1e6, "inf", math.nan, True])
def test_what_no_unit_would_mend_is_only_refused(typed):
    error = refused(PLATE_ANGLE, typed)
    assert "bare" not in str(error)
    assert error.hint == '"3 deg"'
