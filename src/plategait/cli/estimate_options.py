"""Options of the estimate command in groups, and what each group adds up to."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from plategait.cli import options, report
from plategait.cli.material_options import DampingRatio, Density, LossFactor, MaterialOptions, Pitch
from plategait.curve.protocol import USUAL, Protocol
from plategait.errors import InputError
from plategait.model.fragment import read_fragment
from plategait.model.outline import Disk
from plategait.model.scenario import Scenario
from plategait.units import ANGLE, ANGULAR_FREQUENCY, FREQUENCY, PLATE_ANGLE, Quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from plategait.curve.curve import Curve
    from plategait.estimate.candidates import Reach
    from plategait.estimate.observations import Condition
    from plategait.estimate.planning import Plan
    from plategait.estimate.result import Estimate, EstimateOptions
    from plategait.model.motion import PlateMotion

Method = Literal["posterior", "linear", "quadratic", "any-size"]
MethodName = Annotated[
    Method,
    typer.Option("--method", help="posterior; linear (5.6, 5.7) or quadratic; or any-size, regressed for any radius."),
]
Coefficients = Literal["published", "refitted"]
CoefficientsName = Annotated[
    Coefficients | None,
    typer.Option("--coefficients", help="Of linear: published, or refitted to our simulations as quadratic's are."),
]

_MASS = Quantity("kg", "g", "13.6 g", above=0, at_most=10)
_LENGTH = Quantity("m", "mm", "40 mm", above=0, at_most=10)
_THICKNESS = Quantity("m", "mm", "2.5 mm", above=0, at_most=0.1)
_HEIGHT = Quantity("m", "mm", "5 mm", at_least=-1, at_most=1)
_CANDIDATE_ANGLE = Quantity("rad", "deg", "3 deg", above=0, at_most=math.pi / 2)
_CANDIDATE_STROKE = Quantity("m", "mm", "3 mm", at_least=0, at_most=1)
_TIME = Quantity("s", "s", "2 s", above=0)
_MODEL_ERROR = Quantity("", "", "1", at_least=0, at_most=10)
_RAMP = Quantity("s", "s", "0.1 s", at_least=0, at_most=1e3)


@dataclass(frozen=True)
class SetupOptions:
    """The object as far as it is known, and the plate."""

    scenario: Annotated[
        str, typer.Option("--scenario", help="Preset or TOML file with the object's size, shape and mass.")
    ] = "cheese"
    measured: options.With = None
    angle: Annotated[
        list[str] | None, typer.Option("--angle", help='Angular amplitude A_p, one for all curves or each: "3 deg".')
    ] = None
    stroke: options.Stroke = None
    mass: Annotated[str | None, typer.Option("--mass", help='Mass of the object: "13.6 g".')] = None
    radius: Annotated[str | None, typer.Option("--radius", help='Radius of a disk: "40 mm".')] = None
    height: Annotated[
        str | None,
        typer.Option("--height", help='Plate\'s surface above the axis that it turns about: "5 mm", "5 ± 1 mm".'),
    ] = None
    thickness: Annotated[
        str | None, typer.Option("--thickness", help='For Young\'s modulus: "2.5 mm" or "2.5 ± 0.1 mm".')
    ] = None

    outline: Annotated[
        str | None,
        typer.Option(
            "--outline", help='Cut to: "disk 40 mm" (radius), "rectangle 90 mm x 60 mm", corners.csv (x_mm,y_mm), …'
        ),
    ] = None
    pitch: Pitch = None
    material: Annotated[
        str | None, typer.Option("--material", help="Made of one of `plategait materials`, as a first guess of it.")
    ] = None
    young: Annotated[
        str | None,
        typer.Option("--young", help='First guess of Young\'s modulus, which is read anew: "0.5 MPa".'),
    ] = None
    density: Density = None
    poisson: Annotated[str | None, typer.Option("--poisson", help="Poisson's ratio of the material.")] = None
    loss_factor: LossFactor = None
    damping_ratio: DampingRatio = None

    @property
    def size_told(self) -> bool:
        """Whether the object's size was typed."""
        return self.radius is not None or self.outline is not None

    @property
    def made(self) -> MaterialOptions:
        """What the object is cut to and made of; its mass and thickness are the measured ones, laid over any sheet."""
        made = MaterialOptions(outline=self.outline, pitch=self.pitch, material=self.material, young=self.young,
                               density=self.density, poisson=self.poisson, loss_factor=self.loss_factor,
                               damping_ratio=self.damping_ratio)  # fmt: skip
        if not made.of_a_material:
            return made
        thickness = None if self.thickness is None else read_measured(self.thickness, _THICKNESS, "--thickness")[0]
        return replace(made, mass=self.mass, thickness=None if thickness is None else f"{thickness!r} m")

    @property
    def plate_height(self) -> tuple[float, float] | None:
        """Height of the plate and how well it is known, m."""
        return None if self.height is None else read_measured(self.height, _HEIGHT, "--height")

    @property
    def thickness_sd(self) -> float:
        """How well the thickness is known, m."""
        return 0.0 if self.thickness is None else read_measured(self.thickness, _THICKNESS, "--thickness")[1]

    @property
    def known(self) -> dict[str, tuple[float, float]]:
        """What is told of c_b, as a factor, and of the plate's height with how well it is known: SI value and sd."""
        known = {}
        for path in self.measured or []:
            told = read_fragment(path).parameters.get("sheet.bending_damping")
            if told is not None and told.sd > 0 and told.value > 0:
                known["bending_damping"] = (1.0, told.sd / told.value)
        if self.plate_height is not None and self.plate_height[1] > 0:
            known["plate_height"] = self.plate_height
        return known

    @property
    def exact(self) -> tuple[str, ...]:
        """What is told without a spread, and so not sought."""
        return ("plate_height",) if self.plate_height is not None and self.plate_height[1] == 0 else ()

    def build(self) -> Scenario:
        """Scenario of the object; the lattice grows with the radius."""
        if self.radius is not None and self.outline is not None:
            raise InputError("--radius", self.radius, "left out beside --outline", f'--outline "disk {self.radius}"')
        base = options.build(self.scenario, made=self.made, stroke=self.stroke, measured=self.measured)
        changes: dict[str, Any] = {}
        if self.plate_height is not None:
            changes["motion.height"] = self.plate_height[0]
        if self.thickness is not None:
            changes["sheet.thickness"] = read_measured(self.thickness, _THICKNESS, "--thickness")[0]
        if self.radius is not None:
            radius, outline = _LENGTH.read(self.radius, "--radius"), base.sheet.outline
            if not isinstance(outline, Disk):
                raise InputError(
                    "--radius", self.radius, "left out for an object that is no disk", f"--scenario {base.name}.toml"
                )
            changes["sheet.outline"] = Disk(radius=radius)
            changes["sheet.pitch"] = base.sheet.pitch * radius / outline.radius
        if self.mass is not None:
            changes["sheet.mass"] = _MASS.read(self.mass, "--mass")
        return base.replace(**changes) if changes else base

    @property
    def amplitudes(self) -> list[float]:
        """A_p as typed, rad."""
        return [PLATE_ANGLE.read(a, "--angle") for a in self.angle or []]

    def motions(self, base: Scenario, count: int) -> list[PlateMotion]:
        """Plate motion of each of so many curves."""
        angles = self.angle or []
        if len(angles) not in (0, 1, count):
            raise InputError(
                "--angle", f"{len(angles)} of them", f"given once, or once for each of {count} curves", '"3 deg"'
            )
        amplitudes = self.amplitudes or [base.motion.angle]
        amplitudes = amplitudes * count if len(amplitudes) == 1 else amplitudes
        return [base.motion.replace(angle=a) for a in amplitudes]


