"""plategait: a thin soft object on a vibrating plate, how it slides, walks, runs and spins.

>>> import plategait as pg
>>> scenario = pg.preset("cheese").scenario
>>> pg.simulate(scenario).gait  # doctest: +SKIP
'sliding'

Names are loaded when first used, so that the import is quick.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from plategait.campaign.opened import Campaign as Campaign
    from plategait.campaign.opened import open_sweep as open_sweep
    from plategait.campaign.plan import Sweep as Sweep
    from plategait.campaign.plan import read_sweep as read_sweep
    from plategait.campaign.run import sweep as sweep
    from plategait.curve.curve import Curve as Curve
    from plategait.curve.curve_file import read_curve as read_curve
    from plategait.curve.curve_file import write_curve as write_curve
    from plategait.curve.lorentz import LorentzFit as LorentzFit
    from plategait.curve.lorentz import fit_lorentzian as fit_lorentzian
    from plategait.curve.spin_curve import spin_curve as spin_curve
    from plategait.errors import InputError as InputError
    from plategait.estimate.planning import next_measurement as next_measurement
    from plategait.estimate.result import Estimate as Estimate
    from plategait.estimate.result import estimate_parameters as estimate_parameters
    from plategait.export.bag import write_bag as write_bag
    from plategait.export.mjcf.scene import mjcf as mjcf
    from plategait.export.mjcf.scene import write_mjcf as write_mjcf
    from plategait.export.trajectory import Trajectory as Trajectory
    from plategait.export.trajectory import trajectory as trajectory
    from plategait.export.trajectory_file import write_trajectory as write_trajectory
    from plategait.model.contact import Contact as Contact
    from plategait.model.contact import Friction as Friction
    from plategait.model.fragment import Fragment as Fragment
    from plategait.model.fragment import read_fragment as read_fragment
    from plategait.model.fragment import write_fragment as write_fragment
    from plategait.model.machine import MACHINES as MACHINES
    from plategait.model.machine import Machine as Machine
    from plategait.model.machine import machine_of as machine_of
    from plategait.model.material import Material as Material
    from plategait.model.materials import MATERIALS as MATERIALS
    from plategait.model.materials import named_material as named_material
    from plategait.model.motion import Held as Held
    from plategait.model.motion import PlateMotion as PlateMotion
    from plategait.model.motion import Samples as Samples
    from plategait.model.motion import Wave as Wave
    from plategait.model.needs import Needs as Needs
    from plategait.model.needs import needs as needs
    from plategait.model.outline import Disk as Disk
    from plategait.model.outline import Ellipse as Ellipse
    from plategait.model.outline import Mask as Mask
    from plategait.model.outline import Polygon as Polygon
    from plategait.model.outline import Rectangle as Rectangle
    from plategait.model.presets import PRESETS as PRESETS
    from plategait.model.presets import preset as preset
    from plategait.model.scenario import Plate as Plate
    from plategait.model.scenario import Scenario as Scenario
    from plategait.model.scenario import Start as Start
    from plategait.model.scenario_file import read_scenario as read_scenario
    from plategait.model.scenario_file import write_scenario as write_scenario
    from plategait.model.sheet import Sheet as Sheet
    from plategait.moves.atlas import Atlas as Atlas
    from plategait.moves.atlas import atlas as atlas
    from plategait.optimize.goal import Goal as Goal
    from plategait.optimize.optimize import optimize_motion as optimize_motion
    from plategait.optimize.optimum import Optimum as Optimum
    from plategait.simulation.dataset import dataset_of as dataset_of
    from plategait.simulation.dataset import write_dataset as write_dataset
    from plategait.simulation.registry import Observable as Observable
    from plategait.simulation.registry import add_observable as add_observable
    from plategait.simulation.result import Simulation as Simulation
    from plategait.simulation.run import simulate as simulate
    from plategait.simulation.run import simulate_all as simulate_all
    from plategait.simulation.session import Session as Session
    from plategait.version import __version__ as __version__

_HOMES = {
    "campaign.opened": ("Campaign", "open_sweep"),
    "campaign.plan": ("Sweep", "read_sweep"),
    "campaign.run": ("sweep",),
    "curve.curve": ("Curve",),
    "curve.curve_file": ("read_curve", "write_curve"),
    "curve.lorentz": ("LorentzFit", "fit_lorentzian"),
    "curve.spin_curve": ("spin_curve",),
    "errors": ("InputError",),
    "estimate.planning": ("next_measurement",),
    "estimate.result": ("Estimate", "estimate_parameters"),
    "export.bag": ("write_bag",),
    "export.mjcf.scene": ("mjcf", "write_mjcf"),
    "export.trajectory": ("Trajectory", "trajectory"),
    "export.trajectory_file": ("write_trajectory",),
    "model.contact": ("Contact", "Friction"),
    "model.fragment": ("Fragment", "read_fragment", "write_fragment"),
    "model.machine": ("MACHINES", "Machine", "machine_of"),
    "model.material": ("Material",),
    "model.materials": ("MATERIALS", "named_material"),
    "model.motion": ("Held", "PlateMotion", "Samples", "Wave"),
    "model.needs": ("Needs", "needs"),
    "model.outline": ("Disk", "Ellipse", "Mask", "Polygon", "Rectangle"),
    "model.presets": ("PRESETS", "preset"),
    "model.scenario": ("Plate", "Scenario", "Start"),
    "model.scenario_file": ("read_scenario", "write_scenario"),
    "model.sheet": ("Sheet",),
    "moves.atlas": ("Atlas", "atlas"),
    "optimize.goal": ("Goal",),
    "optimize.optimize": ("optimize_motion",),
    "optimize.optimum": ("Optimum",),
    "simulation.dataset": ("dataset_of", "write_dataset"),
    "simulation.registry": ("Observable", "add_observable"),
    "simulation.result": ("Simulation",),
    "simulation.run": ("simulate", "simulate_all"),
    "simulation.session": ("Session",),
    "version": ("__version__",),
}
_HOME_OF = {name: module for module, names in _HOMES.items() for name in names}

__all__ = sorted(_HOME_OF)  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name not in _HOME_OF:
        import difflib

        close = difflib.get_close_matches(name, __all__, 1)
        nearest = f"; try plategait.{close[0]}" if close else ""
        raise AttributeError(f"module 'plategait' has no attribute {name!r}{nearest}")
    value = getattr(importlib.import_module(f"plategait.{_HOME_OF[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return list(__all__)
