"""A drone that speaks MAVLink as a ``DroneDriver``: ArduCopter in GUIDED, PX4 in OFFBOARD."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from housefly.clock import Clock, RealClock
from housefly.config.drone import DroneConfig
from housefly.config.limits import LimitsConfig
from housefly.config.process_log import log_traceback
from housefly.drones.mavlink.checks import Checks
from housefly.drones.mavlink.link import MavlinkLink
from housefly.drones.mavlink.orders import Deed, Order, Orders
from housefly.drones.mavlink.vehicle import Vehicle
from housefly.drones.repeating_driver import RepeatingDriver
from housefly.errors import LinkError, MissingPartError
from housefly.messages import (
    Sighting,
    Telemetry,
    VideoFrame,
)
from housefly.messages.sensing import REPORT_AGE_MAX
from housefly.messages.words import UNSAID, Words, error_words, joined
from housefly.wires.mavlink import requests
from housefly.wires.mavlink.autopilots import AUTOPILOTS, FlightMode
from housefly.wires.mavlink.endpoint import endpoint_of
from housefly.wires.mavlink.poses import PoseSpeed, pose_message
from housefly.wires.mavlink.reports import ClockQuestion, VehicleReport
from housefly.wires.mavlink.setpoints import setpoint_message

if TYPE_CHECKING:
    from housefly.drones.contract import DroneDriver

FIRST_REPORT_TIMEOUT = 5.0
"""How long ``connect`` waits for the first heartbeat [s]."""
_CHECK_PERIOD = 0.5


class MavlinkDrone(RepeatingDriver):
    """Flies one ArduCopter or PX4, real or simulated, by the row of ``AUTOPILOTS`` of its model.

    Args:
        config: model, and where it answers.
        limits: what it may do.
        clock: for ages and rates.

    It takes off only once it told that it is set as it must be, and has an origin.
    """

    def __init__(
        self, config: DroneConfig, limits: LimitsConfig, clock: Clock | None = None
    ) -> None:
        super().__init__(config, limits.tilt_max, clock or RealClock())
        self._autopilot = AUTOPILOTS[config.kind]
        self._vehicle = Vehicle(self._autopilot)
        self._orders, self._checks = Orders(self._vehicle), Checks(self._vehicle, config.address)
        self._speed = PoseSpeed()
        self._link: MavlinkLink | None = None
        self._told: Telemetry | None = None
        self._heard = asyncio.Event()
        self._handler: Callable[[], None] = lambda: None
        self._trouble = UNSAID

    @property
    def firmware(self) -> str:
        """Which autopilot it is."""
        return self._autopilot.name if self._heard.is_set() else ""

    @property
    def notes(self) -> tuple[Words, ...]:
        """What is not as it should be, what it refuses, and its warnings, in its own words."""
        now = self._clock.now()
        taken = (self._taken_words(),) if self._orders.is_taken(now) else ()
        return (*self._checks.notes, *self._permit_notes, *taken, *self._vehicle.refusals.told(now))

    @property
    def problem(self) -> Words:
        """What is wrong with drone or link; UNSAID for nothing."""
        return joined("; ", self.notes) if self._heard.is_set() else self._trouble

    @property
    def telemetry(self) -> Telemetry | None:
        """The newest report, or None before the first."""
        return self._told

    @property
    def telemetry_rate_hz(self) -> float:
        """Reports per second over the last second."""
        return self._vehicle.rate_hz(self._clock.now())

    @property
    def connected(self) -> bool:
        """Whether reports arrive."""
        report = self._told
        return report is not None and self._clock.now() - report.received_at < REPORT_AGE_MAX

    async def connect(self) -> None:
        """Open the wire and wait for a heartbeat; may be called again after a failure.

        Raises:
            LinkError: nobody answers; pymavlink is not installed.
        """
        endpoint = endpoint_of(self._config.address, self._autopilot)
        try:
            self._link = self._link or MavlinkLink(endpoint, self._clock, self._hear)
            await self._link.open()
        except (MissingPartError, LinkError) as error:
            self._trouble = error_words(error)
            raise LinkError(self._trouble) from error
        self._start_repeating()
        self._start("look how it is set", self._check)
        try:
            async with asyncio.timeout(FIRST_REPORT_TIMEOUT):
                await self._heard.wait()
        except TimeoutError as error:
            self._trouble = Words(
                "nobody answers at {name}; is {what} running, and does it stream?",
                name=str(endpoint),
                what=self._autopilot.name,
            )
            raise LinkError(self._trouble) from error

    def send_pose(self, seen: Sighting) -> None:
        """Tell it where it was, and when by our clock."""
        if self._link is None or not self._link.is_open:
            return
        velocity = self._speed.after(seen.pose.position, seen.captured_at)
        self._link.send(pose_message(seen.pose, velocity, seen.captured_at))
        self._checks.pose_sent_at = self._clock.now()

    def show_recording(self, records: bool) -> None:
        """It has no light of ours."""

    def on_video(self, handler: Callable[[VideoFrame], None]) -> None:
        """It has no camera of ours."""

    def on_report(self, handler: Callable[[], None]) -> None:
        """Call the handler after each report of the drone."""
        self._handler = handler

    async def close(self) -> None:
        """Release the wire. Does not land: the pilot does that before."""
        await self._end_tasks()
        if self._link is not None:
            await self._link.close()

    def _hear(self, report: VehicleReport) -> None:
        now = self._clock.now()
        if isinstance(report, ClockQuestion):
            if self._link is not None:
                self._link.send(requests.clock_answer(report.asked_ns, now))
            return
        self._heard.set()
        if self._vehicle.hear(report, now):
            self._told = self._vehicle.report(
                now, configured=self._checks.is_done, notes=self.notes
            )
            self._handler()

    def _taken_words(self) -> Words:
        mode = self._autopilot.mode_name(self._vehicle.mode)
        return Words("somebody else flies it, or it does by itself (mode {mode})", mode=mode)

    async def _check(self) -> None:
        while True:
            if self._link is not None:
                now = self._clock.now()
                self._link.send(*self._checks.due(self._link.target, now))
            await asyncio.sleep(_CHECK_PERIOD)

    def _transmit(self, now: float) -> None:
        link = self._link
        if link is None or not link.is_open:
            return
        self._sent_at = now
        try:
            told = self._failsafe.decide(now, self._told)
            orders = self._orders.due(told, now)
            link.send(*(self._message(order, link.target, now) for order in orders))
        except Exception:
            self._land_blindly()
            log_traceback()

    def _land_blindly(self) -> None:
        if self._link is not None:
            self._link.send(_mode_message(self._autopilot.landing, self._link.target))

    def _message(self, order: Order, target: requests.Target, now: float) -> Any:
        match order:
            case FlightMode():
                return _mode_message(order, target)
            case Deed.ARM:
                return requests.arming(target, True)
            case Deed.DISARM:
                return requests.arming(target, False)
            case Deed.CUT:
                return requests.arming(target, False, by_force=True)
            case Deed.TAKE_OFF:
                return requests.take_off_order(target, self._autopilot.take_off_height)
            case setpoint:
                return setpoint_message(setpoint, target, now)


def _mode_message(mode: FlightMode, target: requests.Target) -> Any:
    return requests.mode_order(target, mode.main, mode.sub)


if TYPE_CHECKING:
    _MEETS_THE_CONTRACT: type[DroneDriver] = MavlinkDrone
