"""Follows the object in pictures of the plate from above: by its markers or its texture, with its edge."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from plategait.arrays import Array, Picture
from plategait.vision.object.markers import MarkerTracker, as_tracked, learn_markers
from plategait.vision.object.pose import Pose, middle_of
from plategait.vision.object.rim import RAYS, find_rim, learn_rim, marked_parts, marks_fit, spots_on_it
from plategait.vision.object.texture import TextureTracker, learn_object
from plategait.vision.plate.rectified import Grid

# Share of the pictures in which what was learnt as markers must be found again.
LEAST_FOLLOWED = 0.3
# Spots that look like markers on an object that has two: a stain is none, toppings are many.
MOST_SPOTS = 3.5
NO_MARKERS = "two spots of one colour are no markers: they are not in the object's middle and near its rim"
MANY_SPOTS = "spots of one colour are no markers: there are more than two of them on the object"


class ObjectTracker:
    """Follows one object.

    Parameters
    ----------
    grid : Grid
        Pixels of pictures of the whole plate.
    allowed : (rows, columns) array
        Where in them the object may be.

    Attributes
    ----------
    markers : MarkerTracker or None
    texture : TextureTracker or None
        One of both, once the object is learnt.
    others : int
        How many other objects look the same.
    notes : list of str
        What to know of the object.
    """

    def __init__(self, grid: Grid, allowed: Picture) -> None:
        self.grid, self.allowed = grid, allowed
        self.markers: MarkerTracker | None = None
        self.texture: TextureTracker | None = None
        self.others = 0
        self.notes: list[str] = []
        self._rim = None

    def learn(self, known_by: str, patches: list[Picture]) -> bool:
        """Learn what the object looks like; whether the pictures show one.

        Parameters
        ----------
        known_by : {"auto", "markers", "texture", "outline"}
        patches : list of (rows, columns, 3) arrays
        """
        if known_by in ("auto", "markers") and self._learn_markers(patches, known_by == "markers"):
            return True
        whole = None if known_by == "markers" else learn_object(patches, self.grid, self.allowed)
        if whole is None:
            return False
        first = TextureTracker(whole)
        self._learn_rim(patches, [first.find(patch, self.grid, self.allowed)[0] for patch in patches])
        self.texture, self.others = TextureTracker(whole), whole.others
        return True

    def _learn_markers(self, patches: list[Picture], told: bool) -> bool:
        """Learn markers that are found again in the pictures, and lie where markers do unless they are told to be."""
        markers = learn_markers(patches, self.grid, self.allowed)
        if markers is None:
            return False
        markers = as_tracked(markers, patches, self.grid, self.allowed)
        tracker = MarkerTracker(markers)
        poses = [tracker.find(patch, self.grid, self.allowed) for patch in patches]
        sure = [k for k, pose in enumerate(poses) if not pose.reason]
        if len(sure) < LEAST_FOLLOWED * len(patches):
            return False
        if not told:
            shown, places = [patches[k] for k in sure], [poses[k] for k in sure]
            parts = marked_parts(shown, places, self.grid, self.allowed)
            if not marks_fit(parts, places, self.grid):
                self.notes.append(NO_MARKERS)
                return False
            spots = [tracker.alike(patch, self.grid, self.allowed) for patch in shown]
            if spots_on_it(parts, spots, self.grid) > MOST_SPOTS:
                self.notes.append(MANY_SPOTS)
                return False
        self._learn_rim(patches, poses)
        self.markers, self.others = MarkerTracker(markers), markers.others
        return True

    def _learn_rim(self, patches: list[Picture], poses: list[Pose]) -> None:
        middles = [None if pose.reason else middle_of(pose) for pose in poses]
        self._rim = learn_rim(patches, self.grid, self.allowed, middles)

    def _edge(self, patch: Picture, grid: Grid, allowed: Picture, pose: Pose) -> Array:
        middle = middle_of(pose)
        if self._rim is None or middle is None:
            return np.full(RAYS, np.nan)
        return find_rim(self._rim, patch, grid, allowed, middle)

    def find(self, warped: Callable[[Grid], Picture]) -> dict[str, Pose]:
        """Poses by method in one frame, of which a picture is to be had on any part of the plate."""
        if self.markers is not None:
            grid, part = self.grid.part(*self.markers.window)
            patch, allowed = warped(grid), self.allowed[part]
            poses = {"markers": self.markers.find(patch, grid, allowed)}
        else:
            assert self.texture is not None
            grid, allowed = self.grid, self.allowed
            patch = warped(grid)
            poses = dict(zip(self.methods, self.texture.find(patch, grid, allowed), strict=True))
        if self._rim is None:
            return poses
        rim = self._edge(patch, grid, allowed, next(iter(poses.values())))
        return {name: pose._replace(rim=rim) for name, pose in poses.items()}

    @property
    def methods(self) -> tuple[str, ...]:
        """Ways in which the object's orientation is found."""
        return ("markers",) if self.markers is not None else ("texture", "outline")

    @property
    def no_edge(self) -> str:
        """Why the object's edge is not looked for; empty where it is."""
        return "" if self._rim else "its colour is too like the plate's: no outline, radius or area"
