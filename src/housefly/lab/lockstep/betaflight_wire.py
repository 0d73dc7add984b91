"""A Betaflight in lock step: its driver's own manoeuvres, and channels instead of bytes.

Such a drone takes off, keeps its height and lands by sticks alone: what would fly it over its wire
flies it here.
"""

from __future__ import annotations

from dataclasses import replace
from math import inf, isfinite

from housefly.config.site import Site
from housefly.drones.betaflight.height import height_model
from housefly.drones.betaflight.manoeuvres import FcState, StickManoeuvres
from housefly.messages import Sighting, Telemetry
from housefly.messages.steering import Instruction
from housefly.twin.betaflight.firmware import BetaflightFirmware
from housefly.twin.contracts import TwinDrone
from housefly.wires.betaflight.arming import OF_THE_SWITCH
from housefly.wires.betaflight.sticks import flight_channels, raw_channels
from housefly.wires.betaflight.switches import Switches, switches_of

_STATUS_PERIOD = 0.1
"""Whether it is armed is asked for this often [s]."""
Channels = tuple[int, ...]


class BetaflightWire:
    """Channels to a simulated flight controller.

    Args:
        site: its airframe, and the largest lean.
        firmware: of the drone.
    """

    def __init__(self, site: Site, firmware: BetaflightFirmware) -> None:
        airframe, self._firmware = site.drone.airframe, firmware
        model = height_model(airframe, firmware.settings.motor_idle)
        self._manoeuvres = StickManoeuvres(
            model, site.limits.tilt_max, airframe.body.standing_height
        )
        switches = switches_of(firmware.settings.ranges)
        assert isinstance(switches, Switches), "the simulated one has all switches"
        self._switches = switches
        self._told = FcState(armed=False, may_arm=False)
        self._asked_at = -inf

    def encoded(
        self, told: Instruction, now: float, report: Telemetry | None
    ) -> tuple[Channels, ...]:
        """Return the channels of one SET_RAW_RC."""
        if report is not None and isfinite(report.phi) and isfinite(report.theta):
            # MSP has whole numbers only: a lean that is none never arrives
            self._told = self._told._replace(phi=report.phi, theta=report.theta)
        leaves = self._manoeuvres.told(told, self._asked(now), now)
        positions = self._switches.armed if leaves.arms else self._switches.disarmed
        settings = self._firmware.settings
        return (raw_channels(flight_channels(leaves.sticks, settings), positions, settings),)

    def obey(self, drone: TwinDrone, command: Channels) -> None:
        """Let the controller hear channels."""
        drone.later(lambda: self._firmware.hear(command))

    def see(self, drone: TwinDrone, seen: Sighting) -> None:
        """Tell the manoeuvres: the controller wants no pose."""
        self._manoeuvres.see(seen)

    def understood(self, report: Telemetry) -> Telemetry:
        """Return it with what it is about: the controller says only that it is armed."""
        return replace(report, status=self._manoeuvres.status(self._told))

    def _asked(self, now: float) -> FcState:
        if now - self._asked_at >= _STATUS_PERIOD:
            self._asked_at = now
            firmware = self._firmware
            may_arm = not firmware.blocked & ~OF_THE_SWITCH
            self._told = self._told._replace(armed=firmware.is_armed, may_arm=may_arm)
        return self._told
