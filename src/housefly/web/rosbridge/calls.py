"""Wishes of all clients on threads: a STOP never waits behind what takes long."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

from housefly.ros2.order_line import RosReply
from housefly.ros2.wishes import replied

WAITING_MAX = 4
"""Wishes of one client that may wait, of those that make safer as many again."""
_THREADS, _SAFER_THREADS = 6, 4


class Calls:
    """Shared by all clients; used on one loop."""

    def __init__(self) -> None:
        self._threads = ThreadPoolExecutor(_THREADS, "rosbridge")
        self._safer = ThreadPoolExecutor(_SAFER_THREADS, "rosbridge-safer")

    def close(self) -> None:
        """Shut the threads down without waiting for answers."""
        for threads in (self._threads, self._safer):
            threads.shutdown(wait=False, cancel_futures=True)

    async def answered(self, wish: Callable[[], RosReply], *, is_safer: bool) -> RosReply:
        """Return what becomes of a wish."""
        threads = self._safer if is_safer else self._threads
        return await asyncio.get_running_loop().run_in_executor(threads, replied, wish)
