"""The room over HTTP: ``/api/v1``, read only; every path is one question of ``hub.api``.

A request needs the console's session, or the key of this run as a bearer token, which
``housefly.connect()`` finds.
"""

from __future__ import annotations

import asyncio
import json
import logging
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from typing import Any

from pydantic import TypeAdapter, ValidationError
from starlette.requests import HTTPConnection, Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Mount, Route, WebSocketRoute
from starlette.websockets import WebSocket, WebSocketDisconnect

from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY
from housefly.errors import HouseflyError
from housefly.hub.api.answers import News
from housefly.hub.api.endpoints import API_PREFIX, ENDPOINTS, Endpoint
from housefly.hub.api.json import first_problem, question_to_json
from housefly.hub.api.questions import Question
from housefly.hub.api.topics import ROOM_NEWS_TOPIC
from housefly.tasks.api.endpoints import TASK_ENDPOINTS
from housefly.web.access.bearer import bears
from housefly.web.access.roles import Role
from housefly.web.access.session_auth import SessionAuth, chosen_subprotocol, same_origin
from housefly.web.access.session_watch import while_logged_in
from housefly.web.api.question_reader import QuestionReader, question_reader
from housefly.web.api.room_openapi import openapi_document
from housefly.web.http.responses import error_response, json_response
from housefly.web.http.seats import Seats

_LOG = logging.getLogger(__name__)
_NEWS: TypeAdapter[News] = TypeAdapter(News)
_MAX_QUEUED_NEWS = 100
"""News that may wait for a slow listener; with more its socket is closed."""
_WHO_MAY_ASK = "ask with the session of the console, or with the key of this run"
_ASK_FOR_TOKEN = {"www-authenticate": "Bearer"}


class RoomApi:
    """Passes questions on to the hub and news on to listeners.

    Args:
        bus: where the hub is.
        auth: the console's sessions.
        key: the bearer token that is accepted; "" accepts none.
    """

    def __init__(self, bus: Bus, auth: SessionAuth, key: str) -> None:
        self._bus, self._auth, self._key = bus, auth, key
        self._threads = ThreadPoolExecutor(4, "room")
        self._seats = Seats()

    def routes(self, more: Sequence[BaseRoute] = ()) -> list[BaseRoute]:
        """Return the routes below ``API_PREFIX``, with more of the same API."""
        asked = [
            Route(endpoint.path, self._handler(endpoint), methods=["GET"]) for endpoint in ENDPOINTS
        ]
        described = Route("/openapi.json", _openapi, methods=["GET"])
        return [
            Mount(
                API_PREFIX,
                routes=[*asked, described, WebSocketRoute("/watch", self._watch), *more],
            )
        ]

    def close(self) -> None:
        """Shut the threads down without waiting for answers."""
        self._threads.shutdown(wait=False, cancel_futures=True)

    def _handler(self, endpoint: Endpoint) -> Callable[[Request], Any]:
        reader = question_reader(endpoint)

        async def answer(request: Request) -> Response:
            if not self._may_ask(request):
                return error_response(401, f"{_WHO_MAY_ASK} as a bearer token", _ASK_FOR_TOKEN)
            try:
                question = _parsed_question(reader, request)
            except ValidationError as error:
                return error_response(422, first_problem(error))
            except ValueError as error:
                return error_response(422, str(error))
            return await self._asked(question)

        return answer

    async def _asked(self, question: Question) -> Response:
        loop = asyncio.get_running_loop()
        try:
            text = await loop.run_in_executor(
                self._threads, self._bus.ask, HUB_QUERY, question_to_json(question), 10.0
            )
        except HouseflyError as error:
            _LOG.debug("the hub: %s", error)
            return error_response(503, "the room's memory does not answer")
        if text.startswith('{"error"'):
            tree = json.loads(text)
            return error_response(404 if tree.get("unknown") else 422, str(tree["error"]))
        return json_response(text)

    async def _watch(self, websocket: WebSocket) -> None:
        if not self._may_ask(websocket) or (
            websocket.headers.get("origin") and not same_origin(websocket)
        ):
            await websocket.close(1008, _WHO_MAY_ASK)
            return
        session = self._auth.session_of(websocket)
        with self._seats.taken(session.owner if session else "") as seated:
            if not seated:
                await websocket.close(1013, "too many listen, in all or of this session")
                return
            await websocket.accept(chosen_subprotocol(websocket))
            async with while_logged_in(websocket, self._auth, session, Role.WATCH):
                await self._tell(websocket)

    async def _tell(self, websocket: WebSocket) -> None:
        """Send news until the listener leaves or is too slow."""
        loop = asyncio.get_running_loop()
        waiting: asyncio.Queue[str] = asyncio.Queue(_MAX_QUEUED_NEWS)

        def received(news: News) -> None:
            loop.call_soon_threadsafe(_put, waiting, _NEWS.dump_json(news).decode())

        subscription = self._bus.subscribe(ROOM_NEWS_TOPIC, received)
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
        return bears(connection, self._key) or self._auth.has_session(connection)


@cache
def _described() -> bytes:
    return json.dumps(openapi_document(ENDPOINTS, TASK_ENDPOINTS, API_PREFIX)).encode()


def _openapi(request: Request) -> Response:
    """Answer from a thread: to describe it all takes half a second, once."""
    return Response(_described(), media_type="application/json")


def _parsed_question(reader: QuestionReader, request: Request) -> Question:
    """Return a request's question; raises ValueError or ValidationError naming the parameter."""
    given = dict(request.path_params)
    for name, value in request.query_params.multi_items():
        if name in given:
            raise ValueError(f"{name}: given twice")
        given[name] = value
    if unknown := sorted(set(given) - reader.parameters):
        there = ", ".join(sorted(reader.parameters))
        raise ValueError(f"{unknown[0]}: no such parameter; there are: {there}")
    question: Question = reader.adapter.validate_python(given)
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
