"""The base of trackers whose library runs in a child process: it can be killed when it hangs."""

from __future__ import annotations

import asyncio
from abc import abstractmethod
from asyncio.subprocess import PIPE, Process
from contextlib import suppress

from housefly.bus.reconnect import ReconnectingClient
from housefly.clock import Clock
from housefly.errors import LinkError, WireError
from housefly.messages import Sighting
from housefly.messages.words import UNSAID, Words
from housefly.tracking.contracts import SightingSink
from housefly.tracking.counts import FrameCounts


class ChildTracker(ReconnectingClient[tuple[Sighting, ...]]):
    """Starts the child, hands its frames to a sink as they arrive, and restarts it for ever.

    Attributes:
        counts: frames and what was dropped.
    """

    def __init__(self, where: str, clock: Clock | None) -> None:
        super().__init__(where, clock)
        self.counts = FrameCounts()

    @property
    def problem(self) -> Words:
        """Why no poses arrive, or why they are refused; UNSAID where all is well."""
        return self._problem or self.counts.unit_problem(self._clock.now()) or super().problem

    @abstractmethod
    def _command(self) -> tuple[str, ...]:
        """Return what starts the child; raises MissingPartError where its library is missing."""

    @abstractmethod
    def _begin(self) -> None:
        """Forget what spans the lines of one child."""

    @abstractmethod
    def _read(self, line: bytes, received_at: float) -> tuple[Sighting, ...] | None:
        """Return the bodies of a line, None when nothing in it is new; raises WireError."""

    async def _read_connection(self, sink: SightingSink) -> None:
        command = self._command()
        child = await asyncio.create_subprocess_exec(*command, stdin=PIPE, stdout=PIPE)
        try:
            self._begin()
            while True:
                line = await self._line(child)
                now = self._clock.now()
                sightings = self._read(line, now)
                self._problem = UNSAID
                if sightings is not None:
                    self._data_arrived(now)
                    sink(sightings)
        finally:
            with suppress(ProcessLookupError):
                child.kill()
            await child.wait()

    async def _line(self, child: Process) -> bytes:
        assert child.stdout is not None
        silence = f"{self._where} is silent; is it there, streaming, and this body seen?"
        try:
            line = await self._before_timeout(child.stdout.readline(), silence)
        except ValueError as error:
            raise WireError("bridge line: longer than 64 kB") from error
        if not line:
            raise LinkError(f"the bridge to {self._where} ended")
        return line
