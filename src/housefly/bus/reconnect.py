"""The base of every client whose device may fall silent and come back."""

from __future__ import annotations

import asyncio
from abc import ABC, abstractmethod
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from typing import ClassVar, Generic, NoReturn, TypeVar

from housefly.clock import Clock, RealClock
from housefly.config.process_log import log_traceback
from housefly.errors import LinkError, MissingPartError, WireError
from housefly.messages.words import UNSAID, Words, error_words

DATA_AGE_MAX = 1.0
"""A client is connected while its newest data are at most this old [s]."""
_FIRST_PAUSE, _LONGEST_PAUSE = 0.1, 2.0
"""Between two connections [s]; doubled each time that nothing arrived."""

TcpStream = tuple[asyncio.StreamReader, asyncio.StreamWriter]
_Item = TypeVar("_Item")
_Result = TypeVar("_Result")


class ReconnectingClient(ABC, Generic[_Item]):
    """Connects, reads until the connection ends, and reconnects for ever.

    A subclass implements ``_read_connection`` and calls ``_data_arrived`` for all that it reads.

    Args:
        where: names the other side in messages.
        clock: for ages.

    Attributes:
        malformed: connections given up because of bytes that are not the protocol.
    """

    SILENCE_TIMEOUT: ClassVar[float] = 5.0
    """Longest silence [s] before reconnecting: a pulled cable gives no notice."""

    def __init__(self, where: str, clock: Clock | None = None) -> None:
        self.malformed = 0
        self._where = where
        self._clock = clock or RealClock()
        self._data_at = float("-inf")
        self._problem = Words("not connected to {name} yet", name=where)
        self._pause = _FIRST_PAUSE

    @property
    def connected(self) -> bool:
        """Whether data arrived within the last second."""
        return self._clock.now() - self._data_at <= DATA_AGE_MAX

    @property
    def problem(self) -> Words:
        """Why no data arrive; UNSAID while they do."""
        return self._problem or (UNSAID if self.connected else self._no_data_problem())

    async def run(self, sink: Callable[[_Item], None]) -> NoReturn:
        """Connect and read for ever; ends only when cancelled."""
        while True:
            try:
                await self._read_connection(sink)
            except WireError as error:
                self.malformed += 1
                self._problem = self._protocol_problem(error)
            except (LinkError, MissingPartError) as error:
                self._problem = error_words(error)
            except Exception as error:
                # Nobody waits for this task: a defect here would end all data in silence.
                self._problem = Words(
                    "{name}: reading failed ({error})",
                    name=self._where,
                    error=f"{type(error).__name__}: {error}",
                )
                log_traceback()
            stop_if_cancelled()
            await asyncio.sleep(self._pause)
            self._pause = min(2 * self._pause, _LONGEST_PAUSE)

    @abstractmethod
    async def _read_connection(self, sink: Callable[[_Item], None]) -> None:
        """Read one connection to its end; raises LinkError, WireError or MissingPartError."""

    def _protocol_problem(self, error: WireError) -> Words:
        """Return why the other side's bytes make no sense."""
        return error_words(error)

    def _no_data_problem(self) -> Words:
        """Return why an open connection brings no data."""
        return Words("connected to {name}, but it is silent", name=self._where)

    def _data_arrived(self, now: float) -> None:
        """Note new data [s]; the next reconnection begins soon."""
        self._data_at = now
        self._pause = _FIRST_PAUSE

    @asynccontextmanager
    async def _open(self, stream: TcpStream) -> AsyncIterator[TcpStream]:
        """Close a stream at the end; raises LinkError when it breaks."""
        try:
            yield stream
        except (asyncio.IncompleteReadError, OSError) as error:
            raise LinkError(connection_lost(self._where)) from error
        finally:
            stream[1].transport.abort()

    async def _before_timeout(self, reading: Awaitable[_Result], silence: str) -> _Result:
        """Await a read; raises LinkError with this text after ``SILENCE_TIMEOUT``."""
        return await within(self.SILENCE_TIMEOUT, reading, silence)


def connection_lost(where: str) -> Words:
    """Return that a connection ended."""
    return Words("the connection to {name} was lost", name=where)


def stop_if_cancelled() -> None:
    """Raise the cancellation that a library turned into a lost connection while it left it.

    Not for a task that itself runs a ``TaskGroup``: Python 3.11 leaves its count raised.
    """
    task = asyncio.current_task()
    if task is not None and task.cancelling():
        raise asyncio.CancelledError


async def within(seconds: float, work: Awaitable[_Result], complaint: str) -> _Result:
    """Await work for at most this long [s]; raises LinkError with the complaint afterwards."""
    try:
        async with asyncio.timeout(seconds):
            return await work
    except TimeoutError as error:
        raise LinkError(complaint) from error


async def open_tcp(
    address: str, port: int, timeout: float, complaint: str, limit: int = 64 * 1024
) -> TcpStream:
    """Connect by TCP; raises LinkError with the complaint.

    Args:
        address: host name or IP address.
        port: TCP port.
        timeout: for the connection to be accepted [s].
        complaint: what to say when it is not.
        limit: of the reader's buffer [bytes].
    """
    try:
        async with asyncio.timeout(timeout):
            return await asyncio.open_connection(address, port, limit=limit)
    except (OSError, UnicodeError) as error:
        raise LinkError(complaint) from error
