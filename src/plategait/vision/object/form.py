"""What the edge of an object over a clip tells of it: its outline, radius and area, and how its rim lifts.

The edge is seen where lines of sight over it meet the plate's plane. A point at a height z is seen away from where it
is, outwards from below the camera, by z times the slope of its line of sight: so thickness makes an object larger, and
a rim that lifts with the plate's swing moves to and fro. Shape turns with the object, thickness stays towards the
camera, lift repeats with the swing: one fit parts them (Gauss-Newton with what is usual as a prior).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from plategait.arrays import Array
from plategait.vision.object.rim import DIRECTIONS, RAYS

# Harmonics of the outline, of the lift around the object, and of the plate's swing.
OUTLINE, AROUND, SWINGS = 8, 3, 2
# What is usual, as shares of the radius: how far an outline is from a circle, a rim lifts, an object is thick.
USUAL_SHAPE, USUAL_LIFT, USUAL_THICKNESS = 0.15, 0.15, (0.06, 0.08)
# Frames that a fit uses, and the fewest.
MOST_FRAMES, FEWEST_FRAMES = 240, 12
# Residuals that count less, and those that count for nothing, as of a hand's edge, over the usual ones.
ROUNDS, HUBER, GROSS = 8, 4.0, 10.0
# Steps of the unknowns, in their standard deviations were all others known, that end the rounds.
SETTLED = 0.02
# Neighbouring rays and frames err alike: so many count as one.
ALIKE = 6
# What an edge's place is known to in all rays alike, px, and lengths on the plate, as a share.
EDGE, SCALE = 0.12, 2e-3
# What the thickness is known to: m, and as a share of it.
THICKNESS = (3e-4, 0.3)
# What of the shortening of a bent sheet is not known.
BENT = 0.05
DRAWS = 200
PHASES = 2 * math.pi * np.arange(24) / 24
# A camera of unknown place stands far above, m, and thickness makes the radius uncertain by this share.
FAR, BLIND = 1e3, 0.015
# Widest gap between the phases of the swing that frames show, rad, and least slope of the lines of sight at which a
# lift shows.
MOST_PHASE_GAP, LEAST_SLANT = math.radians(100), 0.25
# What shade at the edge, which swings with the light, does to a lift: pixels of the picture, and shares of the
# thickness and of the lift itself.
LIFT_PIXELS, LIFT_THICKNESS, LIFT_SHARE = 0.4, 0.25, 0.04


@dataclass(frozen=True, eq=False)
class Form:
    """An object's outline and how its rim lifts.

    Attributes
    ----------
    outline : (RAYS,) array
        Distance of the edge from the middle, m, by angle from the object's orientation, counter-clockwise.
    radius, radius_sd : float
        Of a circle with its area, m, and its standard deviation.
    thickness : float
        As far as it shows, m.
    middle : (n, 2) array
        Of the outline in each frame, freed of thickness, m.
    lift : (phases, RAYS) array
        Height of the rim over the middle in the plate's frame, m, over a period of the swing; empty where unknown.
    rim_lift, rim_lift_sd : float
        Greatest height of the rim over the plate, m; NaN where it does not show.
    lift_unknown : str
        Why it does not; empty where it does.
    """

    outline: Array
    radius: float
    radius_sd: float
    thickness: float
    middle: Array
    lift: Array
    rim_lift: float
    rim_lift_sd: float
    lift_unknown: str = ""

    @property
    def area(self) -> float:
        """m²."""
        return math.pi * self.radius**2

    @property
    def area_sd(self) -> float:
        """Its standard deviation, m²."""
        return 2 * math.pi * self.radius * self.radius_sd


def fit_form(
    angle: Array, seen: Array, rims: Array, eye: Array | None, phase: Array | None, pixel: float, *, marked: bool
) -> Form | None:
    """Outline, size and lift of an object from its edge in many frames; None where the edge was hardly seen.

    Parameters
    ----------
    angle : (n,) array
        Orientation, rad.
    seen : (n, 2) array
        Where the rays begin, m.
    rims : (n, RAYS) array
        Distances of the edge from there, m; NaN where it was not seen.
    eye : (n, 3) array, optional
        Of the camera in the plate's frame, m; without it thickness and lift cannot be told.
    phase : (n,) array, optional
        Of the plate's swing, rad, up to whole turns; without it no lift is looked for.
    pixel : float
        m on the plate.
    marked : bool
        Whether the rays begin at a mark on the object rather than in the middle of what is seen of it.
    """
    blind = eye is None or not np.isfinite(eye).all(axis=1).any()
    eye = np.broadcast_to([0.0, 0.0, FAR], (len(seen), 3)) if eye is None or blind else eye
    usable = np.isfinite(rims).mean(axis=1) > 0.6
    usable &= np.isfinite(angle) & np.isfinite(seen).all(axis=1) & np.isfinite(eye).all(axis=1)
    chosen = np.nonzero(usable)[0]
    if len(chosen) < FEWEST_FRAMES:
        return None
    if len(chosen) > MOST_FRAMES:
        chosen = chosen[np.linspace(0, len(chosen) - 1, MOST_FRAMES).astype(int)]
    slant = math.nan if blind else _slant(seen[chosen], eye[chosen])
    unknown = _why_no_lift(phase if phase is None else phase[chosen], marked, slant)
    waves = np.zeros((len(chosen), 0)) if unknown or phase is None else _harmonics(phase[chosen], SWINGS)[:, 1:]
    size = float(np.nanmedian(rims[chosen]))
    model = _Model(angle[chosen], seen[chosen], eye[chosen], waves, marked)
    model.outline[0] = size
    prior_mean, prior_sd = _usual(model, size)
    model.thickness = float(prior_mean[len(model.outline)])
    covariance = _solve(model, rims[chosen], prior_mean, prior_sd)
    form = _form(model, covariance, pixel, unknown)
    return replace(form, radius_sd=math.hypot(form.radius_sd, BLIND * form.radius)) if blind else form


def _slant(seen: Array, eye: Array) -> float:
    """Slope of the lines of sight, over the plate's normal."""
    return float(np.median(np.linalg.norm(seen - eye[:, :2], axis=1) / eye[:, 2]))


