"""`plategait materials`: materials that go by a name."""

from __future__ import annotations

from plategait.cli import options, report
from plategait.model.materials import MATERIALS, NamedMaterial
from plategait.units import show


def materials(as_json: options.Json = False) -> None:
    """Materials that --material and scenario files take by their names, typical numbers, with spread and source."""
    if as_json:
        return report.print_json({"materials": [_facts(named) for named in MATERIALS.values()]})
    report.print_table(
        "Materials: typical, measure yours",
        ["name", "E", "spread of E", "ν", "ρ kg/m^3", "loss factor", "checked"],
        [_row(named) for named in MATERIALS.values()],
    )
    for source in dict.fromkeys(named.source for named in MATERIALS.values()):
        names = ", ".join(named.name for named in MATERIALS.values() if named.source == source)
        print(f"{names}: {source}")
    print("unconfirmed: no source of the modulus could be read; second hand: as others quote the source")


def _row(named: NamedMaterial) -> list[str]:
    material, unit = named.material, "GPa" if named.material.young_modulus >= 1e9 else "MPa"
    spread = f"{show(named.low, 'Pa', unit).split()[0]} to {show(named.high, 'Pa', unit)}"
    loss = "–" if material.loss_factor is None else f"{material.loss_factor:g}"
    return [
        named.name, show(material.young_modulus, "Pa", unit), spread, f"{material.poisson_ratio:g}",
        f"{material.density:g}", loss, named.checked,
    ]  # fmt: skip


def _facts(named: NamedMaterial) -> dict[str, object]:
    material = named.material
    return {
        "name": named.name, "young_modulus_pa": material.young_modulus, "low_pa": named.low, "high_pa": named.high,
        "poisson_ratio": material.poisson_ratio, "density_kg_m3": material.density,
        "loss_factor": material.loss_factor, "source": named.source, "checked": named.checked,
    }  # fmt: skip
