"""Pictures of a run, drawn without a display: a film, and a strip of snapshots.

A painter's algorithm on supersampled Pillow images: sheet and plate are a few thousand polygons, a tenth of a second a
frame with no graphics library. All is in metres in the world frame until the camera projects it to pixels.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plategait.engine.recording import Recording
from plategait.errors import InputError
from plategait.output import whole_file
from plategait.scenario import Scenario
from plategait.sheet import Sheet
from plategait.simulation import observe

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw
    from PIL.ImageFont import FreeTypeFont

Array = NDArray[np.float64]

# Film time of one plate period, s: 15 frames at 30 fps, enough to tell sliding, walking and running apart by eye.
PERIOD_ON_FILM = 0.5
# Fewest snapshots in a plate period that can be drawn between.
SNAPSHOTS_PER_PERIOD = 8
# Cells along the sheet's longer side, and nodes its surface is drawn through (a finer lattice is thinned out).
CELLS, MOST_NODES = 80, 1000
# Pixels are drawn this many times finer each way, then averaged.
FINER = 2
# The camera looks along the bar from its free end, a little from the side and from above; rad.
AZIMUTH, ELEVATION, FIELD_OF_VIEW = math.radians(-24), math.radians(27), math.radians(24)
# Thickness of the plate and radius of the bar over the plate's width.
SLAB, BAR = 0.045, 0.03

_SKY, _FLOOR, _INK = (250, 251, 252), (216, 223, 230), (38, 46, 56)
_PLATE, _GRID, _AXIS, _METAL = (203, 212, 221), (186, 196, 207), (112, 126, 143), (165, 172, 181)
_SHEET, _MARKER, _SHADOW = (250, 196, 72), (24, 66, 116), (36, 46, 62)
_AMBIENT, _DIFFUSE, _SHINE = 0.50, 0.56, 0.18


def film(
    scenario: Scenario,
    recording: Recording,
    path: Path | str,
    *,
    fps: float = 30,
    slow_motion: float | None = None,
    size: tuple[int, int] = (1280, 720),
    seconds: float = 4.0,
    until: float | None = None,
    progress: Callable[[float], object] | None = None,
) -> Path:
    """Film the last part of a run, when its gait has settled: H.264 in an MP4 file.

    Parameters
    ----------
    recording : Recording
        With snapshots.
    path : Path or str
        File to write, ending in .mp4. It appears when the film is complete, never half.
    fps : float
        Frames per second.
    slow_motion : float, optional
        How much longer the film takes than the motion. By default half a second for each plate period: 12 at 24 Hz.
    size : (width, height)
        Pixels, both even.
    seconds : float
        Length of the film; less where the run is shorter.
    until : float, optional
        Time of the run at which the film ends, s; by default where the run failed, or its end.
    progress : callable, optional
        Called with the fraction done.

    Raises
    ------
    InputError
        For a recording without snapshots or with too few, or a path or number that cannot be used.
    """
    slower = max(1.0, PERIOD_ON_FILM * scenario.motion.frequency) if slow_motion is None else slow_motion
    for field, value, works in (("fps", fps, "30"), ("slow_motion", slower, "10"), ("seconds", seconds, "4")):
        if not (math.isfinite(value) and value > 0):
            raise InputError(field, value, "above 0", works)
    if min(size) < 64 or size[0] % 2 or size[1] % 2:
        raise InputError("size", size, "two even numbers of pixels, 64 or more", "(1280, 720)")
    shots = _Shots.of(scenario, recording, 1 / (fps * slower))
    end = shots.end(scenario, recording, until)
    frames = max(1, round(min(seconds, (end - shots.time[0]) * slower) * fps))
    times = end - np.arange(frames)[::-1] / (fps * slower)
    with whole_file(path, (".mp4",)) as unfinished:
        import av
        from av.video.reformatter import ColorRange, Colorspace

        stage = _Stage(scenario, shots.at(times)[1], size)
        with av.open(str(unfinished), "w", format="mp4", options={"movflags": "+faststart"}) as container:
            stream: Any = container.add_stream("libx264", rate=Fraction(fps).limit_denominator(1001))
            stream.width, stream.height, stream.pix_fmt = *size, "yuv420p"
            stream.options = {"crf": "18", "preset": "medium"}
            stream.codec_context.colorspace, stream.codec_context.color_range = Colorspace.ITU709, ColorRange.MPEG
            for done, time in enumerate(times):
                picture = stage.picture(*shots.at(time))
                _caption(picture, scenario, time, slower)
                frame = av.VideoFrame.from_image(picture).reformat(format="yuv420p", dst_colorspace=Colorspace.ITU709)
                container.mux(stream.encode(frame))
                if progress is not None:
                    progress((done + 1) / frames)
            container.mux(stream.encode())
    return Path(path)


def filmstrip(
    scenario: Scenario, recording: Recording, path: Path | str, *, panels: int = 8, until: float | None = None
) -> Path:
    """Draw snapshots over the last whole plate period of a run, as Fig. 4.3 does: a PNG file.

    Parameters
    ----------
    recording, path, until
        As for `film`; the path ends in .png.
    panels : int
        Snapshots, evenly spaced over the period.

    Raises
    ------
    InputError
        As for `film`.
    """
    from PIL import Image, ImageDraw

    if not 1 <= panels <= 26:
        raise InputError("panels", panels, "from 1 to 26", "8")
    period = scenario.motion.period
    shots = _Shots.of(scenario, recording, 0)
    start = max(float(shots.time[0]), (math.floor(shots.end(scenario, recording, until) / period + 1e-6) - 1) * period)
    times = start + np.arange(panels) * period / panels
    width, height, gap, top = 480, 330, 6, 64
    columns = math.ceil(panels / math.ceil(panels / 4))
    stage = _Stage(scenario, shots.at(times)[1], (width, height))
    strip = Image.new("RGB", (columns * (width + gap) + gap, math.ceil(panels / columns) * (height + gap) + top), "white")
    rate = math.degrees(observe(scenario, recording).spin.rate)
    spin = f"spinning at {rate:.0f} deg/s" if math.isfinite(rate) else "spin rate not measured"
    title = f"{scenario.name}:  {_in_words(scenario)},  {spin}"
    _write(ImageDraw.Draw(strip), (strip.width / 2, top / 2), title, 26, "mm", strip.width - 4 * gap)
    for k, time in enumerate(times):
        panel = stage.picture(*shots.at(time))
        _write(ImageDraw.Draw(panel), (14, height - 14), f"({chr(97 + k)})  {1e3 * (time - start):.1f} ms", 20, "ls")
        strip.paste(panel, (gap + k % columns * (width + gap), top + k // columns * (height + gap)))
    with whole_file(path, (".png",)) as unfinished:
        strip.save(unfinished, format="PNG")
    return Path(path)


# ------------------------------------------------------------------------------------------------------------- time


@dataclass(frozen=True, eq=False)
class _Shots:
    """The snapshots of a recording that are finite, and what lies between them."""

    time: Array
    nodes: Array
    pose: Array

    @classmethod
    def of(cls, scenario: Scenario, recording: Recording, frame_interval: float) -> _Shots:
        finite = np.isfinite(recording.snapshots).all(axis=(1, 2))
        last = len(finite) if finite.all() else int(np.argmin(finite))
        period, time = scenario.motion.period, recording.snapshot_time[:last]
        advice = f"simulate(scenario, snapshot_interval={period / 24:.2g})"
        if last == 0:
            raise InputError("recording", "nothing to draw, no snapshots", "a recording with snapshots", advice)
        coarsest = max(period / SNAPSHOTS_PER_PERIOD, frame_interval)
        if last > 1 and (interval := float(np.diff(time).max())) > coarsest * 1.01:
            raise InputError("recording", f"a snapshot every {interval:.2g} s", f"one with a snapshot every {coarsest:.2g} s", advice)
        return cls(time, recording.snapshots[:last].astype(float), recording.plate_pose[:last])

    def end(self, scenario: Scenario, recording: Recording, until: float | None) -> float:
        """Time to stop at: as asked, or the failure, or the last snapshot."""
        if until is None:
            failure = observe(scenario, recording).failure
            until = math.inf if failure is None else failure.time
        elif not until > self.time[0]:
            raise InputError("until", until, "a time after the first snapshot, s", f"{self.time[-1]:g}")
        return min(float(self.time[-1]), until)

    def at(self, time: ArrayLike) -> tuple[Array, Array]:
        """Nodes and plate pose at a time, or at several."""
        place = np.interp(time, self.time, np.arange(len(self.time)))
        before = np.minimum(place.astype(int), max(0, len(self.time) - 2))
        after, share = np.minimum(before + 1, len(self.time) - 1), place - before
        nodes = self.nodes[before] + share[..., None, None] * (self.nodes[after] - self.nodes[before])
        return nodes, self.pose[before] + share[..., None] * (self.pose[after] - self.pose[before])


def _rotation(pose: Array) -> Array:
    """(…, 3, 3) of Rx Ry Rz."""
    (cx, cy, cz), (sx, sy, sz) = np.moveaxis(np.cos(pose[..., 3:]), -1, 0), np.moveaxis(np.sin(pose[..., 3:]), -1, 0)
    rows = [[cy * cz, -cy * sz, sy],
            [cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy],
            [sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy]]  # fmt: skip
    return np.moveaxis(np.array(rows), (0, 1), (-2, -1))


# ---------------------------------------------------------------------------------------------------------- surface


class Spline:
    """Thin-plate spline through a sheet's nodes: smooth between them and on to the outline, half a pitch beyond."""

    def __init__(self, sheet: Sheet) -> None:
        lattice = sheet.lattice
        stride = math.ceil(math.sqrt(lattice.n_nodes / MOST_NODES))
        self.kept = np.nonzero((lattice.squares % stride == 0).all(axis=1))[0]
        self.centre = (np.array(lattice.occupied.shape) - 1) / 2
        self.nodes = lattice.squares[self.kept] - self.centre
        self.pitch, self.reach, self.wide = sheet.pitch, float(stride), np.ptp(self.nodes, axis=0) > 0
        n, basis = len(self.nodes), self._basis(self.nodes)
        system = np.zeros((basis.shape[1], basis.shape[1]))
        system[:n], system[n:, :n] = basis, basis[:, n:].T
        self.solution = np.linalg.inv(system)[:, :n]

    def _basis(self, points: Array) -> Array:
        from scipy.spatial.distance import cdist

        square = cdist(points, self.nodes, "sqeuclidean")
        return np.concatenate([square * np.log(np.maximum(square, 1e-30)), np.ones((len(points), 1)), points[:, self.wide]], axis=1)

    def reaches(self, points: Array) -> NDArray[np.bool_]:
        """Whether points (n, 2), m, are within a pitch of a node."""
        from scipy.spatial.distance import cdist

        return cdist(points / self.pitch, self.nodes).min(axis=1, initial=np.inf) <= self.reach

    def onto(self, x: Array, y: Array) -> Callable[[Array], Array]:
        """Give what takes values at all nodes (n_nodes, k) to values (len(x), len(y), k) on a grid of points, m."""
        basis = self._basis(np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2) / self.pitch)
        return lambda values: (basis @ (self.solution @ values[self.kept])).reshape(len(x), len(y), -1)


