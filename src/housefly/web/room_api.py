"""The room over HTTP: ``/api/v1``, read only; every path is one question of ``bus.room_questions``.

Asked with the session of the console, or with the key of this run as a bearer token
(``housefly.connect()`` finds it).
"""

from __future__ import annotations

import asyncio
import hmac
import json
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

from pydantic import TypeAdapter, ValidationError
from starlette.requests import HTTPConnection, Request
from starlette.responses import JSONResponse, Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY, ROOM_NEWS
from housefly.errors import HouseflyError
from housefly.hub.api.questions import (
    Catalogue,
    Contents,
    Events,
    Near,
    Picture,
    Question,
    Sensors,
    Trajectory,
    Where,
)
from housefly.hub.api.room_json import complaint, question_to_json
from housefly.messages import RoomNews
from housefly.web.room_openapi import openapi
from housefly.web.security import Doorkeeper, same_origin

PREFIX = "/api/v1"
BEHIND = 100
"""News that may wait for a slow listener; then it is let go and may come again."""


@dataclass(frozen=True, slots=True)
class Endpoint:
    """One path: where, which question, and what it is good for."""

    path: str
    question: type[Question]
    summary: str


ENDPOINTS = (
    Endpoint("/where/{thing}", Where, "Where a thing is, now or at a time"),
    Endpoint("/things", Catalogue, "The catalogue, of one kind or whole"),
    Endpoint("/near", Near, "What is near a point or a thing"),
    Endpoint("/contents/{thing}", Contents, "What is in a thing, however deep"),
    Endpoint("/trajectory/{thing}", Trajectory, "Where a thing was between two times"),
    Endpoint("/events", Events, "What happened"),
    Endpoint("/sensors", Sensors, "How every sensor does"),
    Endpoint("/picture", Picture, "Everything that has a place, now or at a time"),
)


class RoomApi:
    """Passes questions on to the hub and news on to listeners.

    Args:
        bus: where the hub is.
        doorkeeper: knows the console's sessions.
        key: bearer token; "" lets nobody in by one.
    """

    def __init__(self, bus: Bus, doorkeeper: Doorkeeper, key: str) -> None:
        self._bus, self._doorkeeper, self._key = bus, doorkeeper, key
        self._asking = ThreadPoolExecutor(4, "room")

    def routes(self) -> list[BaseRoute]:
        """Return the routes below ``PREFIX``."""
        document = openapi(ENDPOINTS, PREFIX)
        asked = [
            Route(endpoint.path, self._handler(endpoint), methods=["GET"]) for endpoint in ENDPOINTS
        ]
        described = Route("/openapi.json", lambda request: JSONResponse(document), methods=["GET"])
        return [Mount(PREFIX, routes=[*asked, described, WebSocketRoute("/watch", self._watch)])]

    def close(self) -> None:
        """Let go of the threads without waiting for answers."""
        self._asking.shutdown(wait=False, cancel_futures=True)

    def _handler(self, endpoint: Endpoint) -> Callable[[Request], Any]:
        reader: TypeAdapter[Any] = TypeAdapter(endpoint.question)

        async def answer(request: Request) -> Response:
            if not self._may_ask(request):
                return _refused(
                    401,
                    "ask with the session of the console, or with the key of this run as a bearer"
                    " token",
                )
            try:
                question = _question(reader, request)
            except ValidationError as error:
                return _refused(422, complaint(error))
            except ValueError as error:
                return _refused(422, str(error))
            return await self._asked(question)

        return answer

    async def _asked(self, question: Question) -> Response:
        loop = asyncio.get_running_loop()
        try:
            text = await loop.run_in_executor(
                self._asking, self._bus.ask, HUB_QUERY, question_to_json(question), 10.0
            )
        except HouseflyError as error:
            return _refused(503, f"the room's memory does not answer: {error}")
        if text.startswith('{"error"'):
            tree = json.loads(text)
            return _refused(404 if tree.get("unknown") else 422, str(tree["error"]))
        return Response(text, media_type="application/json", headers={"cache-control": "no-store"})

    async def _watch(self, websocket: WebSocket) -> None:
        if not self._may_ask(websocket) or (
            websocket.headers.get("origin") and not same_origin(websocket)
        ):
            await websocket.close(
                1008, "ask with the session of the console, or with the key of this run"
            )
            return
        await websocket.accept()
        loop = asyncio.get_running_loop()
        waiting: asyncio.Queue[str] = asyncio.Queue(BEHIND)

        def heard(news: RoomNews) -> None:
            loop.call_soon_threadsafe(_put, waiting, news.text)

        subscription = self._bus.subscribe(ROOM_NEWS, heard)
        sending = asyncio.create_task(_send(websocket, waiting))
        try:
            while not sending.done():
                await websocket.receive_text()
        except WebSocketDisconnect:
            pass
        finally:
            sending.cancel()
            subscription.close()

    def _may_ask(self, connection: HTTPConnection) -> bool:
        scheme, _, offered = connection.headers.get("authorization", "").partition(" ")
        if scheme.lower() == "bearer" and self._key:
            return hmac.compare_digest(offered.encode(), self._key.encode())
        return self._doorkeeper.knows(connection)


def _question(reader: TypeAdapter[Any], request: Request) -> Question:
    """Return the question of a request; raises ValueError or ValidationError naming the parameter."""
    given = dict(request.path_params)
    for name, value in request.query_params.multi_items():
        if name in given:
            raise ValueError(f"{name}: given twice")
        given[name] = value
    known = set(reader.json_schema()["properties"]) - {"ask"}
    if unknown := sorted(set(given) - known):
        raise ValueError(f"{unknown[0]}: no such parameter; there are: {', '.join(sorted(known))}")
    question: Question = reader.validate_python(given)
    return question


def _put(waiting: asyncio.Queue[str], text: str) -> None:
    if not waiting.full():
        waiting.put_nowait(text)


async def _send(websocket: WebSocket, waiting: asyncio.Queue[str]) -> None:
    while True:
        await websocket.send_text(await waiting.get())
        if waiting.full():
            await websocket.close(1013, "too slow: ask for the picture and come again")
            return


def _refused(status: int, words: str) -> Response:
    headers = {"www-authenticate": "Bearer"} if status == 401 else {}
    return JSONResponse({"error": words}, status_code=status, headers=headers)
