"""The message files of the pages: the same texts with the same values in each language."""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml
from word_templates import made_words, templates

import house
from housefly.config.airframe import Ability
from housefly.messages import DroneFault, DroneStatus, Phase
from housefly.messages.preflight import FrameCheckState
from housefly.pilot.behavior.mission_tables import Response
from housefly.pilot.estimation.validation import RejectionReason
from housefly.web.access.page_routes import STATIC_FOLDER

CLIENT = STATIC_FOLDER.parent / "client" / "src"
CONSOLE, NEW_SITE = CLIENT / "messages", CLIENT / "new" / "messages"
PAGES = {CONSOLE: 300, NEW_SITE: 150}
"""Where the texts of a page are, and how many it has at least."""
OTHERS = ("ja", "de")
SPOKEN = (Ability, DroneFault, DroneStatus, FrameCheckState, Phase, RejectionReason, Response)
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
    assert len(made) > 400
    for one in made:
        assert one.template is not None, one.where
        assert sorted(PLACEHOLDER.findall(one.template)) == sorted(one.names), one.where


@pytest.mark.parametrize("name", ["de-told", "ja-told"])
def test_every_template_of_the_source_is_there_in_each_language(name: str) -> None:
    wanted = templates() | {member.value for kind in SPOKEN for member in kind}
    assert wanted - set(texts(CONSOLE, name)) == set()


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


@pytest.mark.parametrize("name", ["de-told", "ja-told"])
def test_no_template_is_kept_that_nothing_says(name: str) -> None:
    spoken_as_they_are = {member.value for kind in SPOKEN for member in kind}
    known = templates() | spoken_as_they_are | said_elsewhere()
    assert set(texts(CONSOLE, name)) - known == set()
