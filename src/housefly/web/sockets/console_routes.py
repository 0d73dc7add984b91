"""The console's WebSocket, one reader and one writer a browser, and STOP without a socket."""

from __future__ import annotations

import asyncio
from contextlib import suppress

from pydantic import TypeAdapter
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import BaseRoute, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from housefly.web.access.bearer import bears
from housefly.web.access.session import Session
from housefly.web.access.session_auth import SessionAuth, chosen_subprotocol
from housefly.web.http.drone_of_request import drone_of_request
from housefly.web.http.responses import error_response, json_response
from housefly.web.sockets.console import Console
from housefly.web.sockets.consoles import Consoles, DronesView
from housefly.web.viewers.viewer import Viewer


def console_routes(consoles: Consoles, auth: SessionAuth, key: str = "") -> list[BaseRoute]:
    """Return ``/socket``, ``/stop``, ``/land`` and ``/drones``.

    Each takes the name of a drone as ``?drone=``; without it STOP and landing are for all. Programs
    with ``key`` as their bearer token may stop and land, too; "" lets none in.
    """

    def who_asks(request: Request) -> tuple[str, str] | None:
        """Return the name of who asks and of their session; None for nobody that we know."""
        if bears(request, key):
            return _PROGRAM, ""
        session = auth.session_of(request) if auth.is_own_page(request) else None
        return None if session is None else (session.user or _NO_SOCKET, session.name)

    async def socket(websocket: WebSocket) -> None:
        console = consoles.named(drone_of_request(websocket))
        if console is None:
            await websocket.close(1008, _NO_SUCH_DRONE)
        elif session := await auth.admit(websocket):
            with console.seats.taken(session.owner) as seated:
                await _serve(websocket, console, session, seated=seated)

    async def stop(request: Request) -> Response:
        who = who_asks(request)
        if who is None:
            return JSONResponse({"reason": "this page may not stop the drone"}, status_code=403)
        name = drone_of_request(request)
        if consoles.named(name) is None:
            name = ""  # rather all than none
        consoles.stop(*who, name)
        return JSONResponse({"stopped": True})

    async def land(request: Request) -> Response:
        who = who_asks(request)
        if who is None:
            return JSONResponse({"reason": "this page may not land the drone"}, status_code=403)
        name = drone_of_request(request)
        if consoles.named(name) is None:
            return JSONResponse({"reason": _NO_SUCH_DRONE}, status_code=404)
        consoles.land(*who, name)
        return JSONResponse({"landing": True})

    async def drones(request: Request) -> Response:
        if not auth.has_session(request):
            return error_response(401, "this browser has no session")
        return json_response(_DRONES.dump_json(consoles.view()))

    return [
        WebSocketRoute("/socket", socket),
        Route("/stop", stop, methods=["POST"]),
        Route("/land", land, methods=["POST"]),
        Route("/drones", drones),
    ]


_DRONES: TypeAdapter[DronesView] = TypeAdapter(DronesView)
_NO_SOCKET = "a browser without a socket"
_PROGRAM = "a program"
_NO_SUCH_DRONE = "there is no drone of this name"
HELLO_TIMEOUT = 10.0
"""A socket that has not said hello by then [s] is closed."""


_READ_AT_ONCE, _FLOOD_PAUSE = 20, 0.02
"""After so many refused messages a socket is not read for a moment [s]."""


def _expect_hello(viewer: Viewer) -> None:
    if not viewer.present:
        viewer.close(1008, "a browser says hello first")


async def _serve(websocket: WebSocket, console: Console, session: Session, *, seated: bool) -> None:
    """Carry messages both ways until either side leaves."""
    if not seated:
        await websocket.close(1013, "too many viewers, in all or of this browser")
        return
    viewer = Viewer(websocket, session)
    await websocket.accept(chosen_subprotocol(websocket))
    console.viewers.add(viewer)
    hello = asyncio.get_running_loop().call_later(HELLO_TIMEOUT, _expect_hello, viewer)
    writer = asyncio.create_task(viewer.write())
    try:
        # The writer ends when the console closes this viewer; reading ends with it.
        while not writer.done():
            message = await websocket.receive()
            if message["type"] == "websocket.disconnect":
                break
            console.receive(viewer, message.get("text") or "")
            # Messages that wait in a queue are taken without waiting: others must have their turn.
            # Whoever sends too much is read slowly, so that the network holds it back.
            slow = viewer.limiter.refused % _READ_AT_ONCE == _READ_AT_ONCE - 1
            await asyncio.sleep(_FLOOD_PAUSE if slow else 0.0)
    finally:
        hello.cancel()
        console.remove_viewer(viewer)
        writer.cancel()
        with suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError):
            await writer
