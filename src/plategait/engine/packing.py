"""What the core is told of runs, as plain arrays: the numbers of each, and the courses of their plates."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import plategait._native as _native  # pyright: ignore[reportMissingImports]
from plategait.engine.recording import RunRequest
from plategait.engine.trajectories import Followed, table_step, tables
from plategait.model.course import Course, Layer
from plategait.model.lattice import Lattice
from plategait.model.motion import AXES
from plategait.model.scenario import Scenario

# A plate that never ends, m.
_ENDLESS = 1e9

Numbers = dict[str, NDArray[np.int32] | NDArray[np.int64] | NDArray[np.float64]]


def parameters_of(scenario: Scenario) -> dict[str, float]:
    """Every number the core wants of a scenario, by the core's names, SI."""
    sheet, contact, friction, motion = scenario.sheet, scenario.contact, scenario.friction, scenario.motion
    share = sheet.pitch**2 / contact.tile_area
    return {
        "pitch": sheet.pitch,
        "node_mass": sheet.node_mass,
        "axial_stiffness": sheet.axial_stiffness,
        "axial_damping": sheet.axial_damping,
        "shear_ratio": sheet.shear_ratio,
        "bending_stiffness": sheet.bending_stiffness,
        "bending_damping": sheet.bending_damping,
        "torsion_stiffness": sheet.torsion_stiffness,
        "torsion_damping": sheet.torsion_damping,
        "contact_stiffness": contact.stiffness * 1e-3 * share,  # force at 1 mm, as (3.1) counts
        "contact_damping": contact.damping * share,
        "contact_ramp": contact.damping_ramp,
        "static_friction": friction.static,
        "kinetic_friction": friction.kinetic,
        "static_speed": friction.transition_speed,
        "kinetic_speed": friction.transition_speed * friction.kinetic_speed_ratio,
        "smooth_friction": float(friction.law == "adams"),
        "gravity": scenario.gravity,
        "plate_half_length": scenario.plate.length / 2 if scenario.plate else _ENDLESS,
        "plate_half_width": scenario.plate.width / 2 if scenario.plate else _ENDLESS,
        "plate_height": motion.height,
        "time_step": scenario.dt,
    }


def lines_of(lattice: Lattice) -> Numbers:
    """The lattice's lines and cells, by the core's names."""
    lines = lattice.axial_lines + lattice.diagonal_lines
    return {
        "line_start": np.cumsum([0] + [len(line) for line in lines]).astype(np.int32),
        "line_nodes": np.array([node for line in lines for node in line], dtype=np.int32),
        "cells": lattice.cells, "rest": lattice.rest, "mobility": lattice.mobility,
    }  # fmt: skip


def features_of(runs: Sequence[RunRequest], parameters: NDArray[np.float64]) -> list[bool]:
    """Phases that some run needs, in the order of the core's `Features`: the others are left out."""
    row = dict(zip(_native.PARAMETERS, parameters, strict=True))
    return [
        bool(row["torsion_stiffness"].any() or row["torsion_damping"].any()),
        bool(row["smooth_friction"].any()),
        any(r.scenario.plate is not None for r in runs),
        bool(row["contact_ramp"].any()),
    ]


@dataclass(frozen=True)
class Told:
    """What one run's plate was told: its course, and how far it is followed, s."""

    scenario: Scenario
    course: Course
    end: float

    def followed(self, layer: Layer) -> Followed | None:
        """The sampled trajectory of a layer, to as far as it is followed."""
        samples = layer.motion.samples
        if samples is None:
            return None
        return Followed(samples, table_step(self.scenario, layer.motion), self.end - layer.table_begin)


def pack_courses(told: Sequence[Told]) -> Numbers:
    """Courses side by side, by the core's names: the last layers of all are one, and so on down.

    Where a course has fewer layers than the longest, layers of a plate that stands where it begins lie beneath.
    """
    most = max(len(each.course) for each in told)
    rows: list[list[Layer | None]] = [
        [each.course[i - most + len(each.course)] if i >= most - len(each.course) else None for each in told]
        for i in range(most)
    ]
    dofs, numbers, ends = [], [], [0]
    for row in rows:
        dof, terms = _terms([layer.motion.terms() if layer else () for layer in row])
        dofs.append(dof)
        numbers.append(terms)
        ends.append(ends[-1] + len(dof))
    knots, first, count = tables(
        [t.followed(layer) if layer else None for row in rows for t, layer in zip(told, row, strict=True)]
    )
    return {
        "layer_terms": np.array(ends, dtype=np.int32),
        "term_dof": np.concatenate(dofs), "terms": np.concatenate(numbers),
        "layers": np.stack([_layers(row, told) for row in rows]),
        "knots": knots, "first_knot": first, "n_knots": count,
    }  # fmt: skip


def _layers(row: Sequence[Layer | None], told: Sequence[Told]) -> NDArray[np.float64]:
    """(numbers of a layer, n_runs), in the core's order."""
    nothing = (0.0, 0.0, 0.0, 1.0)
    numbers = [
        (layer.begin, layer.duration, layer.table_begin, table_step(t.scenario, layer.motion)) if layer else nothing
        for layer, t in zip(row, told, strict=True)
    ]
    held = [(layer or t.course[0]).motion.offset.pose for layer, t in zip(row, told, strict=True)]
    return np.concatenate([np.array(numbers), np.array(held)], axis=1).T.copy()


def _terms(
    by_run: Sequence[Sequence[tuple[int, float, float, float]]],
) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """Sines of every run in shared slots: degree of freedom of each slot, (n_slots, 3, n_runs) numbers."""
    which = {tuple(term[0] for term in terms) for terms in by_run}
    if len(which) == 1:  # as most are, and many times faster
        dofs = np.array(which.pop(), dtype=np.int32)
        order = np.argsort(dofs, kind="stable")
        whole = np.array(by_run, dtype=float).reshape(len(by_run), len(dofs), 4)
        return dofs[order], np.ascontiguousarray(whole[:, order, 1:].transpose(1, 2, 0))
    most = [max(dofs.count(d) for dofs in which) for d in range(len(AXES))]
    first = np.cumsum([0, *most]).tolist()
    numbers = np.zeros((first[-1], 3, len(by_run)))
    for j, terms in enumerate(by_run):
        free = list(first)
        for dof, *values in terms:
            numbers[free[dof], :, j] = values
            free[dof] += 1
    return np.repeat(np.arange(len(AXES), dtype=np.int32), most), numbers
