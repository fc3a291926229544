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


@dataclass(frozen=True, eq=False)
class Told:
    """What the plates of some runs were told: their courses, and how far each is followed, s."""

    scenarios: Sequence[Scenario]
    courses: Sequence[Course]
    ends: Sequence[float] | NDArray[np.float64]

    def followed(self, j: int, layer: Layer) -> Followed | None:
        """The sampled trajectory of a run's layer, to as far as it is followed."""
        samples = layer.motion.samples
        if samples is None:
            return None
        step = table_step(self.scenarios[j], layer.motion)
        return Followed(samples, step, float(self.ends[j]) - layer.table_begin)


@dataclass(frozen=True, eq=False)
class Row:
    """One layer of each run, packed: degree of freedom of each sine, (n_sines, 3, n_runs) numbers, and the layers'.

    What it was packed of is kept with it, so that nothing else goes by the same identity.
    """

    of: Sequence[Layer]
    dofs: NDArray[np.int32]
    terms: NDArray[np.float64]
    numbers: NDArray[np.float64]
    sampled: bool


Rows = dict[tuple[int, ...], Row]
"""Rows by the identities of what they were packed of, of which there are none in two places."""


def pack_courses(told: Told, before: Rows) -> tuple[Numbers, Rows]:
    """Courses side by side, by the core's names: the last layers of all are one, and so on down.

    Where a course has fewer layers than the longest, layers of a plate that stands where it begins lie beneath.

    Parameters
    ----------
    told : Told
    before : Rows
        What was packed before of the same runs: most of it lies deeper now, and else the same.
    """
    courses = told.courses
    most = max(map(len, courses))
    missing = [most - len(course) for course in courses]
    rows: Rows = {}
    for i in range(most):
        layers = [course[i - gone] if i > gone else course[0] for course, gone in zip(courses, missing, strict=True)]
        count = sum(gone > i for gone in missing)
        key = (*map(id, layers), *((gone > i for gone in missing) if count else ()))
        rows[key] = before.get(key) or _row(layers, [gone > i for gone in missing], told)
    packed, ends = list(rows.values()), np.cumsum([0, *(len(row.dofs) for row in rows.values())])
    followed = []
    if any(row.sampled for row in packed):
        followed = [
            None if gone > i else told.followed(j, layer)
            for i, row in enumerate(packed)
            for j, (layer, gone) in enumerate(zip(row.of, missing, strict=True))
        ]
    knots, first, count_of_knots = tables(followed)
    return {
        "layer_terms": ends.astype(np.int32),
        "term_dof": np.concatenate([row.dofs for row in packed]),
        "terms": np.concatenate([row.terms for row in packed]),
        "layers": np.stack([row.numbers for row in packed]),
        "knots": knots, "first_knot": first, "n_knots": count_of_knots,
    }, rows  # fmt: skip


def _row(layers: Sequence[Layer], missing: Sequence[bool], told: Told) -> Row:
    dofs, terms = _terms([() if gone else layer.motion.terms() for layer, gone in zip(layers, missing, strict=True)])
    numbers = [
        (0.0, 0.0, 0.0, 1.0, *layer.motion.offset.pose) if gone
        else (layer.begin, layer.duration, layer.table_begin,
              1.0 if layer.motion.samples is None else table_step(scenario, layer.motion), *layer.motion.offset.pose)
        for layer, gone, scenario in zip(layers, missing, told.scenarios, strict=True)
    ]  # fmt: skip
    sampled = any(layer.motion.samples is not None for layer in layers)
    return Row(layers, dofs, terms, np.array(numbers).T.copy(), sampled)


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
