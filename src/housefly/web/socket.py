"""The WebSocket of the console: one reader and one writer for each browser."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from starlette.websockets import WebSocket, WebSocketDisconnect

from housefly.web.console import Console
from housefly.web.security import Doorkeeper, same_origin
from housefly.web.viewer import Viewer


async def allowed(socket: WebSocket, doorkeeper: Doorkeeper) -> bool:
    """Turn a handshake away that comes from another site's page or without a session."""
    if same_origin(socket) and doorkeeper.knows(socket):
        return True
    await socket.close(1008, "this page may not open the console")
    return False


async def serve(socket: WebSocket, console: Console) -> None:
    """Carry messages both ways until either side leaves."""
    viewer = Viewer(socket)
    await socket.accept()
    if not console.enter(viewer):
        await socket.close(1013, "too many viewers")
        return
    writer = asyncio.create_task(viewer.write())
    try:
        # The writer ends by itself when the viewer is turned out; then reading ends as well.
        while not writer.done():
            message = await socket.receive()
            if message["type"] == "websocket.disconnect":
                break
            console.heard(viewer, message.get("text") or "")
    finally:
        console.leave(viewer)
        writer.cancel()
        with suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError):
            await writer
