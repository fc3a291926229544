"""Two disks of cheese on one plate, brought to a place each by the same motions; then a picture of what is reachable.

python examples/two_sheets.py                    # one pair
python examples/two_sheets.py --pairs 20         # random pairs besides, and how many came to their goals
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

import plategait as pg
from plategait.control.goal import Goal
from plategait.control.menu import Menu
from plategait.control.menu_file import kept_menu
from plategait.control.pair import APART, breadth, steer_pairs
from plategait.control.pair_figures import plot_pair
from plategait.control.pair_reach import PairReach, pair_reach
from plategait.control.plant import Plant
from plategait.control.pulse import Pulses
from plategait.control.steer import Steering
from plategait.plots.style import save

SHEET = {"sheet.outline.radius": "25 mm", "sheet.mass": "5.3 g"}
START = np.array([[-0.03, -0.03, 0.0], [0.03, 0.03, 0.0]])
GOAL = np.array([[0.02, 0.0, 0.0], [-0.03, 0.042, 0.0]])
# Of pairs that are drawn, and time of the slowest of the ways at goals that count as free, s.
DRAWN, QUICK = 400, 6.0


def random_pairs(count: int, apart: float, seed: int, reach: float = 0.04) -> np.ndarray:
    """(count, 2, 3) poses within `reach` of the middle each way, the second sheet the farther across the bar."""
    generator, pairs = np.random.default_rng(seed), []
    while len(pairs) < count:
        pair = generator.uniform(-1, 1, (2, 3)) * [reach, reach, np.pi]
        if np.hypot(*(pair[0] - pair[1])[:2]) > apart:
            pairs.append(pair[np.argsort(pair[:, 1])])
    return np.array(pairs).reshape(count, 2, 3)


def goals_of(poses: np.ndarray, angles: bool) -> list[tuple[Goal, Goal]]:
    """Goals at poses (n, 2, 3): the angles too, or any."""
    told = [[Goal(x, y, angle if angles else None) for x, y, angle in pair] for pair in poses.tolist()]
    return [(one, other) for one, other in told]


def free(reach: PairReach, goals: np.ndarray) -> bool:
    """Whether every way goes, and none slowly, from where goals (2, 3) lie across the bar."""
    step = reach.places[1] - reach.places[0]
    one, other = np.rint((goals[:, 1] - reach.places[0]) / step).astype(int).tolist()
    return bool(reach.times[one, other].max() < QUICK)


def steered(menu: Menu, starts: np.ndarray, goals: list[tuple[Goal, Goal]]) -> list[tuple[Steering, Steering]]:
    """Ways of pairs from poses (n, 2, 3)."""
    sheets = [menu.scenario.replace(**{"start.x": x, "start.y": y, "start.angle": angle})
              for x, y, angle in starts.reshape(-1, 3).tolist()]  # fmt: skip
    return steer_pairs(Plant(sheets), goals, menu)


def main() -> None:
    """Steer, tell and draw."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--pairs", type=int, default=0)
    parser.add_argument("--angles", action="store_true", help="let random pairs come to angles too")
    parser.add_argument("--menu", default="out/two_sheets.json")
    parser.add_argument("--out", default="out/two_sheets.png")
    told = parser.parse_args()
    Path(told.menu).parent.mkdir(parents=True, exist_ok=True)
    menu = kept_menu(told.menu, pg.preset("cheese").scenario.replace(**SHEET))
    (way,) = steered(menu, START[None], goals_of(GOAL[None], angles=False))
    apart = breadth(menu.scenario) + APART + 2e-3
    reach = pair_reach(Pulses(menu.response), menu.reach)
    starts, ends = random_pairs(DRAWN, apart, 1), random_pairs(DRAWN, apart, 2)
    all_ways = np.array([free(reach, goals) for goals in ends])
    which = np.concatenate([np.flatnonzero(all_ways)[: told.pairs // 2],
                            np.flatnonzero(~all_ways)[: told.pairs - told.pairs // 2]])  # fmt: skip
    tried = steered(menu, starts[which], goals_of(ends[which], told.angles)) if told.pairs else []
    for one, other in [way, *tried]:
        mine, its = one.arrivals[0], other.arrivals[0]
        nearest = 1e3 * np.hypot(*(one.poses - other.poses)[:, :2].T).min()
        print(f"goals {1e3 * abs(mine.goal.y - its.goal.y):3.0f} mm apart across the bar: "
              f"{f'{mine.time:5.1f} s' if mine.reached else mine.status}, {mine.pulses} pulses, "
              f"{1e3 * mine.error:.1f} and {1e3 * its.error:.1f} mm off, {nearest:.0f} mm apart at least")  # fmt: skip
    for name, kind in (("where every way goes", all_ways[which]), ("elsewhere", ~all_ways[which])):
        arrivals = [one.arrivals[0] for (one, _), counts in zip(tried, kind, strict=True) if counts]
        times = [arrival.time for arrival in arrivals if arrival.reached]
        if arrivals:
            print(f"{name}: {len(times)} of {len(arrivals)}, median {np.median(times) if times else np.nan:.1f} s")
    save(plot_pair(reach, way, menu.scenario, tried), told.out)
    print(told.out)


if __name__ == "__main__":
    main()
