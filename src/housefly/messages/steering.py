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


class SetpointForm(Enum):
    """What a drone can be steered by while it flies."""

    TILT_AND_CLIMB = "tilt and climb"
    VELOCITY = "velocity"
    POSITION = "position"
    TRAJECTORY = "trajectory"


@dataclass(frozen=True, slots=True)
class Setpoint:
    """What control asks of the inner loops of a drone that takes tilt and climb.

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


@dataclass(frozen=True, slots=True)
class VelocitySetpoint:
    """What control asks of a drone that flies velocities by itself.

    Attributes:
        forward, left: wanted velocity along the axes of the level drone [m/s].
        vz: wanted climb rate [m/s].
        yaw_rate: wanted yaw rate [rad/s], positive counter-clockwise.
    """

    forward: float = 0.0
    left: float = 0.0
    vz: float = 0.0
    yaw_rate: float = 0.0


@dataclass(frozen=True, slots=True)
class PositionSetpoint:
    """What control asks of a drone that flies to a place by itself, told where it is.

    Attributes:
        x, y, z: wanted place in the world [m].
        yaw_rate: wanted yaw rate [rad/s], positive counter-clockwise.
    """

    x: float
    y: float
    z: float
    yaw_rate: float = 0.0


AnySetpoint = Setpoint | VelocitySetpoint | PositionSetpoint
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
    """One order to the drone driver; what is asked counts only for ``Action.FLY``.

    HOVER asks for the drone's own hover; FLY with LEVEL means level attitude, which drifts.

    Attributes:
        action: what kind of order it is.
        setpoint: by tilt and climb, unless one of the others is given.
        velocity, position: what is asked in its place of a drone of that form, or None.
    """

    action: Action
    setpoint: Setpoint = LEVEL
    velocity: VelocitySetpoint | None = None
    position: PositionSetpoint | None = None

    @property
    def asked(self) -> AnySetpoint:
        """The setpoint in whichever form it is."""
        return self.velocity or self.position or self.setpoint

    @property
    def form(self) -> SetpointForm:
        """Which form that is."""
        return form_of(self.asked)


_FORMS: dict[type[AnySetpoint], SetpointForm] = {
    Setpoint: SetpointForm.TILT_AND_CLIMB,
    VelocitySetpoint: SetpointForm.VELOCITY,
    PositionSetpoint: SetpointForm.POSITION,
}


def form_of(asked: AnySetpoint) -> SetpointForm:
    """Return the form of a setpoint."""
    return _FORMS[type(asked)]


def numbers_of(asked: AnySetpoint) -> tuple[float, float, float, float]:
    """Return the four numbers of a setpoint, in the order of its fields."""
    match asked:
        case VelocitySetpoint(forward, left, vz, yaw_rate):
            return forward, left, vz, yaw_rate
        case PositionSetpoint(x, y, z, yaw_rate):
            return x, y, z, yaw_rate
        case Setpoint(theta, phi, vz, yaw_rate):
            return theta, phi, vz, yaw_rate


def commanded(action: Action, asked: AnySetpoint) -> Command:
    """Return the command of an action with a setpoint of any form."""
    match asked:
        case VelocitySetpoint():
            return Command(action, velocity=asked)
        case PositionSetpoint():
            return Command(action, position=asked)
        case Setpoint():
            return Command(action, asked)


def flying(asked: AnySetpoint) -> Command:
    """Return the command that flies a setpoint of any form."""
    return commanded(Action.FLY, asked)


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
