"""One connection after the other, for every client of a wire that may fall silent and come back."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import NoReturn

from housefly.errors import LinkError, MissingPartError, WireError

FIRST_PAUSE, LONGEST_PAUSE = 0.1, 2.0
"""Between two connections [s]; twice as long each time that nothing was heard."""

Trouble = LinkError | WireError | MissingPartError
"""What ends a connection and is no reason to give up."""


async def reconnect_for_ever(
    session: Callable[[], Awaitable[None]],
    heard: Callable[[], int],
    on_trouble: Callable[[Trouble], None],
) -> NoReturn:
    """Run session after session; ends only when cancelled.

    Args:
        session: reads one connection to its end.
        heard: how much arrived so far; after a session in which anything did, the next begins soon.
        on_trouble: takes what ended a session.
    """
    pause = FIRST_PAUSE
    while True:
        before = heard()
        try:
            await session()
        except (LinkError, WireError, MissingPartError) as error:
            on_trouble(error)
        if heard() > before:
            pause = FIRST_PAUSE
        await asyncio.sleep(pause)
        pause = min(2 * pause, LONGEST_PAUSE)
