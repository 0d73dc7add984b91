"""Work that a process does again and again; what it refuses on purpose is told once."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import NoReturn

from housefly.config.process_log import log_line
from housefly.config.text import without_numbers
from housefly.errors import HouseflyError


async def repeat(period: float, work: Callable[[], None], name: str) -> NoReturn:
    """Do something for ever, on a thread.

    Args:
        period: pause between two times [s].
        work: what to do; a HouseflyError of it is told in the log, once while it stays the same.
        name: of the process, before what is told.
    """
    told = ""
    while True:
        try:
            await asyncio.to_thread(work)
            told = ""
        except HouseflyError as error:
            if (reason := without_numbers(str(error))) != told:
                log_line(f"{name}: {error}")
            told = reason
        await asyncio.sleep(period)
