"""The simulated room as the pilot's shell sees it, with the wires cut out: stepped time, same rates, delays and habits.

What the AR.Drone driver does on its wire happens here by calls: commands are repeated at its cadence, a change of action leaves
at once, requests go on until the drone shows that it understood, the emergency toggle is sent only when it is needed, a silent
pilot makes the drone hover and then land.
"""

from __future__ import annotations

from collections.abc import Callable

from housefly.config import Site
from housefly.messages import Action, Command, DroneStatus, Setpoint, Sighting, Telemetry
from housefly.twin.contracts import Flight, MocapFrame, Onboard, OnboardLimits, Stick, World

CADENCE = 0.03
"""Time between two commands of the same action [s]."""
HOVER_AFTER = 0.25
LAND_AFTER = 2.0
"""Silence of the pilot after which the driver hovers, and lands [s]."""
TOGGLE_PATIENCE = 0.5
"""How long the driver waits for an emergency toggle to show before it sends another [s]."""

STATUS: dict[Flight, DroneStatus] = {
    Flight.LANDED: DroneStatus.LANDED,
    Flight.TAKING_OFF: DroneStatus.TAKING_OFF,
    Flight.FLYING: DroneStatus.FLYING,
    Flight.HOVERING: DroneStatus.FLYING,
    Flight.LANDING: DroneStatus.LANDING,
    Flight.EMERGENCY: DroneStatus.EMERGENCY,
}

FAULTS: tuple[tuple[str, Callable[[Onboard], bool]], ...] = (
    ("battery low", lambda onboard: onboard.low_battery),
    ("communication lost", lambda onboard: onboard.com_lost),
    ("tilted too far", lambda onboard: onboard.angles_out_of_range),
    ("motor problem", lambda onboard: onboard.motors_problem),
)


class LockstepRoom:
    """World, driver and tracking client on one stepped clock."""

    def __init__(self, world: World, site: Site) -> None:
        limits = site.limits
        self._world = world
        self._limits = OnboardLimits(limits.tilt_max, limits.vertical_speed_max, limits.yaw_rate_max, limits.height_max)
        world.set_limits(self._limits)
        world.flat_trim()
        self._command = Command(Action.IDLE)
        self._ordered_at = world.now
        self._next_beat = world.now
        self._toggled_at = -TOGGLE_PATIENCE
        self._actions: dict[Action, Callable[[Setpoint], None]] = {
            Action.IDLE: lambda setpoint: self._idle(),
            Action.TAKE_OFF: lambda setpoint: self._world.request_take_off(),
            Action.FLY: lambda setpoint: self._world.stick(stick_of(setpoint, self._limits)),
            Action.HOVER: lambda setpoint: self._world.stick(Stick(hover=True)),
            Action.LAND: lambda setpoint: self._world.request_land(),
            Action.CUT: lambda setpoint: self._toggle(wanted=True),
            Action.RESET: lambda setpoint: self._toggle(wanted=False),
        }

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._world.now

    def advance(self, seconds: float) -> None:
        """Let the world run, commands repeated at the driver's cadence."""
        end = self.now + seconds
        while self._next_beat <= end:
            self._world.advance(max(0.0, self._next_beat - self.now))
            self._beat()
        self._world.advance(end - self.now)

    def sightings(self) -> tuple[Sighting, ...]:
        """Return what tracking reported since the last call, oldest first."""
        return tuple(sighting for frame in self._world.mocap_frames() for sighting in sightings_of(frame))

    def telemetry(self) -> Telemetry:
        """Return the drone's newest report; the battery is in whole percent as on the wire."""
        onboard = self._world.onboard()
        return Telemetry(
            received_at=onboard.at,
            status=STATUS[onboard.flight],
            battery=round(onboard.battery * 100) / 100,
            phi=onboard.phi,
            theta=onboard.theta,
            psi=onboard.psi,
            height=onboard.height,
            velocity=onboard.velocity,
            faults=tuple(words for words, applies in FAULTS if applies(onboard)),
        )

    def send(self, command: Command) -> None:
        """Hand over the command in force from now on."""
        changed = command.action is not self._command.action
        self._command = command
        self._ordered_at = self.now
        if changed or command.action is not Action.FLY:
            self._beat()

    def _beat(self) -> None:
        """Send what is in force, as one datagram of the driver would."""
        self._next_beat = self.now + CADENCE
        self._world.keep_alive()
        silence = self.now - self._ordered_at
        command = self._command
        if command.action in _MOVING and silence > HOVER_AFTER:
            command = Command(Action.LAND if silence > LAND_AFTER else Action.HOVER)
        self._actions[command.action](command.setpoint)

    def _idle(self) -> None:
        """Keep the take-off bit clear on the ground, where that says only that nobody asks for a flight."""
        if self._world.onboard().flight in _GROUNDED:
            self._world.request_land()

    def _toggle(self, *, wanted: bool) -> None:
        emergency = self._world.onboard().flight is Flight.EMERGENCY
        if emergency is not wanted and self.now - self._toggled_at >= TOGGLE_PATIENCE:
            self._toggled_at = self.now
            self._world.toggle_emergency()


_MOVING = frozenset({Action.TAKE_OFF, Action.FLY, Action.HOVER})
_GROUNDED = frozenset({Flight.LANDED, Flight.EMERGENCY})


def stick_of(setpoint: Setpoint, limits: OnboardLimits) -> Stick:
    """Return the stick that asks for a setpoint, as fractions of the drone's maxima clipped to -1..1."""
    return Stick(
        forward=_fraction(setpoint.theta, limits.tilt),
        left=_fraction(-setpoint.phi, limits.tilt),
        up=_fraction(setpoint.vz, limits.climb),
        turn=_fraction(setpoint.yaw_rate, limits.yaw_rate),
        hover=False,
    )


def sightings_of(frame: MocapFrame) -> tuple[Sighting, ...]:
    """Return the sightings of the bodies that a frame shows."""
    return tuple(Sighting(name, pose, frame.captured_at, frame.due_at) for name, pose in frame.bodies if pose is not None)


def _fraction(value: float, maximum: float) -> float:
    return min(max(value / maximum, -1.0), 1.0)
