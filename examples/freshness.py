"""Two batches of a food on the shelf: which of them has aged by 20 % of its stiffness, told from films of a few pieces.

    python examples/freshness.py [--objects 2] [--films 3] [--keep clips]

Pieces of a batch scatter in stiffness, damping, mass, size and friction, and are filmed for 1.5 s each at frequencies
at which friction counts least (plategait study freshness). The films are rendered here, as a phone would take them,
and tracked like any other; the rule that tells fresh from aged is learnt on other pieces, which are simulated and read
no better than the films are.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import numpy as np

import plategait as pg
from plategait.model.scenario import Scenario
from plategait.study.questions.batches import learn_rule, told_wrong
from plategait.study.questions.freshness import AGEING, FILMED, ON, ONE, SECONDS, batch, film_of


def simulated(pieces: list[list[Scenario]], films: list[int]) -> np.ndarray:
    """(pieces, films) logarithms of the rates of pieces that are not filmed."""
    runs = pg.simulate_all([piece[i] for piece in pieces for i in films])
    return np.log(np.abs([run.spin_rate for run in runs])).reshape(len(pieces), -1)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--objects", type=int, default=2, help="pieces of each batch that are filmed")
    parser.add_argument("--films", type=int, choices=(1, len(FILMED)), default=len(FILMED), help="of each piece")
    parser.add_argument("--learnt", type=int, default=12, help="pieces of each batch that the rule learns from")
    parser.add_argument("--seconds", type=float, default=SECONDS, help="length of a film")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=Path, help="folder in which the films stay")
    told = parser.parse_args()
    films = [ONE] if told.films == 1 else list(range(len(FILMED)))
    shelf = {"A": batch(told.objects, 100 + told.seed), "B": batch(told.objects, 200 + told.seed, AGEING)}

    seen, doubts = {}, []
    with tempfile.TemporaryDirectory() as scratch:
        folder = told.keep or Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for name, pieces in shelf.items():
            rates = []
            for j, piece in enumerate(pieces):
                clips = [folder / f"{name}{j + 1}-{FILMED[i]:g}Hz.mp4" for i in films]
                spins = [film_of(piece[i], clip, j, told.seconds)[1] for i, clip in zip(films, clips, strict=True)]
                doubts.append([(spin.high - spin.low) / 2 / 1.96 / abs(spin.rate) for spin in spins])
                rates.append([np.log(abs(spin.rate)) for spin in spins])
                read = [f"{np.degrees(spin.rate):.1f} ± {np.degrees(spin.high - spin.low) / 2:.1f} deg/s at {f:g}"
                        for f, spin in zip([FILMED[i] for i in films], spins, strict=True)]  # fmt: skip
                print(f"piece {name}{j + 1}: {', '.join(read)} Hz", flush=True)
            seen[name] = np.array(rates)

    reading = np.sqrt(np.mean(np.square(doubts), axis=0))
    rng = np.random.default_rng(told.seed)
    fresh, aged, *others = (
        (rates := simulated([p for i, alpha in enumerate(ON)
                             for p in batch(told.learnt, 10 * kind + i, age, alpha)], films))
        + reading * rng.normal(size=rates.shape)
        for kind, age in ((31, 1.0), (32, AGEING), (33, 1.0), (34, AGEING))
    )  # fmt: skip
    rule = learn_rule(fresh, aged)
    print(f"films are read to {', '.join(f'{100 * sd:.2f}' for sd in reading)} % (1 s.d.)")
    for name, rates in seen.items():
        score = float(rule.scores(rates).mean())
        print(f"batch {name}: score {score:+.2f} (fresh -0.5, aged +0.5): {'aged' if score > 0 else 'fresh'}")
    wrong = [told_wrong(rule.scores(others[0]), rule.scores(others[1]), n) for n in (told.objects, 10)]
    print(
        f"of other batches {told.objects} pieces are told wrong in {100 * wrong[0]:.0f} %, 10 in {100 * wrong[1]:.1f} %"
    )


if __name__ == "__main__":
    main()