@dataclass(frozen=True, eq=False)
class _Faces:
    """Polygons of one colour: (n, k, 3) corners counter-clockwise seen from outside, (n, 3) outward directions."""

    corners: Array
    outward: Array
    colour: tuple[int, int, int]
    nearer: float = 0.0  # how much closer to the camera to take them when sorting, m


class _Skin:
    """A sheet's surfaces: grid cells trimmed to the outline, its rim, and two markers that form a radial line."""

    def __init__(self, sheet: Sheet) -> None:
        spline, extent = Spline(sheet), np.array(sheet.outline.size())
        if not spline.wide.all():
            raise InputError("sheet", "a single row of nodes", "at least 2 nodes across both ways", "a finer sheet.pitch")
        self.thickness, self.step = sheet.thickness, float(extent.max()) / CELLS
        x, y = (self.step * np.arange(-half - 1, half + 2) for half in np.ceil(extent / 2 / self.step))
        self.onto = spline.onto(x, y)
        grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)

        def inside(points: Array) -> NDArray[np.bool_]:
            return sheet.outline.contains(points[:, 0], points[:, 1]) & spline.reaches(points)

        within = inside(grid)
        number = np.arange(len(grid)).reshape(len(x), len(y))
        cells = np.stack([number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]], axis=-1).reshape(-1, 4)
        corners_in = within[cells].sum(axis=1)
        self.whole = cells[corners_in == 4]
        self.trimmed, self.rim, self.edges = _trim(cells[(corners_in > 0) & (corners_in < 4)], within, len(grid))
        # Where the outline crosses the edges, by halving.
        low, high = np.zeros(len(self.edges)), np.ones(len(self.edges))
        for _ in range(20):
            middle = (low + high) / 2
            hit = inside(_between(grid, self.edges, middle))
            low, high = np.where(hit, middle, low), np.where(hit, high, middle)
        self.crossing = low
        self.used = np.unique(self.whole)
        along = grid[within & (np.abs(grid[:, 1]) <= self.step), 0]
        size = float(extent.min()) / 2
        places = (0.0, 0.8 * float(along.max(initial=0.0)))
        self.markers = []
        for place in places:
            mx, my = place + size * np.linspace(-0.17, 0.17, 9), size * np.linspace(-0.085, 0.085, 5)
            middles = np.stack(np.meshgrid((mx[1:] + mx[:-1]) / 2, (my[1:] + my[:-1]) / 2, indexing="ij"), axis=-1)
            self.markers.append((spline.onto(mx, my), inside(middles.reshape(-1, 2))))

    def surface(self, nodes: Array) -> tuple[Array, Array]:
        """(n, 3) vertices of the lower face and their upward unit normals."""
        grid = self.onto(nodes)
        normals = _normals(grid).reshape(-1, 3)
        grid = grid.reshape(-1, 3)
        low = np.concatenate([grid, _between(grid, self.edges, self.crossing)])
        return low, np.concatenate([normals, _between(normals, self.edges, self.crossing)])

    def faces(self, nodes: Array, low: Array, up: Array) -> list[_Faces]:
        """All that can be seen of the sheet, given its surface."""
        high = low + self.thickness * up
        faces = []
        for cells in (self.whole, self.trimmed):
            faces.append(_Faces(high[cells], up[cells].mean(axis=1), _SHEET))
            faces.append(_Faces(low[cells[:, ::-1]], -up[cells].mean(axis=1), _SHEET))
        a, b = self.rim.T
        faces.append(_Faces(np.stack([low[a], low[b], high[b], high[a]], axis=1), np.cross(low[b] - low[a], up[a]), _SHEET))
        for onto, kept in self.markers:
            patch = onto(nodes)
            patch = patch + (self.thickness + 2e-4) * _normals(patch)
            cells = _cells(patch)[kept]
            faces.append(_Faces(cells, np.cross(cells[:, 2] - cells[:, 0], cells[:, 3] - cells[:, 1]), _MARKER, 1.5 * self.step))
        return faces


