"""The pages: the console, the exchange of a one-time link for a session, the built client."""

from __future__ import annotations

from pathlib import Path

from starlette.requests import Request
from starlette.responses import FileResponse, RedirectResponse, Response
from starlette.routing import BaseRoute, Mount, Route
from starlette.staticfiles import StaticFiles

from housefly.web.error_pages import link_used, login_page, no_session
from housefly.web.logins import Logins
from housefly.web.session_auth import SessionAuth
from housefly.web.session_pages import session_answer

STATIC_FOLDER = Path(__file__).parent / "static"


def page_routes(auth: SessionAuth, logins: Logins | None) -> list[BaseRoute]:
    """Return ``/`` and ``/static``; with logins a stranger is asked who he is."""

    async def index(request: Request) -> Response:
        if (offered := request.query_params.get("token")) is not None:
            return _open_session(request, auth, offered)
        if not auth.cookie_session(request):
            return login_page() if logins and logins.is_open else no_session()
        return FileResponse(STATIC_FOLDER / "index.html", headers={"cache-control": "no-store"})

    return [Route("/", index), Mount("/static", StaticFiles(directory=STATIC_FOLDER))]


def _open_session(request: Request, auth: SessionAuth, token: str) -> Response:
    session = auth.redeem(token)
    if session is None:
        # Reloading the printed address in a browser with a session shows the console again.
        return RedirectResponse("/", 303) if auth.cookie_session(request) else link_used()
    return session_answer(request, auth, session)