def _why_no_lift(phase: Array | None, marked: bool, slant: float) -> str:
    """Why a lift does not show; empty where it may."""
    if math.isnan(slant):
        return "the camera's place is unknown: a plate that tilts by some degrees shows it, or --calibration does"
    if slant < LEAST_SLANT:
        return "the camera looks down too straight: what is lifted hardly moves in the picture"
    if not marked:
        return "without a mark in its middle, a rim that lifts alike all around looks like an object that moves"
    if phase is None:
        return "the plate's frequency is unknown"
    turns = np.sort(phase % (2 * math.pi))
    if np.diff(turns, append=turns[0] + 2 * math.pi).max() > MOST_PHASE_GAP:
        return "the frames show only a part of the plate's swing, as its frequency is near a multiple of their rate"
    return ""


def _usual(model: _Model, size: float) -> tuple[Array, Array]:
    """Mean and standard deviation of each unknown, as far as it is known beforehand."""
    shape = [10 * size] + [USUAL_SHAPE * size / k for k in range(1, OUTLINE + 1) for _ in range(2)]
    if not model.marked:
        shape[1:3] = [1e-9, 1e-9]  # the middle of what is seen is the object's
    orders = np.array([0.0, *(k for k in range(1, AROUND + 1) for _ in range(2))])
    swings = np.array([float(k) for k in range(1, SWINGS + 1) for _ in range(2)][: model.waves.shape[1]])
    lift = USUAL_LIFT * size / ((1 + orders[:, None]) * swings[None]).ravel()
    mean = np.zeros(len(model.unknowns))
    mean[0], mean[len(shape)] = size, USUAL_THICKNESS[0] * size
    return mean, np.concatenate([shape, [USUAL_THICKNESS[1] * size], lift])


