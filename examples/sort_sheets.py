"""Sheets of unknown stiffness arrive on a plate, one after the other; each is sent off by the side of its class.

    python examples/sort_sheets.py [--sheets 60] [--sure 0.9] [--menu cheese.json]

Each sheet is spun under a few motions until the rates that a camera reads tell its class of stiffness (three classes,
each 1.4 times as stiff as the one before: Young's modulus at the same thickness), turned to a mark beside the middle of
the plate, and sent off: the softest by +x, then -x, then +y, and what cannot be told by -y. Friction, mass, damping and
where and how a sheet is laid down differ from sheet to sheet. All sheets have a plate of their own here, so that they
are simulated side by side; the times are those of one plate.
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import numpy as np

from plategait.control.feeder import SIDES, from_now, send_off, spin
from plategait.control.goal import Goal
from plategait.control.menu import Menu
from plategait.control.menu_file import kept_menu
from plategait.control.plant import Plant
from plategait.control.room import on_a_plate
from plategait.control.sorter import STEPS, SURE, Variation, learn_sorter
from plategait.control.steer import steer
from plategait.model.scenario import Scenario

# Young's moduli of a class differ by this factor to either side.
WITHIN_A_CLASS = 1.03
# Where a sheet is turned to the mark before it leaves by each side, m: along the bar none moves on the bar.
MARKS = (Goal(0.02, 0.02, 0.0), Goal(-0.02, 0.02, 0.0), Goal(0.0, 0.035, 0.0), Goal(0.0, -0.035, 0.0))
MARK_WITHIN = (8e-3, math.radians(15))
CANNOT_TELL = len(SIDES) - 1
# Time in which a sheet is laid down and comes to rest, s.
ARRIVING = 0.5


def arriving(nominal: Scenario, kind: int, generator: np.random.Generator) -> Scenario:
    """A sheet of a class, as it is laid down."""
    usual = Variation()

    def drawn(factor: float) -> float:
        return float(factor ** generator.uniform(-1, 1))

    sheet, friction = nominal.sheet, nominal.friction
    stiffness, static = STEPS ** (kind - 1) * drawn(WITHIN_A_CLASS), friction.static * drawn(usual.friction)
    ratio = min(1.0, friction.kinetic / friction.static * drawn(usual.friction_ratio))
    x, y = generator.normal(0, 4e-3, 2).tolist()
    return nominal.replace(**{
        "sheet.mass": sheet.mass * drawn(usual.mass),
        "sheet.bending_stiffness": sheet.bending_stiffness * stiffness,
        "sheet.torsion_stiffness": sheet.torsion_stiffness * stiffness,
        "sheet.bending_damping": sheet.bending_damping * drawn(usual.damping),
        "friction.static": static, "friction.kinetic": static * ratio,
        "start.x": x, "start.y": y, "start.angle": float(generator.uniform(-math.pi, math.pi)),
    })  # fmt: skip


def turned(plant: Plant, sides: list[int], menu: Menu, timeout: float) -> tuple[list[bool], np.ndarray]:
    """Turn each sheet to its mark; whether it came there, and the times that it took, s."""
    ways = steer(plant, [[MARKS[side]] for side in sides], menu, hold=0.1, within=MARK_WITHIN, timeout=timeout,
                 look=from_now(plant))  # fmt: skip
    arrivals = [way.arrivals[0] for way in ways]
    return [a.reached for a in arrivals], np.array([a.time + 0.1 if a.reached else timeout for a in arrivals])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sheets", type=int, default=60)
    parser.add_argument("--sure", type=float, default=SURE, help="probability from which a class is told")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--menu", type=Path, help="file in which the motions that were found are kept")
    arguments = parser.parse_args()
    sorter, menu = learn_sorter("cheese"), kept_menu(arguments.menu, on_a_plate("cheese"))
    generator = np.random.default_rng(arguments.seed)
    kinds = generator.permutation(np.arange(arguments.sheets) % 3).tolist()
    sheets = [arriving(sorter.base, kind, generator) for kind in kinds]
    plant = Plant(sheets, seeds=range(arguments.sheets))

    verdicts, spun = spin(plant, sorter, arguments.sure)
    told = [verdict.kind(arguments.sure) for verdict in verdicts]
    sides = [CANNOT_TELL if kind is None else kind for kind in told]
    marked, turning = turned(plant, sides, menu, 15.0)
    left, sending = send_off(plant, sides, menu)

    table = np.zeros((3, 5), dtype=int)
    for kind, side in zip(kinds, left, strict=True):
        table[kind, 4 if side is None else side] += 1
    print(f"{'':12}{'to soft':>9}{'middle':>9}{'stiff':>9}{'cannot tell':>13}{'stayed':>9}")
    for name, row in zip(("soft", "middle", "stiff"), table, strict=True):
        print(f"{name:12}{row[0]:9}{row[1]:9}{row[2]:9}{row[3]:13}{row[4]:9}")
    judged = [(kind, a) for kind, a in zip(kinds, told, strict=True) if a is not None]
    wrong, declined = sum(kind != a for kind, a in judged), len(kinds) - len(judged)
    astray = sum(side is not None and side != wanted for side, wanted in zip(left, sides, strict=True))
    total = ARRIVING + spun + turning + sending
    print(f"judged: {wrong} wrong, {declined} declined of {len(kinds)}; turned to the mark: {sum(marked)}; "
          f"left by another side than they were sent to: {astray}")  # fmt: skip
    print(f"a sheet takes {total.mean():.1f} s: spun {spun.mean():.1f} s, turned {turning.mean():.1f} s, sent off "
          f"{sending.mean():.1f} s; {60 / total.mean():.1f} sheets a minute")  # fmt: skip
    cannot = np.array([a is None for a in told])
    if cannot.any() and not cannot.all():
        more = total[cannot].mean() - total[~cannot].mean()
        print(f"a sheet that cannot be told takes {more:+.1f} s, as it is spun under all motions")
    print("\nas sure as   wrong   declined")
    for sure in (0.5, 0.7, 0.8, 0.9, 0.95):
        if sure <= arguments.sure:
            answers = [(kind, verdict.kind(sure)) for kind, verdict in zip(kinds, verdicts, strict=True)]
            wrong = sum(a is not None and a != kind for kind, a in answers)
            print(f"{sure:10.2f}{wrong:8}{sum(a is None for _, a in answers):11}")


if __name__ == "__main__":
    main()