def _cells(grid: Array) -> Array:
    """(n, 4, 3) corners of the cells of a grid of points."""
    return np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], axis=2).reshape(-1, 4, 3)


def _normals(grid: Array) -> Array:
    return _unit(np.cross(np.gradient(grid, axis=0), np.gradient(grid, axis=1)))


def _unit(vectors: Array) -> Array:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-30)


def _between(points: Array, edges: NDArray[np.intp], share: Array) -> Array:
    return points[edges[:, 0]] + share[:, None] * (points[edges[:, 1]] - points[edges[:, 0]])


def _trim(cells: NDArray[np.intp], within: NDArray[np.bool_], n: int) -> tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.intp]]:
    """Cut the cells that an outline crosses.

    Returns
    -------
    polygons : (n_cells, 6) array
        Corners and crossings counter-clockwise, the last repeated. Crossings are numbered from `n`.
    rim : (n_segments, 2) array
        Crossings at both ends of each piece of outline, the sheet on its left.
    edges : (n_crossings, 2) array
        Grid points inside and outside.
    """
    crossings: dict[tuple[int, int], int] = {}
    polygons, rim = [], []
    for cell in cells.tolist():
        polygon: list[int] = []
        leaving = None
        # Start at a corner inside whose predecessor is outside, so that each way out is followed by the way in.
        first = next(k for k in range(4) if within[cell[k]] and not within[cell[k - 1]])
        for k in range(first, first + 4):
            a, b = cell[k % 4], cell[(k + 1) % 4]
            if within[a]:
                polygon.append(a)
            if within[a] != within[b]:
                crossing = n + crossings.setdefault((a, b) if within[a] else (b, a), len(crossings))
                polygon.append(crossing)
                if within[a]:
                    leaving = crossing
                else:
                    rim.append((leaving, crossing))
        polygons.append((polygon + 6 * polygon[-1:])[:6])
    return (
        np.array(polygons, dtype=np.intp).reshape(-1, 6),
        np.array(rim, dtype=np.intp).reshape(-1, 2),
        np.array(list(crossings), dtype=np.intp).reshape(-1, 2),
    )