@dataclass(frozen=True)
class MeasurementOptions:
    """How the curves were measured, and what is estimated of them."""

    beta: Annotated[str | None, typer.Option("--beta", help="Kinetic over static friction, where it is known.")] = None
    free: Annotated[
        list[str] | None,
        typer.Option("--free", help="Estimate this too: mass, contact_damping; repeatable."),
    ] = None
    fixed: Annotated[
        list[str] | None,
        typer.Option(
            "--fixed",
            help="Known, so not estimated: bending_damping, plate_height, friction_angle, …; repeatable.",
        ),
    ] = None
    noise: Annotated[
        str | None, typer.Option("--noise", help="Relative noise of the rates: 0.05 or 5%. Estimated if left out.")
    ] = None
    duration: Annotated[str, typer.Option("--duration", help="How long each frequency was observed.")] = (
        f"{USUAL.duration:g} s"
    )
    slip_limit: Annotated[str, typer.Option("--slip-limit", help="Slip at which the object counts as run off.")] = (
        f"{1e3 * USUAL.slip_limit:g} mm"
    )
    ramp: Annotated[
        str | None,
        typer.Option(
            "--ramp", help="How long the plate took to its full swing: 0.1 s. Any time up to 0.3 s if unknown."
        ),
    ] = None
    model_error: Annotated[
        str, typer.Option("--model-error", help="How far the model may be off: 1 as far as other models, 0 not at all.")
    ] = "1"
    any_law: Annotated[
        bool, typer.Option("--any-law", help="The law of friction may be the other one: much wider intervals.")
    ] = False
    friction_scatter: Annotated[
        str,
        typer.Option("--friction-scatter", help='Friction angle from point to point, one sd: "3 deg" of food.'),
    ] = "0 deg"
    confidence: Annotated[str, typer.Option("--confidence", help="Of the intervals: 0.9 or 90%.")] = "90%"

    @property
    def friction_ratio(self) -> float | None:
        """β as typed."""
        return None if self.beta is None else options.SHARE.read(self.beta, "--beta")

    @property
    def protocol(self) -> Protocol:
        """Protocol of the measurement."""
        return Protocol(
            _TIME.read(self.duration, "--duration"), slip_limit=_LENGTH.read(self.slip_limit, "--slip-limit")
        )

    def options(self, setup: SetupOptions, seed: int) -> EstimateOptions:
        """What was typed, as `plategait.estimate.result.estimate_parameters` takes it."""
        return {
            "noise": None if self.noise is None else options.read_share(self.noise, "--noise"),
            "friction_ratio": self.friction_ratio,
            "free": tuple(self.free or ()),
            "fixed": (*(self.fixed or ()), *setup.exact),
            "measured": setup.known,
            "thickness_sd": setup.thickness_sd,
            "confidence": options.read_share(self.confidence, "--confidence"),
            "ramp": None if self.ramp is None else _RAMP.read(self.ramp, "--ramp"),
            "model_error": _MODEL_ERROR.read(self.model_error, "--model-error"),
            "any_law": self.any_law,
            "friction_scatter": self.friction_scatter,
            "seed": seed,
        }

    def run(
        self, curves: list[Curve], base: Scenario, motions: list[PlateMotion], setup: SetupOptions, seed: int
    ) -> Estimate:
        """Estimate with the engine in the loop."""
        from plategait.estimate.result import estimate_parameters

        with report.progress_bar("estimating") as progress:
            return estimate_parameters(curves, base, motions=motions, progress=progress, **self.options(setup, seed))


