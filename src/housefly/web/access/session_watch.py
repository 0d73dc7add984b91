"""Closes a WebSocket soon after its session is over: logged out, removed, or too old."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress

from starlette.websockets import WebSocket

from housefly.web.access.roles import Role
from housefly.web.access.session import Session
from housefly.web.access.session_auth import SessionAuth

LOOK_PERIOD = 1.0
"""How often it is asked whether a session still is one [s]."""
CLOSE_SESSION_OVER = 4003
"""WebSocket close code."""


@asynccontextmanager
async def while_logged_in(
    websocket: WebSocket, auth: SessionAuth, session: Session | None, needed: Role
) -> AsyncIterator[None]:
    """Close a WebSocket when its session ends or may no longer do what it does; None has none."""
    watching = asyncio.create_task(_close_at_end(websocket, auth, session, needed))
    try:
        yield
    finally:
        watching.cancel()
        with suppress(asyncio.CancelledError, RuntimeError):
            await watching


async def _close_at_end(
    websocket: WebSocket, auth: SessionAuth, session: Session | None, needed: Role
) -> None:
    if session is None:
        return
    while (now := auth.renewed(session)) is not None and now.role.includes(needed):
        await asyncio.sleep(LOOK_PERIOD)
    await websocket.close(CLOSE_SESSION_OVER, "this session is over")
