"""What stands between a driver and its drone in lock step, where there are no bytes."""

from __future__ import annotations

from typing import Any, Protocol

from housefly.config.site import Site
from housefly.lab.lockstep.betaflight_wire import BetaflightWire
from housefly.messages import Command, Sighting, Telemetry
from housefly.messages.steering import Instruction
from housefly.messages.stick import Maxima
from housefly.twin.betaflight.firmware import BetaflightFirmware
from housefly.twin.contracts import OnboardLimits, TwinDrone
from housefly.twin.plain_drone import Obedience, within
from housefly.wires.ardrone import at
from housefly.wires.ardrone.command_encoder import CommandEncoder
from housefly.wires.ardrone.conversions import stick_from_pcmd


class LockstepWire(Protocol):
    """Encodes what the failsafe decides, and lets the drone obey it."""

    def encoded(self, told: Instruction, now: float, report: Telemetry | None) -> tuple[Any, ...]:
        """Return what would be one datagram, now [s], given the drone's newest report."""
        ...

    def obey(self, drone: TwinDrone, command: Any) -> None:
        """Let the drone obey one command of a datagram."""
        ...

    def see(self, drone: TwinDrone, seen: Sighting) -> None:
        """Hand over where tracking saw the drone, to one that wants to know, or to its driver."""
        ...

    def understood(self, report: Telemetry) -> Telemetry:
        """Return a report as the driver understands it."""
        ...


class OwnReports:
    """The half of a wire whose drone takes poses itself, and says what it does."""

    def see(self, drone: TwinDrone, seen: Sighting) -> None:
        """Tell the drone."""
        drone.tell_pose(seen.pose, seen.captured_at)

    def understood(self, report: Telemetry) -> Telemetry:
        """Return it as it is."""
        return report


class ArDroneWire(OwnReports):
    """The AR.Drone's own commands.

    Args:
        maxima: what a full stick means.
    """

    def __init__(self, maxima: Maxima) -> None:
        self._encoder = CommandEncoder(maxima)
        self._emergency_held = False

    def encoded(self, told: Instruction, now: float, report: Telemetry | None) -> tuple[Any, ...]:
        """Return AT commands."""
        return self._encoder.encoded(told, now, report)

    def obey(self, drone: TwinDrone, command: at.AtCommand) -> None:
        """Obey a command as the drone does; the emergency bit acts on its rising edge."""
        match command:
            case at.Pcmd():
                drone.set_stick(stick_from_pcmd(command))
            case at.FlatTrim():
                drone.flat_trim()
            case at.Ref(bits):
                emergency = at.RefBits.EMERGENCY in bits
                if emergency and not self._emergency_held:
                    drone.toggle_emergency()
                self._emergency_held = emergency
                if at.RefBits.TAKE_OFF in bits:
                    drone.request_take_off()
                else:
                    drone.request_land()


class PlainWire(OwnReports):
    """Commands as they are: of a drone whose bytes are not simulated.

    Args:
        maxima: what a full stick means.
    """

    def __init__(self, maxima: Maxima) -> None:
        self._obedience = Obedience(maxima)

    def encoded(self, told: Instruction, now: float, report: Telemetry | None) -> tuple[Any, ...]:
        """Return the command."""
        return (told.command,)

    def obey(self, world: TwinDrone, command: Command) -> None:
        """Obey a command."""
        self._obedience.obey(world, command)


def lockstep_wire(site: Site, drone: TwinDrone) -> LockstepWire:
    """Return the wire of a site's drone.

    Args:
        site: model and limits.
        drone: at the other end.
    """
    limits = site.limits
    firmware = getattr(drone, "firmware", None)
    if isinstance(firmware, BetaflightFirmware):
        return BetaflightWire(site, firmware)
    maxima = Maxima(limits.tilt_max, limits.full_climb, limits.yaw_rate_max)
    return ArDroneWire(maxima) if site.drone.kind == "ardrone" else PlainWire(maxima)


def onboard_limits(site: Site) -> OnboardLimits:
    """Return what a driver would write into a site's drone."""
    limits = site.limits
    asked = OnboardLimits(
        limits.tilt_max,
        limits.full_climb,
        limits.yaw_rate_max,
        limits.onboard_height_max,
        site.drone.airframe.capabilities.silence.after,
    )
    return within(asked, site.drone.airframe)
