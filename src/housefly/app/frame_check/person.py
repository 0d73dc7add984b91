"""The person who carries the drone: reads words and a live line, and presses Enter."""

from __future__ import annotations

import asyncio
import contextlib
import os
import sys
import threading
from typing import Protocol

from rich.status import Status

from housefly.app.terminal import console
from housefly.errors import LinkError

_PAUSE = 0.2
"""However fast somebody presses Enter, tracking and drone are listened to in between [s]."""


class Person(Protocol):
    """Whoever carries the drone."""

    def tell(self, words: str) -> None:
        """Say something that stays to be read."""
        ...

    def show(self, words: str) -> None:
        """Show what is seen now in place of what was shown before."""
        ...

    async def done(self) -> None:
        """Wait until the person says that the step is done; raises LinkError when they left."""
        ...


class PersonAtTerminal:
    """Somebody at this terminal, or a script that writes lines; a context manager."""

    def __init__(self) -> None:
        self._lines: asyncio.Queue[bool] = asyncio.Queue()
        self._status = Status("", console=console)

    def __enter__(self) -> PersonAtTerminal:
        loop = asyncio.get_running_loop()
        # A thread, because a file or /dev/null cannot be waited for; raw reads, because a daemon
        # thread that holds the lock of sys.stdin breaks the end of the process.
        threading.Thread(target=self._read, args=(loop,), name="typed lines", daemon=True).start()
        if console.is_terminal:
            self._status.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._status.stop()

    def tell(self, words: str) -> None:
        """Print a line."""
        console.print(words, soft_wrap=True, markup=False)

    def show(self, words: str) -> None:
        """Show what is seen now; nothing where the output is no terminal."""
        if console.is_terminal:
            self._status.update(f"[dim]{words.replace('[', '(')}[/dim]  - Enter when done")

    async def done(self) -> None:
        """Wait for Enter; raises LinkError at the end of the input."""
        while not self._lines.empty() and sys.stdin.isatty():
            if not self._lines.get_nowait():
                raise _left()
        if not await self._lines.get():
            raise _left()
        await asyncio.sleep(_PAUSE)

    def _read(self, loop: asyncio.AbstractEventLoop) -> None:
        def say(is_line: bool) -> None:
            with contextlib.suppress(RuntimeError):
                loop.call_soon_threadsafe(self._lines.put_nowait, is_line)

        while True:
            try:
                typed = os.read(0, 4096)
            except OSError:
                typed = b""
            for _ in range(typed.count(b"\n")):
                say(True)
            if not typed:
                say(False)
                return


def _left() -> LinkError:
    return LinkError("the input ended before the last step: nothing is kept; run it again")