@dataclass(frozen=True)
class PlanOptions:
    """What to measure next."""

    plan: Annotated[bool, typer.Option("--next", help="Say also what to measure next.")] = False
    candidate_angle: Annotated[
        list[str] | None,
        typer.Option(
            "--candidate-angle", help='A_p that the plate can make, for --next: "3 deg" or "1:6 deg"; repeatable.'
        ),
    ] = None
    candidate_stroke: Annotated[
        list[str] | None, typer.Option("--candidate-stroke", help='B_p likewise: "3 mm" or "1:5 mm"; repeatable.')
    ] = None
    candidate_height: Annotated[
        list[str] | None,
        typer.Option("--candidate-height", help='Height of the plate likewise: "0:20 mm"; repeatable.'),
    ] = None
    candidate_phase: Annotated[
        list[str] | None,
        typer.Option(
            "--candidate-phase", help='Phase of the stroke before the turning likewise: "0:90 deg"; repeatable.'
        ),
    ] = None
    candidate_frequency: Annotated[
        str | None,
        typer.Option("--candidate-frequency", help='Frequencies that the plate can make: "10:30 Hz".'),
    ] = None
    machine: Annotated[
        str | None, typer.Option("--machine", help="What drives the plate, for --next: a TOML file, or source-robot.")
    ] = None
    want_frequency: Annotated[
        str | None, typer.Option("--want-frequency", help='Precision wanted of ω_n, for --next: "0.5 pi rad/s".')
    ] = None
    want_angle: Annotated[
        str | None, typer.Option("--want-angle", help='Precision wanted of the friction angle, for --next: "1 deg".')
    ] = None

    @property
    def asked(self) -> bool:
        """Whether a plan is asked for."""
        return bool(self.plan or self.want_frequency or self.want_angle)

    @property
    def wanted(self) -> dict[str, float]:
        """Precision wanted by parameter, SI."""
        wanted = {}
        if self.want_frequency is not None:
            wanted["natural_frequency"] = ANGULAR_FREQUENCY.read(self.want_frequency, "--want-frequency")
        if self.want_angle is not None:
            wanted["friction_angle"] = ANGLE.read(self.want_angle, "--want-angle")
        return wanted

    def reach(self, conditions: Sequence[Condition], motion: PlateMotion) -> Reach:
        """What the plate can make, as far as it is told."""
        from plategait.estimate.candidates import reach_of
        from plategait.model.machine import machine_of

        frequency = None if self.candidate_frequency is None else read_span(
            self.candidate_frequency, FREQUENCY, "--candidate-frequency")  # fmt: skip
        return reach_of(
            conditions,
            motion,
            angle=[read_span(x, _CANDIDATE_ANGLE, "--candidate-angle") for x in self.candidate_angle or []],
            stroke=[read_span(x, _CANDIDATE_STROKE, "--candidate-stroke") for x in self.candidate_stroke or []],
            height=[read_span(x, _HEIGHT, "--candidate-height") for x in self.candidate_height or []],
            phase=[read_span(x, ANGLE, "--candidate-phase") for x in self.candidate_phase or []],
            frequency=frequency,
            machine=None if self.machine is None else machine_of(self.machine, "--machine"),
        )

    def run(self, estimate: Estimate, reach: Reach, wanted: dict[str, float], seed: int) -> Plan:
        """Plan the next measurement."""
        from plategait.estimate.planning import next_measurement

        with report.progress_bar("planning") as progress:
            return next_measurement(estimate.posterior, reach=reach, wanted=wanted, seed=seed, progress=progress)


