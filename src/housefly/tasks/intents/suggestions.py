"""Did you mean: sentences that are close to one that nobody understands. Only ever offered."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from itertools import islice
from typing import TYPE_CHECKING

from housefly.tasks.intents.intent import Language, NameKind
from housefly.tasks.intents.reading import NAME_SLOTS, readings
from housefly.tasks.intents.sentence_book import SentenceBook
from housefly.tasks.intents.sentence_file import ROOM_LISTS
from housefly.tasks.intents.spoken_names import SpokenName, plain_name
from housefly.tasks.intents.spoken_text import folded, is_cjk, occurrences

if TYPE_CHECKING:
    from hassil.recognize import RecognizeResult

_MOST = 3
_NAME_LIKENESS, _WORD_LIKENESS, _SENTENCE_LIKENESS = 0.6, 0.65, 0.62
"""What is at least this similar may have been meant, 0 to 1."""
_FEWEST_LITERAL = 3
"""A sentence with fewer characters besides an unknown name is none [characters]."""
_LONGEST_NAME = 40
_MOST_READINGS = 50
_CASES = 6
"""A name has so many forms in a language at most."""
_MARKS = " ?!.。"
_WORD = re.compile(r"[^\W\d_]+(?:'[a-z]+)?")


@dataclass(frozen=True, slots=True)
class Suggestion:
    """What may have been meant, and the name that nobody has here, or ""."""

    sentences: tuple[str, ...] = ()
    unknown: str = ""


def suggested(said: str, book: SentenceBook, spoken: tuple[SpokenName, ...]) -> Suggestion:
    """Return what a folded sentence that nobody understands may have meant.

    What has a negation in it was not meant as any sentence that there is.
    """
    if any(occurrences(word, said) for word in book.negations):
        return Suggestion()
    corrected = _corrected(said, book, spoken)
    if corrected and readings(corrected, book, spoken):
        return Suggestion((_written(corrected, book, spoken),))
    unknown = _unknown_name(said, book)
    if unknown:
        close = _close_names(unknown, spoken, book.language)
        meant = [said.replace(unknown, name, 1) for name in close]
    else:
        examples = tuple(dict.fromkeys(_examples(said, book, spoken)))
        meant = get_close_matches(said, examples, _MOST, _SENTENCE_LIKENESS)
    known = [_written(one, book, spoken) for one in meant if readings(one, book, spoken)]
    return Suggestion(tuple(dict.fromkeys(known)), unknown)


def _close_names(unknown: str, spoken: tuple[SpokenName, ...], language: Language) -> list[str]:
    """Return the names that are close to an unknown one, one a subject, not each of its cases."""
    known = {one.said: one for one in reversed(spoken)}
    close = get_close_matches(unknown, list(known), _MOST * _CASES, _NAME_LIKENESS)
    best = {known[name].subject: name for name in reversed(close)}
    nearest = sorted(best.values(), key=close.index)[:_MOST]
    return [plain_name(known[name].shown, language) for name in nearest]


def _written(said: str, book: SentenceBook, spoken: tuple[SpokenName, ...]) -> str:
    """Return a folded sentence with its words as they are written, umlauts and all."""
    written = dict(book.words)
    for one in spoken:
        for word in _WORD.findall(one.shown):
            written.setdefault(folded(word, book.language), word)
    return _WORD.sub(lambda match: written.get(match[0], match[0]), said).rstrip(_MARKS)


def _corrected(said: str, book: SentenceBook, spoken: tuple[SpokenName, ...]) -> str:
    """Return a sentence with its unknown words replaced by known ones that are close."""
    if is_cjk(said):
        return ""
    known = set(book.words) | {word for one in spoken for word in _WORD.findall(one.said)}
    sorted_words = sorted(known)

    def close(match: re.Match[str]) -> str:
        word = match[0]
        if word in known:
            return word
        return next(iter(get_close_matches(word, sorted_words, 1, _WORD_LIKENESS)), word)

    corrected = _WORD.sub(close, said)
    return corrected if corrected != said else ""


def _unknown_name(said: str, book: SentenceBook) -> str:
    """Return what stands where a name should stand, "" when nothing does."""
    from hassil.intents import WildcardSlotList
    from hassil.recognize import recognize_all

    found = recognize_all(
        said,
        book.intents,
        slot_lists={name: WildcardSlotList(name) for name in ROOM_LISTS},
        skip_words=list(book.skip_words),
        language=book.language,
    )
    likely = [one for one in islice(found, _MOST_READINGS) if _is_likely(one)]
    best = max(likely, key=lambda one: one.text_chunks_matched, default=None)
    return "" if best is None else _name_of(best)


def _is_likely(result: RecognizeResult) -> bool:
    named = [one for one in result.entities_list if one.name in NAME_SLOTS]
    return (
        len(named) == 1
        and result.text_chunks_matched >= _FEWEST_LITERAL
        and 0 < len(named[0].text.strip()) <= _LONGEST_NAME
    )


def _name_of(result: RecognizeResult) -> str:
    return next(one.text.strip() for one in result.entities_list if one.name in NAME_SLOTS)


def _examples(said: str, book: SentenceBook, spoken: tuple[SpokenName, ...]) -> Iterator[str]:
    """Yield one sentence a template; a name must stand in the sentence already."""
    here = [one for one in spoken if occurrences(one.said, said)]
    people = [one for one in here if one.subject.kind is NameKind.PERSON]
    for template in book.examples:
        if ("{person}" in template and not people) or ("{subject}" in template and not here):
            continue
        names = {
            "subject": here[0].said if here else "",
            "person": people[0].said if people else "",
        }
        yield template.format(**names)
