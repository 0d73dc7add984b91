"""The simulated room without the wires, on a stepped clock.

Rates, delays and habits are those of the wires: the driver's own command sequencer decides what the
drone hears and when.
"""

from __future__ import annotations

from collections.abc import Callable

from housefly.config.site import Site
from housefly.messages import Command, DroneStatus, Sighting, Telemetry
from housefly.twin.contracts import (
    FlightState,
    MocapFrame,
    OnboardLimits,
    OnboardState,
    TwinWorld,
)
from housefly.wires.ardrone import at
from housefly.wires.ardrone.command_sequencer import (
    REPEAT_AFTER,
    SEND_INTERVAL_MIN,
    CommandSequencer,
)
from housefly.wires.ardrone.conversions import Maxima, stick_from_pcmd

FLIGHT_STATUS: dict[FlightState, DroneStatus] = {
    FlightState.LANDED: DroneStatus.LANDED,
    FlightState.TAKING_OFF: DroneStatus.TAKING_OFF,
    FlightState.FLYING: DroneStatus.FLYING,
    FlightState.HOVERING: DroneStatus.FLYING,
    FlightState.LANDING: DroneStatus.LANDING,
    FlightState.EMERGENCY: DroneStatus.EMERGENCY,
}

_FAULTS: tuple[tuple[str, Callable[[OnboardState], bool]], ...] = (
    ("motors problem", lambda onboard: onboard.motors_problem),
    ("battery low", lambda onboard: onboard.low_battery),
    ("tilted too far", lambda onboard: onboard.angles_out_of_range),
    ("drone lost our commands", lambda onboard: onboard.com_lost),
)


class LockstepRoom:
    """World, driver and tracking client on one stepped clock."""

    def __init__(self, world: TwinWorld, site: Site) -> None:
        limits = site.limits
        self._world = world
        world.set_limits(
            OnboardLimits(
                limits.tilt_max, limits.vertical_speed_max, limits.yaw_rate_max, limits.height_max
            )
        )
        maxima = Maxima(limits.tilt_max, limits.vertical_speed_max, limits.yaw_rate_max)
        self._sequencer = CommandSequencer(maxima, world.now)
        self._sent_at = world.now
        self._emergency_held = False

    @property
    def now(self) -> float:
        """World time [s]."""
        return self._world.now

    def advance(self, seconds: float) -> None:
        """Let the world run while commands are repeated at the driver's rate."""
        end = self.now + seconds
        while (beat := self._sent_at + REPEAT_AFTER) <= end:
            self._world.advance(max(0.0, beat - self.now))
            self._transmit()
        self._world.advance(max(0.0, end - self.now))

    def sightings(self) -> tuple[Sighting, ...]:
        """Return what tracking reported since the last call, oldest first."""
        return tuple(
            sighting for frame in self._world.mocap_frames() for sighting in _sightings_of(frame)
        )

    def telemetry(self) -> Telemetry:
        """Return the drone's newest report.

        As on the wire: battery in whole percent, no vertical speed.
        """
        onboard = self._world.onboard()
        forward, left, _ = onboard.velocity
        return Telemetry(
            received_at=onboard.at,
            status=FLIGHT_STATUS[onboard.flight],
            battery=round(onboard.battery * 100) / 100,
            phi=onboard.phi,
            theta=onboard.theta,
            psi=onboard.psi,
            height=onboard.height,
            velocity=(forward, left, 0.0),
            faults=tuple(words for words, applies in _FAULTS if applies(onboard)),
        )

    def send(self, command: Command) -> None:
        """Hand over the command in force from now on."""
        action_changed = self._sequencer.update(command, self.now)
        if action_changed or self.now - self._sent_at >= SEND_INTERVAL_MIN:
            self._transmit()

    def _transmit(self) -> None:
        """Let the drone obey what would be one datagram."""
        self._sent_at = self.now
        self._world.keep_alive()
        for command in self._sequencer.next_commands(self.now, self.telemetry()):
            self._obey(command)

    def _obey(self, command: at.AtCommand) -> None:
        """Obey a command as the drone does; the emergency bit acts on its rising edge."""
        match command:
            case at.Pcmd():
                self._world.set_stick(stick_from_pcmd(command))
            case at.FlatTrim():
                self._world.flat_trim()
            case at.Ref(bits):
                emergency = at.RefBits.EMERGENCY in bits
                if emergency and not self._emergency_held:
                    self._world.toggle_emergency()
                self._emergency_held = emergency
                if at.RefBits.TAKE_OFF in bits:
                    self._world.request_take_off()
                else:
                    self._world.request_land()


def _sightings_of(frame: MocapFrame) -> tuple[Sighting, ...]:
    """Return the sightings of the bodies that a frame shows."""
    return tuple(
        Sighting(name, pose, frame.captured_at, frame.due_at)
        for name, pose in frame.bodies
        if pose is not None
    )