# ----------------------------------------------------------------------------------------------------------- camera


@dataclass(frozen=True, eq=False)
class _Camera:
    """A pinhole: where it is, its axes (rows: right, up, forward), focal length and middle in pixels."""

    eye: Array
    axes: Array
    focal: float
    middle: Array

    @classmethod
    def framing(cls, points: Array, size: tuple[int, int]) -> _Camera:
        """Look at points from the direction of `AZIMUTH` and `ELEVATION` so that they fill the frame."""
        ca, sa, ce, se = math.cos(AZIMUTH), math.sin(AZIMUTH), math.cos(ELEVATION), math.sin(ELEVATION)
        forward = -np.array([ce * ca, ce * sa, se])
        right = np.array([-sa, ca, 0.0])
        axes = np.stack([right, np.cross(right, forward), forward])
        target = (points.min(axis=0) + points.max(axis=0)) / 2
        focal = size[1] / 2 / math.tan(FIELD_OF_VIEW / 2)
        distance = float(np.linalg.norm(np.ptp(points, axis=0)))
        while True:
            camera = cls(target - distance * forward, axes, focal, np.zeros(2))
            seen, depth = camera.project(points)
            if depth.min() > 0 and (np.ptp(seen, axis=0) <= np.array(size) * (0.86, 0.70)).all():
                break
            distance *= 1.02
        middle = np.array(size) * (0.5, 0.535) - (seen.min(axis=0) + seen.max(axis=0)) / 2
        return cls(camera.eye, axes, focal, middle)

    def project(self, points: Array) -> tuple[Array, Array]:
        """(…, 2) pixels and (…) distance along the view."""
        x, y, depth = np.moveaxis((points - self.eye) @ self.axes.T, -1, 0)
        scale = self.focal / np.maximum(depth, 1e-6)
        return np.stack([x * scale, -y * scale], axis=-1) + self.middle, depth

    def plane(self, origin: Array, u: Array, v: Array) -> Array:
        """(3, 3) homography from coordinates on a plane to pixels."""
        lens = np.array([[self.focal, 0, self.middle[0]], [0, -self.focal, self.middle[1]], [0, 0, 1]])
        return lens @ self.axes @ np.stack([u, v, origin - self.eye], axis=1)