def _solve(model: _Model, rims: Array, mean: Array, sd: Array) -> Array:
    """Fit the model; gives the covariance of its unknowns."""
    n = len(mean)
    seen = np.isfinite(rims)
    weight = seen.astype(float)
    normal, noise = np.eye(n), 1.0
    moved, along = np.zeros_like(model.seen), np.zeros((*model.seen.shape, n))
    for _ in range(ROUNDS):
        edge, rows = model.expected()
        residual = np.where(seen, rims - edge, 0.0)
        root = np.sqrt(weight)
        rows, data = rows * root[..., None], residual * root
        places, rows = rows[..., n:], rows[..., :n]
        if not model.marked:
            # What moves the whole object tells nothing of its form.
            gram = np.linalg.pinv(np.einsum("ijk,ijl->ikl", places, places))
            moved = np.einsum("ikl,ijl,ij->ik", gram, places, data)
            along = np.einsum("ikl,ijl,ijm->ikm", gram, places, rows)
            data = data - np.einsum("ijk,ik->ij", places, moved)
            rows = rows - np.einsum("ijk,ikm->ijm", places, along)
        flat, values = rows.reshape(-1, n), data.ravel()
        noise = max(1.48 * float(np.median(np.abs(residual[seen]))), 1e-5)
        normal = flat.T @ flat / (ALIKE * noise**2) + np.diag(sd**-2.0)
        step = np.linalg.solve(normal, flat.T @ values / (ALIKE * noise**2) + (mean - model.unknowns) / sd**2)
        if not model.marked:
            model.shift = model.shift + moved - np.einsum("ikm,m->ik", along, step)
        model.unknowns = model.unknowns + step
        if (np.abs(step) < SETTLED / np.sqrt(np.diag(normal))).all():
            break
        off = np.abs(residual) / noise
        weight = seen * (off < GROSS) * np.minimum(1.0, HUBER / np.maximum(off, 1e-9))
    return np.asarray(np.linalg.inv(normal), dtype=float)


def _form(model: _Model, covariance: Array, pixel: float, unknown: str) -> Form:
    """What the fitted model says."""
    outline = _harmonics(DIRECTIONS, OUTLINE) @ model.outline
    radius = math.sqrt(float(np.mean(outline**2)))
    slope = _harmonics(DIRECTIONS, OUTLINE).T @ outline / (RAYS * radius)
    size = slope @ covariance[: len(slope), : len(slope)] @ slope
    # The upper edge is nearer to the camera, and larger by as much.
    nearer = radius * (THICKNESS[0] + THICKNESS[1] * model.thickness) / float(np.median(model.eye[:, 2]))
    radius_sd = math.sqrt(float(size) + (EDGE * pixel) ** 2 + (SCALE * radius) ** 2 + nearer**2)
    if unknown:
        return Form(outline, radius, radius_sd, model.thickness, model.place(), np.zeros((0, RAYS)), math.nan,
                    math.nan, unknown)  # fmt: skip
    draws = np.random.default_rng(0).multivariate_normal(
        model.lift, covariance[-len(model.lift) :, -len(model.lift) :], DRAWS
    )
    phases = _harmonics(PHASES, SWINGS)[:, 1:]
    shapes = _harmonics(DIRECTIONS, AROUND)
    heights = [
        np.einsum("pw,as,sw->pa", phases, shapes, lift.reshape(shapes.shape[1], -1)) for lift in (model.lift, *draws)
    ]
    # What does not move with the swing may as well be thickness, or shade at the edge.
    greatest = [float(np.ptp(h, axis=0).max()) for h in heights]
    lift, scatter = greatest[0], float(np.std(greatest[1:]))
    shade = LIFT_PIXELS * pixel / _slant(model.seen, model.eye)
    thick = LIFT_THICKNESS * max(model.thickness, USUAL_THICKNESS[0] * radius)
    sd = math.sqrt(scatter**2 + shade**2 + thick**2 + (LIFT_SHARE * lift) ** 2)
    # The greatest of many heights with errors is too great: a flat sheet seems to lift by about as much as they are.
    lift = math.sqrt(max(lift**2 - scatter**2 - shade**2 - thick**2, 0.0))
    shorter = BENT * 2 * lift**2 / (3 * radius)
    radius_sd = math.hypot(radius_sd, shorter)
    return Form(outline, radius, radius_sd, model.thickness, model.place(), heights[0], lift, sd, unknown)


