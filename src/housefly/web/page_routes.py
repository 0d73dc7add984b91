"""The pages: the console, the exchange of a one-time link for a session, the built client."""

from __future__ import annotations

from pathlib import Path

from starlette.requests import Request
from starlette.responses import FileResponse, RedirectResponse, Response
from starlette.routing import BaseRoute, Mount, Route
from starlette.staticfiles import StaticFiles

from housefly.web.error_pages import link_used, no_session
from housefly.web.session_auth import SessionAuth, cookie_name

STATIC_FOLDER = Path(__file__).parent / "static"


def page_routes(auth: SessionAuth) -> list[BaseRoute]:
    """Return ``/`` and ``/static``."""

    async def index(request: Request) -> Response:
        if (offered := request.query_params.get("token")) is not None:
            return _open_session(request, auth, offered)
        if not auth.cookie_session(request):
            return no_session()
        return FileResponse(STATIC_FOLDER / "index.html", headers={"cache-control": "no-store"})

    return [Route("/", index), Mount("/static", StaticFiles(directory=STATIC_FOLDER))]


def _open_session(request: Request, auth: SessionAuth, token: str) -> Response:
    session = auth.redeem(token)
    if session is None:
        # Reloading the printed address in a browser with a session shows the console again.
        return RedirectResponse("/", 303) if auth.cookie_session(request) else link_used()
    # In the query, so that what stands behind the # survives; the page takes it out at once.
    proof = auth.proof(session.partition(".")[0])
    answer = RedirectResponse(f"/?proof={proof}", 303, headers={"cache-control": "no-store"})
    secure = request.url.scheme == "https"
    answer.set_cookie(
        cookie_name(request), session, httponly=True, samesite="strict", secure=secure, path="/"
    )
    return answer
