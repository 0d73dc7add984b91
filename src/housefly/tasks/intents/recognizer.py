"""Recognizes what a sentence means: an intent, or what may have been meant. Flies nothing."""

from __future__ import annotations

import threading
from functools import cache, lru_cache
from pathlib import Path

from housefly.tasks.api.values import ReasonCode
from housefly.tasks.intents.intent import Intent, IntentName, IntentSlots, Language, may_fly
from housefly.tasks.intents.names import Names
from housefly.tasks.intents.not_understood import NotUnderstood, Recognition
from housefly.tasks.intents.phrases import phrases
from housefly.tasks.intents.reading import SentenceReading, is_only_a_name, readings
from housefly.tasks.intents.sentence_book import SentenceBook, sentence_book
from housefly.tasks.intents.spoken_names import SpokenName, spoken_names
from housefly.tasks.intents.spoken_text import folded, without_quotes
from housefly.tasks.intents.stop_words import has_stop_word, is_only_stop_words
from housefly.tasks.intents.subjects import AmbiguousName, intent_of
from housefly.tasks.intents.suggestions import suggested

LONGEST_SENTENCE = 200
"""Nobody asks for anything in a longer sentence [characters]."""
_ROOMS_KEPT = 8


class Recognizer:
    """Recognizes sentences of one language; thread-safe.

    Args:
        language: which.
        own: folder with a person's own sentence files, or None.
    """

    def __init__(self, language: Language, own: Path | None = None) -> None:
        self.book: SentenceBook = sentence_book(language, own)
        self._spoken = lru_cache(_ROOMS_KEPT)(lambda names: spoken_names(names, self.book))
        self._lock = threading.Lock()

    def is_only_stop(self, text: str) -> bool:
        """Return whether a text is nothing but STOP, whatever there is in the room."""
        said = folded(without_quotes(text)[0], self.book.language)
        return is_only_stop_words(said, self.book.skip_words)

    def recognize(self, text: str, names: Names) -> Recognition:
        """Return what a sentence means among the names of a room.

        STOP is looked for first and last: what is only STOP words always is STOP, and so is what
        nobody understands but has one of them in it.
        """
        text = " ".join(text.split())
        bare, quoted = without_quotes(text)
        said = folded(bare, self.book.language)
        stop = Intent(IntentName.STOP, IntentSlots(), text, self.book.language)
        if is_only_stop_words(said, self.book.skip_words):
            return stop
        found = self._understood(text, said, quoted, names)
        if isinstance(found, NotUnderstood) and has_stop_word(said):
            return stop
        return found

    def _understood(
        self, text: str, said: str, quoted: tuple[str, ...], names: Names
    ) -> Recognition:
        if not any(one.isalnum() for one in said):
            return self._refused(text, "say_something")
        if len(said) > LONGEST_SENTENCE:
            return self._refused(text, "too_long")
        with self._lock:
            spoken = self._spoken(names)
            found = readings(said, self.book, spoken)
            if not found:
                return self._unknown(text, said, spoken)
        return self._meant(text, found[0], quoted, spoken)

    def _meant(
        self,
        text: str,
        reading: SentenceReading,
        quoted: tuple[str, ...],
        spoken: tuple[SpokenName, ...],
    ) -> Recognition:
        try:
            intent = intent_of(reading, text, self.book.language, spoken)
        except AmbiguousName as error:
            return self._which_one(text, error)
        if intent is None:
            return self._refused(text, "not_understood")
        if may_fly(intent) and is_only_a_name(reading.said, spoken, self.book.skip_words):
            return self._refused(text, "only_a_name", ReasonCode.NOT_ALLOWED)
        if not reading.names_all(folded(one, self.book.language) for one in quoted):
            return self._refused(text, "quoted", ReasonCode.NOT_ALLOWED)
        return intent

    def _unknown(self, text: str, said: str, spoken: tuple[SpokenName, ...]) -> NotUnderstood:
        meant = suggested(said, self.book, spoken)
        if not meant.unknown:
            return self._refused(text, "not_understood", meant=meant.sentences)
        code = ReasonCode.UNKNOWN_THING
        name = _as_said(meant.unknown, text, self.book.language)
        return self._refused(text, "unknown_name", code, meant.sentences, name)

    def _which_one(self, text: str, error: AmbiguousName) -> NotUnderstood:
        say = phrases(self.book.language)
        return NotUnderstood(
            text, self.book.language, say("which_one", names=say.listed(error.choices, "or")),
            error.choices, ReasonCode.NOT_UNDERSTOOD,
        )  # fmt: skip

    def _refused(
        self,
        text: str,
        why: str,
        code: ReasonCode = ReasonCode.NOT_UNDERSTOOD,
        meant: tuple[str, ...] = (),
        name: str = "",
    ) -> NotUnderstood:
        say = phrases(self.book.language)
        words = say(why, name=name)
        if meant:
            shown = (say("offered", sentence=one) for one in meant)
            words = say.joined(words, say("did_you_mean", sentences=say.listed(shown, "or")))
        return NotUnderstood(text, self.book.language, words, meant, code)


def _as_said(name: str, text: str, language: Language) -> str:
    """Return a folded name as it stands in a text, capitals, umlauts and all."""
    words = text.strip(" ?!.。").split()
    parts = (
        " ".join(words[begin:end])
        for begin in range(len(words))
        for end in range(begin + 1, len(words) + 1)
    )
    return next((part for part in parts if folded(part, language) == name), name)


@cache
def recognizer(language: Language, own: Path | None = None) -> Recognizer:
    """Return the recognizer of a language; it is loaded once."""
    return Recognizer(language, own)


def recognize(text: str, language: Language, names: Names, own: Path | None = None) -> Recognition:
    """Return what a sentence means, or what may have been meant; never raises for any text.

    Args:
        text: as said or typed.
        language: which it is in.
        names: of the room.
        own: folder with a person's own sentence files, or None.

    Raises:
        ConfigError: one of the sentence files is not one.
    """
    return recognizer(language, own).recognize(text, names)
