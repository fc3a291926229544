"""Fragments of scenarios: measured parameters with their uncertainty, to and from TOML, laid over any scenario."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plategait.errors import InputError, check_kind
from plategait.files.output import whole_file
from plategait.files.toml import read_toml
from plategait.model.measured import CONFIDENCE, Measured
from plategait.model.parameters import find_parameter, kinetic_follows, with_values
from plategait.model.scenario import Scenario
from plategait.shown import Shown
from plategait.units import Quantity, show

_CONFIDENCE = Quantity("", "", "0.95", above=0, at_most=1)
_HINT = "plategait identify bending CANTILEVER.csv --out bending.toml"


@dataclass(frozen=True, eq=False, repr=False)
class Fragment(Shown):
    """Part of a scenario that was measured: parameters by dotted name, their uncertainty and how they hang together.

    Attributes
    ----------
    parameters : mapping of str to Measured
        By dotted name of a scenario's field ("sheet.bending_stiffness").
    correlation : (n, n) array or None
        Of the parameters, in their order; None where they are independent.
    confidence : float
        Of the intervals.
    source : str
        Where it comes from, in a line.
    remarks : tuple of str
        What to know beside the numbers, a line each: comments of the file.
    """

    parameters: Mapping[str, Measured]
    correlation: NDArray[np.float64] | None = None
    confidence: float = CONFIDENCE
    source: str = ""
    remarks: tuple[str, ...] = ()

    def apply(self, scenario: Scenario) -> Scenario:
        """Scenario with the measured values."""
        return _laid_over(scenario, {name: m.value for name, m in self.parameters.items()})

    def draw(self, scenario: Scenario, generator: np.random.Generator) -> Scenario:
        """Scenario with one draw of the measured values, each log-normal about its value with its sd, correlated."""
        names = list(self.parameters)
        correlation = np.eye(len(names)) if self.correlation is None else self.correlation
        normal = generator.multivariate_normal(np.zeros(len(names)), correlation, method="eigh")
        drawn = {}
        for name, z in zip(names, normal, strict=True):
            m = self.parameters[name]
            drawn[name] = m.value * math.exp(z * math.log1p(m.sd / abs(m.value))) if m.value else 0.0
        return _laid_over(scenario, drawn)


def _laid_over(scenario: Scenario, measured: dict[str, float]) -> Scenario:
    values = kinetic_follows(measured, scenario)
    if "friction.static" in values:
        # Drawn each by itself, the kinetic one may come out above.
        values["friction.kinetic"] = min(values["friction.kinetic"], values["friction.static"])
    return with_values(scenario, values)


def overlay(
    scenario: Scenario, fragments: Sequence[Fragment], generator: np.random.Generator | None = None
) -> Scenario:
    """Scenario with fragments laid over it in turn, at their values, or drawn where a generator is given."""
    for fragment in fragments:
        scenario = fragment.apply(scenario) if generator is None else fragment.draw(scenario, generator)
    return scenario


def fragment_text(fragment: Fragment) -> str:
    """Write a fragment as commented TOML that `read_fragment` reads back."""
    lines = [f"# {fragment.source}"] if fragment.source else []
    lines += ["# Lay it over a scenario: plategait simulate cheese --with THIS.toml"]
    lines += [f"# {remark}" for remark in fragment.remarks]
    for section in dict.fromkeys(name.partition(".")[0] for name in fragment.parameters):
        lines += ["", f"[{section}]"]
        for name, m in fragment.parameters.items():
            if name.startswith(f"{section}."):
                lines.append(f"{name.partition('.')[2]} = {_literal(name, m.value)}")
    lines += ["", "[uncertainty]", f"confidence = {fragment.confidence:g}"]
    if fragment.correlation is not None:
        lines.append(f"between = [{', '.join(_quoted(n) for n in fragment.parameters)}]")
        rows = ", ".join("[" + ", ".join(f"{v:.6g}" for v in row) + "]" for row in fragment.correlation)
        lines.append(f"correlation = [{rows}]")
    lines += ["", "[uncertainty.sd]"]
    lines += [f"{_quoted(name)} = {_literal(name, m.sd)}" for name, m in fragment.parameters.items()]
    lines += ["", "[uncertainty.interval]"]
    lines += [
        f"{_quoted(name)} = [{_literal(name, m.low)}, {_literal(name, m.high)}]"
        for name, m in fragment.parameters.items()
    ]
    return "\n".join(lines) + "\n"


def write_fragment(fragment: Fragment, path: Path | str) -> None:
    """Write a fragment to a file, whole or not at all.

    Parameters
    ----------
    fragment : Fragment
        Values with their standard deviations, intervals and correlations.
    path : Path or str
        File that ends in .toml.

    Raises
    ------
    InputError
        When the file cannot be written.
    """
    check_kind(fragment, Fragment, "fragment", "what to_fragment() of a result gives")
    with whole_file(path, (".toml",), "--out") as temporary:
        temporary.write_text(fragment_text(fragment), encoding="utf-8")


def read_fragment(path: Path | str, field: str = "--with") -> Fragment:
    """Read a fragment, or part of a scenario written by hand: values without an uncertainty are taken as exact.

    Parameters
    ----------
    path : Path or str
        TOML file of `identify` or `estimate`, or one written by hand.
    field : str, optional
        What errors call it.

    Raises
    ------
    InputError
        When the file cannot be read, is no TOML, or names what no scenario has.
    """
    data, text = read_toml(path, field, "a fragment file that can be read", _HINT)
    uncertainty = dict(_items("uncertainty", data.pop("uncertainty", {})))
    named = {f"{section}.{name}": value for section, table in data.items() for name, value in _items(section, table)}
    if not named:
        raise InputError(field, str(path), "a file with parameters in it", _HINT)
    sds, intervals = (dict(_items(f"uncertainty.{kind}", uncertainty.get(kind, {}))) for kind in ("sd", "interval"))
    parameters = {}
    for name, value in named.items():
        quantity = _quantity(name)
        number = quantity.read(value, name)
        sd = replace(_free(quantity), at_least=0.0).read(sds.get(name, 0.0), f"uncertainty.sd.{name}")
        ends = intervals.get(name, [number, number])
        if not isinstance(ends, list) or len(ends) != 2:
            raise InputError(f"uncertainty.interval.{name}", ends, "a list of its two ends", '["1", "2"]')
        low, high = (_free(quantity).read(end, f"uncertainty.interval.{name}") for end in ends)
        parameters[name] = Measured(number, sd, low, high)
    correlation = _correlation(uncertainty, list(parameters))
    source = text.partition("\n")[0].removeprefix("#").strip() if text.startswith("#") else ""
    confidence = _CONFIDENCE.read(uncertainty.get("confidence", CONFIDENCE), "uncertainty.confidence")
    return Fragment(parameters, correlation, confidence, source)


def _items(section: str, table: object) -> list[tuple[str, Any]]:
    if not isinstance(table, dict):
        # Not what it is instead: the file need not be one of ours.
        raise InputError(section, "nothing like a table", "a table of parameters", "[sheet]")
    return list(table.items())


def _correlation(uncertainty: dict[str, Any], names: list[str]) -> NDArray[np.float64] | None:
    if "correlation" not in uncertainty:
        return None
    try:
        matrix = np.array(uncertainty["correlation"], dtype=float)
        order = [uncertainty.get("between", names).index(name) for name in names]
        matrix = matrix[np.ix_(order, order)]
        sound = np.allclose(np.diag(matrix), 1) and np.allclose(matrix, matrix.T) and np.abs(matrix).max() <= 1 + 1e-9
        # As written, with six digits, it may miss being a correlation by their round-off.
        sound = sound and np.linalg.eigvalsh(matrix).min() >= -1e-4
    except (ValueError, TypeError, IndexError, AttributeError, RecursionError, np.linalg.LinAlgError):
        sound, matrix = False, np.eye(len(names))
    if not sound:
        raise InputError("uncertainty.correlation", uncertainty["correlation"],
                         "the symmetric matrix of a correlation, with a row for each name in `between`",
                         "[[1, 0.5], [0.5, 1]]")  # fmt: skip
    return matrix


def _quantity(name: str) -> Quantity:
    """What a scenario's field measures.

    Raises
    ------
    InputError
        When no scenario has a number of that name.
    """
    quantity = find_parameter(name).quantity
    if quantity is None:
        raise InputError(name, "a word", "a number of a scenario", "sheet.bending_stiffness")
    return quantity


def _free(quantity: Quantity) -> Quantity:
    """Same without limits: an interval may reach where the value may not."""
    return Quantity(quantity.unit, quantity.display, quantity.example)


def _literal(name: str, value: float) -> str:
    quantity = _quantity(name)
    if not math.isfinite(value):
        return str(value)
    return f'"{show(value, quantity.unit, quantity.display)}"' if quantity.unit else f"{value:.10g}"


def _quoted(name: str) -> str:
    return f'"{name}"'
