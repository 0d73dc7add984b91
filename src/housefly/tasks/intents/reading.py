"""How a sentence can be read by the templates of a language."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import islice
from typing import TYPE_CHECKING, Any

from housefly.tasks.intents.intent import IntentName, NameKind
from housefly.tasks.intents.sentence_book import SentenceBook
from housefly.tasks.intents.spoken_names import SpokenName
from housefly.tasks.intents.spoken_text import occurrences

if TYPE_CHECKING:
    from hassil.intents import SlotList
    from hassil.recognize import RecognizeResult

_MOST_READINGS = 50
NAME_SLOTS = ("subject", "owner")
"""Slots that hold names of the room."""


@dataclass(frozen=True, slots=True)
class SlotText:
    """A slot as it was matched: its value, its text and where that stands in the sentence."""

    slot: str
    value: Any
    text: str
    begin: int
    end: int


@dataclass(frozen=True, slots=True)
class SentenceReading:
    """One way to read a sentence.

    Attributes:
        said: the sentence, folded.
        intent: its name.
        literal: how many characters the template itself has matched.
        fixed: slots that the template sets.
        slots: those that the sentence fills.
    """

    said: str
    intent: IntentName
    literal: int
    fixed: tuple[tuple[str, Any], ...]
    slots: tuple[SlotText, ...]

    def names_all(self, quoted: Iterable[str]) -> bool:
        """Return whether all that stood between quotation marks are names of the room."""
        named = {slot.text for slot in self.slots if slot.slot in NAME_SLOTS}
        return all(one in named for one in quoted)


def is_only_a_name(said: str, spoken: Iterable[SpokenName], fillers: Iterable[str]) -> bool:
    """Return whether a folded sentence is one name of the room, and words without meaning.

    Then nobody can tell an order from a name that reads like one: it is no order.
    """
    return any(
        not _rest(said[:begin] + " " + said[end:], fillers)
        for name in spoken
        for begin, end in occurrences(name.said, said)
    )


def _rest(text: str, fillers: Iterable[str]) -> bool:
    """Return whether a text says anything besides words without meaning."""
    for word in fillers:
        for begin, end in reversed(occurrences(word, text)):
            text = text[:begin] + " " * (end - begin) + text[end:]
    return any(one.isalnum() for one in text)


def readings(
    said: str, book: SentenceBook, spoken: tuple[SpokenName, ...]
) -> tuple[SentenceReading, ...]:
    """Return the readings of a folded sentence: the most literal first, then long names."""
    from hassil.recognize import recognize_all

    found = recognize_all(
        said,
        book.intents,
        slot_lists=_name_lists(said, spoken),
        skip_words=list(book.skip_words),
        language=book.language,
    )
    made = [_reading(said, one) for one in islice(found, _MOST_READINGS)]
    return tuple(sorted(made, key=_order))


def _name_lists(said: str, spoken: tuple[SpokenName, ...]) -> dict[str, SlotList]:
    """Return hassil's lists of the names that stand in a sentence, as plain text."""
    from hassil.expression import TextChunk
    from hassil.intents import TextSlotList, TextSlotValue

    def of(names: Iterator[SpokenName]) -> TextSlotList:
        said_names = dict.fromkeys(one.said for one in names)
        return TextSlotList("", [TextSlotValue(TextChunk(one), one) for one in said_names])

    here = [one for one in spoken if one.said in said]
    return {
        "subject": of(iter(here)),
        "person": of(one for one in here if one.subject.kind is NameKind.PERSON),
        "place": of(one for one in here if one.subject.kind is NameKind.PLACE),
    }


def _order(reading: SentenceReading) -> tuple[int, int]:
    named = sum(len(slot.text) for slot in reading.slots)
    return -reading.literal, -named


def _reading(said: str, result: RecognizeResult) -> SentenceReading:
    fixed = dict(result.intent_data.slots)
    slots = [
        SlotText(one.name, one.value, one.text.strip(), *(one.text_span or (0, 0)))
        for one in result.entities_list
        if one.name not in fixed
    ]
    return SentenceReading(
        said,
        IntentName(result.intent.name),
        result.text_chunks_matched,
        tuple(fixed.items()),
        tuple(slots),
    )
