"""What a free vibration tells of a sheet: its modes, and the joints' stiffness and damping."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from plategait.arrays import Array
from plategait.errors import InputError
from plategait.model.fragment import Fragment
from plategait.model.measured import CONFIDENCE, Measured, as_json
from plategait.shown import Shown

Support = Literal["free", "cantilever"]


@dataclass(frozen=True)
class RingMode:
    """One mode of a recording.

    Attributes
    ----------
    omega, damping_ratio : Measured
        Undamped natural angular frequency, rad/s, and ζ.
    amplitude : float
        Largest deflection, in the signal's unit.
    share : float
        Its rms over that of the whole motion.
    rings : bool
        Whether it is seen to oscillate: ζ below 1 and a cycle or more within the recording.
    """

    omega: Measured
    damping_ratio: Measured
    amplitude: float
    share: float
    rings: bool

    @property
    def frequency(self) -> float:
        """Undamped natural frequency, Hz."""
        return self.omega.value / (2 * math.pi)


@dataclass(frozen=True, eq=False, repr=False)
class RingResult(Shown):
    """What a free vibration tells of a sheet.

    Attributes
    ----------
    name, kind, support, sheet : str
        The recording, its column, how it was held, and the sheet that the numbers belong to.
    modes : tuple of RingMode
        In order of frequency.
    mode_index : int or None
        Place of the mode that the numbers come from; None where nothing rings.
    natural_frequency : Measured or None
        ω_n of the whole sheet, rad/s.
    stiffness, damping : Measured or None
        k_b (N m/rad) and c_b (N m s/rad); None where not determined.
    correlation : float
        Of ln k_b and ln c_b.
    torsion_ratio : float
        k_t/k_b of the sheet, which is kept.
    time, signal, fitted : (m,) arrays
        What was fitted, and the fit.
    notes : tuple of str
        What to know about it.
    """

    name: str
    kind: str
    support: Support
    sheet: str
    modes: tuple[RingMode, ...]
    mode_index: int | None
    natural_frequency: Measured | None
    stiffness: Measured | None
    damping: Measured | None
    correlation: float
    torsion_ratio: float
    time: Array
    signal: Array
    fitted: Array
    notes: tuple[str, ...]

    @property
    def mode(self) -> RingMode | None:
        """The mode that the numbers come from."""
        return None if self.mode_index is None else self.modes[self.mode_index]

    def to_fragment(self) -> Fragment:
        """Fragment with sheet.bending_stiffness and, where determined, sheet.bending_damping; torsion in proportion.

        Raises
        ------
        InputError
            When nothing rings.
        """
        if self.stiffness is None:
            raise InputError("modes", "nothing determined", "a recording that rings", "recording at a higher rate")
        parts = {"stiffness": self.stiffness} | ({"damping": self.damping} if self.damping else {})
        parameters, kinds = {}, []
        for joint, factor in (("bending", 1.0), ("torsion", self.torsion_ratio)):
            for kind, m in parts.items():
                if factor:
                    parameters[f"sheet.{joint}_{kind}"] = Measured(
                        *(factor * v for v in (m.value, m.sd, m.low, m.high))
                    )
                    kinds.append(kind)
        related = np.array([[1.0 if a == b else self.correlation for b in kinds] for a in kinds])
        return Fragment(
            parameters, related if len(kinds) > 1 else None, source=f"plategait identify modes, {self.name}"
        )

    def summary(self) -> dict[str, Any]:
        """Numbers for programs, with units in the names."""
        return {
            "recording": self.name,
            "support": self.support,
            "sheet": self.sheet,
            "natural_frequency_rad_s": as_json(self.natural_frequency),
            "bending_stiffness_n_mm_per_deg": as_json(self.stiffness, 1e3 * math.radians(1)),
            "bending_damping_n_mm_s_per_deg": as_json(self.damping, 1e3 * math.radians(1)),
            "correlation": self.correlation if self.damping else None,
            "confidence": CONFIDENCE,
            "mode": None if self.mode_index is None else self.mode_index + 1,
            "modes": [
                {
                    "omega_rad_s": as_json(m.omega),
                    "frequency_hz": m.frequency,
                    "damping_ratio": as_json(m.damping_ratio),
                    "amplitude": m.amplitude,
                    "share": m.share,
                    "rings": m.rings,
                }
                for m in self.modes
            ],
            "notes": list(self.notes),
        }
