"""What the drone was asked to do, and how far it has come with it."""

from __future__ import annotations

from dataclasses import dataclass, replace

from housefly.geometry import Vec2, Vec3, heading_to
from housefly.messages import OrderKind, Phase


@dataclass(frozen=True, slots=True)
class Refused:
    """The answer when something cannot be done, with the reason in words."""

    reason: str


@dataclass(frozen=True, slots=True)
class Mission:
    """What to do in the air.

    Attributes:
        kind: TAKE_OFF (stay), GO, SERVICE or HOME.
        name: the goal in words.
        goal: world xy [m], None to stay.
        look_at: world point [m] to face on arrival, or None.
        look_s: how long to look [s].
        yaw: heading on arrival when there is nothing to look at [rad]; None keeps the heading.
    """

    kind: OrderKind = OrderKind.TAKE_OFF
    name: str = ""
    goal: Vec2 | None = None
    look_at: Vec3 | None = None
    look_s: float = 0.0
    yaw: float | None = None

    def arrival_yaw(self, position: Vec2) -> float | None:
        """Return the heading [rad] to take at the goal, seen from a position [m]; None keeps it."""
        return self.yaw if self.look_at is None else heading_to(position, self.look_at[:2])


STAY = Mission()
"""Hover where the drone is."""


@dataclass(frozen=True, slots=True)
class MissionState:
    """How far the drone has come with its mission.

    Attributes:
        phase: what the drone is doing.
        since: when the phase began [s].
        mission: what is done, or will be once in the air.
        stopped: STOP is latched.
        cutting: the motors are to be cut; asked until the drone says so.
        resetting: the emergency state is to be left; asked until the drone says so.
        pressed_at: when cut or reset was ordered [s].
    """

    phase: Phase = Phase.IDLE
    since: float = 0.0
    mission: Mission = STAY
    stopped: bool = False
    cutting: bool = False
    resetting: bool = False
    pressed_at: float = 0.0

    def entering(self, phase: Phase, now: float, mission: Mission | None = None) -> MissionState:
        """Return the state in a phase that begins now."""
        return replace(
            self, phase=phase, since=now, mission=self.mission if mission is None else mission
        )

    def stopping(self, now: float, grounded: bool) -> MissionState:
        """Return the state with STOP latched: a mission is given up, a landing goes on."""
        stopped = replace(self, stopped=True, mission=STAY)
        if self.phase is Phase.TAKING_OFF and grounded:
            return stopped.entering(Phase.IDLE, now)
        if self.phase in (Phase.OUTBOUND, Phase.LOOKING, Phase.RETURNING):
            return stopped.entering(Phase.HOLDING, now)
        return stopped

    def pressing(self, now: float, *, cut: bool) -> MissionState:
        """Return the state with the motors to be cut, or the emergency to be left."""
        return replace(self, cutting=cut, resetting=not cut, pressed_at=now)

    def released(self) -> MissionState:
        """Return the state with neither cut nor reset wanted."""
        if not (self.cutting or self.resetting):
            return self
        return replace(self, cutting=False, resetting=False)
