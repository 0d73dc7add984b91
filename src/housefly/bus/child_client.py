"""The base of clients whose library runs in a child process: it can be killed when it hangs."""

from __future__ import annotations

import asyncio
from abc import abstractmethod
from asyncio.subprocess import PIPE, Process
from collections.abc import Callable
from contextlib import suppress
from typing import ClassVar, TypeVar

from housefly.bus.reconnect import ReconnectingClient
from housefly.errors import LinkError, WireError
from housefly.messages.words import UNSAID

_Item = TypeVar("_Item")


class ChildClient(ReconnectingClient[_Item]):
    """Starts the child, hands what its lines say to a sink, and restarts it for ever."""

    LINE_MAX: ClassVar[int] = 64 * 1024
    """Longest line of the child [bytes]."""

    @abstractmethod
    def _command(self) -> tuple[str, ...]:
        """Return what starts the child; raises MissingPartError where its library is missing."""

    @abstractmethod
    def _begin(self) -> None:
        """Forget what spans the lines of one child."""

    @abstractmethod
    def _read(self, line: bytes, received_at: float) -> _Item | None:
        """Return what a line says, None when nothing in it is new; raises LinkError, WireError."""

    async def _read_connection(self, sink: Callable[[_Item], None]) -> None:
        command, limit = self._command(), self.LINE_MAX
        child = await asyncio.create_subprocess_exec(*command, stdin=PIPE, stdout=PIPE, limit=limit)
        try:
            self._begin()
            while True:
                line = await self._line(child)
                now = self._clock.now()
                item = self._read(line, now)
                self._problem = UNSAID
                if item is not None:
                    self._data_arrived(now)
                    sink(item)
        finally:
            with suppress(ProcessLookupError):
                child.kill()
            await child.wait()

    def _silence(self) -> str:
        """Return what to say of a child that says nothing."""
        return f"{self._where} is silent"

    async def _line(self, child: Process) -> bytes:
        assert child.stdout is not None
        try:
            line = await self._before_timeout(child.stdout.readline(), self._silence())
        except ValueError as error:
            raise WireError(f"bridge line: longer than {self.LINE_MAX // 1024} kB") from error
        if not line:
            raise LinkError(f"the bridge to {self._where} ended")
        return line
