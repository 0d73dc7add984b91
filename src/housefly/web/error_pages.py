"""The pages that the server writes itself; the console's own page comes from ``static/``."""

from __future__ import annotations

from html import escape

from starlette.responses import HTMLResponse

_PAGE = """<!doctype html>
<html lang="en">
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


def _page(
    title: str, *paragraphs: str, status: int = 200, link: tuple[str, str] | None = None
) -> HTMLResponse:
    """Return a plain page with a title, paragraphs, and an optional link (address, text)."""
    body = [f"<p>{escape(text)}</p>" for text in paragraphs]
    if link:
        body.append(f'<p><a href="{escape(link[0])}">{escape(link[1])}</a></p>')
    text = _PAGE.format(title=escape(title), body="\n".join(body))
    return HTMLResponse(text, status_code=status, headers={"cache-control": "no-store"})


def link_used() -> HTMLResponse:
    """Return the page for a one-time link that is used up or was never valid."""
    return _page(
        "This link was already used",
        "A link opens the console in one browser only, so that nobody can fly the drone with a link"
        " that was left lying about.",
        "For another browser or person: open “Control” in a console that is already open and choose"
        " “Invite”. It makes a fresh link. Without an open console, start Housefly again; it prints"
        " a new address.",
        status=403,
        link=("/", "I have the console open in this browser"),
    )


def no_session() -> HTMLResponse:
    """Return the page for a browser that has no session."""
    return _page(
        "Who is there?",
        "This browser does not have the console open yet. Use the address that Housefly printed"
        " when it started; it looks like http://127.0.0.1:8080/?token=… and opens the console in"
        " one browser.",
        "If you came here through such a link on another page, try again:",
        status=403,
        link=("/", "Open the console"),
    )
