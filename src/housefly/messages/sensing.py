"""What tracking, drone and sensors report, and the estimate made of it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

from housefly.geometry import IDENTITY, Quaternion, Vec3, yaw_of
from housefly.messages.words import UNSAID, Words


@dataclass(frozen=True, slots=True)
class Pose:
    """Position [m] and orientation (w, x, y, z) of a body in the world."""

    position: Vec3
    orientation: Quaternion = IDENTITY

    @property
    def yaw(self) -> float:
        """Heading psi [rad] in (-pi, pi]."""
        return yaw_of(self.orientation)


@dataclass(frozen=True, slots=True)
class Sighting:
    """One body seen once by the tracking system.

    Attributes:
        body: name of the tracked body.
        pose: where it was.
        captured_at: when the cameras saw it [s, our monotonic clock].
        received_at: when we received it [s].
    """

    body: str
    pose: Pose
    captured_at: float
    received_at: float


@dataclass(frozen=True, slots=True)
class TrackedFrame:
    """One frame of the tracking system, published on arrival."""

    sightings: tuple[Sighting, ...]


@dataclass(frozen=True, slots=True)
class SensorReport:
    """The state of one sensor, reported by the process that listens to it.

    Attributes:
        id: of the sensor, as the site file calls it.
        kind: what it is, in a word or two.
        connected: whether it sends as often as it should.
        rate_hz: its rate over the last seconds [Hz].
        age: time since it last sent [s]; infinite when never.
        problem: what is wrong; UNSAID for nothing.
    """

    id: str
    kind: str
    connected: bool
    rate_hz: float
    age: float
    problem: Words = UNSAID


@dataclass(frozen=True, slots=True)
class SightNews:
    """Until when all sensors that look for people were believed, said ten times a second.

    Attributes:
        seen_at: of each the newest believed scan or image, of those the oldest [s]; -inf before the
            first of one of them.
    """

    seen_at: float


class DroneStatus(Enum):
    """What the drone says it is doing."""

    UNKNOWN = "unknown"
    LANDED = "landed"
    TAKING_OFF = "taking off"
    FLYING = "flying"
    LANDING = "landing"
    EMERGENCY = "emergency"


class DroneFault(Enum):
    """What a drone may complain of: no driver can tell a fault that nobody knows."""

    MOTORS_PROBLEM = "motors problem"
    SOFTWARE_FAULT = "software fault"
    MOTORS_CUT_OUT = "motors cut out"
    BATTERY_LOW = "battery low"
    TILTED_TOO_FAR = "tilted too far"
    ULTRASOUND_DEAF = "ultrasound deaf"
    USER_EMERGENCY = "emergency landing by the user"
    FLIGHT_TIMER_ELAPSED = "flight timer elapsed"
    WIND = "too much wind"
    SENSOR_BOARD_SILENT = "sensor board silent"
    COMMANDS_LOST = "drone lost our commands"


AIRBORNE_STATUSES = (DroneStatus.TAKING_OFF, DroneStatus.FLYING, DroneStatus.LANDING)
"""States in which the propellers carry the drone."""
REPORT_AGE_MAX = 0.5
"""An older report of the drone says nothing about the present [s]."""


@dataclass(frozen=True, slots=True)
class Telemetry:
    """The last report of the drone about itself.

    Attributes:
        received_at: when we received it [s].
        status: the drone's own state.
        battery: charge, 0 to 1.
        phi, theta, psi: attitude [rad], REP-103 signs; psi is relative to the drone's own start,
            not to the world.
        height: height above the floor by the drone's own sensor [m].
        velocity: body velocity forward, left, up by the drone's own estimate [m/s].
        faults: the drone's complaints.
        acceleration: specific force in the body [m/s^2]; None where the drone does not tell it.
        configured: its limits were written, acknowledged and read back; no take-off before.
        notes: what is not as it should be with its settings or sensors.
        drone_time: when the drone wrote it, by its own clock [s]; None where it does not tell it.
        hears_us: whether our commands reach the drone; so where it does not say.
    """

    received_at: float
    status: DroneStatus
    battery: float
    phi: float = 0.0
    theta: float = 0.0
    psi: float = 0.0
    height: float = 0.0
    velocity: Vec3 = (0.0, 0.0, 0.0)
    faults: tuple[DroneFault, ...] = ()
    acceleration: Vec3 | None = None
    configured: bool = True
    notes: tuple[Words, ...] = ()
    drone_time: float | None = None
    hears_us: bool = True


@dataclass(frozen=True, slots=True)
class Estimate:
    """Where the drone is, by the Kalman filter (paper V-D).

    Attributes:
        at: time the estimate is for [s].
        position: world [m]; z comes from tracking.
        velocity: world [m/s].
        yaw: heading psi [rad].
        pose_age: time since the last accepted sighting was captured [s].
        position_std: one-sigma uncertainty in x and y [m].
    """

    at: float
    position: Vec3
    velocity: Vec3
    yaw: float
    pose_age: float
    position_std: float


@dataclass(frozen=True, slots=True)
class VideoFrame:
    """One encoded picture of the drone's camera.

    Attributes:
        data: H.264 Annex B access unit; key frames start with SPS and PPS.
        keyframe: can be decoded without earlier frames.
        width, height: shown size [px].
        sequence: the drone's frame number.
        received_at: when its last byte arrived [s].
        drone_time: the drone's own clock [s].
    """

    data: bytes
    keyframe: bool
    width: int
    height: int
    sequence: int
    received_at: float
    drone_time: float = 0.0
