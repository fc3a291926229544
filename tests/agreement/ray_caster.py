"""A stranger's films: a small ray caster in NumPy that shares no code with the package.

Own pinhole, own plate motion, own textures and light; the fiducials' patterns are OpenCV's. A ray is cast through each
pixel at its own moment (rolling shutter, exposure) onto the plate and onto a sheet of finite thickness that lies on it
and may bend. Lengths in m, times in s, angles in deg where they are said by people, else rad.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

import av
import cv2
import numpy as np

PLATES = {  # colour, grain along the bar (levels), gloss (levels)
    "steel": ((205, 207, 210), 2.0, 40.0),
    "glossy": ((188, 190, 196), 1.0, 150.0),
    "wood": ((150, 105, 62), 14.0, 10.0),
    "dark": ((45, 46, 50), 2.0, 60.0),
    "white": ((236, 236, 233), 1.0, 15.0),
}
CHEESE, SKIN, MARKER, PEPPERONI, OLIVE = (242, 200, 84), (214, 160, 130), (20, 66, 140), (170, 46, 34), (44, 40, 46)
SUBSAMPLES = ((-0.33, -0.17), (0.0, 0.33), (0.33, -0.17))  # of a pixel and of an exposure


@dataclass(frozen=True)
class Film:
    """What is filmed, and how. Seen from above, x runs along the bar, about which the plate tilts."""

    plate: str = "steel"
    side: float = 0.1
    fiducial: float = 0.1 / 6  # 0 for none
    frequency: float = 11.0
    tilt: float = 5.0
    stroke: float = 2e-3
    bar_below: float = 6e-3

    radius: float = 0.03
    stretch: float = 1.0  # of an ellipse: axis across the mark's line over that along it
    thickness: float = 2.5e-3
    colour: tuple[int, int, int] = CHEESE
    look: str = "markers"  # or grain, toppings, plain
    rate: float = 150.0
    swing: float = 1.5
    start: float = 20.0
    place: tuple[float, float] = (0.002, -0.003)
    speed: tuple[float, float] = (0.0, 0.0)
    leaves: tuple[float, float] = (math.inf, 0.3)  # when it begins to slide off along x, and its acceleration
    dish: float = 0.0  # how high the rim is lifted at most: alike all around
    fold: float = 0.0  # and as a channel along the bar, both sides

    size: tuple[int, int] = (320, 240)
    fps: float = 30.0
    seconds: float = 2.0
    eye: tuple[float, float, float] = (0.06, -0.15, 0.27)
    view: float = 22.0  # deg, over the picture's height
    shake: float = 0.0  # of a hand that holds the camera: m, and as much turning as that is at half a metre
    readout: float = 0.0  # from the first row to the last
    exposure: float = 1 / 800
    flicker: float = 0.0  # share by which the exposure wanders
    noise: float = 1.5
    hand: tuple[float, float] = (math.inf, math.inf)  # from when to when one is over the object
    times: tuple[float, ...] = ()  # of the frames, where they do not come evenly
    stamps: float = 1 / 90000  # to which times are rounded in the file
    seed: int = 0

    def but(self, **changes: object) -> Film:
        """Give the same film but for some changes."""
        return replace(self, **changes)  # type: ignore[arg-type]

    @property
    def time(self) -> np.ndarray:
        """Of each frame: of its middle row, in the middle of its exposure."""
        return np.array(self.times) if self.times else np.arange(round(self.seconds * self.fps)) / self.fps

    def phase(self, t: np.ndarray) -> np.ndarray:
        """Of the plate, rad."""
        return 2 * math.pi * self.frequency * t

    def angle(self, t: np.ndarray) -> np.ndarray:
        """Orientation of the object on the plate, rad."""
        swing = math.radians(self.swing) * np.sin(self.phase(t) + 0.4)
        return math.radians(self.start) + math.radians(self.rate) * t + swing

    def middle(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Where the object's middle is on the plate."""
        begins, a = self.leaves
        away = 0.5 * a * np.clip(t - begins, 0, None) ** 2 if math.isfinite(begins) else 0.0 * t
        return self.place[0] + self.speed[0] * t + away, self.place[1] + self.speed[1] * t

    @property
    def area(self) -> float:
        """Of the object, flat."""
        return math.pi * self.radius**2 * self.stretch

    def rise(self, t: np.ndarray) -> np.ndarray:
        """Share of its highest lift that the rim has."""
        return 0.5 + 0.5 * np.sin(self.phase(t) + 1.0)

    def shape(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Highest lift of the lower side at a place relative to the middle, m, along the plate's axes."""
        along, across = (np.float32(h / self.radius**2) for h in (self.dish, self.dish + self.fold))
        return along * x * x + across * y * y


def _smooth_noise(seed: int, width: float) -> np.ndarray:
    """(1024, 1024) blots of about so many 256ths, mean 0 and deviation 1, which go on at the edges."""
    grain = np.random.default_rng(seed).normal(size=(256, 256)).astype(np.float32)
    grain = cv2.GaussianBlur(np.tile(grain, (2, 2)), (0, 0), width)
    grain = cv2.resize(grain, (2048, 2048), interpolation=cv2.INTER_LINEAR)[512:1536, 512:1536]
    return (grain - grain.mean()) / grain.std()


class Sheet:
    """The object at the moments of some rays (n,)."""

    def __init__(self, film: Film, t: np.ndarray) -> None:
        self.film, a, (mx, my) = film, film.angle(t), film.middle(t)
        self.pose = np.stack([mx, my, np.cos(a), np.sin(a), film.rise(t)]).astype(np.float32)

    def at(self, chosen: np.ndarray) -> Sheet:
        """Only for some of the rays."""
        other = Sheet.__new__(Sheet)
        other.film, other.pose = self.film, self.pose[:, chosen]
        return other

    def within(self, x: np.ndarray, y: np.ndarray, z: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Where points of the plate's frame are in its own, and how far below its upper side."""
        mx, my, c, s, up = self.pose
        x, y = x - mx, y - my
        below = up * self.film.shape(x, y) + np.float32(self.film.thickness) - z
        if self.film.dish or self.film.fold:
            # A sheet that bends does not stretch: seen from above it is shorter than along itself.
            dish, fold = (np.float32(2 / 3) * (up * np.float32(h / self.film.radius**2)) ** 2
                          for h in (self.film.dish, self.film.fold))  # fmt: skip
            longer = 1 + dish * (x * x + y * y)
            x, y = x * longer, y * (longer + fold * y * y)
        return c * x + s * y, c * y - s * x, below

    def holds(self, x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
        """Whether points are inside it."""
        u, v, below = self.within(x, y, z)
        film = self.film
        flat = u * u + v * v * np.float32(film.stretch**-2) < np.float32(film.radius**2)
        return flat & (below >= 0) & (below <= np.float32(film.thickness))

    def slopes(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Of its upper side, along the plate's axes."""
        mx, my, _, _, up = self.pose
        k = 2 * up / self.film.radius**2
        return k * self.film.dish * (x - mx), k * (self.film.dish + self.film.fold) * (y - my)


class Caster:
    """Casts the rays of one film."""

    def __init__(self, film: Film) -> None:
        self.film = film
        rng = np.random.default_rng(film.seed)
        self.grain, self.table = _smooth_noise(film.seed + 1, 5.0), _smooth_noise(film.seed + 2, 3.0)
        self.toppings = [
            (film.radius * 0.78 * math.sqrt(q) * math.cos(a), film.radius * 0.78 * math.sqrt(q) * math.sin(a))
            for q, a in rng.uniform((0, 0), (1, 2 * math.pi), (11, 2))
        ]
        dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
        self.codes = [cv2.aruco.generateImageMarker(dictionary, k, 6) > 0 for k in range(4)]
        self.sways = rng.uniform((0.7, 0), (4.5, 2 * math.pi), (12, 2))
        w, h = film.size
        self.focal = h / 2 / math.tan(math.radians(film.view) / 2)
        self.columns = np.arange(w, dtype=np.float32)[None]
        self.rows = np.arange(h, dtype=np.float32)[:, None]
        forward = -np.array(film.eye) / np.linalg.norm(film.eye)
        right = np.cross(forward, (0.0, 1.0, 0.0))
        right /= np.linalg.norm(right)
        self.axes = np.stack([right, np.cross(forward, right), forward])

    def _sway(self, k: int, t: np.ndarray) -> np.ndarray:
        """One of the ways in which a hand moves what it holds, about 1."""
        (f, a), (g, b) = self.sways[2 * k : 2 * k + 2]
        return (np.sin(2 * math.pi * f * t + a) + 0.5 * np.sin(2 * math.pi * 2 * g * t + b)) / 1.1

    def rays(self, t: np.ndarray, jitter: tuple[float, float]) -> tuple[list[np.ndarray], list[np.ndarray]]:
        """Origin (rows, 1) and direction (rows, columns) of the rays, by component, in the plate's frame."""
        film, (w, h) = self.film, self.film.size
        u = (self.columns + jitter[0] - (w - 1) / 2) / self.focal
        v = (self.rows + jitter[1] - (h - 1) / 2) / self.focal
        turn = [2 * film.shake * self._sway(k, t) for k in range(3)]
        # Small turns of the camera about its own axes.
        u, v, n = u - turn[2] * v + turn[1], v + turn[2] * u - turn[0], 1 - turn[1] * u + turn[0] * v
        d = [self.axes[0, i] * u + self.axes[1, i] * v + self.axes[2, i] * n for i in range(3)]
        o = [film.eye[i] + film.shake * self._sway(3 + i, t) for i in range(3)]
        tilt = math.radians(film.tilt) * np.sin(film.phase(t))
        o[0] = o[0] - film.stroke * np.sin(film.phase(t) + 0.8)
        c, s = np.cos(tilt), np.sin(tilt)
        o[2] = o[2] + film.bar_below
        o[1], o[2] = c * o[1] + s * o[2], -s * o[1] + c * o[2] - film.bar_below
        d[1], d[2] = c * d[1] + s * d[2], -s * d[1] + c * d[2]
        return [np.asarray(p, np.float32) for p in o], [np.asarray(p, np.float32) for p in d]

    def light(self, t: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Direction towards the lamp in the plate's frame."""
        tilt = math.radians(self.film.tilt) * np.sin(self.film.phase(t))
        x, y, z = -0.38, 0.30, 0.87
        return x + 0 * tilt, np.cos(tilt) * y + np.sin(tilt) * z, -np.sin(tilt) * y + np.cos(tilt) * z

    def shoot(self, t: np.ndarray, jitter: tuple[float, float]) -> np.ndarray:
        """(rows, columns, 3) picture whose rows are taken at the times t (rows, 1)."""
        film, (o, d) = self.film, self.rays(t, jitter)
        k = -o[2] / d[2]
        x, y = o[0] + k * d[0], o[1] + k * d[1]
        picture = np.empty((*x.shape, 3), np.float32)
        picture[...] = 92 + 9 * _looked_up(self.table, x / 0.5, y / 0.5)[..., None] + np.float32((2.0, 0.0, -4.0))
        picture[(np.abs(y) < 6e-3) & (x < -film.side / 2)] = (120, 122, 126)
        on_plate = np.nonzero((np.abs(x) < film.side / 2) & (np.abs(y) < film.side / 2))
        picture[on_plate] = self._lit_plate(x[on_plate], y[on_plate], [p[on_plate] for p in d], t[on_plate[0], 0])
        rim = film.radius * max(1, film.stretch) + 1.2 * self.top
        mx, my = film.middle(t)
        near = np.nonzero((x - mx) ** 2 + (y - my) ** 2 < rim**2)
        dz = d[2][near]
        seen, colour = self._object(x[near], y[near], d[0][near] / dz, d[1][near] / dz, t[near[0], 0])
        picture[near[0][seen], near[1][seen]] = colour
        if film.hand[0] <= float(t.mean()) <= film.hand[1]:
            self._paint_hand(picture, o, d)
        return picture

    @property
    def top(self) -> float:
        """Highest that the sheet reaches."""
        return self.film.thickness + self.film.dish + self.film.fold

    def _lit_plate(self, x: np.ndarray, y: np.ndarray, d: list[np.ndarray], t: np.ndarray) -> np.ndarray:
        film, lamp = self.film, self.light(t)
        shade = 0.35 + 0.65 * lamp[2] / 0.87
        # What lies between a point and the lamp, at a few heights.
        mx, my = film.middle(t)
        sheet = Sheet(film, t)
        near = np.nonzero((x - mx) ** 2 + (y - my) ** 2 < (film.radius * max(1, film.stretch) + self.top) ** 2)[0]
        sheet = sheet.at(near)
        sx, sy = (lamp[0] / lamp[2])[near], (lamp[1] / lamp[2])[near]
        dark = np.zeros(len(near), bool)
        for z in np.linspace(0.1, 0.95, 4, dtype=np.float32) * np.float32(self.top):
            dark |= sheet.holds(x[near] + sx * z, y[near] + sy * z, z)
        shade[near[dark]] *= 0.6
        norm = np.sqrt(d[0] ** 2 + d[1] ** 2 + d[2] ** 2)
        half = [lamp[i] - d[i] / norm for i in range(3)]
        gloss = PLATES[film.plate][2] * (half[2] / np.sqrt(half[0] ** 2 + half[1] ** 2 + half[2] ** 2)) ** 180
        return self._plate(x, y) * shade[:, None] + gloss[:, None]

    def _plate(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        film = self.film
        colour, grain, _ = PLATES[film.plate]
        waves = np.sin(y * 900 + 3 * _looked_up(self.table, x / 1.5, y / 0.2)) if film.plate == "wood" else 0.0
        out = np.array(colour, np.float32) + grain * (_looked_up(self.grain, x / 0.6, y / 0.05) + waves)[..., None]
        m, half = film.fiducial, film.side / 2
        for number, (sx, sy) in enumerate(((-1, 1), (1, 1), (1, -1), (-1, -1)) if m else ()):
            cx, cy = (s * (half - m / 6 - m / 2) for s in (sx, sy))
            column, row = (x - cx) / m * 6 + 3, 3 - (y - cy) / m * 6
            paper = (column > -1) & (column < 7) & (row > -1) & (row < 7)
            out[paper] = 240
            code = (column >= 0) & (column < 6) & (row >= 0) & (row < 6)
            white = self.codes[number][row[code].astype(int), column[code].astype(int)]
            out[code] = np.where(white, 240, 22)[:, None]
        return out

    def _object(self, x: np.ndarray, y: np.ndarray, sx: np.ndarray, sy: np.ndarray, t: np.ndarray) -> tuple:
        """Which rays meet the sheet, of those that would meet the plate at x, y, running by sx, sy per height."""
        film, sheet = self.film, Sheet(self.film, t)
        # The first depth inside, from above, and the last one before it; then between the two.
        slices = 12 if film.dish or film.fold else 5
        before, hit = np.full(x.shape, self.top * 1.001, np.float32), np.full(x.shape, np.nan, np.float32)
        for z in np.linspace(self.top, 0, slices, dtype=np.float32):
            hit[np.isnan(hit) & sheet.holds(x + z * sx, y + z * sy, z)] = z
            before[np.isnan(hit)] = z
        seen = np.nonzero(np.isfinite(hit))[0]
        sheet, x, y, sx, sy, hit, before = sheet.at(seen), *(p[seen] for p in (x, y, sx, sy, hit, before))
        for _ in range(5):
            z = (hit + before) / 2
            inside = sheet.holds(x + z * sx, y + z * sy, z)
            hit, before = np.where(inside, z, hit), np.where(inside, before, z)
        x, y = x + hit * sx, y + hit * sy
        u, v, below = sheet.within(x, y, hit)
        gx, gy = sheet.slopes(x, y)
        lx, ly, lz = self.light(t[seen])
        lit = np.clip((lz - gx * lx - gy * ly) / np.sqrt(1 + gx * gx + gy * gy), 0, None)
        side = below > 0.12 * film.thickness + 2e-4
        return seen, self._texture(u, v, side) * np.where(side, 0.55, 0.3 + 0.7 * lit / 0.87)[:, None]

    def _texture(self, u: np.ndarray, v: np.ndarray, side: np.ndarray) -> np.ndarray:
        film = self.film
        out = np.tile(np.array(film.colour, np.float32), (len(u), 1))
        if film.look in ("grain", "toppings"):
            strength = 0.10 if film.look == "grain" else 0.03
            out *= 1 + strength * _looked_up(self.grain, u / 0.25 + 0.5, v / 0.25 + 0.5)[:, None]
        if film.look == "toppings":
            for k, (a, b) in enumerate(self.toppings):
                size, colour = (5.2e-3, PEPPERONI) if k < 6 else (2.6e-3, OLIVE)
                out[((u - a) ** 2 + (v - b) ** 2 < size**2) & ~side] = colour
        if film.look == "markers":
            rim = 0.8 * film.radius
            long, square = (np.abs(u) < 6e-3) & (np.abs(v) < 3e-3), (np.abs(u - rim) < 3e-3) & (np.abs(v) < 3e-3)
            out[(long | square) & ~side] = MARKER
        return out

    def _paint_hand(self, picture: np.ndarray, o: list, d: list) -> None:
        """A forearm and a fist 35 mm above the plate."""
        k = (0.035 - o[2]) / d[2]
        x, y = o[0] + k * d[0], o[1] + k * d[1]
        along = np.clip(((x - 0.005) * 0.8 - (y - 0.01) * 0.6) / 0.2, 0, 1)
        away = np.hypot(x - 0.005 - 0.16 * along, y - 0.01 + 0.12 * along)
        arm = away < 0.024 + 0.006 * np.exp(-along * 10)
        picture[arm] = np.array(SKIN) * (1.05 - 0.5 * (away[arm] / 0.03) ** 2)[:, None]

    def pictures(self) -> Iterator[np.ndarray]:
        """(rows, columns, 3) pictures in bytes, red first."""
        film = self.film
        rng = np.random.default_rng(film.seed + 3)
        down = film.readout * (self.rows / (film.size[1] - 1) - 0.5)
        for k, time in enumerate(film.time):
            shots = [
                self.shoot(time + down + film.exposure * ((i + 0.5) / len(SUBSAMPLES) - 0.5), jitter)
                for i, jitter in enumerate(SUBSAMPLES)
            ]
            gain = 1 + film.flicker * math.sin(2.1 * time + 0.05 * k)
            mean = gain * sum(np.clip(s, 0, 255) for s in shots) / len(shots)
            noise = film.noise * rng.standard_normal(mean.shape, np.float32)
            yield np.clip(mean + noise, 0, 255).astype(np.uint8)


def _looked_up(table: np.ndarray, u: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Nearest values of a table that repeats itself, at shares of its width."""
    n = len(table)
    return table[(v * n).astype(np.int32) & (n - 1), (u * n).astype(np.int32) & (n - 1)]


# A tree of macroblocks, x264's default, changes the file's bits from run to run, and so does the number of cores.
OPTIONS = {"crf": "20", "preset": "veryfast", "threads": "2", "x264-params": "mbtree=0"}


def shot(
    film: Film, path: Path, turned: bool = False, change: Callable[[np.ndarray], np.ndarray] | None = None
) -> Path:
    """Write a film as a phone would: H.264 with a time stamp for each frame.

    Parameters
    ----------
    turned : bool
        Whether the phone was held upright: pictures are stored lying, with a note that they are to be turned.
    change : callable, optional
        Done to each picture, red first, before it is stored.
    """
    with av.open(str(path), "w") as container:
        stream = container.add_stream("libx264", rate=Fraction(film.fps).limit_denominator(1001))
        width, height = film.size
        stream.width, stream.height = (height, width) if turned else (width, height)
        stream.pix_fmt, stream.options = "yuv420p", dict(OPTIONS)
        stream.codec_context.time_base = Fraction(1, 90000)
        for picture, time in zip(Caster(film).pictures(), film.time, strict=True):
            picture = picture if change is None else change(picture)
            stored = np.ascontiguousarray(np.rot90(picture) if turned else picture)
            frame = av.VideoFrame.from_ndarray(stored, format="rgb24")
            stamp = round(time / film.stamps) * film.stamps
            frame.pts, frame.time_base = round(stamp * 90000), Fraction(1, 90000)
            container.mux(stream.encode(frame))
        container.mux(stream.encode(None))
    if turned:
        _note_turn(path)
    return path


def _note_turn(path: Path) -> None:
    """Write into an MP4's track header that its pictures are to be turned clockwise by a quarter."""
    content = bytearray(path.read_bytes())
    at = content.index(b"tkhd") + 4 + 40
    matrix = np.array([0, 1 << 16, 0, -(1 << 16), 0, 0, 0, 0, 1 << 30], ">i4")
    content[at : at + 36] = matrix.tobytes()
    path.write_bytes(content)
