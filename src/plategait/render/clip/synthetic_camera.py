"""Takes the pictures of a synthetic film: the moments of each exposure, what covers markers, what is seen of them."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from plategait.arrays import Array
from plategait.camera.camera import Camera
from plategait.model.scenario import Scenario
from plategait.render.clip.appearance import Appearance
from plategait.render.clip.raster import Fragments, Rasteriser, Sensor
from plategait.render.clip.scene import Occluder, Scene, random_occluders
from plategait.render.snapshots import Snapshots

# Shifts within a pixel of the pictures that one exposure is made of (px), and how far things may move between two.
_SHIFTS = np.array([(-0.125, -0.375), (0.375, -0.125), (-0.375, 0.125), (0.125, 0.375)])
_LARGEST_STEP = 3.0
_MOST_SAMPLES = 24
# Frames for which a marker stays covered, on average.
_COVERED = 4.0


class SyntheticCamera:
    """Takes the pictures of one run.

    Parameters
    ----------
    scenario : Scenario
    snapshots : Snapshots
        Of the run.
    camera : Camera
    appearance : Appearance
    exposure : float
        For which the shutter is open, s.
    """

    def __init__(
        self, scenario: Scenario, snapshots: Snapshots, camera: Camera, appearance: Appearance, exposure: float
    ) -> None:
        self.scenario, self.scene = scenario, Scene(scenario, appearance, camera)
        self.snapshots, self.camera, self.appearance, self.exposure = snapshots, camera, appearance, exposure
        self.rasteriser = Rasteriser(camera, self.scene.atlas)
        self.sensor = Sensor(
            (camera.height, camera.width),
            appearance.gradient,
            appearance.defocus,
            appearance.noise,
            appearance.seed + 5,
        )

    def picture(self, time: float, occluders: list[Occluder]) -> tuple[NDArray[np.uint8], Array]:
        """Picture (height, width, 3) of a time of the run, and how much it shows of each marker (2,)."""
        nodes, pose = self.snapshots.at(time)
        shadow = self.scene.shadow(nodes, pose)
        n = self._n_samples(time)
        samples = []
        for k, share in enumerate((np.arange(n) + 0.5) / n - 0.5):
            at, plate = self.snapshots.at(time + self.exposure * share)
            mesh = self.scene.lit_mesh(at, plate, shadow, occluders)
            samples.append(self.rasteriser.rasterise(mesh, tuple(_SHIFTS[k % len(_SHIFTS)])))
        # The moment nearest to the middle is at most half a step away.
        at, plate = self.snapshots.at(time + self.exposure * ((n // 2 + 0.5) / n - 0.5))
        return self.sensor.read(self.rasteriser.expose(samples)), self.visible_share(samples[n // 2], at, plate)

    def _n_samples(self, time: float) -> int:
        """Moments that an exposure needs so that nothing jumps between two of them."""
        if self.exposure == 0:
            return self.appearance.samples
        nodes, poses = self.snapshots.at(time + self.exposure * np.array([-0.5, 0.0, 0.5]))
        moving = np.concatenate([nodes, self.scene.corners(poses)], axis=1)
        steps = np.linalg.norm(np.diff(self.camera.project(moving), axis=0), axis=-1)
        moved = float(np.nanmax(steps.sum(axis=0)))
        return int(
            np.clip(
                math.ceil(moved / _LARGEST_STEP), self.appearance.samples, max(_MOST_SAMPLES, self.appearance.samples)
            )
        )

    def markers(self, nodes: Array, pose: Array) -> tuple[Array, float]:
        """Middles (2, 3) of the markers in the world, m, and the direction from the first to the second, rad."""
        middles, _, _ = self.scene.marker_frames(nodes)
        rotation, _ = self.scene.plate_frame(pose)
        x, y = (middles[1] - middles[0]) @ rotation[:, :2]
        return middles, math.atan2(y, x)

    def visible_share(self, fragments: Fragments, nodes: Array, pose: Array) -> Array:
        """Pixels of each marker over what it would cover lying flat in the same place."""
        if not self.appearance.markers:
            return np.zeros(2)
        middles, direction = self.markers(nodes, pose)
        rotation, _ = self.scene.plate_frame(pose)
        along = rotation[:, :2] @ (math.cos(direction), math.sin(direction))
        steps = 1e-4 * np.array([along, np.cross(rotation[:, 2], along)])
        shares = []
        for middle, place, size in zip(middles, self.scene.marker_places, self.scene.marker_sizes, strict=True):
            pixel, *sides = self.camera.project(np.concatenate([middle[None], middle + steps]))
            (ax, ay), (bx, by) = (np.array(sides) - pixel) / 1e-4  # px for a metre along and across
            flat = abs(ax * by - ay * bx) * size[0] * size[1]
            corners = np.add(place, np.multiply(size, [(-0.5, -0.5), (0.5, 0.5)]))
            (left, bottom), (right, top) = self.scene.atlas.upper.texels(corners)
            reach = int(2 * size[0] * max(math.hypot(ax, ay), math.hypot(bx, by))) + 4
            column, row = (int(v) for v in pixel - (fragments.left, fragments.top))
            rows, columns = (slice(max(0, v - reach), max(0, v + reach)) for v in (row, column))
            u, v = fragments.values[rows, columns, 0], fragments.values[rows, columns, 1]
            shares.append(((u > left) & (u < right) & (v > top) & (v < bottom)).sum() / max(flat, 1e-9))
        return np.array(shares)


def occlusions(n: int, share: float, seed: int) -> list[list[Occluder]]:
    """For each of n frames what covers the markers: nothing, or the same thing for a few frames on end."""
    generator = np.random.default_rng(seed + 11)
    frames: list[list[Occluder]] = []
    open_for = _COVERED * (1 - share) / share if share > 0 else math.inf
    while len(frames) < n:
        frames += [[]] * (n if share == 0 else int(generator.geometric(1 / max(open_for, 1.0))))
        if share > 0:
            frames += [random_occluders(generator)] * int(generator.geometric(1 / max(_COVERED, share / (1 - share))))
    return frames[:n]