@dataclass(eq=False)
class _Model:
    """The edge as it should be seen, from what is unknown: outline, thickness, lift, and places in the frames.

    Attributes
    ----------
    angle : (n,) array
    seen : (n, 2) array
        Where the rays begin.
    eye : (n, 3) array
    waves : (n, w) array
        Of the swing in each frame.
    marked : bool
        Whether the rays begin at a point of the object's upper side.
    """

    angle: Array
    seen: Array
    eye: Array
    waves: Array
    marked: bool

    def __post_init__(self) -> None:
        self.outline = np.zeros(2 * OUTLINE + 1)
        self.thickness = 0.0
        self.lift = np.zeros((2 * AROUND + 1) * self.waves.shape[1])
        self.shift = np.zeros_like(self.seen)

    @property
    def unknowns(self) -> Array:
        return np.concatenate([self.outline, [self.thickness], self.lift])

    @unknowns.setter
    def unknowns(self, values: Array) -> None:
        n = len(self.outline)
        self.outline, self.thickness, self.lift = values[:n], max(float(values[n]), 0.0), values[n + 1 :]

    def height(self, around: Array) -> Array:
        """Of the rim over its lowest place in a period, at directions (n, k) in the plate's frame, m."""
        return self._lifting(around) @ self.lift if len(self.lift) else np.zeros_like(around)

    def _lifting(self, around: Array) -> Array:
        """(n, k, …) what each unknown of the lift does to the height."""
        shapes = _harmonics(around, AROUND)
        waves = self.waves[:, None] + np.zeros((1, around.shape[1], 1))
        if self.lift.any():
            each = _harmonics(PHASES, SWINGS)[:, 1:]
            lowest = np.argmin(shapes @ self.lift.reshape(shapes.shape[-1], -1) @ each.T, axis=-1)
            waves = waves - each[lowest]
        return (shapes[..., :, None] * waves[..., None, :]).reshape(*around.shape, -1)

    def expected(self) -> tuple[Array, Array]:
        """Distance of the edge along each ray (n, RAYS), and what each unknown does to it (n, RAYS, …).

        The places' unknowns come last: two, the same in each frame.
        """
        psi = np.broadcast_to(DIRECTIONS, (len(self.angle), RAYS))
        towards = np.stack([np.cos(psi), np.sin(psi)], axis=-1)
        middle, eye = self.place()[:, None], self.eye[:, None, :2]
        far = self.eye[:, None, 2]
        h = self.height(psi)
        radius = _harmonics(psi - self.angle[:, None], OUTLINE) @ self.outline
        # A sheet that bends is shorter seen from above: by a parabola's length.
        at = middle + (radius - 2 * h**2 / (3 * np.maximum(radius, 1e-6)))[..., None] * towards
        back = np.sum((at - eye) * towards, axis=-1) > 0
        z = h + self.thickness * back
        seen = eye + (at - eye) * (far / (far - z))[..., None] - self.seen[:, None]
        direction, distance = (
            np.unwrap(np.arctan2(seen[..., 1], seen[..., 0]), axis=1),
            np.hypot(*np.moveaxis(seen, -1, 0)),
        )
        source, edge = np.empty_like(distance), np.empty_like(distance)
        for i in range(len(distance)):
            turned = direction[i] - 2 * math.pi * np.round((direction[i] - psi[i]).mean() / (2 * math.pi))
            source[i] = DIRECTIONS + np.interp(DIRECTIONS, turned, psi[i] - turned, period=2 * math.pi)
            edge[i] = np.interp(DIRECTIONS, turned, distance[i], period=2 * math.pi)
        slope = (np.roll(edge, -1, axis=1) - np.roll(edge, 1, axis=1)) / (2 * DIRECTIONS[1]) / edge
        aside = np.stack([-towards[..., 1], towards[..., 0]], axis=-1)
        normal = towards - np.clip(slope, -1, 1)[..., None] * aside
        sight = (self.seen[:, None] + edge[..., None] * towards - eye) / far[..., None]
        across = np.sum(sight * normal, axis=-1)
        thick = np.maximum(across, 0)
        if self.marked:
            thick = thick - np.sum((self.seen - self.eye[:, :2])[:, None] / far[..., None] * normal, axis=-1)
        rows = [_harmonics(source - self.angle[:, None], OUTLINE), thick[..., None]]
        if len(self.lift):
            lifting = self._lifting(source)
            shorter = 4 * (lifting @ self.lift) / (3 * np.maximum(edge, 1e-6))
            rows.append((across - shorter)[..., None] * lifting)
        return edge, np.concatenate([*rows, normal], axis=-1)

    def place(self) -> Array:
        """(n, 2) middle of the object on the plate, m."""
        if not self.marked:
            return self.seen + self.shift
        low = (self.eye[:, 2:] - self.thickness) / self.eye[:, 2:]
        return self.eye[:, :2] + (self.seen - self.eye[:, :2]) * low


def _harmonics(angle: Array, orders: int) -> Array:
    """(…, 2 orders + 1) constant, cosines and sines."""
    waves = [np.ones_like(angle)]
    waves += [f(k * angle) for k in range(1, orders + 1) for f in (np.cos, np.sin)]
    return np.stack(waves, axis=-1)
