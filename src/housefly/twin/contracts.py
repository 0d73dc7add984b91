"""What the twin's servers may ask of the simulated world.

``twin.world`` implements ``TwinWorld``, ``twin.simulated_drone`` ``TwinDrone``; the servers and
lock step use them. World frame and body frame (forward, left, up) as everywhere; a
model's own signs live in its wire and its server.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Protocol

from housefly.geometry import Vec3
from housefly.messages import AnySetpoint, Pose
from housefly.messages.stick import Stick

AWAY_Z = -30.0
"""Height at which bodies wait that are not in the room [m]."""


class FlightState(Enum):
    """Major control states of the simulated firmware."""

    LANDED = "landed"
    TAKING_OFF = "taking off"
    FLYING = "flying"
    HOVERING = "hovering"
    LANDING = "landing"
    EMERGENCY = "emergency"

    @property
    def airborne(self) -> bool:
        """Whether the drone is off the ground with its motors running."""
        return self in _AIRBORNE


_AIRBORNE = frozenset(
    {FlightState.TAKING_OFF, FlightState.FLYING, FlightState.HOVERING, FlightState.LANDING}
)


class DroneCamera(Enum):
    """The drone's two cameras."""

    FRONT = "front"
    BOTTOM = "bottom"


@dataclass(frozen=True, slots=True)
class OnboardLimits:
    """What a client may set.

    Attributes:
        tilt, climb, yaw_rate: of a full stick [rad], [m/s], [rad/s].
        altitude: that it does not climb above [m].
        silence: without a command, after which it lands by itself [s].
    """

    tilt: float = 0.20943952
    climb: float = 0.7
    yaw_rate: float = 1.7453293
    altitude: float = 3.0
    silence: float = 2.0


@dataclass(frozen=True, slots=True)
class OnboardState:
    """What the simulated drone's own computer believes; the source of navdata.

    Attributes:
        at: world time [s].
        flight: major control state.
        battery: charge 0 to 1; battery_voltage: [V].
        phi, theta, psi: attitude estimate [rad], REP-103; psi relative to power-on, drifting.
        height: ultrasound height [m].
        velocity: optical flow estimate, body [m/s].
        acceleration: specific force, body [m/s^2]; angular_rate: body [rad/s].
        motors: four duty cycles, 0 to 1.
        low_battery, com_watchdog, com_lost, angles_out_of_range, motors_problem, ultrasound_deaf:
            state bits.
    """

    at: float
    flight: FlightState
    battery: float
    battery_voltage: float
    phi: float
    theta: float
    psi: float
    height: float
    velocity: Vec3
    acceleration: Vec3
    angular_rate: Vec3
    motors: tuple[float, float, float, float]
    low_battery: bool = False
    com_watchdog: bool = False
    com_lost: bool = False
    angles_out_of_range: bool = False
    motors_problem: bool = False
    ultrasound_deaf: bool = False


@dataclass(frozen=True, slots=True)
class GroundTruth:
    """The true state: for pictures, scores and tests, never for the pilot.

    ``leds`` is the animation that the drone's lights play; 6 is the one of every day.
    """

    at: float
    pose: Pose
    velocity: Vec3
    contacts: int
    leds: int = 6


@dataclass(frozen=True, slots=True)
class EncodedPicture:
    """One encoded picture of the drone's camera.

    Attributes:
        number: counts up from 1, over restarts of the camera process too.
        data: H.264 Annex B access unit; key frames start with SPS and PPS.
        keyframe: can be decoded without earlier pictures; the first after a restart always is.
        width, height: shown size [px].
        at: world time of exposure [s].
    """

    number: int
    data: bytes
    keyframe: bool
    width: int
    height: int
    at: float


@dataclass(frozen=True, slots=True)
class MocapFrame:
    """One frame of the simulated tracking system.

    Attributes:
        number: frame counter; lost frames count too.
        captured_at: world time of exposure [s].
        due_at: world time at which the server may send it [s].
        bodies: name and pose of each body; pose None when too few markers were seen.
    """

    number: int
    captured_at: float
    due_at: float
    bodies: tuple[tuple[str, Pose | None], ...]


class TwinDrone(Protocol):
    """One drone of the simulated room; time passes only in ``TwinWorld.advance``."""

    @property
    def now(self) -> float:
        """World time [s]."""
        ...

    @property
    def firmware(self) -> object:
        """Its own computer, for a server that speaks with it in its own words."""
        ...

    def later(self, call: Callable[[], None]) -> None:
        """Let a command take effect after the command delay."""
        ...

    def set_stick(self, stick: Stick) -> None:
        """Pass on a movement command; it takes effect after the command delay."""
        ...

    def steer(self, asked: AnySetpoint) -> None:
        """Pass on a setpoint to a drone that takes no sticks; late as ``set_stick``."""
        ...

    def tell_pose(self, pose: Pose, captured_at: float) -> None:
        """Tell the drone where it was at a time [s]; late as ``set_stick``."""
        ...

    def keep_alive(self) -> None:
        """Any command arrived; without one a flag after 50 ms, landing after ``silence``."""
        ...

    def request_take_off(self) -> None:
        """REF bit 9 set."""
        ...

    def request_land(self) -> None:
        """REF bit 9 clear."""
        ...

    def toggle_emergency(self) -> None:
        """REF bit 8: cut the motors, or leave the emergency state."""
        ...

    def flat_trim(self) -> None:
        """Zero the attitude offsets; counts only when landed."""
        ...

    def set_limits(self, limits: OnboardLimits) -> None:
        """Configuration changed the maxima."""
        ...

    def play_leds(self, animation: int, frequency_hz: float, seconds: float) -> None:
        """Play an animation on the lights for some time [s]; 0 is for ever."""
        ...

    def onboard(self) -> OnboardState:
        """Return what the firmware believes now."""
        ...

    def truth(self) -> GroundTruth:
        """Return the true state now."""
        ...


class TwinWorld(TwinDrone, Protocol):
    """The simulated room; by itself it speaks of its only, or first, drone."""

    def advance(self, seconds: float) -> None:
        """Run physics, firmware, tracking and batteries for this long."""
        ...

    def mocap_frames(self) -> tuple[MocapFrame, ...]:
        """Return the frames that have become due since the last call, oldest first."""
        ...

    def set_visitor(self, present: bool) -> None:
        """A visitor comes to the door or leaves."""
        ...
