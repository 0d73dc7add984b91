"""What was seen of the drone while a person carried it, and one sample of where it lies."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from math import atan2, cos, dist, inf, sin
from statistics import median
from typing import TypeVar

from housefly.geometry import Vec3
from housefly.lab.frames.plan import CarryStep
from housefly.numeric import wrapped

Point = TypeVar("Point", "TrackedPoint", "OnboardPoint")

STILL_TIME = 0.8
"""A sample is what was seen in this time before it [s]."""
SEEN_AGE_MAX = 0.4
"""A body whose newest pose is older than this is not seen [s]."""
_FEWEST_POSES = 4
STILL_DISTANCE, STILL_ANGLE = 0.06, 0.15
"""A drone that lies, or is held still, stays within this of its middle [m], [rad]."""


@dataclass(frozen=True, slots=True)
class TrackedPoint:
    """A body seen once: capture time [s], position [m] and heading [rad] on the map."""

    at: float
    position: Vec3
    yaw: float


@dataclass(frozen=True, slots=True)
class OnboardPoint:
    """One report of the drone: arrival [s], heading since its start [rad], height [m]."""

    at: float
    psi: float
    height: float


@dataclass(frozen=True, slots=True)
class CarryTrack:
    """All that was seen in one step.

    Attributes:
        bodies: poses by the name of the body, oldest first.
        onboard: reports of the drone, oldest first; empty where it does not answer.
        heard_at: when the last frame of the tracking system arrived, whatever it showed [s].
    """

    bodies: dict[str, tuple[TrackedPoint, ...]] = field(default_factory=dict)
    onboard: tuple[OnboardPoint, ...] = ()
    heard_at: float = inf


@dataclass(frozen=True, slots=True)
class FrameSample:
    """Where the drone lay at the end of a step.

    Attributes:
        step: which.
        position: by tracking [m]; None while the body is not seen at all.
        yaw: by tracking [rad].
        psi: by the drone's own report [rad], None where it does not answer.
        height: likewise [m].
        others: where the other bodies were [m].
    """

    step: CarryStep
    position: Vec3 | None
    yaw: float = 0.0
    psi: float | None = None
    height: float | None = None
    others: tuple[tuple[str, Vec3], ...] = ()


@dataclass(frozen=True, slots=True)
class NoSample:
    """Why there is no sample, and what to do, in words.

    Attributes:
        words: for the person.
        unseen: the body is not seen, rather than moving.
    """

    words: str
    unseen: bool = False


def unseen_sample(step: CarryStep, body: str, track: CarryTrack, now: float) -> FrameSample:
    """Return the sample of a step in which the drone's body is not seen."""
    own = _newest(track.onboard, now)
    bodies = {name: _newest(points, now) for name, points in track.bodies.items()}
    return FrameSample(
        step,
        None,
        psi=middle_angle([point.psi for point in own]) if own else None,
        height=median(point.height for point in own) if own else None,
        others=tuple(
            (name, _middle(points)) for name, points in bodies.items() if points and name != body
        ),
    )


def take_sample(
    step: CarryStep, body: str, track: CarryTrack, now: float
) -> FrameSample | NoSample:
    """Return where a body is, or why that cannot be said.

    Args:
        step: that ends now.
        body: name of the drone's body.
        track: what was seen.
        now: same clock as the capture times [s].
    """
    bare = unseen_sample(step, body, track, now)
    if now - track.heard_at > SEEN_AGE_MAX:
        return NoSample(
            f"Tracking is silent for {now - track.heard_at:.1f} s: it has stopped, or the network"
            " or this computer is too slow. Press Enter again when it is back."
        )
    seen = _newest(track.bodies.get(body, ()), now)
    if len(seen) < _FEWEST_POSES or now - seen[-1].at > SEEN_AGE_MAX:
        return NoSample(_unseen_words(body, track, now, bare.others), unseen=True)
    position, yaw = _middle(seen), middle_angle([point.yaw for point in seen])
    if any(_is_off(point, position, yaw) for point in seen):
        return NoSample("It still moves: lay it down, or hold it still for a second.")
    return replace(bare, position=position, yaw=yaw)


def middle_angle(angles: Sequence[float]) -> float:
    """Return the mean direction of angles [rad]."""
    return atan2(sum(map(sin, angles)), sum(map(cos, angles)))


def _newest(points: tuple[Point, ...], now: float) -> tuple[Point, ...]:
    return tuple(point for point in points if point.at >= now - STILL_TIME)


def _middle(points: Iterable[TrackedPoint]) -> Vec3:
    x, y, z = (median(values) for values in zip(*(point.position for point in points), strict=True))
    return x, y, z


def _is_off(point: TrackedPoint, position: Vec3, yaw: float) -> bool:
    far = dist(point.position, position) > STILL_DISTANCE
    return far or abs(wrapped(point.yaw - yaw)) > STILL_ANGLE


def _unseen_words(
    body: str, track: CarryTrack, now: float, others: tuple[tuple[str, Vec3], ...]
) -> str:
    points = track.bodies.get(body, ())
    when = f"for {now - points[-1].at:.1f} s" if points else "at all"
    names = ", ".join(repr(name) for name, _ in others)
    hint = f"It sees {names}." if names else "It sees no body."
    return (
        f"Tracking does not see {body!r} {when}. {hint} Turn it so that the cameras see its"
        " markers, and keep your hands off them."
    )
