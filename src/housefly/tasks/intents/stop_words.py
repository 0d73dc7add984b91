"""STOP in words: looked for without grammar, in every language at once."""

from __future__ import annotations

from collections.abc import Iterable

from housefly.tasks.intents.intent import LANGUAGES
from housefly.tasks.intents.sentence_book import all_stop_words
from housefly.tasks.intents.spoken_text import folded, occurrences


def has_stop_word(said: str) -> bool:
    """Return whether a folded sentence has a STOP word in it."""
    return any(occurrences(stop, said) for stop in all_stop_words())


def says_stop(text: str) -> bool:
    """Return whether a sentence, as said, has a STOP word in it, in any language."""
    return any(has_stop_word(folded(text, language)) for language in LANGUAGES)


def is_only_stop_words(said: str, fillers: Iterable[str]) -> bool:
    """Return whether a folded sentence is nothing but STOP words and words without meaning."""
    if not has_stop_word(said):
        return False
    rest = said
    for word in sorted({*all_stop_words(), *fillers}, key=len, reverse=True):
        for begin, end in reversed(occurrences(word, rest)):
            rest = rest[:begin] + " " * (end - begin) + rest[end:]
    return not any(one.isalnum() for one in rest)
