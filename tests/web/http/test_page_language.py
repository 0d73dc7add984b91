"""The pages that the server writes itself: in the language that was chosen, or of the browser."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial
from html import unescape
from itertools import product

import pytest
from starlette.requests import Request
from starlette.responses import HTMLResponse

from housefly.web.access.logins import WRONG
from housefly.web.http.error_pages import (
    came_from_elsewhere,
    link_used,
    login_page,
    no_authority,
    no_draft_session,
    no_session,
    signed_in,
    signed_out,
)
from housefly.web.http.page_language import PageLanguage, accepted_languages, page_language
from housefly.web.http.page_words import PAGE_WORDS
from housefly.web.messages.role import Role

EN, JA, DE = PageLanguage.ENGLISH, PageLanguage.JAPANESE, PageLanguage.GERMAN
PAGES: dict[str, Callable[[PageLanguage], HTMLResponse]] = {
    "login": login_page,
    "wrong login": lambda language: login_page(language, WRONG.words),
    "too many logins": lambda language: login_page(language, "Too many tries: wait a minute.", 9.0),
    "used link": link_used,
    "link of elsewhere": lambda language: came_from_elsewhere(language, "abc"),
    "no authority": no_authority,
    "no session": no_session,
    "no draft": no_draft_session,
    "logged out": signed_out,
    **{
        f"account of {user or 'a link'}, {role.value}": partial(
            signed_in, user=user, role=role.value
        )
        for user, role in product(("anna", ""), Role)
    },
}
SAME_IN_GERMAN = {"Name"}


def asking(cookie: str = "", accepted: str = "") -> Request:
    given = [(b"cookie", cookie.encode()), (b"accept-language", accepted.encode())]
    return Request({"type": "http", "headers": [one for one in given if one[1]]})


def pieces(page: HTMLResponse) -> set[str]:
    """Return the texts of a page."""
    text = re.sub(r"<title>.*?</title>", "", bytes(page.body).decode())
    return {unescape(one).strip() for one in re.split(r"<[^>]*>", text)} - {""}


@pytest.mark.parametrize("name", PAGES)
def test_no_text_of_a_page_is_left_untranslated(name: str) -> None:
    english = pieces(PAGES[name](EN))
    assert pieces(PAGES[name](JA)) & english == set()
    assert pieces(PAGES[name](DE)) & english <= SAME_IN_GERMAN
    for language in PageLanguage:
        text = bytes(PAGES[name](language).body).decode()
        assert f'<html lang="{language.value}">' in text and "{" not in text


def test_each_language_has_the_same_words_with_the_same_values() -> None:
    assert set(PAGE_WORDS) == {JA, DE} and set(PAGE_WORDS[JA]) == set(PAGE_WORDS[DE])
    for words in PAGE_WORDS.values():
        for english, own in words.items():
            assert own.strip() and re.findall(r"{\w+}", own) == re.findall(r"{\w+}", english)


@pytest.mark.parametrize(
    ("cookie", "accepted", "language"),
    [
        ("", "", EN),
        ("", "de-AT,de;q=0.9,en;q=0.8", DE),
        ("", "fr, en;q=0.4, ja;q=0.7", JA),
        ("", "fr,es;q=0.5", EN),
        ("housefly-language=ja", "de", JA),
        ("housefly-language=xx", "de", DE),
        ("", "de;q=nonsense,ja;q=0", EN),
    ],
)
def test_what_was_chosen_counts_then_the_browsers_first_that_is_spoken(
    cookie: str, accepted: str, language: PageLanguage
) -> None:
    assert page_language(asking(cookie, accepted)) is language


def test_weights_order_what_a_browser_accepts() -> None:
    assert accepted_languages("en;q=0.2, ja, de;q=0.5") == ["ja", "de", "en"]
