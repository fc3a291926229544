"""What help says beside each option's own line: its group, what it is written in, and examples of each command."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typer.core import TyperCommand, TyperOption

# Groups, in the order in which they are shown; an option that is in none is the command's own.
_GROUPS = {
    "Object": (
        "sheet", "natural_frequency", "mu_s", "mu_k", "friction_law", "measured", "mass", "thickness", "radius", "beta",
        "friction_scatter",
        "young", "density", "poisson", "loss_factor", "damping_ratio", "material", "outline", "pitch", "plate_size",
        "scenario",
    ),
    "Motion": ("frequency", "angle", "stroke", "height", "ramp", "joints", "machine", "cycle", "rate", "topic"),
    "Runs": (
        "duration", "transient", "dt", "draws", "repeats", "seed", "engine", "slip_limit", "evaluations", "searches",
        "seeds", "generations", "dask", "store", "refine", "repair", "status",
    ),
    "Output": ("out", "fragments", "plot", "film", "filmstrip", "preview", "trajectory", "as_json", "no_open"),
}  # fmt: skip
_GROUP_OF = {name: group for group, names in _GROUPS.items() for name in names}

# What the value of an option is written in, by the option's name.
_WRITTEN_IN = {
    "frequency": "FREQUENCY", "natural_frequency": "FREQUENCY", "angle": "ANGLE", "stroke": "LENGTH",
    "height": "LENGTH", "mu_s": "NUMBER", "mu_k": "NUMBER", "beta": "NUMBER", "duration": "TIME", "dt": "TIME",
    "friction_scatter": "ANGLE",
    "seconds": "SECONDS", "ramp": "TIME", "hold": "TIME", "timeout": "TIME", "camera_delay": "TIME",
    "rate": "FREQUENCY", "camera_rate": "FREQUENCY", "mass": "MASS", "thickness": "LENGTH", "radius": "LENGTH",
    "reach": "LENGTH", "slip_limit": "LENGTH", "width": "LENGTH", "length": "LENGTH", "length_sd": "LENGTH",
    "link_length": "LENGTH", "plate_size": "SIZE", "scale": "SCALE", "young": "PRESSURE", "density": "DENSITY",
    "poisson": "NUMBER", "loss_factor": "NUMBER", "damping_ratio": "NUMBER", "mass_per_area": "MASS/AREA",
    "spin": "RATE", "along": "SPEED", "across": "SPEED", "friction_law": "LAW", "sheet": "OBJECT",
    "scenario": "SCENARIO", "machine": "MACHINE", "measured": "FILE", "out": "FILE", "plot": "FILE", "film": "FILE",
    "filmstrip": "FILE", "preview": "FILE", "trajectory": "FILE", "store": "FOLDER", "fragments": "FOLDER",
    "menu": "FILE", "goals": "FILE", "beside": "FILE", "calibration": "FILE", "frequencies": "FILE", "to": "POSE",
    "start": "POSE", "path": "PATH", "dark": "FROM,TO", "seed": "N", "repeats": "N", "draws": "N", "count": "N",
    "refine": "N", "evaluations": "N", "searches": "N", "generations": "N", "seeds": "N", "confidence": "SHARE",
    "chance_of_failure": "SHARE", "joints": "NAMES", "topic": "NAME", "plate": "KIND", "object_by": "KIND",
    "fps": "FPS", "size": "WIDTHxHEIGHT", "elevation": "DEGREES", "exposure": "SHARE", "crf": "N", "hidden": "SHARE",
    "cell": "SIZES", "least": "WHAT", "method": "METHOD", "preset_name": "PRESET", "noise": "SHARE",
    "model_error": "SHARE", "missed": "SHARE", "pitch": "LENGTH", "outline": "OUTLINE", "material": "NAME",
    "candidate_frequency": "RANGE", "candidate_angle": "ANGLE", "candidate_stroke": "LENGTH",
    "candidate_height": "LENGTH", "candidate_phase": "ANGLE", "want_frequency": "FREQUENCY", "want_angle": "ANGLE",
    "cell_across": "SPEED", "cell_along": "SPEED", "cell_turn": "RATE", "fiducial": "LENGTH", "dask": "ADDRESS",
    "free": "NAME", "fixed": "NAME", "camera_noise": "LENGTH,ANGLE", "within": "LENGTH,ANGLE", "show": "OBSERVABLE",
}  # fmt: skip

EXAMPLES = {
    "simulate": (
        'plategait simulate cheese --frequency "20 Hz" --plot run.png', "plategait simulate mine.toml --film run.mp4",
    ),
    "curve": (
        "plategait curve cheese --plot curve.png", "plategait curve mine.toml --frequency 12:30:1 --out curve.csv",
    ),
    "fit": ("plategait fit curve.csv --plot fit.png",),
    "export": ("plategait export cheese --out motion.csv", "plategait export cheese --out scene.xml"),
    "modes": ("plategait modes cheese --plot modes.png",),
    "materials": ("plategait materials",),
    "lab": ("plategait lab cheese", "plategait lab run.nc --out run.html"),
    "needs": ("plategait needs cheese --machine source-robot",),
    "optimize": ("plategait optimize cheese --machine source-robot", 'plategait optimize cheese --along "30 mm/s"'),
    "moves": ("plategait moves cheese --machine source-robot --plot moves.png",),
    "steer": ('plategait steer cheese --to "20 mm, 10 mm, 90 deg" --film way.mp4',),
    "scenario": ("plategait scenario --print cheese > mine.toml", "plategait scenario mine.toml"),
    "estimate": (
        'plategait estimate curve.csv --mass "13.6 g" --radius "40 mm" --out object.toml',
        "plategait estimate curve.csv --scenario mine.toml --next --plot estimate.png",
    ),
    "estimate-all": ("plategait estimate-all curves/ --out objects.csv",),
    "track": ('plategait track clip.mp4 --frequency "20 Hz" --out poses.csv',),
    "track-folder": ("plategait track-folder clips/ --out curve.csv",),
    "track-strip": ("plategait track-strip sag.mp4 --fps 240 --out angles.csv",),
    "target": ("plategait target target.pdf",),
    "shoot": ("plategait shoot cheese clip.mp4",),
    "sweep": ("plategait sweep plan.toml", "plategait sweep plan.toml --status"),
    "plot": ("plategait plot plan.zarr --out map.png",),
    "thesis": ("plategait thesis",),
}  # fmt: skip


def complete(command: TyperCommand) -> None:
    """Give a command's options their groups and what they are written in, and the command its examples."""
    from typer.core import TyperOption

    for parameter in command.params:
        if not isinstance(parameter, TyperOption):
            continue
        name = parameter.name or ""
        if name in _GROUP_OF and not parameter.rich_help_panel:
            parameter.rich_help_panel = _GROUP_OF[name]
        if parameter.metavar is None:
            parameter.metavar = "" if getattr(parameter, "is_flag", False) else _written_in(parameter)
    if examples := EXAMPLES.get(command.name or ""):
        command.epilog = "\n\n".join(("Examples:", *examples))


def _written_in(parameter: TyperOption) -> str | None:
    # A choice of words says more than any name for it.
    is_choice = parameter.type_descriptor.is_choice
    return None if is_choice else _WRITTEN_IN.get(parameter.name or "")
