"""The simulated room without the wires, on a stepped clock.

Rates, delays and habits are those of the wires: the driver's own failsafe and encoder decide what
the drone hears and when. Faults befall the same streams as on the wires.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from math import inf, nan
from typing import Any

from housefly.config.site import Site
from housefly.drones.failsafe import Failsafe
from housefly.drones.pose_rate import PoseRate
from housefly.errors import ConfigError
from housefly.lab.lockstep.lockstep_wires import lockstep_wire, onboard_limits
from housefly.lab.lockstep.shared_tracking import SharedTracking
from housefly.messages import (
    Command,
    KnownMotion,
    Sighting,
    Telemetry,
)
from housefly.messages.steering import commanded
from housefly.twin.contracts import (
    OnboardState,
    TwinDrone,
    TwinWorld,
)
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.onboard_stream import not_numbers
from housefly.twin.faults.packet_stream import PacketCodec, PacketStream
from housefly.twin.faults.vocabulary import FaultComponent
from housefly.twin.plain_drone import as_measured, telemetry_of
from housefly.twin.simulated_drone import SimulatedDrone
from housefly.twin.world import SimulatedWorld

_ROUNDING = 1e-9
_Datagram = tuple[int, tuple[Any, ...]]
"""Sequence number and commands of what would be one datagram."""
_COMMANDS: PacketCodec[_Datagram] = PacketCodec(
    garbled=lambda fault, datagram, number: None, repeated=lambda old, new: (new[0], old[1])
)
"""The drone does not read noise."""
_REPORTS: PacketCodec[OnboardState] = PacketCodec(
    garbled=not_numbers, repeated=lambda old, new: new
)
"""Reports that stand still are written anew, with old content."""
_Step = tuple[float, Command, KnownMotion | None]
"""When the pilot gave a command [s], the command, and how the drone moved then."""
_STEPS: PacketCodec[_Step] = PacketCodec(
    garbled=lambda fault, step, number: (
        step[0],
        commanded(step[1].action, type(step[1].asked)(nan, nan, nan, nan)),
        step[2],
    ),
    repeated=lambda old, new: (new[0], *old[1:]),
)


class LockstepRoom:
    """World, driver and tracking client of one drone on one stepped clock.

    Args:
        world: what flies.
        site: limits, and the faults of its ``[[faults]]``; as the drone's own chain sees it.
        faults: those instead, when somebody else uses them too.
        guarded: False takes the driver's watchdog away; for negative controls only.
        drone: which drone of the world it is; None for its first.
        tracking: what hears the tracking system, and as which of its listeners; None for a client
            of its own.

    Attributes:
        world: as given.
        faults: what fails, and when.

    Raises:
        ConfigError: a fault that cannot be made in lock step.
    """

    def __init__(
        self,
        world: TwinWorld,
        site: Site,
        faults: FaultInjector | None = None,
        *,
        guarded: bool = True,
        drone: TwinDrone | None = None,
        tracking: tuple[SharedTracking, int] | None = None,
    ) -> None:
        self.world, self._drone = world, drone or world
        self.faults = FaultInjector(site) if faults is None else faults
        self._tracking, self._listener = tracking or (SharedTracking(world, (self.faults,)), 0)
        self._drone.set_limits(onboard_limits(site))
        self._failsafe = Failsafe(
            world.now, site.limits.tilt_max, site.drone.airframe, watched=guarded
        )
        self._wire = lockstep_wire(site, self._drone)
        self._lacks = site.drone.airframe.lacks
        self._pose_rate = PoseRate(site.drone.airframe.capabilities.external_pose_rate)
        self._sent_at, self._link = world.now, site.drone.airframe.link
        self._uplink = PacketStream(FaultComponent.COMMANDS, _COMMANDS)
        self._downlink = PacketStream(FaultComponent.TELEMETRY, _REPORTS)
        self._pilot_link = PacketStream(FaultComponent.PILOT, _STEPS)
        self._steps_under_way: deque[tuple[float, _Step]] = deque()
        self._commands_under_way: deque[tuple[float, _Datagram]] = deque()
        self._reports_under_way: deque[tuple[float, OnboardState]] = deque()
        self._number = self._heard_number = 0
        self._report: Telemetry | None = None
        self._understood: tuple[OnboardState, Telemetry] | None = None
        self._reported_at = -1.0

    @property
    def now(self) -> float:
        """World time [s]."""
        return self.world.now

    def inject(self, *faults: Fault) -> None:
        """Let these faults happen, too; raises ConfigError for one that cannot be made here."""
        self.faults.inject(*faults)

    def advance(self, seconds: float) -> None:
        """Let the world run while commands are repeated at the driver's rate."""
        advance_together((self,), seconds)

    @property
    def next_beat(self) -> float:
        """When its driver has something to do next [s]."""
        return min(self._sent_at + self._link.repeat_after, self._next_arrival())

    def beat(self) -> None:
        """Let the drone hear what has arrived, and repeat the command when it is time to."""
        self._deliver()
        if self._sent_at + self._link.repeat_after <= self.now:
            self._transmit()

    def sightings(self) -> tuple[Sighting, ...]:
        """Return what tracking reported since the last call, oldest first."""
        return self._tracking.sightings(self._listener)

    def telemetry(self) -> Telemetry | None:
        """Return the drone's newest report; None before the first.

        As on the wire: battery in whole percent, no vertical speed.
        """
        report = self._newest_report()
        return None if report is None else self._wire.understood(report)

    def _newest_report(self) -> Telemetry | None:
        onboard = self._drone.onboard()
        if not self.faults.schedule.faults:
            return self._telemetry_of(onboard)
        if onboard.at > self._reported_at:
            self._reported_at = onboard.at
            reported = self.faults.reported(onboard)
            self._reports_under_way.extend(
                self._downlink.sent(reported, self.faults.schedule, onboard.at)
            )
        while self._reports_under_way and self._reports_under_way[0][0] <= self.now + _ROUNDING:
            due, onboard = self._reports_under_way.popleft()
            self._report = as_measured(telemetry_of(onboard, due), self._lacks)
        return self._report

    def _telemetry_of(self, onboard: OnboardState) -> Telemetry:
        """Return a report that is received as it is written, once for each state."""
        if self._understood is None or self._understood[0] is not onboard:
            self._understood = onboard, as_measured(telemetry_of(onboard), self._lacks)
        return self._understood[1]

    def send(self, command: Command, motion: KnownMotion | None = None) -> None:
        """Hand over the command in force from now on, and how the drone moves."""
        now = self.now
        self._steps_under_way.extend(
            self._pilot_link.sent((now, command, motion), self.faults.schedule, now)
        )
        while self._steps_under_way and self._steps_under_way[0][0] <= now + _ROUNDING:
            self._hear(*self._steps_under_way.popleft()[1])

    def send_pose(self, seen: Sighting | None) -> None:
        """Hand over where tracking saw the drone, to one that wants to know."""
        due = self._pose_rate.due(seen)
        if due is not None:
            self._wire.see(self._drone, due)

    def _hear(self, issued_at: float, command: Command, motion: KnownMotion | None) -> None:
        """Let the driver hear a step of the pilot; one that is late arrives with a later step."""
        action_changed = self._failsafe.update(command, self.now, issued_at, motion)
        if action_changed or self.now - self._sent_at >= self._link.interval_min:
            self._transmit()

    def disturb(self) -> None:
        """Let the faults act on the drone, and on who is in its way."""
        drone = self._drone
        if isinstance(self.world, SimulatedWorld):
            assert isinstance(drone, SimulatedWorld | SimulatedDrone)
            self.faults.act_on(self.world, drone)
        elif self.faults.schedule.faults:
            raise ConfigError("faults", "need the simulated room; this world has no physics")

    def _transmit(self) -> None:
        """Send what would be one datagram."""
        self._sent_at = self.now
        self._number += 1
        report = self.telemetry()
        told = self._failsafe.decide(self.now, report)
        commands = self._wire.encoded(told, self.now, report)
        datagram = (self._number, commands)
        self._commands_under_way.extend(self._uplink.sent(datagram, self.faults.schedule, self.now))
        self._deliver()

    def _next_arrival(self) -> float:
        return self._commands_under_way[0][0] if self._commands_under_way else inf

    def _deliver(self) -> None:
        """Let the drone obey the datagrams that have arrived; it drops older ones than heard."""
        while self._next_arrival() <= self.now + _ROUNDING:
            number, commands = self._commands_under_way.popleft()[1]
            if number <= self._heard_number:
                continue
            self._heard_number = number
            self._drone.keep_alive()
            for command in commands:
                self._wire.obey(self._drone, command)


def advance_together(rooms: Sequence[LockstepRoom], seconds: float) -> None:
    """Let the world of some drones run, while each driver repeats its commands at its own rate."""
    world = rooms[0].world
    end = world.now + seconds
    for room in rooms:
        room.disturb()
    while (beat := min(room.next_beat for room in rooms)) <= end:
        world.advance(max(0.0, beat - world.now))
        for room in rooms:
            room.beat()
    world.advance(max(0.0, end - world.now))
