"""The pages that the server writes itself; the console's own page comes from ``static/``."""

from __future__ import annotations

from html import escape
from math import ceil

from starlette.responses import HTMLResponse

from housefly.web.http.page_language import PageLanguage
from housefly.web.http.page_words import page_words

_PAGE = """<!doctype html>
<html lang="{language}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title} · Housefly</title>
<link rel="icon" href="/static/favicon.svg">
<link rel="stylesheet" href="/static/app.css">
</head>
<body class="page">
<main>
<img src="/static/favicon.svg" alt="" width="48" height="48">
<h1>{title}</h1>
{body}
</main>
</body>
</html>
"""


_FORM_HEADERS = {
    "cache-control": "no-store",
    "referrer-policy": "same-origin",
    "content-security-policy": (
        "default-src 'none'; img-src 'self'; style-src 'self'; base-uri 'none';"
        " form-action 'self'; frame-ancestors 'none'"
    ),
}
"""For the pages with a form: without a referrer browsers would send no Origin with it."""
_LOGIN_FORM = """<form method="post" action="/login">
<p><label>{name}<br><input name="name" autocomplete="username" autocapitalize="none"
 required maxlength="24" autofocus></label></p>
<p><label>{password}<br><input name="password" type="password" autocomplete="current-password"
 required maxlength="256"></label></p>
<p><button type="submit">{log_in}</button></p>
</form>"""
_LOGOUT_FORM = """<form method="post" action="/logout">
<p><button type="submit">{log_out}</button></p>
</form>"""


_YOU_ARE = "You are {user}; your role is “{role}”. STOP and LAND are for everybody."
_YOU_CAME = (
    "You came in by a one-time link; your role is “{role}”. STOP and LAND are for everybody."
)


def _page(
    language: PageLanguage,
    title: str,
    *paragraphs: str,
    status: int = 200,
    link: tuple[str, str] | None = None,
    form: str = "",
) -> HTMLResponse:
    """Return a plain page: title, paragraphs, an optional link (address, text), a form's HTML.

    Title, paragraphs and the link's text are English words of ``PAGE_WORDS``, or already said.
    """

    def said(words: str) -> str:
        return escape(page_words(language, words))

    body = [f"<p>{said(text)}</p>" for text in paragraphs]
    body += [form] if form else []
    if link:
        body.append(f'<p><a href="{escape(link[0])}">{said(link[1])}</a></p>')
    text = _PAGE.format(language=language.value, title=said(title), body="\n".join(body))
    headers = _FORM_HEADERS if form else {"cache-control": "no-store"}
    return HTMLResponse(text, status_code=status, headers=headers)


def link_used(language: PageLanguage) -> HTMLResponse:
    """Return the page for a one-time link that is used up or was never valid."""
    return _page(
        language,
        "This link was already used, or is too old",
        "A link opens the console in one browser only, and an invitation waits 10 minutes for it,"
        " so that nobody can fly the drone with a link that was left lying about. If you have not"
        " used it, somebody else may have: tell who runs Housefly.",
        "For another browser or person: open “Control” in a console that is already open and choose"
        " “Invite”. It makes a fresh link. Without an open console, press Enter where Housefly"
        " runs for others on the network, or start it again; it prints a new address.",
        status=403,
        link=("/", "I have the console open in this browser"),
    )


def came_from_elsewhere(language: PageLanguage, proof: str) -> HTMLResponse:
    """Return the page for a link that was opened on a page of another site.

    Browsers do not send the new cookie before somebody goes on from a page of ours.

    Args:
        language: of the page.
        proof: of the session that the link has opened.
    """
    return _page(
        language,
        "One more step",
        "The link has opened the console in this browser.",
        link=(f"/?proof={proof}", "Show the console"),
    )


def no_authority(language: PageLanguage) -> HTMLResponse:
    """Return the page for a console whose certificate is not of an authority of its own."""
    return _page(
        language,
        "There is nothing to trust here",
        "This console has no certificate of its own authority: nothing need be installed for it.",
        status=404,
        link=("/", "Open the console"),
    )


def no_session(language: PageLanguage) -> HTMLResponse:
    """Return the page for a browser that has no session."""
    return _page(
        language,
        "Who is there?",
        "This browser does not have the console open yet. Use the address that Housefly printed"
        " when it started; it looks like http://127.0.0.1:8080/?token=… and opens the console in"
        " one browser.",
        "If you came here through such a link on another page, try again:",
        status=403,
        link=("/", "Open the console"),
    )


def no_draft_session(language: PageLanguage) -> HTMLResponse:
    """Return the page for a browser that may not draw the new room."""
    return _page(
        language,
        "This address was already used",
        "The address that `housefly new` printed opens the page in one browser. Go on there, or end"
        " the command with Ctrl+C and start it again: it prints a fresh address, and the draft is"
        " as you left it.",
        status=403,
        link=("/", "I have the page open in this browser"),
    )


def login_page(language: PageLanguage, problem: str = "", wait: float = 0.0) -> HTMLResponse:
    """Return the page that asks who is there.

    Args:
        language: of the page.
        problem: why the last try did not succeed.
        wait: when to try again [s]; 0 for at once.
    """
    form = _LOGIN_FORM.format(
        name=page_words(language, "Name"),
        password=page_words(language, "Password"),
        log_in=page_words(language, "Log in"),
    )
    page = _page(language, "Who is there?", *filter(None, (problem,)), status=403, form=form)
    if wait > 0.0:
        page.status_code = 429
        page.headers["retry-after"] = str(ceil(wait))
    return page


def signed_in(language: PageLanguage, user: str, role: str) -> HTMLResponse:
    """Return the page that says who one is and what one may do."""
    words = _YOU_ARE if user else _YOU_CAME
    role_words = page_words(language, role)
    return _page(
        language,
        "Your session",
        page_words(language, words, user=user, role=role_words),
        form=_LOGOUT_FORM.format(log_out=page_words(language, "Log out")),
        link=("/", "Back to the console"),
    )


def signed_out(language: PageLanguage) -> HTMLResponse:
    """Return the page after logging out."""
    return _page(
        language,
        "You are logged out",
        "Every window of this session is closed to it. The drone goes on with what it does.",
        link=("/", "Log in again"),
    )
