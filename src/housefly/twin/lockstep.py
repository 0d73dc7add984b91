"""The simulated room as the pilot's shell sees it, with the wires cut out: stepped time, same
rates, delays and habits.

What the AR.Drone driver does on its wire happens here by calls: a change of action leaves at once,
setpoints leave at the drone's cadence, a silent pilot makes the drone hover and then land, flat
trim comes before each take-off, the take-off bit is raised only on the ground, and the emergency
toggle is pressed only while the drone is in the other state.
"""

from __future__ import annotations

from collections.abc import Callable

from housefly.config.site import Site
from housefly.messages import Action, Command, DroneStatus, Setpoint, Sighting, Telemetry
from housefly.twin.ardrone.firmware import AIRBORNE
from housefly.twin.contracts import Flight, MocapFrame, Onboard, OnboardLimits, Stick, World
from housefly.wires.ardrone.signs import Maxima, pcmd_from_setpoint, stick_from_pcmd

CADENCE = 0.027
"""A setpoint leaves at once when the last one left this long ago [s]."""
REPEAT = 0.035
"""Without a word from the pilot the command in force is repeated after this long [s]."""
HOVER_AFTER = 0.25
LAND_AFTER = 2.0
"""Silence of the pilot after which the driver hovers, and lands [s]."""
TRIM_TIME = 0.1
"""How long flat trim is repeated before take-off [s]."""
PRESS_TIME = 0.5
"""How long the driver waits for an emergency toggle to show before it presses again [s]."""

STATUS: dict[Flight, DroneStatus] = {
    Flight.LANDED: DroneStatus.LANDED,
    Flight.TAKING_OFF: DroneStatus.TAKING_OFF,
    Flight.FLYING: DroneStatus.FLYING,
    Flight.HOVERING: DroneStatus.FLYING,
    Flight.LANDING: DroneStatus.LANDING,
    Flight.EMERGENCY: DroneStatus.EMERGENCY,
}

FAULTS: tuple[tuple[str, Callable[[Onboard], bool]], ...] = (
    ("motors problem", lambda onboard: onboard.motors_problem),
    ("battery low", lambda onboard: onboard.low_battery),
    ("tilted too far", lambda onboard: onboard.angles_out_of_range),
    ("drone lost our commands", lambda onboard: onboard.com_lost),
)


class LockstepRoom:
    """World, driver and tracking client on one stepped clock."""

    def __init__(self, world: World, site: Site) -> None:
        limits = site.limits
        self._world = world
        self._limits = OnboardLimits(
            limits.tilt_max, limits.vertical_speed_max, limits.yaw_rate_max, limits.height_max
        )
        world.set_limits(self._limits)
        self._command = Command(Action.IDLE)
        self._ordered_at = self._since = self._sent_at = world.now
        self._pressed_at = world.now - PRESS_TIME
        self._must_land = self._has_risen = False
        self._actions: dict[Action, Callable[[Flight], None]] = {
            Action.IDLE: self._idle,
            Action.TAKE_OFF: self._take_off,
            Action.FLY: lambda flight: self._world.stick(
                stick_of(self._command.setpoint, self._limits)
            ),
            Action.HOVER: lambda flight: self._world.stick(Stick()),
            Action.LAND: lambda flight: self._world.request_land(),
            Action.CUT: lambda flight: self._press(flight is not Flight.EMERGENCY),
            Action.RESET: lambda flight: self._press(flight is Flight.EMERGENCY),
        }

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._world.now

    def advance(self, seconds: float) -> None:
        """Let the world run, commands repeated as the driver repeats them."""
        end = self.now + seconds
        while (beat := self._sent_at + REPEAT) <= end:
            self._world.advance(max(0.0, beat - self.now))
            self._transmit()
        self._world.advance(max(0.0, end - self.now))

    def sightings(self) -> tuple[Sighting, ...]:
        """Return what tracking reported since the last call, oldest first."""
        return tuple(
            sighting for frame in self._world.mocap_frames() for sighting in sightings_of(frame)
        )

    def telemetry(self) -> Telemetry:
        """Return the drone's newest report; battery in whole percent and no vertical speed, as on
        the wire.
        """
        onboard = self._world.onboard()
        forward, left, _ = onboard.velocity
        return Telemetry(
            received_at=onboard.at,
            status=STATUS[onboard.flight],
            battery=round(onboard.battery * 100) / 100,
            phi=onboard.phi,
            theta=onboard.theta,
            psi=onboard.psi,
            height=onboard.height,
            velocity=(forward, left, 0.0),
            faults=tuple(words for words, applies in FAULTS if applies(onboard)),
        )

    def send(self, command: Command) -> None:
        """Hand over the command in force from now on."""
        is_other_action = command.action is not self._command.action
        self._command, self._ordered_at = command, self.now
        if is_other_action:
            self._since, self._has_risen = self.now, False
        if is_other_action or self.now - self._sent_at >= CADENCE:
            self._transmit()

    def _transmit(self) -> None:
        """Do what one datagram of the driver does."""
        self._sent_at = self.now
        self._world.keep_alive()
        flight = self._world.onboard().flight
        self._actions[self._action_in_force(flight)](flight)

    def _action_in_force(self, flight: Flight) -> Action:
        """Return the pilot's action, or what the driver puts in its place when the pilot is silent."""
        action, silence = self._command.action, self.now - self._ordered_at
        airborne = flight in AIRBORNE
        self._must_land = airborne and (self._must_land or silence > LAND_AFTER)
        if action in _CUTTING:
            return action
        if self._must_land:
            self._has_risen = True
            return Action.LAND
        if silence > HOVER_AFTER and action is not Action.LAND:
            return Action.HOVER if airborne else Action.IDLE
        return action

    def _idle(self, flight: Flight) -> None:
        if flight in AIRBORNE:
            self._world.stick(Stick())
        else:
            self._world.request_land()

    def _take_off(self, flight: Flight) -> None:
        if flight in AIRBORNE:
            self._has_risen = self._has_risen or flight is not Flight.LANDING
            self._world.stick(Stick())
        elif flight is not Flight.LANDED or self._has_risen:
            self._idle(flight)
        elif self.now - self._since < TRIM_TIME:
            self._world.request_land()
            self._world.flat_trim()
        else:
            self._world.request_take_off()

    def _press(self, wanted: bool) -> None:
        if wanted and self.now - self._pressed_at >= PRESS_TIME:
            self._pressed_at = self.now
            self._world.toggle_emergency()


_CUTTING = frozenset({Action.CUT, Action.RESET})


def stick_of(setpoint: Setpoint, limits: OnboardLimits) -> Stick:
    """Return the stick that asks for a setpoint, by the same mapping that the wire carries."""
    asked = stick_from_pcmd(
        pcmd_from_setpoint(setpoint, Maxima(limits.tilt, limits.climb, limits.yaw_rate))
    )
    return Stick(asked.forward, asked.left, asked.up, asked.turn, hover=False)


def sightings_of(frame: MocapFrame) -> tuple[Sighting, ...]:
    """Return the sightings of the bodies that a frame shows."""
    return tuple(
        Sighting(name, pose, frame.captured_at, frame.due_at)
        for name, pose in frame.bodies
        if pose is not None
    )
