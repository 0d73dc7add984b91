"""One frame check over real wires: leads a person through the steps and returns the verdict."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable
from functools import partial

from housefly.app.frame_check.carrying_hands import CarryingHands
from housefly.app.frame_check.frame_log import FrameLog
from housefly.app.frame_check.live_words import live_words
from housefly.app.frame_check.person import Person
from housefly.clock import Clock
from housefly.drones.contract import Drone
from housefly.errors import LinkError
from housefly.lab.frames.findings import FrameVerdict
from housefly.lab.frames.guide import CarryGuide
from housefly.lab.frames.plan import STEPS, CarryStep
from housefly.tracking.contracts import Tracker

_START_TIMEOUT = 30.0
"""Longest wait for tracking, and for the drone after it [s]."""
_DRONE_TIMEOUT = 20.0
_SETTLING_MAX = 3.0
"""A hand needs so long to be still, and a busy computer to go on [s]."""
_POLL_PERIOD = 0.01
_SHOW_PERIOD = 0.2


class FrameCheckSession:
    """Carries one guide through; all calls belong to one asyncio loop.

    Args:
        guide: what is asked, and what is made of it.
        tracker: the tracking system.
        drone: its own reports; it is never told anything.
        person: whoever carries it.
        clock: of both.
        hands: simulated hands that do each step when Enter is pressed; None for a real person.
    """

    def __init__(
        self,
        guide: CarryGuide,
        tracker: Tracker,
        drone: Drone,
        person: Person,
        clock: Clock,
        hands: CarryingHands | None = None,
    ) -> None:
        self._guide, self._tracker, self._drone = guide, tracker, drone
        self._person, self._clock, self._hands = person, clock, hands
        self._log = FrameLog()

    async def run(self) -> FrameVerdict:
        """Return the verdict after the last step.

        Raises:
            LinkError: tracking does not answer, or the person left.
        """
        work = [
            asyncio.create_task(
                self._tracker.run(lambda seen: self._log.see(seen, self._clock.now()))
            ),
            asyncio.create_task(self._connect()),
            asyncio.create_task(self._listen()),
        ]
        try:
            await self._wait_for_wires()
            work.append(asyncio.create_task(self._show()))
            while self._guide.step is not None:
                await self._do_step(self._guide.step)
            return self._guide.verdict()
        finally:
            for task in work:
                task.cancel()
            await asyncio.gather(*work, return_exceptions=True)
            await self._drone.close()

    async def _do_step(self, step: CarryStep) -> None:
        """Ask for one step until its sample is taken, or all begins anew."""
        guide, person = self._guide, self._person
        number = STEPS.index(step) + 1
        person.tell(f"\n{number}/{len(STEPS)}  {guide.instruction}")
        began, is_done = self._clock.now(), False
        while True:
            await person.done()
            if self._hands is not None and not is_done:
                await self._hands.do(step)
                is_done = True
            await self._within(_SETTLING_MAX, partial(self._is_still, began))
            now = self._clock.now()
            person.tell(f"   {live_words(guide, self._log, now)}")
            answer = guide.offer(self._log.track(began), now)
            for words in answer.words:
                person.tell(f"   {words}")
            if guide.step is not step:
                return
            person.tell(f"   -> still step {number}: Enter when done")
            began = now if answer.begins_anew else began

    async def _wait_for_wires(self) -> None:
        self._person.show("waiting for tracking")
        if not await self._within(_START_TIMEOUT, lambda: self._tracker.connected):
            raise LinkError(f"tracking does not answer: {self._tracker.problem}")
        self._person.show("waiting for the drone")
        if not await self._within(_DRONE_TIMEOUT, lambda: self._drone.connected):
            self._person.tell(
                f"The drone itself does not answer ({self._drone.problem or 'no report'}). Without"
                " its own heading the turn is believed as asked, and a delay is not found."
            )

    def _is_still(self, began: float) -> bool:
        return self._guide.is_still(self._log.track(began), self._clock.now())

    async def _within(self, seconds: float, holds: Callable[[], bool]) -> bool:
        end = self._clock.now() + seconds
        while not holds():
            if self._clock.now() > end:
                return False
            await asyncio.sleep(0.05)
        return True

    async def _connect(self) -> None:
        while True:
            with contextlib.suppress(LinkError):
                await self._drone.connect()
                return
            await asyncio.sleep(1.0)

    async def _listen(self) -> None:
        while True:
            self._log.hear(self._drone.telemetry)
            await asyncio.sleep(_POLL_PERIOD)

    async def _show(self) -> None:
        while True:
            if self._guide.step is not None:
                self._person.show(live_words(self._guide, self._log, self._clock.now()))
            await asyncio.sleep(_SHOW_PERIOD)
