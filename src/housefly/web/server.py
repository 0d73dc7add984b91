"""The console's server as one ASGI application.

/                the console (with ``?token=`` : exchanges a one-time link for a session)
/socket          WebSocket: state to the browser, orders from it
/video           WebSocket: the drone's H.264
/stop            POST: STOP, for a browser whose socket is down
/static/...      the built client
/api/v1/...      the room: where things are, what happened (``web.room_api``)
/coverage        which parts of the room the tracking cameras see
/edits           places and no-fly zones: seen, saved, undone (``web.edits_api``)
"""

from __future__ import annotations

import asyncio
import logging
import secrets
import signal
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path

from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, RedirectResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.websockets import WebSocket

from housefly.bus.bus import Bus
from housefly.clock import Clock, RealClock
from housefly.config.furniture import FurnitureConfig
from housefly.errors import HouseflyError
from housefly.web import mjpeg, socket
from housefly.web.broadcast import Broadcast
from housefly.web.console import Console
from housefly.web.coverage_layer import CoverageLayer, CoverageView
from housefly.web.edit_desk import EditDesk
from housefly.web.edits_api import EditsApi
from housefly.web.news import PilotNews
from housefly.web.pages import link_used, no_session
from housefly.web.pilot_link import PilotLink
from housefly.web.room_api import RoomApi
from housefly.web.security import (
    LOOPBACK_NAMES,
    Doorkeeper,
    Guard,
    api_key,
    cookie_name,
    same_origin,
)
from housefly.web.video import VideoRoom

log = logging.getLogger(__name__)

STATIC = Path(__file__).parent / "static"


def create_app(
    bus: Bus,
    token: str,
    stop: Callable[[], object],
    *,
    hosts: frozenset[str] = LOOPBACK_NAMES,
    secret: str = "",
    drone_body: str = "ardrone",
    furniture: tuple[FurnitureConfig, ...] = (),
    clock: Clock | None = None,
    coverage: Callable[[], CoverageView] | None = None,
    edits: EditDesk | None = None,
) -> Starlette:
    """Build the application.

    Args:
        bus: where the pilot is.
        token: one-time token of the first link.
        stop: sends STOP on its own path, past the bus; must return at once.
        hosts: names that the server answers to.
        secret: key of the sessions; the same secret keeps browsers logged in over a restart. Empty
            makes a fresh one.
        drone_body: name of the drone among the tracked bodies.
        furniture: things that the tracking system sees.
        clock: tests may bring their own.
        coverage: computes what the tracking cameras see, on a thread; None when nobody knows.
        edits: where places and zones are edited; None where they are not.
    """
    clock = clock or RealClock()
    doorkeeper = Doorkeeper(token, secret or secrets.token_urlsafe(32))
    link = PilotLink(bus, stop, clock)
    console = Console(PilotNews(clock, drone_body, furniture), link, doorkeeper, clock)
    video = VideoRoom(bus)
    room = RoomApi(bus, doorkeeper, api_key(secret) if secret else "")
    layer = CoverageLayer(coverage) if coverage else None
    editing = EditsApi(edits, doorkeeper, console)

    @asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:
        console.news.listen(bus)
        video.listen(asyncio.get_running_loop())
        task = asyncio.create_task(Broadcast(console).run())
        task.add_done_callback(_leave_on_failure)
        yield
        task.cancel()
        with suppress(asyncio.CancelledError):
            await task
        link.close()
        room.close()
        editing.close()
        if layer is not None:
            layer.close()

    async def index(request: Request) -> Response:
        if (offered := request.query_params.get("token")) is not None:
            return _enter(request, doorkeeper, offered)
        if not doorkeeper.knows(request):
            return no_session()
        return FileResponse(STATIC / "index.html", headers={"cache-control": "no-store"})

    async def stop_now(request: Request) -> Response:
        if not (same_origin(request) and doorkeeper.knows(request)):
            return JSONResponse({"reason": "this page may not stop the drone"}, status_code=403)
        console.stop("a browser without a socket")
        return JSONResponse({"stopped": True})

    async def pictures(request: Request) -> Response:
        return mjpeg.stream(video) if doorkeeper.knows(request) else no_session()

    async def seen(request: Request) -> Response:
        if not doorkeeper.knows(request):
            return JSONResponse({"error": "this browser has no session"}, status_code=401)
        if layer is None:
            return JSONResponse(
                {"error": "nobody knows what the cameras of this site see"}, status_code=404
            )
        try:
            text = await layer.text()
        except HouseflyError as error:
            return JSONResponse({"error": str(error)}, status_code=503)
        return Response(text, media_type="application/json", headers={"cache-control": "no-store"})

    async def console_socket(websocket: WebSocket) -> None:
        if await socket.allowed(websocket, doorkeeper):
            await socket.serve(websocket, console)

    async def video_socket(websocket: WebSocket) -> None:
        if await socket.allowed(websocket, doorkeeper):
            await video.serve(websocket)

    return Starlette(
        routes=[
            Route("/", index),
            Route("/video.mjpeg", pictures),
            Route("/coverage", seen),
            Route("/stop", stop_now, methods=["POST"]),
            WebSocketRoute("/socket", console_socket),
            WebSocketRoute("/video", video_socket),
            *room.routes(),
            *editing.routes(),
            Mount("/static", StaticFiles(directory=STATIC)),
        ],
        middleware=[Middleware(Guard, hosts=hosts)],
        lifespan=lifespan,
    )


def _leave_on_failure(task: asyncio.Task[None]) -> None:
    """A console that no longer tells the truth must not stay up: end, and let the launcher start a
    fresh one.
    """
    if not task.cancelled() and (error := task.exception()) is not None:
        log.critical("the console cannot go on", exc_info=error)
        signal.raise_signal(signal.SIGTERM)


def _enter(request: Request, doorkeeper: Doorkeeper, token: str) -> Response:
    if doorkeeper.knows(request):
        # A reload of the printed address in a browser that is already in must not use up anything.
        return RedirectResponse("/", 303)
    session = doorkeeper.redeem(token)
    if session is None:
        return link_used()
    answer = RedirectResponse("/", 303, headers={"cache-control": "no-store"})
    secure = request.url.scheme == "https"
    answer.set_cookie(
        cookie_name(request), session, httponly=True, samesite="strict", secure=secure, path="/"
    )
    return answer
