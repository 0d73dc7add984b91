"""The language of the pages that the server writes: what a device chose, or its browser's."""

from __future__ import annotations

from enum import Enum

from starlette.requests import Request

LANGUAGE_COOKIE = "housefly-language"
"""What the console's page leaves here when somebody chooses a language."""
_TAGS_MAX = 20


class PageLanguage(Enum):
    """A language that the pages speak."""

    ENGLISH = "en"
    JAPANESE = "ja"
    GERMAN = "de"


def page_language(request: Request) -> PageLanguage:
    """Return the language that was chosen on this device, or the browser's first that we speak."""
    wanted = [request.cookies.get(LANGUAGE_COOKIE, "")]
    wanted += accepted_languages(request.headers.get("accept-language", ""))
    spoken = {one.value: one for one in PageLanguage}
    known = (spoken[name] for tag in wanted if (name := tag[:2].lower()) in spoken)
    return next(known, PageLanguage.ENGLISH)


def accepted_languages(header: str) -> list[str]:
    """Return the tags of an ``Accept-Language`` header, the most wanted first."""
    weighed = []
    for part in header.split(",")[:_TAGS_MAX]:
        tag, _, weight = part.partition(";")
        if (value := _weight(weight)) > 0.0:
            weighed.append((value, tag.strip()))
    return [tag for _, tag in sorted(weighed, key=lambda one: -one[0])]


def _weight(text: str) -> float:
    """Return a weight such as ``q=0.8``; 1 where none is told, 0 where it cannot be read."""
    try:
        return float(text.partition("=")[2]) if text.strip() else 1.0
    except ValueError:
        return 0.0
