"""Flights to look at again over HTTP: ``GET /flights`` and ``GET /flights/{id}``."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Mapping

from pydantic import TypeAdapter
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from housefly.errors import RecordingError
from housefly.web.access.session_auth import SessionAuth
from housefly.web.flights.flight_book import FlightBook, FlightReplay, FlightsView
from housefly.web.http.drone_of_request import drone_of_request
from housefly.web.http.responses import error_response, json_response

_FLIGHTS: TypeAdapter[FlightsView] = TypeAdapter(FlightsView)
_REPLAY: TypeAdapter[FlightReplay] = TypeAdapter(FlightReplay)
_NO_SESSION = "this browser has no session"
_NONE_KEPT = "no flights are kept here"


def flight_routes(books: Mapping[str, FlightBook], auth: SessionAuth) -> list[BaseRoute]:
    """Return ``/flights`` and ``/flights/{id}``; without a book they answer 404.

    Args:
        books: by the names of the drones, as ``?drone=`` names one; "" is that without a name.
        auth: the console's sessions.
    """

    async def flights(request: Request) -> Response:
        if not auth.has_session(request):
            return error_response(401, _NO_SESSION)
        if (book := books.get(drone_of_request(request))) is None:
            return error_response(404, _NONE_KEPT)
        found = await asyncio.to_thread(book.flights)
        return json_response(_FLIGHTS.dump_json(FlightsView(time.time(), found)))

    async def replay(request: Request) -> Response:
        if not auth.has_session(request):
            return error_response(401, _NO_SESSION)
        if (book := books.get(drone_of_request(request))) is None:
            return error_response(404, _NONE_KEPT)
        try:
            text = await asyncio.to_thread(
                lambda: _REPLAY.dump_json(book.replay(request.path_params["flight"]))
            )
        except RecordingError as error:
            return error_response(404, str(error))
        return json_response(text)

    return [Route("/flights", flights), Route("/flights/{flight}", replay)]
