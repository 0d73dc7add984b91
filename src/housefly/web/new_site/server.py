"""The server of the page of ``housefly new`` as one ASGI application, for one browser.

/                the page (with ``?token=`` : exchanges the one-time link for a session)
/static/...      the built client
/draft...        the draft: ``housefly.web.new_site.draft_api``
"""

from __future__ import annotations

import secrets
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import FileResponse, RedirectResponse, Response
from starlette.routing import Mount, Route

from housefly.web.access.page_routes import STATIC_FOLDER
from housefly.web.access.security import LOOPBACK_NAMES, HostGuard
from housefly.web.access.session_auth import SessionAuth
from housefly.web.access.session_pages import session_answer
from housefly.web.http.error_pages import no_draft_session
from housefly.web.http.packed_files import PackedFiles
from housefly.web.http.page_language import page_language
from housefly.web.new_site.draft_api import DraftApi


def new_site_session(token: str) -> SessionAuth:
    """Return the sessions of the page; ``token`` opens the first and only one."""
    return SessionAuth(token, secrets.token_urlsafe(32))


def create_new_site_app(
    api: DraftApi, auth: SessionAuth, hosts: frozenset[str] = LOOPBACK_NAMES
) -> Starlette:
    """Build the application.

    Args:
        api: the draft.
        auth: who may change it.
        hosts: names that the server answers to.
    """

    async def index(request: Request) -> Response:
        if (offered := request.query_params.get("token")) is not None:
            session = auth.redeem(offered)
            if session is not None:
                return session_answer(request, auth, session)
            # Reloading the printed address in the browser that has the session shows the page.
            return RedirectResponse("/", 303)
        if not auth.cookie_session(request):
            return no_draft_session(page_language(request))
        return FileResponse(STATIC_FOLDER / "new.html", headers={"cache-control": "no-store"})

    @asynccontextmanager
    async def running(app: Starlette) -> AsyncIterator[None]:
        yield
        api.close()

    return Starlette(
        routes=[
            Route("/", index),
            Mount("/static", PackedFiles(directory=STATIC_FOLDER)),
            *api.routes(),
        ],
        middleware=[Middleware(HostGuard, hosts=hosts)],
        lifespan=running,
    )
