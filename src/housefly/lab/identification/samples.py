"""One block as flown: commands that left the gate, and what tracking saw along its axis."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import cos, sin

import numpy as np

from housefly.geometry import euler_from_quaternion
from housefly.lab.identification.pattern import Axis, Block
from housefly.messages import Action, PilotStep, Setpoint, Sighting
from housefly.numeric import FloatArray, wrapped

COMMANDS_BEFORE = 0.7
"""Commands are kept from this long before a block [s]: more than the longest delay searched for."""


@dataclass(frozen=True, slots=True)
class Flown:
    """A block and when it began [s]."""

    block: Block
    began: float


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """A block in numbers; times count from its beginning.

    Attributes:
        block: what was to be flown.
        sent_at: when commands left the gate [s].
        sent: their value on the block's axis [rad, m/s or rad/s]; 0 where the drone was not flown.
        at: when frames were taken [s].
        place: position along the axis [m], height [m] or heading [rad].
        angle: pitch or roll [rad]; empty for climb and turn.
    """

    block: Block
    sent_at: FloatArray
    sent: FloatArray
    at: FloatArray
    place: FloatArray
    angle: FloatArray

    @property
    def gap(self) -> float:
        """Longest time without a frame, the ends of the block included [s]."""
        edges = np.concatenate(([0.0], self.at, [self.block.duration]))
        return float(np.diff(edges).max())


def samples_of(
    steps: Iterable[PilotStep], flown: tuple[Flown, ...], body: str
) -> tuple[Samples, ...]:
    """Cut a flight into its blocks.

    Args:
        steps: of the pilot, in order.
        flown: blocks and when they began, in order.
        body: name of the drone among the tracked bodies.
    """
    kept = [(step.now, step.outputs.command, step.inputs.sightings) for step in steps]
    times = np.array([now for now, _, _ in kept])
    sightings = _newest_first_seen(
        sighting for _, _, seen in kept for sighting in seen if sighting.body == body
    )
    taken = np.array([sighting.captured_at for sighting in sightings])
    found = []
    for own in flown:
        first, last = np.searchsorted(
            times, (own.began - COMMANDS_BEFORE, own.began + own.block.duration)
        )
        values = [
            _value(own.block.axis, kept[i][1].setpoint) * (kept[i][1].action is Action.FLY)
            for i in range(first, last)
        ]
        begin, end = np.searchsorted(taken, (own.began, own.began + own.block.duration))
        place, angle = _along(own.block.axis, sightings[begin:end])
        found.append(
            Samples(
                own.block,
                times[first:last] - own.began,
                np.array(values),
                taken[begin:end] - own.began,
                place,
                angle,
            )
        )
    return tuple(found)


def _newest_first_seen(sightings: Iterable[Sighting]) -> list[Sighting]:
    """Return the sightings in order of capture time, each once."""
    return [
        sighting
        for _, sighting in sorted(
            {sighting.captured_at: sighting for sighting in sightings}.items()
        )
    ]


def _value(axis: Axis, setpoint: Setpoint) -> float:
    return {
        Axis.PITCH: setpoint.theta,
        Axis.ROLL: setpoint.phi,
        Axis.CLIMB: setpoint.vz,
        Axis.TURN: setpoint.yaw_rate,
    }[axis]


def _along(axis: Axis, sightings: list[Sighting]) -> tuple[FloatArray, FloatArray]:
    """Return position and angle along an axis.

    Forward for pitch and right for roll, by the mean heading; height; heading.
    """
    if not sightings:
        return np.zeros(0), np.zeros(0)
    angles = np.array([euler_from_quaternion(sighting.pose.orientation) for sighting in sightings])
    x, y, z = np.array([sighting.pose.position for sighting in sightings]).T
    if axis is Axis.CLIMB:
        return z, np.zeros(0)
    if axis is Axis.TURN:
        return np.unwrap(angles[:, 2]), np.zeros(0)
    psi = float(angles[0, 2])
    psi += float(np.mean([wrapped(angle - psi) for angle in angles[:, 2]]))
    if axis is Axis.PITCH:
        return x * cos(psi) + y * sin(psi), angles[:, 1]
    return x * sin(psi) - y * cos(psi), angles[:, 0]
