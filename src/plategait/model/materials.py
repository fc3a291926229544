"""Named materials: typical numbers with their spread and where they come from.

No sample is a table: a batch of silicone differs by a tenth, a slice of cheese by a factor. `low` and `high` are what
to try beside the typical modulus; a weighed sheet and a bent strip (`plategait identify bending`) beat all of it.
"""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal

from plategait.errors import InputError
from plategait.model.material import DAMPING_RATIO, Material
from plategait.units import DAMPING

Checked = Literal["at the source", "second hand", "unconfirmed"]


@dataclass(frozen=True)
class NamedMaterial:
    """A material by its name.

    Attributes
    ----------
    material : Material
        Typical numbers: E, ν, ρ, and η where it is known.
    low, high : float
        Spread of Young's modulus, Pa: of the source where it gives one, of the kind of material elsewhere.
    source : str
        Where they come from; "typical" where they are of the kind and not of a sample.
    checked : {"at the source", "second hand", "unconfirmed"}
        Whether the modulus was read where it is said to come from, is so quoted by others, or is what is usually said
        and was found in no source that could be read.
    """

    material: Material
    low: float
    high: float
    source: str
    checked: Checked

    @property
    def name(self) -> str:
        """What it is called."""
        return self.material.name


_RUBBER = 0.5  # of whatever keeps its volume: rubbers and wet foods within 0.01
_SMOOTH_ON = (
    "Smooth-On technical bulletin: 8, 10, 12 psi (Ecoflex 00-10, 00-30, 00-50), 22, 49, 86 psi (Dragon Skin 10, 20, "
    "30) at 100 %, taken as E, and ρ; the upper end, for small strain, is typical"
)
_USUAL = "typical of the kind"
_CHEESES = "Journal of Nutrition & Food Sciences 2 (2012) 136, table 4, in compression; ρ and ν typical"
_READ: Checked = "at the source"
_QUOTED: Checked = "second hand"
_UNCONFIRMED: Checked = "unconfirmed"

# Name, E in MPa with its spread, ν, ρ in kg/m³, η, whether it was checked, source.
_ROWS: tuple[tuple[str, float, float, float, float, float, float | None, Checked, str], ...] = (
    ("silicone-ecoflex-00-10", 0.055, 0.05, 0.08, _RUBBER, 1040, None, _QUOTED, _SMOOTH_ON),
    ("silicone-ecoflex-00-30", 0.069, 0.06, 0.13, _RUBBER, 1070, None, _QUOTED, _SMOOTH_ON),
    ("silicone-ecoflex-00-50", 0.083, 0.08, 0.14, _RUBBER, 1070, None, _QUOTED, _SMOOTH_ON),
    ("silicone-dragon-skin-10", 0.152, 0.14, 0.27, _RUBBER, 1070, None, _QUOTED, _SMOOTH_ON),
    ("silicone-dragon-skin-20", 0.338, 0.3, 0.5, _RUBBER, 1080, None, _QUOTED, _SMOOTH_ON),
    ("silicone-dragon-skin-30", 0.593, 0.5, 0.8, _RUBBER, 1080, None, _QUOTED, _SMOOTH_ON),
    ("silicone-sylgard-184", 1.8, 1.32, 2.97, _RUBBER, 1030, None, _READ,
     "Johnston et al., J. Micromech. Microeng. 24 (2014) 035017: 1.32 to 2.97 MPa, cured at 25 to 200 °C; ρ typical"),
    ("natural-rubber", 1.5, 1.5, 2.5, _RUBBER, 950, None, _READ,
     "MatWeb, natural rubber, vulcanized: shear modulus 0.5 MPa and 1.5 MPa at 100 %, ρ; the upper end is typical"),
    ("foam-soft", 2.0, 1.0, 3.0, 0.3, 55, None, _UNCONFIRMED, f"{_USUAL}: flexible polymer foam of low density"),
    ("cheese-slice", 0.12, 0.11, 0.32, 0.0, 1080, 0.049, _READ,
     "Ramirez-Alpizar (2013), Table 4.1: E of k_b at ν = 0, as the source has none; k_c gives the upper end; "
     "η of c_b at 10π rad/s"),
    ("dumpling-skin", 1.3, 0.7, 2.7, 0.0, 1370, None, _READ,
     "Ramirez-Alpizar (2013), section 5.6.2: mass and ω_n = 11.9π; its thickness, taken as 1 mm (0.8 to 1.25), is not "
     "printed"),
    ("pancake", 0.74, 0.3, 2.0, 0.0, 1800, None, _UNCONFIRMED,
     "Ramirez-Alpizar (2013), section 2.4: mass, radius and 1 mm; no stiffness is printed, E is of the preset's "
     "inferred 7π rad/s"),
    ("cheddar-mild", 0.113, 0.1, 0.16, 0.49, 1090, None, _READ, _CHEESES),
    ("cheddar-medium", 0.23, 0.16, 0.27, 0.49, 1090, None, _READ, _CHEESES),
    ("mozzarella", 0.224, 0.077, 0.26, 0.49, 1080, None, _READ, _CHEESES),
    ("gel-polyacrylamide", 0.035, 0.03, 0.04, 0.48, 1020, None, _UNCONFIRMED,
     f"{_USUAL}: 10 % acrylamide, 0.3 % bis; ν by Boudou et al., Biorheology 43 (2006) 721: 0.480 ± 0.012; ρ typical"),
    ("felt-wool", 1.0, 0.1, 10.0, 0.1, 250, None, _UNCONFIRMED,
     "typical of pressed felt, which differs by ten either way and along its own directions: measure a strip"),
    ("leather", 200.0, 100.0, 500.0, 0.3, 900, None, _UNCONFIRMED, _USUAL),
    ("paper", 4000.0, 3000.0, 8900.0, 0.3, 750, None, _UNCONFIRMED,
     f"{_USUAL}: paper and cardboard; about twice as stiff along the machine's direction as across it"),
    ("film-polyethylene", 250.0, 172.0, 282.0, 0.42, 920, None, _READ,
     "Callister, Materials Science and Engineering, table B.2: low density, 172 to 282 MPa; ρ and ν typical"),
    ("film-polyester", 4000.0, 2760.0, 5000.0, 0.38, 1390, None, _READ,
     "DuPont Teijin Films: Mylar LBT 3.8 GPa, Mylar (H-37232-3) 4.8 and 5.0 GPa along and across, its ν and ρ; undrawn "
     "PET from 2.76 GPa (Callister, table B.2)"),
    ("film-polyimide", 2500.0, 2300.0, 3000.0, 0.34, 1420, None, _READ,
     "DuPont, Kapton HN technical data sheet: 2.5 GPa at 23 °C, ν and ρ; the spread is typical"),
    ("foil-aluminium", 70e3, 68e3, 72e3, 0.33, 2700, None, _READ,
     "MIT 6.777J material property database, aluminium: 70 GPa, ν and ρ; the spread is that of its alloys"),
)  # fmt: skip


