"""A serial port as an asyncio transport: bytes in, bytes out, nothing waits."""

from __future__ import annotations

import asyncio
import os
import termios
import tty
from collections.abc import Callable

from housefly.errors import LinkError

_READ_MAX = 4096


class SerialPort:
    """One open port; all calls belong to one asyncio loop.

    Args:
        place: its file.
        baud: rate.
        hear: takes what comes.
        lost: called once nothing comes any more.

    Attributes:
        unsent: bytes that the port did not take.

    Raises:
        LinkError: there is no such port, or it has no such rate.
    """

    def __init__(
        self, place: str, baud: int, hear: Callable[[bytes], None], lost: Callable[[], None]
    ) -> None:
        speed = getattr(termios, f"B{baud}", None)
        if speed is None:
            raise LinkError(f"cannot open {place}: it has no rate of {baud} baud")
        self._hear, self._lost, self.unsent = hear, lost, 0
        try:
            self._file = os.open(place, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
            tty.setraw(self._file)
            settings = termios.tcgetattr(self._file)
            settings[4] = settings[5] = speed
            termios.tcsetattr(self._file, termios.TCSANOW, settings)
        except (OSError, termios.error) as error:
            raise LinkError(f"cannot open {place}: {error.args[-1]}") from error
        self._loop = asyncio.get_running_loop()
        self._loop.add_reader(self._file, self._read)

    def write(self, data: bytes) -> None:
        """Send bytes; what the port does not take now is dropped, for it would come too late."""
        if self._file < 0:
            return
        try:
            self.unsent += len(data) - os.write(self._file, data)
        except BlockingIOError:
            self.unsent += len(data)
        except OSError:
            self._end()

    def abort(self) -> None:
        """Close it."""
        if self._file >= 0:
            self._loop.remove_reader(self._file)
            os.close(self._file)
            self._file = -1

    def _read(self) -> None:
        try:
            data = os.read(self._file, _READ_MAX)
        except BlockingIOError:
            return
        except OSError:
            data = b""
        if data:
            self._hear(data)
        else:
            self._end()

    def _end(self) -> None:
        self.abort()
        self._lost()
