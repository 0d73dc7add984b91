"""People as MuJoCo bodies, a capsule and a head each; cameras, rays and the drone's hull meet them.

Own frame: origin between the feet, x forward, z up. Someone who sits sinks into the floor up to the
hips; someone absent waits far below it. Metres.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, pi, sin

from housefly.errors import ConfigError
from housefly.geometry import quaternion_from_euler
from housefly.messages import Pose
from housefly.twin.contracts import AWAY_Z
from housefly.twin.people.script import PersonScript
from housefly.twin.people.state import PersonState, Posture

PERSON_PREFIX = "person "
"""Prefix of the names of their bodies."""
_TRUNK_RADIUS, _HEAD_RADIUS = 0.17, 0.11
"""Radius of trunk and head [m]."""
_HIPS = 0.52
"""Height of the hips over body height."""
_FOOT = 0.03
_COATS = ("0.24 0.42 0.62 1", "0.62 0.36 0.28 1", "0.32 0.52 0.34 1", "0.52 0.40 0.60 1")
_SKIN = "0.93 0.74 0.62 1"


def people_bodies(people: tuple[PersonScript, ...]) -> str:
    """Return the MJCF of the people in the order of the script, without the room's visitor.

    Raises ConfigError when two of them have the same name.
    """
    bodies = _with_bodies(people)
    if len({person.name for person in bodies}) < len(bodies):
        raise ConfigError("people", "two people have the same name; give each their own")
    return "".join(_body(person, number) for number, person in enumerate(bodies))


def _with_bodies(people: tuple[PersonScript, ...]) -> tuple[PersonScript, ...]:
    """Return the people who need a body: all but the visitor, whose body the room has."""
    return tuple(person for person in people if not person.visitor)


def body_pose(person: PersonState, height: float) -> Pose:
    """Return the pose of a person's body.

    Args:
        person: posture, place and direction.
        height: of the person [m].
    """
    return _POSES.get(person.posture, _upright)(person, height)


def _upright(person: PersonState, height: float) -> Pose:
    return Pose((*person.position, person.support), quaternion_from_euler(0.0, 0.0, person.yaw))


def _seated(person: PersonState, height: float) -> Pose:
    return Pose(
        (*person.position, person.support - _HIPS * height + _TRUNK_RADIUS),
        quaternion_from_euler(0.0, 0.0, person.yaw),
    )


def _lying(person: PersonState, height: float) -> Pose:
    x, y = person.position
    feet = (
        x - height / 2 * cos(person.yaw),
        y - height / 2 * sin(person.yaw),
        person.support + _TRUNK_RADIUS,
    )
    return Pose(feet, quaternion_from_euler(0.0, pi / 2, person.yaw))


def _away(person: PersonState, height: float) -> Pose:
    return Pose((*person.position, AWAY_Z), quaternion_from_euler(0.0, 0.0, 0.0))


_POSES: dict[Posture, Callable[[PersonState, float], Pose]] = {
    Posture.SITTING: _seated,
    Posture.LYING: _lying,
    Posture.AWAY: _away,
}


def _body(person: PersonScript, number: int) -> str:
    top, trunk, head = person.height, _TRUNK_RADIUS, _HEAD_RADIUS
    low = _FOOT + trunk
    line = f"0 0 {low:.9g} 0 0 {max(low + 0.01, top - 2 * head - trunk):.9g}"
    name, coat = f"{PERSON_PREFIX}{person.name}", _COATS[number % len(_COATS)]
    return (
        f'<body name="{name}" mocap="true" pos="0 0 {AWAY_Z}"><geom name="{name} trunk"'
        f' type="capsule" fromto="{line}" size="{trunk}" rgba="{coat}"'
        f' material="cloth"/><geom name="{name} head" type="sphere" pos="0 0 {top - head:.9g}"'
        f' size="{head}" rgba="{_SKIN}" material="cloth"/></body>'
    )
