"""Camera coverage over HTTP: ``GET /coverage``."""

from __future__ import annotations

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from housefly.errors import HouseflyError
from housefly.web.access.session_auth import SessionAuth
from housefly.web.api.coverage_layer import CoverageLayer
from housefly.web.http.responses import error_response, json_response


def coverage_routes(layer: CoverageLayer | None, auth: SessionAuth) -> list[BaseRoute]:
    """Return ``/coverage``; without a layer it answers 404."""

    async def coverage(request: Request) -> Response:
        if not auth.has_session(request):
            return error_response(401, "this browser has no session")
        if layer is None:
            return error_response(404, "nobody knows what the cameras of this site see")
        try:
            return json_response(await layer.text())
        except HouseflyError as error:
            return error_response(503, str(error))

    return [Route("/coverage", coverage)]
