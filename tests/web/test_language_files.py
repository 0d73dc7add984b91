"""The message files of the pages: the same texts with the same values in each language."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from enum import Enum
from functools import cache
from pathlib import Path
from typing import TypeGuard

import pytest
import yaml
from draft_sentences import draft_sentences
from word_templates import console_templates, made_words, new_page_templates

import house
from housefly.config.airframe import Ability
from housefly.messages import DroneFault, DroneStatus, Phase
from housefly.messages.preflight import FrameCheckState
from housefly.messages.words import Words, parts_of
from housefly.pilot.behavior.mission_tables import Response
from housefly.pilot.estimation.validation import RejectionReason
from housefly.room.draft.imports.drawing import LeftOut
from housefly.web.access.page_routes import STATIC_FOLDER

CLIENT = STATIC_FOLDER.parent / "client" / "src"
CONSOLE, NEW_SITE = CLIENT / "messages", CLIENT / "new" / "messages"
PAGES = {CONSOLE: 300, NEW_SITE: 150}
"""Where the texts of a page are, and how many it has at least."""
OTHERS = ("ja", "de")
TOLD = ("de-told", "ja-told")
SPOKEN: dict[Path, tuple[type[Enum], ...]] = {
    CONSOLE: (Ability, DroneFault, DroneStatus, FrameCheckState, Phase, RejectionReason, Response),
    NEW_SITE: (DroneStatus, LeftOut),
}
"""Enums whose values are said as they are (``messages.words.said``)."""
PLACEHOLDER = re.compile(r"\{(\w+)\}")
_TEXT = r'"(?:[^"\\]|\\.)*"(?:\s*\+\s*"(?:[^"\\]|\\.)*")*'
_STAGES = set(re.findall(r'\| "([a-z ]+)"', (CLIENT / "wire/task-messages.ts").read_text()))
"""States of a task, which the page gets from the server as they are."""


def spoken(text: str) -> str:
    """Return a text of TypeScript, which may be several in a sum."""
    return "".join(json.loads(part) for part in re.findall(r'"(?:[^"\\]|\\.)*"', text))


def english(page: Path = CONSOLE) -> list[str]:
    source = (page / "en.ts").read_text(encoding="utf-8")
    return [spoken(text) for text in re.findall(rf"^  ({_TEXT}),$", source, re.MULTILINE)]


def texts(page: Path, name: str) -> dict[str, str]:
    """Return the entries of one of the files, English to that language."""
    source = (page / f"{name}.ts").read_text(encoding="utf-8")
    pairs = re.findall(rf"^  \[?({_TEXT})\]?:\s*({_TEXT}),$", source, re.MULTILINE)
    return {spoken(key): spoken(own) for key, own in pairs}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name)
def test_each_language_has_every_text_of_the_page_once(page: Path) -> None:
    keys = english(page)
    assert len(keys) > PAGES[page] and len(keys) == len(set(keys))
    for name in OTHERS:
        assert set(texts(page, name)) == set(keys), name
    assert set(texts(page, "ja-told")) == set(texts(page, "de-told"))


def test_every_template_of_the_source_is_a_literal_that_is_given_its_values() -> None:
    made = list(made_words())
    assert len(made) > 600
    for one in made:
        assert one.template is not None, one
        assert sorted(PLACEHOLDER.findall(one.template)) == sorted(one.names), one


def said_by_the_server(page: Path) -> set[str]:
    """Return every template that the server of a page may say to it."""
    found = console_templates() if page == CONSOLE else new_page_templates()
    return found | {member.value for kind in SPOKEN[page] for member in kind}


@pytest.mark.parametrize("name", TOLD)
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name)
def test_every_template_of_the_source_is_there_in_each_language(page: Path, name: str) -> None:
    assert said_by_the_server(page) - set(texts(page, name)) == set()


@pytest.mark.parametrize("name", ["ja", "de", "ja-told", "de-told"])
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name)
def test_each_text_has_the_values_of_the_english_one_and_is_not_empty(
    page: Path, name: str
) -> None:
    for key, own in texts(page, name).items():
        assert own.strip(), key
        assert set(PLACEHOLDER.findall(own)) == set(PLACEHOLDER.findall(key)), key


def test_every_line_of_the_list_of_keys_is_a_text_of_the_page() -> None:
    source = (CLIENT / "keymap.ts").read_text(encoding="utf-8")
    lines = re.findall(rf"(?:shown|does):\s*({_TEXT})", source)
    assert len(lines) > 20 and {spoken(line) for line in lines} <= set(english())


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name)
def test_japanese_has_no_plural_and_german_has_one_where_english_has(page: Path) -> None:
    assert not any("|" in own for own in texts(page, "ja").values())
    assert all(("|" in own) == ("|" in key) for key, own in texts(page, "de").items())


def sources(page: Path) -> str:
    """Return the code of a page, without its texts."""
    files = page.parent.rglob("*.ts*")
    return "".join(
        path.read_text(encoding="utf-8") for path in files if path.parent.name != "messages"
    )


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name)
def test_no_text_is_kept_that_no_page_shows(page: Path) -> None:
    source = sources(page)
    words = {key for key in english(page) if json.dumps(key, ensure_ascii=False) not in source}
    built = {key for key in words if key.endswith(("^lines", "^mode", "^phase"))}
    told = {"waiting", "skipped", *_STAGES}
    assert words - built - told == set()


def test_what_is_said_of_a_draft_is_said_by_templates_of_its_page(tmp_path: Path) -> None:
    sentences = draft_sentences(tmp_path)
    assert len(sentences) > 80
    assert [words for words in sentences if not words.template] == []
    parts = {part.template for words in sentences for part in parts_of(words) if _is_said(part)}
    assert parts - set(texts(NEW_SITE, "de-told")) == set()


def _is_said(part: str) -> TypeGuard[Words]:
    return isinstance(part, Words) and part.template != ""


@cache
def said_elsewhere() -> set[str]:
    """Return the texts of the source that are no templates: of Python, of documents, of pages."""
    found: set[str] = set()
    for path in house.PACKAGE.rglob("*.py"):
        nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        found |= {
            n.value for n in nodes if isinstance(n, ast.Constant) and isinstance(n.value, str)
        }
    for path in (house.PACKAGE / "tasks").rglob("*.yaml"):
        found |= set(texts_in(yaml.safe_load(path.read_text(encoding="utf-8"))))
    return found | {spoken(text) for text in re.findall(_TEXT, sources(CONSOLE))}


def texts_in(tree: object) -> Iterator[str]:
    if isinstance(tree, str):
        yield " ".join(tree.split())
    elif isinstance(tree, dict | list):
        for part in tree.values() if isinstance(tree, dict) else tree:
            yield from texts_in(part)


@pytest.mark.parametrize("name", TOLD)
def test_no_template_is_kept_that_nothing_says(name: str) -> None:
    known = said_by_the_server(CONSOLE) | said_elsewhere()
    assert set(texts(CONSOLE, name)) - known == set()


@pytest.mark.parametrize("name", TOLD)
def test_the_page_of_a_new_site_keeps_no_template_that_nothing_says(name: str) -> None:
    of_the_page = {spoken(text) for text in re.findall(_TEXT, sources(NEW_SITE))}
    assert set(texts(NEW_SITE, name)) - said_by_the_server(NEW_SITE) - of_the_page == set()