# ------------------------------------------------------------------------------------------------------------ stage


class _Stage:
    """Everything about a picture that does not change from frame to frame."""

    def __init__(self, scenario: Scenario, poses: Array, size: tuple[int, int]) -> None:
        from PIL import Image

        self.skin = _Skin(scenario.sheet)
        side = 1.5 * max(scenario.sheet.outline.size())
        self.half = np.array([side, side] if scenario.plate is None else [scenario.plate.length, scenario.plate.width]) / 2
        self.slab, self.bar = 2 * SLAB * self.half[1], 2 * BAR * self.half[1]
        corners = np.concatenate([self._corners(0.0), self._corners(-self.slab)])
        framed = (corners @ _rotation(poses).swapaxes(-1, -2) + poses[:, None, :3]).reshape(-1, 3)
        self.camera = _Camera.framing(framed, (size[0] * FINER, size[1] * FINER))
        right, above, forward = self.camera.axes
        self.light = _unit(0.8 * above - 0.6 * right - 0.2 * forward + (0.0, 0.0, 0.4))
        self.halfway = _unit(self.light - forward)
        fall = Image.linear_gradient("L").resize((size[0] * FINER, size[1] * FINER))
        self.background = Image.composite(Image.new("RGB", fall.size, _FLOOR), Image.new("RGB", fall.size, _SKY), fall)

    def _corners(self, z: float) -> Array:
        """(4, 3) corners of the plate at a height in its own frame, counter-clockwise from above."""
        return np.column_stack([np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * self.half, np.full(4, z)])

    def picture(self, nodes: Array, pose: Array) -> Image:
        """One frame."""
        from PIL import Image, ImageDraw

        rotation, moved = _rotation(pose), pose[:3]
        low, up = self.skin.surface(nodes)
        polygons, colours, corners = self._seen(self.skin.faces(nodes, low, up))
        # The plane of the plate parts what it hides from what hides it.
        towards = rotation[:, 2] * np.sign((self.camera.eye - moved) @ rotation[:, 2])
        hidden = (corners - moved) @ towards < -2 * self.skin.thickness
        canvas = self.background.copy()
        draw = ImageDraw.Draw(canvas)
        for k in np.nonzero(hidden)[0]:
            draw.polygon(polygons[k], colours[k])
        self._draw_plate(draw, rotation, moved)
        picture = canvas.reduce(FINER)
        self._cast_shadow(picture, (low[self.skin.used] - moved) @ rotation, rotation, moved)
        layer = Image.new("RGBA", canvas.size)
        draw = ImageDraw.Draw(layer)
        for k in np.nonzero(~hidden)[0]:
            draw.polygon(polygons[k], colours[k])
        box = layer.getbbox()
        if box:
            left, top = box[0] // FINER, box[1] // FINER
            smooth = layer.crop((left * FINER, top * FINER, box[2], box[3])).reduce(FINER)
            picture.paste(smooth, (left, top), smooth)
        return picture

    def _seen(self, groups: list[_Faces]) -> tuple[list[list[float]], list[tuple[int, int, int]], Array]:
        """Polygons in pixels and their colours, the furthest first, and the middle of each in the world."""
        polygons: list[list[float]] = []
        colours, middles, depths = [], [], []
        for group in groups:
            pixels, depth = self.camera.project(group.corners)
            x, y = np.moveaxis(pixels, -1, 0)
            facing = (x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1)).sum(axis=1) < 0
            seen = facing & (depth.min(axis=1) > 1e-3) & (np.abs(pixels).max(axis=(1, 2)) < 1e5)
            polygons += pixels[seen].reshape(-1, 2 * pixels.shape[1]).tolist()
            colours.append(self._lit(group.colour, group.outward[seen]))
            middles.append(group.corners[seen].mean(axis=1))
            depths.append(depth[seen].mean(axis=1) - group.nearer)
        order = np.argsort(-np.concatenate(depths))
        colour = np.concatenate(colours)[order].tolist()
        return [polygons[k] for k in order], [tuple(c) for c in colour], np.concatenate(middles)[order]

    def _lit(self, colour: tuple[int, int, int], outward: Array) -> NDArray[np.uint8]:
        """(n, 3) colours of faces that look outward (n, 3): ambient, diffuse and a little shine."""
        outward = _unit(outward)
        matt = _AMBIENT + _DIFFUSE * np.maximum(outward @ self.light, 0)
        shine = 255 * _SHINE * np.maximum(outward @ self.halfway, 0) ** 30
        return np.clip(np.outer(matt, colour) + shine[:, None], 0, 255).astype(np.uint8)

    def _draw_plate(self, draw: ImageDraw, rotation: Array, moved: Array) -> None:
        def pixels(points: ArrayLike) -> Array:
            return self.camera.project(np.asarray(points, dtype=float) @ rotation.T + moved)[0]

        def lines(points: ArrayLike, colour: tuple[int, int, int], width: float) -> None:
            for line in pixels(points).reshape(-1, 4).tolist():
                draw.line(line, colour, round(width * FINER))

        length, width = self.half
        top, bottom = self._corners(0.0), self._corners(-self.slab)
        # The bar leaves the plate at its far edge.
        angle = np.linspace(0, 2 * math.pi, 25)
        ring = self.bar * np.column_stack([0 * angle, np.cos(angle), np.sin(angle)]) - (0, 0, self.slab / 2)
        near, far = ring - (length, 0, 0), ring - (6 * length, 0, 0)
        sides = np.stack([near[:-1], far[:-1], far[1:], near[1:]], axis=1)
        slab = np.stack([bottom, np.roll(bottom, -1, axis=0), np.roll(top, -1, axis=0), top], axis=1)
        slab = np.concatenate([slab, [top, bottom[::-1]]])
        for corners, colour in ((sides, _METAL), (slab, _PLATE)):
            outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) @ rotation.T
            for polygon, tint in zip(*self._seen([_Faces(corners @ rotation.T + moved, outward, colour)])[:2], strict=True):
                draw.polygon(polygon, tint)
        if (self.camera.eye - moved) @ rotation[:, 2] > 0:
            pitch = 10 ** round(math.log10(2 * max(length, width) / 8))
            for k in range(-int(length / pitch), int(length / pitch) + 1):
                lines([(k * pitch, -width, 0), (k * pitch, width, 0)], _GRID, 1)
            for k in range(-int(width / pitch), int(width / pitch) + 1):
                lines([(-length, k * pitch, 0), (length, k * pitch, 0)], _GRID, 1)
            lines([(-length, 0, 0), (length, 0, 0)], _AXIS, 1.5)

    def _cast_shadow(self, picture: Image, sheet: Array, rotation: Array, moved: Array) -> None:
        """Darken the plate under the sheet (n, 3), plate frame: sharply where it touches, softly where it is lifted."""
        from PIL import Image
        from scipy.ndimage import gaussian_filter

        if (self.camera.eye - moved) @ rotation[:, 2] <= 0:
            return
        grain = self.half.max() / 80
        shape = np.ceil(2 * self.half / grain).astype(int)
        sheet = sheet[sheet[:, 2] > -2 * self.skin.thickness]
        ray = self.light @ rotation
        height = np.maximum(sheet[:, 2], 0)
        falls = (sheet[:, :2] - height[:, None] * ray[:2] / ray[2] + self.half) / grain
        places = np.floor(falls).astype(int)
        on = ((places >= 0) & (places < shape)).all(axis=1)
        index = places[on, 0] * shape[1] + places[on, 1]
        close = np.exp(-height[on] / 3e-3)

        def cover(weights: Array, blur: float) -> Array:
            share = np.bincount(index, weights, shape.prod()).reshape(shape) * (self.skin.step / grain) ** 2
            return np.minimum(gaussian_filter(share, blur / grain), 1)

        dark = 0.45 * cover(close, 1.5e-3) + 0.4 * cover(1 - close, 4e-3) + 0.3 * cover(close, 5e-3)
        texture = Image.fromarray((255 * np.clip(dark, 0, 0.7)).astype(np.uint8).T)
        plane = self.camera.plane(moved, rotation[:, 0], rotation[:, 1])
        scale = np.diag([FINER, FINER, 1.0])
        to_texture = np.array([[1, 0, self.half[0]], [0, 1, self.half[1]], [0, 0, grain]]) @ np.linalg.inv(plane) @ scale
        to_texture /= to_texture[2, 2]
        mask = texture.transform(picture.size, Image.Transform.PERSPECTIVE, to_texture.ravel()[:8].tolist(), Image.Resampling.BILINEAR)
        picture.paste(_SHADOW, (0, 0), mask)


