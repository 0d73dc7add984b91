"""What the pilot wants of the drone: paths, references, setpoints, commands."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.geometry import Vec2, Vec3
from housefly.messages.words import UNSAID, Words


@dataclass(frozen=True, slots=True)
class Path:
    """A planned way through the map.

    Attributes:
        waypoints: world xy [m], start cell centre first, goal last.
        length: sum of the legs [m].
        clearance: smallest distance [m] from the path to an obstacle in the map, before inflation.
    """

    waypoints: tuple[Vec2, ...]
    length: float
    clearance: float


@dataclass(frozen=True, slots=True)
class TrajectoryPoint:
    """Where a trajectory is planned to be: place [m], time since its start [s], speed [m/s]."""

    position: Vec3
    time: float
    speed: float


@dataclass(frozen=True, slots=True)
class PlannedTrajectory:
    """The ``Path`` in use as it is planned in space; a path in the plane has none.

    Attributes:
        at: when this was said [s]; it is said again and again.
        points: at the waypoints of the path, in order.
    """

    at: float
    points: tuple[TrajectoryPoint, ...]


@dataclass(frozen=True, slots=True)
class PlanAnswer:
    """The answer to "how do I get from start to goal?"; ``path`` is None when there is no way.

    Attributes:
        start, goal: as asked [m].
        path: the way, or None.
        reason: in words, why there is no path ("" when there is one).
        suggestion: nearest free cell centre to a blocked or outside start or goal [m], when there
            is one.
        duration: expected flight time [s].
    """

    start: Vec2
    goal: Vec2
    path: Path | None
    reason: Words = UNSAID
    suggestion: Vec2 | None = None
    duration: float = 0.0


class Behavior(Enum):
    """States of the finite state acceptor (paper Fig. 10)."""

    HOVER = "hover"
    ALTITUDE_CONTROL = "altitudeControl"
    YAW_CONTROL = "yawControl"
    PATH_TRACKING = "pathTracking"


@dataclass(frozen=True, slots=True)
class Reference:
    """Where the drone should be now: position [m], velocity [m/s] and yaw [rad] in the world."""

    position: Vec3
    velocity: Vec3
    yaw: float


@dataclass(frozen=True, slots=True)
class Setpoint:
    """What control asks of the drone's inner loops.

    Attributes:
        theta: wanted pitch [rad], positive accelerates forward.
        phi: wanted roll [rad], positive accelerates right.
        vz: wanted climb rate [m/s].
        yaw_rate: wanted yaw rate [rad/s], positive counter-clockwise.
    """

    theta: float = 0.0
    phi: float = 0.0
    vz: float = 0.0
    yaw_rate: float = 0.0


LEVEL = Setpoint()


class Action(Enum):
    """What kind of command goes to the drone."""

    IDLE = "idle"
    TAKE_OFF = "take off"
    FLY = "fly"
    HOVER = "hover"
    LAND = "land"
    CUT = "cut motors"
    RESET = "reset emergency"


@dataclass(frozen=True, slots=True)
class KnownMotion:
    """How the drone moves, for who has to bring it to rest when the pilot is silent.

    Attributes:
        forward, left: velocity in the body by tracking [m/s]; None where that is not believed.
        theta, phi: the attitude that stands still against what pushes steadily [rad].
        hovers: the drone's own hover can be left to itself.
    """

    forward: float | None = None
    left: float | None = None
    theta: float = 0.0
    phi: float = 0.0
    hovers: bool = True


@dataclass(frozen=True, slots=True)
class Command:
    """One order to the drone driver; ``setpoint`` counts only for ``Action.FLY``.

    HOVER asks for the drone's own hover; FLY with LEVEL means level attitude, which drifts.
    """

    action: Action
    setpoint: Setpoint = LEVEL


@dataclass(frozen=True, slots=True)
class Instruction:
    """What a driver tells its drone now, once the watchdog over the pilot has had its word.

    Attributes:
        command: to encode; a take-off only while one may begin or is under way.
        order: how many orders of another kind than the one before the pilot has given.
        ordered_at: when the newest of these came [s].
        lands_all: whatever may be in the air has to land, also where nobody knows whether it is.
    """

    command: Command
    order: int
    ordered_at: float
    lands_all: bool


class SafetyMode(Enum):
    """What the last gate decided; the worst wins, in this order.

    WARN and SLOW fly on; HOLD hovers until what is wrong is over; RETURN flies home, as slowly as
    SLOW and no sooner than HOLD allows; STOPPED hovers until a person resumes; LAND is the drone's
    own landing, DESCEND a level descent where that is not to be had.
    """

    NOMINAL = "nominal"
    WARN = "warn"
    SLOW = "slow"
    HOLD = "hold"
    RETURN = "return"
    STOPPED = "stopped"
    LAND = "land"
    DESCEND = "descend"
    CUT = "cut"


class Clearing(Enum):
    """What ends the answer of the last gate to a broken rule."""

    ITSELF = "by itself"
    GROUND = "once it stands"
    ORDER = "a fresh order on the ground"
    RESUME = "Resume"
    RESET = "a reset"
