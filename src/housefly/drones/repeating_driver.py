"""The half of a driver between pilot and wire: the command in force, said again and again."""

from __future__ import annotations

import asyncio
from abc import ABC, abstractmethod
from collections.abc import Callable, Coroutine
from math import inf

from housefly.clock import Clock
from housefly.config.capabilities import Capabilities
from housefly.config.drone import DroneConfig
from housefly.config.process_log import log_traceback
from housefly.drones.failsafe import Failsafe, Permit
from housefly.messages import Command, KnownMotion
from housefly.messages.words import Words

_FOUND_IN_THE_AIR = Words("found in the air by a new driver: it only hovers and lands")


class RepeatingDriver(ABC):
    """What every driver does that keeps the command in force itself.

    A command whose action differs from the one before leaves in the same call. FLY setpoints leave
    at the drone's rate, timed so that a regular pilot's setpoint leaves as soon as it comes; when
    the pilot pauses, the newest command is repeated.

    Args:
        config: of the drone.
        tilt_max: that the failsafe brakes with [rad].
        clock: for ages and rates.
    """

    def __init__(self, config: DroneConfig, tilt_max: float, clock: Clock) -> None:
        self._config, self._clock = config, clock
        self._failsafe = Failsafe(clock.now(), tilt_max, config.airframe)
        self._sent_at = -inf
        self._tasks: dict[str, asyncio.Task[None]] = {}

    @property
    def capabilities(self) -> Capabilities:
        """What its model can do."""
        return self._config.airframe.capabilities

    @property
    def video_connected(self) -> bool:
        """Whether pictures arrive; without a camera of ours they never do."""
        return False

    def send(
        self,
        command: Command,
        motion: KnownMotion | None = None,
        issued_at: float | None = None,
    ) -> None:
        """Hand over the command in force from now on; returns at once.

        Args:
            command: of the pilot.
            motion: what the pilot knew of the drone's motion; None says nothing new.
            issued_at: when the pilot gave it [s]; now when None.
        """
        now = self._clock.now()
        action_changed = self._failsafe.update(command, now, issued_at, motion)
        if action_changed or now - self._sent_at >= self._config.airframe.link.interval_min:
            self._transmit(now)

    def abandon(self) -> None:
        """Note that the pilot is gone: a flying drone brakes now and lands soon."""
        self._failsafe.abandon()
        self._transmit(self._clock.now())

    def land_for_good(self) -> None:
        """Land now, and take no order any more but to cut the motors."""
        self._failsafe.land_for_good()
        self._transmit(self._clock.now())

    @property
    def _permit_notes(self) -> tuple[Words, ...]:
        """What a person should know of what the failsafe lets it do."""
        is_found = self._failsafe.permit is Permit.HOVER_AND_LAND
        return (_FOUND_IN_THE_AIR,) if is_found else ()

    def _start(self, name: str, work: Callable[[], Coroutine[None, None, None]]) -> None:
        if name not in self._tasks:
            self._tasks[name] = asyncio.create_task(work(), name=name)

    def _start_repeating(self) -> None:
        self._start("repeat commands", self._repeat)

    async def _end_tasks(self) -> None:
        for task in self._tasks.values():
            task.cancel()
        await asyncio.gather(*self._tasks.values(), return_exceptions=True)
        self._tasks.clear()

    async def _repeat(self) -> None:
        """Repeat the command in force; what fails in it must not end the stream."""
        after = self._config.airframe.link.repeat_after
        while True:
            now = self._clock.now()
            if now - self._sent_at >= after:
                try:
                    self._transmit_again(now)
                except Exception:
                    self._land_blindly()
                    log_traceback()
            await asyncio.sleep(max(0.001, self._sent_at + after - self._clock.now()))

    def _transmit_again(self, now: float) -> None:
        """Send the command in force because its time has come."""
        self._transmit(now)

    @abstractmethod
    def _transmit(self, now: float) -> None:
        """Send what the failsafe decides now [s], where the wire is open, and set ``_sent_at``."""

    @abstractmethod
    def _land_blindly(self) -> None:
        """Tell the drone to land by itself: nothing else can be decided."""