# ------------------------------------------------------------------------------------------------------------- text


def _in_words(scenario: Scenario) -> str:
    """What the plate does."""
    motion = scenario.motion
    if motion.samples is not None or motion.waves:
        return f"own plate motion at {motion.frequency:g} Hz"
    return f"plate {motion.frequency:g} Hz,  A_p = {math.degrees(motion.angle):.4g} deg,  B_p = {1e3 * motion.stroke:.4g} mm"


def _caption(picture: Image, scenario: Scenario, time: float, slower: float) -> None:
    from PIL import ImageDraw

    draw, (width, height) = ImageDraw.Draw(picture), picture.size
    unit = height / 720
    _write(draw, (32 * unit, 28 * unit), scenario.name, 34 * unit, "lt", width / 2, bold=True)
    _write(draw, (32 * unit, 76 * unit), _in_words(scenario), 22 * unit, "lt", width * 0.6)
    _write(draw, (32 * unit, height - 30 * unit), f"{1e3 * time:7.1f} ms", 26 * unit, "ls")
    speed = "real time" if math.isclose(slower, 1) else f"slowed {slower:.3g} ×"
    _write(draw, (width - 32 * unit, height - 30 * unit), speed, 22 * unit, "rs")


def _write(
    draw: ImageDraw, place: tuple[float, float], text: str, size: float, anchor: str, room: float = math.inf, bold: bool = False
) -> None:
    """Write text no wider than the room there is."""
    font = _font(size, bold)
    if (wide := font.getlength(text)) > room:
        font = _font(size * room / wide, bold)
    draw.text(place, text, _INK, font, anchor)


def _font(size: float, bold: bool) -> FreeTypeFont:
    from matplotlib import get_data_path
    from PIL import ImageFont

    return ImageFont.truetype(Path(get_data_path()) / "fonts" / "ttf" / f"DejaVuSans{'-Bold' if bold else ''}.ttf", max(8, round(size)))
