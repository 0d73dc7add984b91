"""The draft over HTTP: show, change, undo, import, listen to the tracking system, write.

Only the page of this server with its session may ask. 409 when the draft was changed elsewhere;
422, with the key, for a value that is not allowed.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import Protocol

from pydantic import TypeAdapter
from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response
from starlette.routing import BaseRoute, Route

from housefly.errors import ConfigError, HouseflyError
from housefly.messages.words import Words, figure
from housefly.room.draft.model import DraftDrone, DraftTracking
from housefly.tracking.live_check import LISTEN_SECONDS, Heard, heard_words
from housefly.web.access.session_auth import SessionAuth
from housefly.web.http.responses import json_response
from housefly.web.new_site.draft_actions import ACTIONS, DraftRequest, parsed_request
from housefly.web.new_site.draft_answers import (
    BodyView,
    HeardView,
    OpenedView,
    WrittenFile,
    WrittenView,
    draft_refusal,
    refused,
)
from housefly.web.new_site.draft_service import DraftService
from housefly.web.new_site.draft_view import DraftView
from housefly.web.new_site.uploads import Uploads

DRAFT_SIZE_MAX = 4 * 2**20
"""Largest request but for files [bytes]."""

_VIEW: TypeAdapter[DraftView] = TypeAdapter(DraftView)
_HEARD: TypeAdapter[HeardView] = TypeAdapter(HeardView)
_WRITTEN: TypeAdapter[WrittenView] = TypeAdapter(WrittenView)
_OPENED: TypeAdapter[OpenedView] = TypeAdapter(OpenedView)


class RoomOpener(Protocol):
    """What starts the simulated room of a site that was written."""

    def open(self, site: Path) -> None:
        """Start it, unless it is there."""

    def view(self) -> OpenedView:
        """Return how far it is."""


class DraftApi:
    """The routes of the page of ``housefly new``.

    Args:
        service: keeps the draft.
        uploads: keeps files.
        auth: the page's session.
        hear: listens to a tracking system for so many seconds; blocks.
        check_drone: asks whether a drone answers; blocks.
        room: starts the simulated room.
    """

    def __init__(
        self,
        service: DraftService,
        uploads: Uploads,
        auth: SessionAuth,
        hear: Callable[[DraftTracking, float], Heard],
        check_drone: Callable[[DraftDrone], tuple[Words, ...]],
        room: RoomOpener,
    ) -> None:
        self._service, self._uploads, self._auth = service, uploads, auth
        self._hear, self._check_drone, self._room = hear, check_drone, room
        self._thread = ThreadPoolExecutor(1, "draft")
        self._listener = ThreadPoolExecutor(1, "listener")

    def routes(self) -> list[BaseRoute]:
        """Return the routes."""
        return [
            Route("/draft", self._show, methods=["GET"]),
            *(Route(path, partial(self._changed, path), methods=["POST"]) for path in ACTIONS),
            Route("/files/{name}", self._upload, methods=["PUT"]),
            Route("/tracking/heard", self._heard, methods=["POST"]),
            Route("/drone/heard", self._drone, methods=["POST"]),
            Route("/site", self._write, methods=["POST"]),
            Route("/room", self._opened, methods=["GET"]),
            Route("/room", self._open, methods=["POST"]),
        ]

    def close(self) -> None:
        """Shut the threads down without waiting."""
        self._service.close()
        for pool in (self._thread, self._listener):
            pool.shutdown(wait=False, cancel_futures=True)

    async def _show(self, request: Request) -> Response:
        if not self._auth.has_session(request):
            return refused(401, Words("this browser has no session"))
        return await self._answer(lambda: _VIEW.dump_json(self._service.view()))

    async def _changed(self, path: str, request: Request) -> Response:
        return await self._asked(
            request,
            lambda body: _VIEW.dump_json(ACTIONS[path](self._service, self._uploads, body)),
        )

    async def _heard(self, request: Request) -> Response:
        return await self._asked(request, self._hear_tracking, self._listener)

    async def _drone(self, request: Request) -> Response:
        return await self._asked(request, self._hear_drone, self._listener)

    async def _write(self, request: Request) -> Response:
        return await self._asked(request, self._write_site)

    async def _opened(self, request: Request) -> Response:
        if not self._auth.has_session(request):
            return refused(401, Words("this browser has no session"))
        return json_response(_OPENED.dump_json(self._room.view()))

    async def _open(self, request: Request) -> Response:
        return await self._asked(request, self._open_room)

    async def _upload(self, request: Request) -> Response:
        if not self._auth.is_own_page(request):
            return _refused()
        try:
            size = await self._uploads.keep(request.path_params["name"], request.stream())
        except HouseflyError as error:
            return draft_refusal(error)
        except ClientDisconnect:
            return refused(400, Words("the browser left before the whole file was here"))
        except OSError as error:
            words = Words("the file cannot be kept: {why}", why=error.strerror or str(error))
            return refused(507, words)
        return JSONResponse({"bytes": size})

    def _hear_tracking(self, body: bytes) -> bytes:
        parsed_request(DraftRequest, body)
        tracking = self._service.draft().tracking
        if tracking is None:
            raise ConfigError(
                "tracking", Words("say first which system it is, and where it answers")
            )
        heard = self._hear(tracking, LISTEN_SECONDS)
        bodies = tuple(BodyView(body.name, body.position) for body in heard.bodies)
        return _HEARD.dump_json(HeardView(heard_words(heard, tracking.body), bodies))

    def _hear_drone(self, body: bytes) -> bytes:
        parsed_request(DraftRequest, body)
        drone = self._service.draft().drone
        if drone is None or not drone.address:
            raise ConfigError("drone", Words("say first where the drone answers"))
        return _HEARD.dump_json(HeardView(self._check_drone(drone), ()))

    def _write_site(self, body: bytes) -> bytes:
        paths = self._service.write(parsed_request(DraftRequest, body).based_on)
        files = (WrittenFile(str(path), path.read_text(encoding="utf-8")) for path in paths)
        return _WRITTEN.dump_json(WrittenView(tuple(files)))

    def _open_room(self, body: bytes) -> bytes:
        parsed_request(DraftRequest, body)
        site = self._service.simulated_site()
        if not site.is_file():
            raise ConfigError("site", Words("write the site first"))
        self._room.open(site)
        return _OPENED.dump_json(self._room.view())

    async def _asked(
        self,
        request: Request,
        work: Callable[[bytes], bytes],
        pool: ThreadPoolExecutor | None = None,
    ) -> Response:
        if not self._auth.is_own_page(request):
            return _refused()
        body = b""
        async for part in request.stream():
            body += part
            if len(body) > DRAFT_SIZE_MAX:
                words = Words("too much; allowed: {n} MiB", n=figure(DRAFT_SIZE_MAX >> 20))
                return refused(413, words)
        return await self._answer(lambda: work(body), pool)

    async def _answer(
        self, work: Callable[[], bytes], pool: ThreadPoolExecutor | None = None
    ) -> Response:
        loop = asyncio.get_running_loop()
        try:
            return json_response(await loop.run_in_executor(pool or self._thread, work))
        except HouseflyError as error:
            return draft_refusal(error)
        except OSError as error:
            words = Words("nothing was kept: {why}", why=error.strerror or str(error))
            return refused(507, words)


def _refused() -> JSONResponse:
    return refused(403, Words("this page may not change the site"))