def _named(name: str, modulus: float, low: float, high: float, poisson: float, density: float,
           loss: float | None, checked: Checked, source: str) -> NamedMaterial:  # fmt: skip
    material = Material(
        name=name, young_modulus=1e6 * modulus, poisson_ratio=poisson, density=density, loss_factor=loss
    )
    return NamedMaterial(material, 1e6 * low, 1e6 * high, source, checked)


MATERIALS: Mapping[str, NamedMaterial] = MappingProxyType({row[0]: _named(*row) for row in _ROWS})
"""Materials by name."""


def named_material(name: object, field: str = "material") -> NamedMaterial:
    """Look a material up by its name.

    Parameters
    ----------
    name : str
        One of `MATERIALS`.
    field : str, optional
        What errors call it.

    Raises
    ------
    InputError
        When there is none of that name, with the nearest.
    """
    if isinstance(name, str) and name in MATERIALS:
        return MATERIALS[name]
    text = str(name).lower().replace(" ", "-")
    close = difflib.get_close_matches(text, MATERIALS, 1, cutoff=0.5) or [n for n in MATERIALS if text in n]
    raise InputError(field, name, "a name of `plategait materials`", (close or ["silicone-ecoflex-00-30"])[0])


def material_told(told: Mapping[str, Any]) -> Material:
    """Material of what a sheet was told by `KEYS`: a named one's numbers where nothing else was said.

    Raises
    ------
    InputError
        When a number is not as it must be, none was given for Young's modulus, or two stand for the damping.
    """
    own = {key: value for key, value in told.items() if key in Material.model_fields}
    if DAMPING_RATIO in told:
        if "loss_factor" in told:
            raise InputError(DAMPING_RATIO, told[DAMPING_RATIO], "left out where loss_factor is given",
                             "loss_factor, which is twice the damping ratio")  # fmt: skip
        own["loss_factor"] = 2 * DAMPING.read(told[DAMPING_RATIO], DAMPING_RATIO)
    named = told.get("material")
    if isinstance(named, Material):
        return named.replace(**own)
    if named is not None:
        return named_material(named).material.replace(**own)
    return Material(**own)