@dataclass(frozen=True)
class OutputOptions:
    """What is written and printed."""

    out: Annotated[Path | None, typer.Option("--out", help="Write a scenario fragment for --with: .toml.")] = None
    plot: options.Plot = None
    as_json: options.Json = False


def read_measured(text: str, quantity: Quantity, option: str) -> tuple[float, float]:
    """Value and standard deviation, SI, of "5 mm" (0) or "5 ± 1 mm".

    Raises
    ------
    InputError
        When either is no number of what is measured, or the spread is below 0.
    """
    value, sign, spread = text.replace("+/-", "±").replace("+-", "±").partition("±")
    if not sign:
        return quantity.read(text, option), 0.0
    unit = spread.strip().lstrip("+-.0123456789eE").strip()
    value = value.strip()
    bare = value[-1:].isdigit() or value.endswith(".")
    mean = quantity.read(f"{value} {unit}".strip() if bare else value, option)
    return mean, replace(quantity, above=-math.inf, at_least=0.0).read(spread.strip(), option)


def read_span(text: str, quantity: Quantity, option: str) -> tuple[float, float]:
    """Ends, SI, of "1:6 deg"; twice the same of "3 deg".

    Raises
    ------
    InputError
        When an end is no number of what is measured, or the first is above the second.
    """
    first, colon, last = text.partition(":")
    if not colon:
        value = quantity.read(text, option)
        return value, value
    unit = last.strip().lstrip("+-.0123456789eE").strip()
    low = quantity.read(f"{first.strip()} {unit}" if first.strip()[-1:].isdigit() else first.strip(), option)
    high = quantity.read(last.strip(), option)
    if not low < high:
        raise InputError(option, text, "two ends, the lower first", f'"{quantity.example}"')
    return low, high
