"""How often and how soon sheets are brought to random poses, controller by controller.

``python -m benchmarks.steering [--goals 200] [--object NAME …] [--method NAME …] [--incidents]``

Goals within 40 mm of the middle of a 200 mm plate, any angle, held for 2 s within 3 mm and 5 deg; starts likewise. The
camera is the usual one: 60 Hz, 0.5 mm and 1 deg of noise, 30 ms late, 5 % of the frames missing. "Unknown" objects are
cheese to the controller, and truly of 0.5 to 2 times its stiffness, 0.67 to 1.5 times its friction and mass, on plates
of other heights, each drawn for itself.
"""

from __future__ import annotations

import argparse
import math
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from plategait.control.camera import Seen
from plategait.control.goal import Goal, random_goals
from plategait.control.menu import Menu, menu_of
from plategait.control.options import Variation
from plategait.control.plant import Plant
from plategait.control.steer import METHODS, Arrival, Method, steer
from plategait.model.scenario import Scenario

OBJECTS = {"cheese": "cheese", "dumpling skin": "dumpling-skin", "unknown": "cheese"}
UNKNOWN = Variation(stiffness=(0.5, 2.0), friction=(0.67, 1.5), mass=(0.67, 1.5), height=(0.0, 0.008))
TOGETHER = 50  # sheets simulated side by side
KICKS, PUSH, TURN = (1.0, 2.5), 0.25, 4.0  # s, m/s, rad/s
WET, DARK = 1.0, (1.0, 1.5)  # s


def laid(menu: Menu, starts: Sequence[Goal], unknown: bool, seed: int) -> list[Scenario]:
    """The sheets, each where it begins."""
    shares = np.random.default_rng(seed).random((len(starts), 4))
    sheets = []
    for start, own in zip(starts, shares, strict=True):
        sheet = menu.scenario.replace(**{"start.x": start.x, "start.y": start.y, "start.angle": start.angle or 0.0})
        sheets.append(UNKNOWN.drawn(sheet, own) if unknown else sheet)
    return sheets


def kicked(plant: Plant, now: float) -> None:
    """Kick every sheet, each some way."""
    for kick in KICKS:
        if abs(now - kick) < plant.tick / 2:
            for lane, (way, turn) in enumerate(np.random.default_rng(int(10 * kick)).random((len(plant), 2))):
                angle = 2 * math.pi * way
                plant.push(lane, (PUSH * math.cos(angle), PUSH * math.sin(angle), TURN * (2 * turn - 1)))


def wetted(plant: Plant, now: float) -> None:
    """Halve the friction under every sheet."""
    if abs(now - WET) < plant.tick / 2:
        for lane, own in enumerate(plant.session.scenarios):
            half = {f"friction.{name}": getattr(own.friction, name) / 2 for name in ("static", "kinetic")}
            plant.become(lane, own.replace(**half))


def darkened(plant: Plant) -> Seen:
    """What the cameras deliver, but nothing for half a second."""
    dark = (plant.time >= DARK[0]) & (plant.time < DARK[1])
    return replace(plant.seen, new=plant.seen.new & ~dark)


INCIDENTS: dict[str, dict[str, Any]] = {
    "kicked twice, 0.25 m/s and 4 rad/s": {"each_tick": kicked},
    "camera dark for 0.5 s": {"look": darkened},
    "friction halved after 1 s": {"each_tick": wetted},
}


def arrivals(
    menu: Menu, count: int, seed: int, method: Method, unknown: bool = False, learns: bool = True, **incident: Any
) -> list[Arrival]:
    """How it went with so many goals."""
    poses = random_goals(2 * count, menu.scenario, seed)
    sheets = laid(menu, poses[:count], unknown, seed)
    told: list[Arrival] = []
    for i in range(0, count, TOGETHER):
        goals = [[goal] for goal in poses[count + i : count + min(i + TOGETHER, count)]]
        plant = Plant(sheets[i : i + TOGETHER], seeds=range(seed + i, seed + i + len(goals)))
        told += [way.arrivals[0] for way in steer(plant, goals, menu, method=method, learns=learns, **incident)]
    return told


def row(name: str, method: str, told: Sequence[Arrival], seconds: float) -> str:
    """A line of the table."""
    times = np.array([arrival.time for arrival in told if arrival.reached] or [math.nan])
    lost = Counter(arrival.status for arrival in told if arrival.status not in ("", "not within the time"))
    reached = sum(arrival.reached for arrival in told) / len(told)
    spread = 1.65 * math.sqrt(reached * (1 - reached) / len(told))
    return (f"| {name} | {method} | {len(told)} | {100 * reached:.1f} ± {100 * spread:.1f} % "
            f"| {sum(lost.values())}{' (' + ', '.join(lost) + ')' if lost else ''} "
            f"| {np.median(times):.1f} | {np.quantile(times, 0.9):.1f} "
            f"| {np.mean([arrival.pulses for arrival in told]):.1f} | {seconds:.0f} |")  # fmt: skip


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--goals", type=int, default=200)
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--object", action="append", choices=OBJECTS)
    parser.add_argument("--method", action="append", choices=(*METHODS, "not learning"))
    parser.add_argument("--incidents", action="store_true", help="what else may happen, to cheese")
    arguments = parser.parse_args()
    menus: dict[str, Menu] = {}
    print(
        "| object | controller | goals | reached (90 %) | lost | median (s) | 90th percentile (s) | pulses | took (s) |"
    )
    print("|---|---|---|---|---|---|---|---|---|", flush=True)

    def show(name: str, title: str, made: Callable[[], list[Arrival]]) -> None:
        began = time.monotonic()
        told = made()
        print(row(name, title, told, time.monotonic() - began), flush=True)

    for name in arguments.object or OBJECTS:
        if OBJECTS[name] not in menus:
            menus[OBJECTS[name]] = menu_of(OBJECTS[name])
        menu = menus[OBJECTS[name]]
        for title in arguments.method or (*METHODS, "not learning"):
            method: Method = "blend" if title == "not learning" else title
            show(name, title, lambda m=menu, k=method, n=name, t=title: arrivals(
                m, arguments.goals, arguments.seed, k, n == "unknown", t != "not learning"))  # fmt: skip
    for title, incident in INCIDENTS.items() if arguments.incidents else ():
        menu = menus.get("cheese") or menu_of("cheese")
        show("cheese", title, lambda m=menu, i=incident: arrivals(m, arguments.goals, arguments.seed, "blend", **i))


if __name__ == "__main__":
    main()
