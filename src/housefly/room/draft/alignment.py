"""The frame of a tracking system against the map, from points whose place on both is known.

A motion capture frame is level, so what is sought is a turn about z and a shift.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, degrees, hypot, sin

import numpy as np

from housefly.errors import ConfigError
from housefly.messages.words import Words, figure, joined
from housefly.numeric import FloatArray
from housefly.room.draft.model import FramePoint

APART_MIN = 0.5
"""Points nearer to each other than this say nothing about the turn [m]."""
RESIDUAL_MAX = 0.05
"""A point that fits worse than this was put or measured wrongly [m]."""
SCALE_RANGE = (0.95, 1.05)
_MIRROR_GAIN = 0.3
"""Mirrored when the mirrored fit leaves less than this share of the residual."""


@dataclass(frozen=True, slots=True)
class RigidFit:
    """Where a tracking frame is on the map, by least squares.

    Attributes:
        x, y, z: its origin [m]: the keys of ``[tracking]``.
        yaw: heading of its x axis [rad].
        residuals: how far each point is seen from where it is, over the floor and in height [m].
        scale: how long tracking sees a metre [1].
        is_mirrored: whether the points fit much better with one axis turned round.
        width: how far the points reach across their longest line [m].
    """

    x: float
    y: float
    z: float
    yaw: float
    residuals: tuple[float, ...]
    scale: float
    is_mirrored: bool
    width: float

    @property
    def is_trusted(self) -> bool:
        """Whether nothing speaks against it."""
        low, high = SCALE_RANGE
        fits = max(self.residuals) <= RESIDUAL_MAX
        return fits and low <= self.scale <= high and not self.is_mirrored


def rigid_fit(points: tuple[FramePoint, ...]) -> RigidFit:
    """Return the turn and shift that bring what tracking sees onto the map.

    Args:
        points: two at least, three to see whether they agree; far from each other.

    Raises:
        ConfigError: there are too few, or they are too near each other.
    """
    if len(points) < 2:
        raise ConfigError("frame_points", Words("two points are needed, and a third to check them"))
    on_map = np.array([point.on_map for point in points])
    seen = np.array([point.seen for point in points])
    for what, where in (
        (Words("on the map"), on_map),
        (Words("as tracking sees them"), seen),
    ):
        away = np.ptp(where[:, :2], axis=0)
        if hypot(*away) < APART_MIN:
            raise ConfigError(
                "frame_points",
                Words(
                    "the points are within {a} m of each other {what}; take points that are {b} m"
                    " and more apart, better several metres",
                    a=figure(hypot(*away), ".2f"),
                    what=what,
                    b=figure(APART_MIN, "g"),
                ),
            )
    middle_on_map, middle_seen = on_map.mean(axis=0), seen.mean(axis=0)
    a, b = (seen - middle_seen)[:, :2], (on_map - middle_on_map)[:, :2]
    yaw, left = _turn(a, b)
    _, left_mirrored = _turn(a * (1.0, -1.0), b)
    x, y = middle_on_map[:2] - _rotation(yaw) @ middle_seen[:2]
    z = middle_on_map[2] - middle_seen[2]
    moved = np.column_stack([seen[:, :2] @ _rotation(yaw).T + (x, y), seen[:, 2] + z])
    residuals = np.linalg.norm(moved - on_map, axis=1)
    width = _width(b)
    return RigidFit(
        x=round(float(x), 4),
        y=round(float(y), 4),
        z=round(float(z), 4),
        yaw=round(yaw, 5),
        residuals=tuple(round(float(value), 4) for value in residuals),
        scale=round(float(np.sqrt((a**2).sum() / (b**2).sum())), 4),
        # Of points that are nearly on one line, noise alone may look like a mirror.
        is_mirrored=width >= APART_MIN and left_mirrored < _MIRROR_GAIN * left - 1e-4,
        width=width,
    )


def _width(centred: FloatArray) -> float:
    """Return how far points reach across the direction in which they reach farthest [m]."""
    _, _, axes = np.linalg.svd(centred, full_matrices=True)
    return float(np.ptp(centred @ axes[1]))


def _turn(a: FloatArray, b: FloatArray) -> tuple[float, float]:
    """Return the angle [rad] that turns rows of a onto b best, and the sum of squares left."""
    cross = float((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum())
    dot = float((a * b).sum())
    angle = atan2(cross, dot)
    return angle, float(((a @ _rotation(angle).T - b) ** 2).sum())


def _rotation(angle: float) -> FloatArray:
    return np.array([[cos(angle), -sin(angle)], [sin(angle), cos(angle)]])


def fit_words(fit: RigidFit, points: tuple[FramePoint, ...]) -> tuple[Words, ...]:
    """Return what was found, and how well each point fits; then the doubts."""
    left_over = (
        Words("{name} {n} cm", name=point.name, n=figure(100 * left, ".1f"))
        for point, left in zip(points, fit.residuals, strict=True)
    )
    return (
        Words(
            "the tracking frame has its origin at ({x}, {y}, {z}) m on the map, turned by {a} deg",
            x=figure(fit.x, ".3f"),
            y=figure(fit.y, ".3f"),
            z=figure(fit.z, ".3f"),
            a=figure(degrees(fit.yaw), "+.1f"),
        ),
        Words("left over: {names}", names=joined(", ", left_over)),
        *fit_doubts(fit, points),
    )


def fit_doubts(fit: RigidFit, points: tuple[FramePoint, ...]) -> tuple[Words, ...]:
    """Return what speaks against a fit, and what nothing could show."""
    words = []
    if fit.is_mirrored:
        words.append(
            Words(
                "the points fit as in a mirror: two were exchanged, or the tracking system counts"
                " one axis the other way; take them again in the right order, or choose z up,"
                " right-handed, in its software"
            )
        )
    elif not SCALE_RANGE[0] <= fit.scale <= SCALE_RANGE[1]:
        words.append(
            Words(
                "tracking sees a metre as {a} m: measure the points again; if it comes again,"
                " calibrate the cameras or set metres in the tracking software",
                a=figure(fit.scale, ".4g"),
            )
        )
    elif max(fit.residuals) > RESIDUAL_MAX:
        worst = max(range(len(points)), key=fit.residuals.__getitem__)
        words.append(
            Words(
                "the points do not agree to {n} cm, {name} worst: put the drone there again and"
                " measure, or measure its place on the map again",
                n=figure(100 * RESIDUAL_MAX, ".0f"),
                name=points[worst].name,
            )
        )
    elif len(points) > 2 and fit.width < APART_MIN:
        words.append(
            Words(
                "the points lie on one line: an axis that is counted the other way would not show;"
                " take one more beside it"
            )
        )
    if len(points) < 3:
        words.append(Words("two points cannot check each other: take a third"))
    return tuple(words)
