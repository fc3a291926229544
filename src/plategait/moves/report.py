"""An atlas as plain data, in the units that people use, and what a picture needs of another one."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.files.input import read_text
from plategait.files.plain import plain
from plategait.model.motion import AXES, PlateMotion
from plategait.moves.atlas import CONFIDENCE, Atlas
from plategait.moves.certainty import COVERED
from plategait.moves.primitives import Primitive
from plategait.optimize.ranking import largest_chance
from plategait.optimize.trials import Trial

PEOPLES = np.array([1e3, 1e3, 180 / math.pi])
"""From m/s, m/s, rad/s to mm/s, mm/s, deg/s."""
MOST_BYTES = 1 << 28


def summary(atlas: Atlas) -> dict[str, Any]:
    """Plain numbers for `--json`.

    `motion` are the fields of a `PlateMotion`, SI: ``pg.PlateMotion(**cell["motion"])``. Covariances are of the
    velocity of one fresh run, in mm/s, mm/s and deg/s.
    """
    twists = atlas.twists * PEOPLES
    return {
        "scenario": atlas.scenario.name,
        "machine": atlas.machine.name,
        "duration_s": atlas.scenario.duration,
        "transient_s": atlas.scenario.measured_from,
        "starts_within_mm": 1e3 * atlas.reach,
        "cell_size": (atlas.sizes * PEOPLES).tolist(),
        "covered": COVERED,
        "confidence": CONFIDENCE,
        "runs": atlas.runs,
        "reached": {
            name: [float(twists[:, i].min()), float(twists[:, i].max())]
            for i, name in enumerate(("along_mm_s", "across_mm_s", "turn_deg_s"))
        },
        "cells": [_shown(atlas, trial) for trial in atlas.cells.values()],
        "primitives": [_primitive(atlas, each) for each in atlas.primitives],
    }


def _shown(atlas: Atlas, trial: Trial) -> dict[str, Any]:
    along, across, turn = (trial.twist * PEOPLES).tolist()
    return {
        "velocity_mm_s": [along, across],
        "turn_deg_s": turn,
        "covariance": (atlas.covariance(trial) * np.outer(PEOPLES, PEOPLES)).tolist(),
        "chance_of_failure": largest_chance(trial.failed, trial.runs, CONFIDENCE),
        "failed_runs": trial.failed,
        "runs": trial.runs,
        "settling_s": plain(float(trial.further[:, 0].mean())),
        "acceleration_m_s2": plain(trial.cost("acceleration")),
        "motion": motion_fields(trial.motion),
    }


def _primitive(atlas: Atlas, primitive: Primitive) -> dict[str, Any]:
    low, high = (primitive.interval * PEOPLES[:, None]).T.tolist()
    return {
        "name": primitive.name,
        "verified": primitive.verified,
        **_shown(atlas, primitive.trial),
        "mean_interval": {"velocity_mm_s": [[low[0], high[0]], [low[1], high[1]]], "turn_deg_s": [low[2], high[2]]},
    }


def motion_fields(motion: PlateMotion) -> dict[str, Any]:
    """Fields of a motion of sines as plain data, SI."""
    return {
        **{name: getattr(motion, name) for name in ("frequency", "angle", "stroke", "height", "ramp")},
        "offset": dict(zip(AXES, motion.offset.pose, strict=True)),
        "waves": [{name: getattr(wave, name) for name in ("axis", "amplitude", "ratio", "phase")}
                  for wave in motion.waves],
    }  # fmt: skip


def reached_in(path: Path | str, field: str = "beside") -> tuple[str, Array]:
    """Machine and velocities (cells, 3) in mm/s and deg/s of an atlas that was written to a JSON file.

    Raises
    ------
    InputError
        When it is none.
    """
    allowed, hint = "an atlas as plategait moves --out writes it", "six-axis.json"
    content = read_text(path, MOST_BYTES, field, allowed, hint)
    try:
        told = json.loads(content)
        twists = np.array([[*cell["velocity_mm_s"], cell["turn_deg_s"]] for cell in told["cells"]], dtype=float)
        machine = str(told["machine"])
    except (ValueError, TypeError, KeyError):
        twists, machine = np.empty((0, 3)), ""
    if twists.ndim != 2 or twists.shape[1:] != (3,) or not len(twists) or not np.isfinite(twists).all():
        raise InputError(field, str(path), allowed, hint)
    return machine, twists
