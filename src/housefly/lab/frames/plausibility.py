"""What a clumsy person, or tracking that lies, makes of one step; asked before it is believed."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from itertools import pairwise
from math import atan2, degrees, dist, hypot, inf, pi, radians

from housefly.geometry import Vec3
from housefly.lab.frames.plan import LIFT_HEIGHT, CarryPlan, CarryStep
from housefly.lab.frames.samples import CarryTrack, FrameSample, TrackedPoint
from housefly.numeric import wrapped

ANGLE_DOUBT = radians(25.0)
"""A way, or a nose, farther off than this is asked about [rad]."""
PLACE_DOUBT = 0.3
"""A place farther off than this is asked about [m]."""
LENGTH_DOUBT = (0.7, 1.4)
"""A way that is seen shorter or longer than this share of its length is asked about."""
LIFT_DOUBT = (0.25, 0.9)
CARRY_SPEED_MAX = 2.5
"""Faster than this tracking may lose or exchange it [m/s]."""
TURN_RATE_MAX = radians(200.0)
LOST_TIME_MAX = 0.7
"""A longer hole in tracking is asked about [s]."""


class CheckKind(Enum):
    """What is asked about; a person who stands by it is not asked about it again."""

    PAD_PLACE = "place on the pad"
    PAD_NOSE = "nose on the pad"
    LENGTH = "length of a way"
    WAY = "direction of a way"
    NOSE = "turned on a way"
    LIFT = "lift"
    TURN = "turn"
    SPOT = "place of the turn"
    BACK_PLACE = "place when back"
    BACK_NOSE = "nose when back"
    LOST = "lost on the way"
    FAST = "moved too fast"


@dataclass(frozen=True, slots=True)
class FailedCheck:
    """What may be wrong with a step, in words."""

    kind: CheckKind
    words: str


def failed_checks(
    plan: CarryPlan,
    before: tuple[FrameSample, ...],
    sample: FrameSample,
    track: CarryTrack,
    body: str,
) -> tuple[FailedCheck, ...]:
    """Return what may be wrong with a step, the gravest first.

    Args:
        plan: what was asked.
        before: the samples of the steps before.
        sample: of this step.
        track: what was seen in it.
        body: name of the drone's body.
    """
    if sample.position is None or any(past.position is None for past in before):
        return ()
    found = [*_way_doubts(track.bodies.get(body, ()), sample.step)]
    if sample.step is CarryStep.PAD:
        found += _pad_doubts(plan, sample)
    elif sample.step is CarryStep.BACK:
        found += _back_doubts(before[0], sample)
    elif sample.step is CarryStep.TURN:
        found += _turn_doubts(before[-1], sample)
    else:
        found += _leg_doubts(plan, before[-1], sample)
    return tuple(found)


def _way_doubts(points: tuple[TrackedPoint, ...], step: CarryStep) -> list[FailedCheck]:
    """Return what failed about how it was carried."""
    found = []
    gap = max((b.at - a.at for a, b in pairwise(points)), default=0.0)
    if gap > LOST_TIME_MAX:
        found.append(
            FailedCheck(
                CheckKind.LOST,
                f"Tracking lost it for {gap:.1f} s on the way. Do this step again, slowly, with"
                " its markers free",
            )
        )
    speed, rate = _fastest(points)
    if speed > CARRY_SPEED_MAX or (step is CarryStep.TURN and rate > TURN_RATE_MAX):
        how = f"{speed:.1f} m/s" if speed > CARRY_SPEED_MAX else f"{degrees(rate):.0f} deg/s"
        found.append(
            FailedCheck(
                CheckKind.FAST, f"It was moved too fast ({how}). Do this step again, slowly"
            )
        )
    return found


def _fastest(points: tuple[TrackedPoint, ...]) -> tuple[float, float]:
    """Return the largest speed [m/s] and turn rate [rad/s], each over a fifth of a second."""
    speed, rate, first = 0.0, 0.0, 0
    for point in points:
        while points[first].at < point.at - 0.2:
            first += 1
        start = points[max(first - 1, 0)]
        seconds = point.at - start.at
        if 0.15 < seconds < LOST_TIME_MAX:
            speed = max(speed, dist(point.position, start.position) / seconds)
            rate = max(rate, abs(wrapped(point.yaw - start.yaw)) / seconds)
    return speed, rate


def _pad_doubts(plan: CarryPlan, sample: FrameSample) -> list[FailedCheck]:
    found, position = [], _position(sample)
    off = dist(position[:2], plan.home)
    if off > PLACE_DOUBT:
        found.append(
            FailedCheck(
                CheckKind.PAD_PLACE,
                f"Tracking sees it {off:.2f} m beside the pad of the map, at"
                f" ({position[0]:.2f}, {position[1]:.2f}) m instead of ({plan.home[0]:.2f},"
                f" {plan.home[1]:.2f}) m. Does it lie on the middle of its pad?",
            )
        )
    angle = wrapped(sample.yaw - plan.heading)
    if abs(angle) > ANGLE_DOUBT:
        found.append(
            FailedCheck(
                CheckKind.PAD_NOSE,
                f"Tracking sees its nose {turned_words(angle)} of the pad's heading. Does its nose"
                " point along it?",
            )
        )
    return found


def _leg_doubts(plan: CarryPlan, last: FrameSample, sample: FrameSample) -> list[FailedCheck]:
    asked = plan.displacement(sample.step)
    x, y, z = seen = _between(last, sample)
    found = _unasked_turn(last, sample)
    if sample.step is CarryStep.LIFT:
        if not LIFT_DOUBT[0] <= z <= LIFT_DOUBT[1] or hypot(x, y) > PLACE_DOUBT:
            found.append(
                FailedCheck(
                    CheckKind.LIFT,
                    f"Tracking sees it {z:.2f} m higher and {hypot(x, y):.2f} m aside; asked was"
                    f" {LIFT_HEIGHT:g} m straight up",
                )
            )
        return found
    length, true = hypot(*seen), hypot(*asked)
    short, far = LENGTH_DOUBT
    if not short * true <= length <= far * true:
        found.append(
            FailedCheck(
                CheckKind.LENGTH,
                f"Tracking sees a way of {length:.2f} m; asked was {true:g} m by the tape",
            )
        )
    off = wrapped(atan2(y, x) - atan2(asked[1], asked[0]))
    if length > 0.2 and (abs(off) > ANGLE_DOUBT or abs(z) > PLACE_DOUBT):
        found.append(FailedCheck(CheckKind.WAY, _way_words(plan, sample.step, seen)))
    return found


def _way_words(plan: CarryPlan, step: CarryStep, seen: Vec3) -> str:
    asked = direction_words(plan, plan.displacement(step)).partition(" (")[0]
    return f"Asked was {asked}; on the map tracking sees it go {direction_words(plan, seen)}"


def _unasked_turn(last: FrameSample, sample: FrameSample) -> list[FailedCheck]:
    """Return the doubt about a drone that was turned where it should not be."""
    turned = onboard_turn(last, sample)
    by = "its own gyros say" if turned is not None else "tracking sees"
    turned = wrapped(sample.yaw - last.yaw) if turned is None else turned
    if abs(turned) <= ANGLE_DOUBT:
        return []
    words = f"It should not be turned on this way; {by} {turned_words(turned)}"
    return [FailedCheck(CheckKind.NOSE, words)]


def _turn_doubts(last: FrameSample, sample: FrameSample) -> list[FailedCheck]:
    seen, said = wrapped(sample.yaw - last.yaw), onboard_turn(last, sample)
    turned, by = (seen, "tracking sees") if said is None else (said, "its own gyros say")
    found = []
    if not radians(50.0) <= turned <= radians(130.0):
        words = turned_words(turned) if abs(turned) > 0.1 else "it was not turned"
        found.append(FailedCheck(CheckKind.TURN, f"Asked was a quarter to the left; {by} {words}"))
    x, y, _ = _between(last, sample)
    if hypot(x, y) > PLACE_DOUBT:
        words = f"It should turn on the spot; tracking sees it {hypot(x, y):.2f} m aside"
        found.append(FailedCheck(CheckKind.SPOT, words))
    return found


def _back_doubts(first: FrameSample, sample: FrameSample) -> list[FailedCheck]:
    x, y, z = _between(first, sample)
    turned = wrapped(sample.yaw - first.yaw)
    found = []
    if dist((x, y, z), (0.0, 0.0, 0.0)) > PLACE_DOUBT:
        words = f"Tracking sees it {hypot(x, y):.2f} m from where it lay on the pad at first"
        found.append(FailedCheck(CheckKind.BACK_PLACE, words))
    if abs(turned) > ANGLE_DOUBT:
        words = f"Its nose points {turned_words(turned)} of where it pointed at first"
        found.append(FailedCheck(CheckKind.BACK_NOSE, words))
    return found


def onboard_turn(last: FrameSample, sample: FrameSample) -> float | None:
    """Return how far the drone turned by its own word [rad], None where it does not tell."""
    if last.psi is None or sample.psi is None:
        return None
    return wrapped(sample.psi - last.psi)


def turned_words(angle: float) -> str:
    """Return an angle [rad] as degrees to the left or right."""
    return f"{abs(degrees(angle)):.0f} deg to the {'left' if angle > 0 else 'right'}"


def direction_words(plan: CarryPlan, seen: Vec3) -> str:
    """Return a displacement [m] in words, as from a drone on the pad."""
    x, y, z = seen
    if abs(z) > hypot(x, y):
        return f"{abs(z):.2f} m {'up' if z > 0 else 'down'}"
    off = wrapped(atan2(y, x) - plan.heading)
    names = ("ahead", "to the left", "back", "to the right")
    return f"{hypot(x, y):.2f} m {names[round(off / (pi / 2)) % 4]} ({degrees(off):+.0f} deg)"


def _between(a: FrameSample, b: FrameSample) -> Vec3:
    (ax, ay, az), (bx, by, bz) = _position(a), _position(b)
    return bx - ax, by - ay, bz - az


def _position(sample: FrameSample) -> Vec3:
    return (inf, inf, inf) if sample.position is None else sample.position
