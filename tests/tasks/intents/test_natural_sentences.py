"""What people say, in their own words and with all their politeness."""

from __future__ import annotations

from pathlib import Path

import pytest
from talk_room import answered, names_with

from housefly.tasks.intents.intent import LANGUAGES, Intent, Language
from housefly.tasks.intents.not_understood import NotUnderstood
from housefly.tasks.intents.recognizer import recognize

NAMES = names_with(
    answered("place-bedroom", "Bedroom", "place", "bedroom"),
    answered("window", "the window"),
    answered("lamp", "the lamp"),
    answered("washer", "the washing machine"),
    answered("glasses", "the glasses"),
)
_FILE = Path(__file__).with_name("natural_sentences.txt")


def sentences(section: str) -> list[tuple[str, str, str]]:
    """Return intent, subject or "", and sentence of each line of a section."""
    found: list[tuple[str, str, str]] = []
    here = ""
    for line in _FILE.read_text(encoding="utf-8").splitlines():
        if line.startswith("["):
            here = line[1:-1]
        elif " | " in line and here == section:
            what, said = line.split(" | ", 1)
            intent, _, subject = what.partition(" ")
            found.append((intent, subject, said))
    return found


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_people_say_is_understood(language: Language) -> None:
    wrong = []
    for intent, subject, said in sentences(language):
        found = recognize(said, language, NAMES)
        if not isinstance(found, Intent) or found.intent.value != intent:
            wrong.append((said, intent, found))
        elif subject and found.slots.subject != subject:
            wrong.append((said, subject, found))
    assert len(sentences(language)) > 100 and wrong == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_is_not_understood_is_refused_and_nothing_else(language: Language) -> None:
    for _, _, said in sentences(f"{language}, not understood"):
        assert isinstance(recognize(said, language, NAMES), NotUnderstood), said


@pytest.mark.parametrize(
    ("language", "said", "words"),
    [
        ("ja", "コンロを見かけるか", "「コンロを見て」"),
        ("de", "ist jemand im Keller", "„ist jemand"),
        ("en", "where is the refrigrator", "“where is the refrigerator”"),
    ],
)
def test_what_may_have_been_meant_stands_between_quotation_marks(
    language: Language, said: str, words: str
) -> None:
    found = recognize(said, language, NAMES)
    assert isinstance(found, NotUnderstood)
    assert words in found.words


@pytest.mark.parametrize(
    ("language", "room", "container"),
    [
        ("en", "look in the bedroom", "look in the fridge"),
        ("de", "schau in das Schlafzimmer", "schau in den Kühlschrank"),
        ("ja", "寝室の中を見て", "冷蔵庫の中を見て"),
    ],
)
def test_a_room_is_looked_at_and_a_container_is_looked_into(
    language: Language, room: str, container: str
) -> None:
    meant = [recognize(said, language, NAMES) for said in (room, container)]
    assert [one.intent.value for one in meant if isinstance(one, Intent)] == ["look", "inventory"]
