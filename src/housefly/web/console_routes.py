"""The console's WebSocket, one reader and one writer a browser, and STOP without a socket."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import BaseRoute, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from housefly.web.console import Console
from housefly.web.session_auth import SessionAuth
from housefly.web.viewer import Viewer


def console_routes(console: Console, auth: SessionAuth) -> list[BaseRoute]:
    """Return ``/socket`` and ``/stop``."""

    async def socket(websocket: WebSocket) -> None:
        if await auth.admit(websocket):
            await _serve(websocket, console)

    async def stop(request: Request) -> Response:
        if not auth.is_own_page(request):
            return JSONResponse({"reason": "this page may not stop the drone"}, status_code=403)
        console.stop("a browser without a socket")
        return JSONResponse({"stopped": True})

    return [WebSocketRoute("/socket", socket), Route("/stop", stop, methods=["POST"])]


async def _serve(websocket: WebSocket, console: Console) -> None:
    """Carry messages both ways until either side leaves."""
    viewer = Viewer(websocket)
    await websocket.accept()
    if not console.add_viewer(viewer):
        await websocket.close(1013, "too many viewers")
        return
    writer = asyncio.create_task(viewer.write())
    try:
        # The writer ends when the console closes this viewer; reading ends with it.
        while not writer.done():
            message = await websocket.receive()
            if message["type"] == "websocket.disconnect":
                break
            console.receive(viewer, message.get("text") or "")
    finally:
        console.remove_viewer(viewer)
        writer.cancel()
        with suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError):
            await writer
