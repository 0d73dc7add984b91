"""Each sentence that a page, the terminal or a document offers to say is understood."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from remembered_room import THINGS

from housefly.hub.api.answers import ThingAnswer
from housefly.sites.loaded_site import load_site
from housefly.tasks.intents.intent import LANGUAGES, Intent, Language
from housefly.tasks.intents.names import Names, names_of, names_of_room
from housefly.tasks.intents.phrases import phrases
from housefly.tasks.intents.recognizer import recognize
from housefly.tasks.intents.sentence_book import sentence_book

ROOT = Path(__file__).parents[3]
CLIENT = ROOT / "src/housefly/web/client/src/tasks"
MESSAGES = CLIENT.parent / "messages"
GAPS = {"en": ("cup", "the sofa"), "de": ("die Tasse", "dem Sofa"), "ja": ("カップ", "ソファ")}
"""What stands for the gap "…" of a sentence, in each language."""
TYPED = re.compile(
    r'housefly ask (?:--no-wait |--no-fly |--language (\w\w) )*(?:"([^"]+)"|([a-z ]+))'
)
SHIPPED_TEXTS = (
    *sorted((ROOT / "docs").glob("*.md")),
    ROOT / "README.md",
    ROOT / "src/housefly/app/task_words.py",
    ROOT / "src/housefly/app/interactive.py",
    ROOT / "src/housefly/app/commands/tasks.py",
)


def names() -> Names:
    """Return the names of the shipped room and of a day with grandma in it."""
    room = names_of_room(load_site("bsen").room)
    things = names_of(
        ThingAnswer(one.id, one.name, one.kind.value, one.aliases, None, "", ()) for one in THINGS
    )
    known = {one.id for one in room.subjects}
    return Names((*room.subjects, *(one for one in things.subjects if one.id not in known)))


NAMES = names()


def ideas(language: Language) -> Iterator[str]:
    """Yield what the page offers to tap, its gaps filled."""
    file, begin = (CLIENT / "ideas.ts", "ideasToAsk() ??")
    if language != "en":
        file, begin = (MESSAGES / f"{language}-speech.ts", "const ideas =")
    block = re.search(rf"{re.escape(begin)} \[(.*?)\];\n", file.read_text("utf-8"), re.S)
    assert block is not None
    for quoted in re.findall(r'"([^"]+)"|`([^`]+)`', block[1]):
        yield re.sub(r"\$\{[^}]*\}", "sofa", "".join(quoted))


def helped(language: Language) -> Iterator[str]:
    """Yield what the answer to "help" names, with its gaps."""
    sentences = phrases(language)("help")
    for begin in ("for example: ", "zum Beispiel sagen: ", "たとえば: "):
        sentences = sentences.removeprefix(sentences.partition(begin)[0] + begin)
    yield from re.split(r"[、,]\s*", sentences.strip(" .。"))


def understood(text: str, language: Language) -> bool:
    return isinstance(recognize(text, language, NAMES), Intent)


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_the_page_offers_to_tap_is_understood(language: Language) -> None:
    offered = list(ideas(language))
    assert len(offered) >= 4, "the file of the page changed"
    assert not [one for one in offered if not understood(one, language)]


def shown_in_the_field(language: Language) -> str:
    """Return what the page's field shows before anything is typed."""
    found = re.search(r'placeholder=\{t\("([^"]+)"\)', (CLIENT / "ask-bar.tsx").read_text("utf-8"))
    assert found is not None
    if language == "en":
        return found[1]
    words = (MESSAGES / f"{language}.ts").read_text("utf-8")
    translated = re.search(rf'^  "{re.escape(found[1])}": "([^"]+)"', words, re.M)
    assert translated is not None
    return translated[1]


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_the_field_of_the_page_shows_is_understood(language: Language) -> None:
    for one in re.split("[,、] ?", shown_in_the_field(language).strip(" …")):
        assert understood(one, language), one


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_help_names_is_understood_with_one_name_or_another(language: Language) -> None:
    offered = list(helped(language))
    assert len(offered) >= 10
    for one in offered:
        filled = [one.replace("…", gap) for gap in GAPS[language]]
        assert any(understood(text, language) for text in filled), filled


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_short_sentence_that_may_be_suggested_is_understood(language: Language) -> None:
    subject, person = {"en": ("sofa", "grandma"), "de": ("sofa", "oma")}.get(
        language, ("ソファ", "おばあちゃん")
    )
    wrong = [
        text
        for template in sentence_book(language).examples
        if not understood(text := template.format(subject=subject, person=person), language)
    ]
    assert len(wrong) <= 0.05 * len(sentence_book(language).examples), wrong


@pytest.mark.parametrize("file", SHIPPED_TEXTS, ids=lambda path: path.name)
def test_what_a_document_or_the_terminal_shows_to_type_is_understood(file: Path) -> None:
    for language, quoted, bare in TYPED.findall(file.read_text(encoding="utf-8")):
        text = (quoted or bare).strip()
        if text and not text.startswith("{"):
            assert understood(text, language or "en"), text
