"""The files of sentences and phrases: whole, alike in all languages, and added to by people."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from talk_room import NAMES

from housefly.errors import ConfigError
from housefly.tasks.intents.answering import answer_intent
from housefly.tasks.intents.intent import LANGUAGES, Intent, IntentName, Language
from housefly.tasks.intents.phrases import phrases
from housefly.tasks.intents.recognizer import Recognizer, recognize
from housefly.tasks.intents.sentence_book import sentence_book
from housefly.tasks.intents.spoken_text import folded, without_quotes

OWN = """
language: en
intents:
  service:
    data:
      - sentences: ["water [the ](plants|flowers)", "give {subject} water"]
        slots: {service: water_plants}
  look:
    data:
      - sentences: ["peek at <thing>"]
names:
  stove: [hob]
"""


def test_own_sentences_start_an_own_task_and_add_to_what_is_understood(tmp_path: Path) -> None:
    (tmp_path / "mine.yaml").write_text(OWN, encoding="utf-8")
    found = recognize("please water the plants", "en", NAMES, tmp_path)
    assert isinstance(found, Intent)
    assert found.given() == {"service": "water_plants"}
    reply = answer_intent(found, NAMES, None, 0.0, tmp_path)  # type: ignore[arg-type]
    assert reply.request is not None and reply.request.service == "water_plants"
    assert isinstance(recognize("peek at the hob", "en", NAMES, tmp_path), Intent)
    assert not isinstance(recognize("peek at the hob", "en", NAMES), Intent)
    assert isinstance(recognize("look at the stove", "en", NAMES, tmp_path), Intent)
    assert not isinstance(recognize("water the plants", "de", NAMES, tmp_path), Intent)


def test_no_own_sentence_takes_a_stop_word_away(tmp_path: Path) -> None:
    tree = "language: en\nintents: {patrol: {data: [{sentences: [stop, 'please halt now']}]}}"
    (tmp_path / "mine.yaml").write_text(tree, encoding="utf-8")
    for text in ("stop", "please halt now"):
        found = recognize(text, "en", NAMES, tmp_path)
        assert isinstance(found, Intent) and found.intent is IntentName.STOP


@pytest.mark.parametrize(
    ("text", "key"),
    [
        ("[", "cannot be read"),
        ("intents: {}", "language"),
        ("language: fr", "language"),
        ("language: en\nintents: {explode: {data: [{sentences: [boom]}]}}", "intents.explode"),
        ("language: en\nfoo: 1", "foo"),
        ("language: en\nlists: {subject: {values: [a]}}", "subject is filled with"),
        ("language: en\nintents: {look: {data: [{sentences: ['look (at']}]}}", "cannot be read"),
        ("language: en\nintents: {look: {data: [{sentences: ['see {nothing}']}]}}", "nothing"),
        ("language: en\nintents: {look: {data: [{sentences: ['see <nothing>']}]}}", "nothing"),
        ("language: en\nintents: {look: {data: [{sentences: ['{subject}']}]}}", "only of names"),
        ("language: en\nintents: {look: []}", "intents.look"),
        ("language: en\nintents: 3", "intents: is 3"),
    ],
)
def test_a_wrong_file_is_refused_with_what_is_wrong(tmp_path: Path, text: str, key: str) -> None:
    (tmp_path / "mine.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(ConfigError, match=re.escape(key)):
        sentence_book("en", tmp_path)


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_intent_can_be_said_in_every_language(language: Language) -> None:
    book = Recognizer(language).book
    said = {name for name, intent in book.intents.intents.items() if intent.data}
    assert said == {one.value for one in IntentName} - {"service"}


def test_all_languages_have_the_same_phrases_with_the_same_values() -> None:
    english = phrases("en").texts
    for language in ("de", "ja"):
        own = phrases(language).texts
        more = {key for key in own if key.startswith("state ")}
        assert set(own) - more == set(english)
        for key, text in english.items():
            assert _fields(own[key]) <= _fields(text) | {"month", "day"}, key
    assert {key for key in phrases("de").texts if key.startswith("state ")} == {
        key for key in phrases("ja").texts if key.startswith("state ")
    }


def _fields(text: str) -> set[str]:
    found = re.findall(r"\{(\w+)\}", text)
    return {one.removesuffix("_dat").removesuffix("_acc").lower() for one in found}


def test_text_is_folded_to_one_form() -> None:
    assert folded("  Wo ist der KÜHLSCHRANK? ", "de") == "wo ist der kuehlschrank?"
    assert folded("\uff13時\u3000に", "ja") == "3時に"
    assert folded("st\u200bop\u202e", "en") == "stop"
    assert folded("grandma\u2019s", "en") == "grandma's"


@pytest.mark.parametrize(
    ("text", "bare", "quoted"),
    [
        ('look at "the sofa"', "look at  the sofa", ("the sofa",)),
        ("„flieg“ »los«", "flieg   los", ("flieg", "los")),
        ("「ソファ」を見て", "ソファ を見て", ("ソファ",)),
        ('a "b', "a b", ()),
        ("", "", ()),
    ],
)
def test_quotation_marks_are_taken_away_and_what_they_hold_is_kept(
    text: str, bare: str, quoted: tuple[str, ...]
) -> None:
    assert without_quotes(text) == (bare, quoted)


def test_nothing_is_loaded_before_the_first_sentence() -> None:
    import subprocess
    import sys

    code = (
        "import sys, housefly.tasks.intents.answering, housefly.tasks.intents.recognizer;"
        "sys.exit('hassil' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
