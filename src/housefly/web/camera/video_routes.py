"""Live video over HTTP: H.264 on a WebSocket, and JPEG for browsers without WebCodecs."""

from __future__ import annotations

import asyncio
from collections.abc import Mapping
from contextlib import suppress

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from housefly.web.access.roles import Role
from housefly.web.access.session_auth import SessionAuth, chosen_subprotocol
from housefly.web.access.session_watch import while_logged_in
from housefly.web.camera.mjpeg import mjpeg_response
from housefly.web.camera.video import FrameQueue, VideoRelay
from housefly.web.http.drone_of_request import drone_of_request
from housefly.web.http.error_pages import no_session
from housefly.web.http.page_language import page_language
from housefly.web.http.seats import Seats


def video_routes(videos: Mapping[str, VideoRelay], auth: SessionAuth) -> list[BaseRoute]:
    """Return ``/video`` and ``/video.mjpeg``; a drone is named by ``?drone=``.

    Args:
        videos: by the names of the drones; "" is what is shown without a name.
        auth: the console's sessions.
    """
    seats = Seats()

    async def h264(websocket: WebSocket) -> None:
        video = videos.get(drone_of_request(websocket))
        if video is None:
            await websocket.close(1008, "there is no drone of this name")
        elif session := await auth.admit(websocket):
            with seats.taken(session.owner) as seated:
                async with while_logged_in(websocket, auth, session, Role.WATCH):
                    await _serve(websocket, video, seated=seated)

    async def jpeg(request: Request) -> Response:
        session = auth.session_of(request)
        video = videos.get(drone_of_request(request))
        if session is None or video is None:
            return no_session(page_language(request))
        return mjpeg_response(
            video, seats, session.owner, lambda: auth.renewed(session) is not None
        )

    return [WebSocketRoute("/video", h264), Route("/video.mjpeg", jpeg)]


async def _serve(websocket: WebSocket, video: VideoRelay, *, seated: bool) -> None:
    """Send frames to one browser until it leaves; it acknowledges each with one byte."""
    if not seated:
        await websocket.close(1013, "too many watch the video, in all or of this browser")
        return
    await websocket.accept(chosen_subprotocol(websocket))
    with video.subscribed() as queue:
        writer = asyncio.create_task(_write(websocket, queue))
        try:
            while (await websocket.receive())["type"] != "websocket.disconnect":
                queue.acknowledge()
        finally:
            writer.cancel()
            with suppress(asyncio.CancelledError, WebSocketDisconnect, RuntimeError):
                await writer


async def _write(websocket: WebSocket, queue: FrameQueue) -> None:
    while True:
        await queue.wake.wait()
        queue.wake.clear()
        while (message := queue.next()) is not None:
            await websocket.send_bytes(message)
