"""Options that say what a sheet is cut to and made of, and the sheet that they add up to."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Annotated, Any

import typer

from plategait.cli.outline import read_outline
from plategait.errors import InputError
from plategait.model.material import USUAL_POISSON_RATIO
from plategait.model.materials import named_material
from plategait.model.presets import PRESETS, as_scenario
from plategait.model.scenario import Scenario
from plategait.model.sheet import Sheet

# What these options are called in a sheet's fields, where they are called otherwise.
_FIELDS = {"young": "young_modulus", "poisson": "poisson_ratio"}
# Densities of what sheets are made of, kg/m³.
LEAST_DENSITY, MOST_DENSITY = 20.0, 25_000.0
_OF_A_MATERIAL = ("thickness", "density", "poisson", "loss_factor", "damping_ratio")


Pitch = Annotated[str | None, typer.Option("--pitch", help='Distance between nodes: "5 mm".')]
Density = Annotated[str | None, typer.Option("--density", help='Of the material: "1100 kg/m^3".')]
LossFactor = Annotated[str | None, typer.Option("--loss-factor", help="Damping, tan delta at the dish mode: 0.1.")]
DampingRatio = Annotated[
    str | None, typer.Option("--damping-ratio", help="Or the damping ratio of the dish mode: 0.05.")
]


@dataclass(frozen=True)
class MaterialOptions:
    """What the sheet is cut to and made of, as typed, in place of the scenario's."""

    outline: Annotated[
        str | None,
        typer.Option(
            "--outline",
            help='Cut to: "disk 40 mm" (radius), "rectangle 90 mm x 60 mm", "leaf.png 70 mm", or corners.csv: '
            "a first line x_mm,y_mm, then a row for each corner in order.",
        ),
    ] = None
    pitch: Pitch = None
    mass: Annotated[str | None, typer.Option("--mass", help='Weighed mass: "5 g".')] = None
    material: Annotated[
        str | None, typer.Option("--material", help="Made of one of `plategait materials`, typical numbers.")
    ] = None
    young: Annotated[str | None, typer.Option("--young", help='Young\'s modulus: "0.5 MPa".')] = None
    thickness: Annotated[str | None, typer.Option("--thickness", help='Of the material: "1 mm".')] = None
    density: Density = None
    poisson: Annotated[
        str | None, typer.Option("--poisson", help=f"Poisson's ratio; {USUAL_POISSON_RATIO} with --young.")
    ] = None
    loss_factor: LossFactor = None
    damping_ratio: DampingRatio = None

    @property
    def of_a_material(self) -> bool:
        """Whether a material was told."""
        return self.young is not None or self.material is not None

    @property
    def makes_a_sheet(self) -> bool:
        """Whether anything here was typed."""
        return any(getattr(self, field.name) is not None for field in fields(MaterialOptions))

    def laid_over(self, scenario: Scenario) -> Scenario:
        """Scenario with this sheet; what was not typed is the scenario's own sheet's.

        Raises
        ------
        InputError
            When one says what the others leave open, or contradicts them.
        """
        if not self.makes_a_sheet:
            return scenario
        sheet = self._of_the_material(scenario.sheet) if self.of_a_material else self._of_the_same(scenario.sheet)
        name = {"name": sheet.name} if self.of_a_material else {}
        return scenario.replace(sheet=sheet, **name)

    def _shape(self, sheet: Sheet) -> dict[str, Any]:
        """Outline and pitch."""
        outline = sheet.outline if self.outline is None else read_outline(self.outline)
        return {"outline": outline, "pitch": sheet.pitch if self.pitch is None else self.pitch}

    def _of_the_same(self, sheet: Sheet) -> Sheet:
        """The scenario's sheet cut anew: of the same mass per area unless it was weighed."""
        for name in _OF_A_MATERIAL:
            if (typed := getattr(self, name)) is not None:
                raise InputError(f"--{name.replace('_', '-')}", typed, "left out where no material is told",
                                 '--young "0.5 MPa" or --material beside it')  # fmt: skip
        cut: Sheet = sheet.replace(**self._shape(sheet))
        scaled = sheet.mass if self.outline is None else sheet.mass * cut.area / sheet.area
        weighed: Sheet = cut.replace(mass=scaled if self.mass is None else self.mass)
        return weighed

    def _of_the_material(self, sheet: Sheet) -> Sheet:
        told: dict[str, Any] = self._shape(sheet) | {"thickness": sheet.thickness, "name": "sheet"}
        if self.material is not None:
            named_material(self.material, "--material")
            told["name"] = self.material
        for name in ("material", "young", "mass", *_OF_A_MATERIAL):
            if (typed := getattr(self, name)) is not None:
                told[_FIELDS.get(name, name)] = typed
        if self.mass is None and self.density is None and self.material is None:
            if self.outline is not None:
                raise InputError("--density", "nothing", "given with a new outline, or else --mass",
                                 '--density "1100 kg/m^3"')  # fmt: skip
            told["mass"] = sheet.mass
        return Sheet(**told)

    def remarks(self, scenario: Scenario) -> dict[str, str]:
        """Where the numbers of a sheet of a material come from, by dotted field, for a scenario file."""
        if not self.of_a_material:
            return {}
        told = {"E": self.young, "h": self.thickness, "ρ": self.density, "ν": self.poisson, "η": self.loss_factor,
                "ζ": self.damping_ratio}  # fmt: skip
        words = [self.material or "", *(f"{sign} = {typed}" for sign, typed in told.items() if typed is not None)]
        of = ", ".join(filter(None, words))
        sheet = {
            "bending_stiffness": f"D of {of}", "torsion_stiffness": "(1 - ν) D", "axial_stiffness": f"of {of}",
            "shear_ratio": "by Poisson's ratio",
        }  # fmt: skip
        if scenario.sheet.bending_damping:
            sheet |= dict.fromkeys(("bending_damping", "axial_damping", "torsion_damping"), "of the loss factor")
        if self.mass is None and (self.density is not None or self.material is not None):
            sheet["mass"] = "by the density, of the lattice's squares"
        return {f"sheet.{name}": remark for name, remark in sheet.items()}

    def taken(self, name: str, scenario: Scenario, *, friction_told: bool = False) -> list[str]:
        """What a scenario made of the one of this name takes for want of anybody's word, and what its sheet weighs."""
        said = self.assumed(name, scenario, friction_told=friction_told)
        lines = [f"taken, as nobody told otherwise: {', '.join(said)}"] if said else []
        return lines + (weighed(scenario.sheet) if self.makes_a_sheet else [])

    def assumed(self, name: str, scenario: Scenario, *, friction_told: bool = False) -> list[str]:
        """What is taken for want of anybody's word, each in a few."""
        read = as_scenario(name)
        preset = read.name if name in PRESETS else ""
        said = [f"Poisson's ratio {USUAL_POISSON_RATIO}"] if self.young and not (self.poisson or self.material) else []
        if self.of_a_material or not preset:
            pair, source = scenario.friction, f"preset {preset}" if preset else "slice of cheese"
            as_for = f"as for the {source}"
            if not friction_told and (preset or "friction" not in read.model_fields_set):
                speed = f"{1e3 * pair.transition_speed:.3g} mm/s"
                said.append(f"friction {pair.static:.2f}/{pair.kinetic:.2f} from {speed} on {as_for}")
            if preset or "contact" not in read.model_fields_set:
                said.append(f"contact {as_for}")
            if not scenario.sheet.bending_damping and (said or self.of_a_material):
                said.append("no damping of the sheet")
        return said


def weighed(sheet: Sheet) -> list[str]:
    """Mass, area and thickness of a sheet and the density that they come to; a warning of one that no sheet has."""
    area = 1e4 * sheet.area
    density = sheet.mass / (sheet.area * sheet.thickness)
    line = (f"sheet: {1e3 * sheet.mass:.4g} g over {area:.4g} cm² ({sheet.lattice.n_nodes} nodes): "
            f"{_dense(density)} kg/m³ at {1e3 * sheet.thickness:.3g} mm")  # fmt: skip
    if LEAST_DENSITY <= density <= MOST_DENSITY:
        return [line]
    allowed = f"{_dense(LEAST_DENSITY)} (foam) to {_dense(MOST_DENSITY)} kg/m³ (the heaviest metals)"
    return [line, f"warning: {_dense(density)} kg/m³ is beyond {allowed}: check --mass, --thickness and --outline"]


def _dense(density: float) -> str:
    return f"{density:,.0f}" if density >= 1000 else f"{density:.3g}"
