"""Logging in and out: ``POST /login``, ``POST /logout``, and ``/account`` to see who one is.

Plain forms without a script. Their pages ask browsers to send the Origin of a form, which the
console's other pages withhold; a form of another site is refused by it.
"""

from __future__ import annotations

import asyncio
from urllib.parse import parse_qs

from starlette.requests import Request
from starlette.responses import RedirectResponse, Response
from starlette.routing import BaseRoute, Route

from housefly.web.access.audit_log import AuditLog
from housefly.web.access.logins import LoginRefusal, Logins
from housefly.web.access.session_auth import SessionAuth, cookie_name, is_encrypted, same_origin
from housefly.web.http.error_pages import login_page, signed_in, signed_out
from housefly.web.http.page_language import page_language
from housefly.web.http.responses import error_response

_MAX_BODY_SIZE, _MAX_FIELDS = 4096, 4
_BODY_TIMEOUT = 5.0
"""How long a form may take [s]."""
_OTHER_SITE = "this page may not log anybody in or out"


def session_routes(
    auth: SessionAuth, logins: Logins | None, audit: AuditLog | None
) -> list[BaseRoute]:
    """Return ``/login``, ``/logout`` and ``/account``."""

    async def log_in(request: Request) -> Response:
        if logins is None or not logins.is_open:
            return error_response(404, "nobody logs in here: use the address that was printed")
        if not same_origin(request):
            return error_response(403, _OTHER_SITE)
        form = await _form(request)
        if form is None:
            return error_response(413, "that is no name and no password")
        address = request.client.host if request.client else ""
        found = await logins.log_in(form.get("name", ""), form.get("password", ""), address)
        if isinstance(found, LoginRefusal):
            return login_page(page_language(request), found.words, found.wait)
        return session_answer(request, auth, auth.log_in(found))

    async def log_out(request: Request) -> Response:
        session = auth.cookie_session(request)
        if not same_origin(request) or session is None:
            return error_response(403, _OTHER_SITE)
        auth.log_out(session)
        if audit is not None:
            audit.record(session.user, session.name, "logged out")
        answer = signed_out(page_language(request))
        answer.delete_cookie(
            cookie_name(request), httponly=True, samesite="strict", secure=is_encrypted(request)
        )
        return answer

    async def account(request: Request) -> Response:
        session = auth.cookie_session(request)
        if session is None:
            return RedirectResponse("/", 303)
        return signed_in(page_language(request), session.user, session.role.value)

    return [
        Route("/login", log_in, methods=["POST"]),
        Route("/logout", log_out, methods=["POST"]),
        Route("/account", account),
    ]


def session_answer(request: Request, auth: SessionAuth, session: str) -> Response:
    """Return what opens the console with a session: its cookie, and its proof in the address.

    Args:
        request: what is answered.
        auth: the console's sessions.
        session: the cookie's value.
    """
    # In the query, so that what stands behind the # survives; the page takes it out at once.
    proof = auth.proof(session.partition(".")[0])
    answer = RedirectResponse(f"/?proof={proof}", 303, headers={"cache-control": "no-store"})
    answer.set_cookie(
        cookie_name(request),
        session,
        httponly=True,
        samesite="strict",
        secure=is_encrypted(request),
        path="/",
    )
    return answer


async def _form(request: Request) -> dict[str, str] | None:
    """Return a small form, or None for what is none."""
    read = b""
    try:
        async with asyncio.timeout(_BODY_TIMEOUT):
            async for part in request.stream():
                read += part
                if len(read) > _MAX_BODY_SIZE:
                    return None
        fields = parse_qs(read.decode(), strict_parsing=True, max_num_fields=_MAX_FIELDS)
    except (TimeoutError, ValueError):
        return None
    return {name: values[0] for name, values in fields.items()}
