"""The pages: the console, the exchange of a one-time link for a session, the built client."""

from __future__ import annotations

import re
from pathlib import Path

from starlette.middleware.gzip import GZipMiddleware
from starlette.requests import Request
from starlette.responses import FileResponse, HTMLResponse, RedirectResponse, Response
from starlette.routing import BaseRoute, Mount, Route

from housefly.web.access.logins import Logins
from housefly.web.access.session_auth import SessionAuth
from housefly.web.access.session_pages import session_answer
from housefly.web.http.error_pages import (
    came_from_elsewhere,
    link_used,
    login_page,
    no_authority,
    no_session,
)
from housefly.web.http.packed_files import PackedFiles
from housefly.web.http.page_language import page_language

STATIC_FOLDER = Path(__file__).parents[1] / "static"
_PROOF = re.compile("[0-9a-f]{64}")
_ALWAYS_NEW = {"cache-control": "no-store"}
_LIST_OF_DRONES = (
    '<link rel="stylesheet" href="/static/drones.css" />'
    '<script type="module" src="/static/drones.js"></script>'
)
_CERTIFICATE_TYPE = "application/x-x509-ca-cert"
"""By this phones know that it is to be installed."""


def page_routes(
    auth: SessionAuth,
    logins: Logins | None,
    authority: bytes | None = None,
    *,
    several_drones: bool = False,
) -> list[BaseRoute]:
    """Return ``/``, ``/static``, ``/service-worker.js`` and ``/authority.crt``.

    Args:
        auth: the console's sessions.
        logins: with them a stranger is asked who he is.
        authority: the certificate that phones are to trust, in DER; None when there is none.
        several_drones: whether the page lists them.
    """
    page_text = (STATIC_FOLDER / "index.html").read_text(encoding="utf-8")
    if several_drones:
        page_text = page_text.replace("</head>", f"{_LIST_OF_DRONES}</head>", 1)

    async def index(request: Request) -> Response:
        if (offered := request.query_params.get("token")) is not None:
            return _open_session(request, auth, offered)
        if not auth.cookie_session(request):
            if _PROOF.fullmatch(proof := request.query_params.get("proof", "")):
                return came_from_elsewhere(page_language(request), proof)
            page = login_page if logins and logins.is_open else no_session
            return page(page_language(request))
        return HTMLResponse(page_text, headers=_ALWAYS_NEW)

    async def service_worker(request: Request) -> Response:
        # At the root, for its scope is the folder that it comes from.
        return FileResponse(
            STATIC_FOLDER / "service-worker.js", headers={"cache-control": "no-cache"}
        )

    async def authority_certificate(request: Request) -> Response:
        if authority is None:
            return no_authority(page_language(request))
        return Response(authority, media_type=_CERTIFICATE_TYPE, headers=_ALWAYS_NEW)

    return [
        Route("/", index),
        Route("/service-worker.js", service_worker),
        Route("/authority.crt", authority_certificate),
        Mount("/static", GZipMiddleware(PackedFiles(directory=STATIC_FOLDER), compresslevel=6)),
    ]


def _open_session(request: Request, auth: SessionAuth, token: str) -> Response:
    if not _is_opened_by_a_person(request):
        return Response(status_code=204, headers=_ALWAYS_NEW)
    session = auth.redeem(token)
    if session is None:
        # Reloading the printed address in a browser with a session shows the console again.
        if auth.cookie_session(request):
            return RedirectResponse("/", 303)
        return link_used(page_language(request))
    return session_answer(request, auth, session)


def _is_opened_by_a_person(request: Request) -> bool:
    """Return whether a browser goes to a page; what only looks ahead must not use a link up."""
    headers = request.headers
    looks_ahead = "prefetch" in headers.get("sec-purpose", "") + headers.get("purpose", "")
    goes_there = headers.get("sec-fetch-dest", "document") == "document"
    return request.method == "GET" and goes_there and not looks_ahead
