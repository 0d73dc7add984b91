"""Time that a test's own event loop makes: a flight over a real socket on any machine's time."""

from __future__ import annotations

import asyncio
import selectors
import time
from collections.abc import Callable
from concurrent.futures import Executor
from typing import Any


class _Selector(selectors.DefaultSelector):  # type: ignore[misc, valid-type]
    """Looks whether something came; where nothing did, time jumps to the next timer."""

    def __init__(self) -> None:
        super().__init__()
        self.now = time.monotonic()
        self.in_threads = 0

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        if timeout is None or self.in_threads:
            return super().select(timeout)
        came = super().select(0)
        if not came:
            self.now += timeout
        return came


class VirtualTimeLoop(asyncio.SelectorEventLoop):
    """An event loop whose clock moves only when nothing is left to do.

    What is sent over loopback has arrived when the sender's call returns, so no packet is ever
    under way. A busy machine makes such a test slower and changes nothing else. It is for tests
    whose peers live in the same loop: another process would be left behind.
    """

    def __init__(self) -> None:
        self._peek = _Selector()
        super().__init__(self._peek)

    def time(self) -> float:
        """Return the time [s] of this loop."""
        return self._peek.now

    def run_in_executor(  # type: ignore[override]
        self, executor: Executor | None, func: Callable[..., Any], *args: Any
    ) -> asyncio.Future[Any]:
        """Run it in a thread; no time passes meanwhile."""
        future: asyncio.Future[Any] = super().run_in_executor(executor, func, *args)
        self._peek.in_threads += 1

        def done(_: object) -> None:
            self._peek.in_threads -= 1

        future.add_done_callback(done)
        return future


def loop_time(_: object = None) -> float:
    """Return the time [s] of the loop that runs, else of the machine."""
    try:
        return asyncio.get_running_loop().time()
    except RuntimeError:
        return time.monotonic()
