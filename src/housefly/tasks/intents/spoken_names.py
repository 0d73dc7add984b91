"""Names as they are said in one language: native words, inflected, without their article."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

from housefly.tasks.intents.intent import Language, NameKind
from housefly.tasks.intents.names import NamedSubject, Names
from housefly.tasks.intents.sentence_book import SentenceBook
from housefly.tasks.intents.spoken_text import folded, is_cjk

_ARTICLES: dict[Language, str] = {
    "en": r"(the|a|an|my|our) ",
    "de": r"(der|die|das|den|dem|des|ein|eine|einen|mein|meine|unser|unsere) ",
    "ja": "",
}
_ADJECTIVE_ENDINGS = ("e", "en", "er", "es", "em")
_NOUN_ENDINGS = ("", "s", "es", "n", "en")
_MAX_ADJECTIVES = 2


@dataclass(frozen=True, slots=True)
class SpokenName:
    """One way to say a name: folded, as it is shown, and whom it means."""

    said: str
    shown: str
    subject: NamedSubject


def spoken_names(names: Names, book: SentenceBook) -> tuple[SpokenName, ...]:
    """Return every way to say the names of a room, the longest first.

    What is only a STOP word is no name.
    """
    found: dict[tuple[str, str, NameKind], SpokenName] = {}
    for subject in names.subjects:
        for shown in native_names(subject, book):
            for said in _inflected(plain_name(shown, book.language), book.language):
                if said not in book.stop_words and any(one.isalnum() for one in said):
                    key = (said, subject.id, subject.kind)
                    found.setdefault(key, SpokenName(said, shown, subject))
    return tuple(sorted(found.values(), key=lambda one: (-len(one.said), one.said)))


def native_names(subject: NamedSubject, book: SentenceBook) -> tuple[str, ...]:
    """Return the names of a subject in a language: first the one that is shown.

    In English that is its own name; in other languages a name with an article of theirs or in
    their script, then a native word for its English name.
    """
    native: list[str] = []
    for name in subject.names:
        plain = plain_name(name, "en")
        native += book.native_names.get(plain, ()) or book.native_names.get(
            plain.replace("-", " "), ()
        )
    if book.language == "en":
        return tuple(dict.fromkeys((*subject.names, *native)))
    own = [name for name in subject.names if _is_of(name, book.language)]
    return tuple(dict.fromkeys((*own, *native, *subject.names)))


def _is_of(name: str, language: Language) -> bool:
    """Return whether a name looks like one of a language that is not English."""
    if language == "ja":
        return is_cjk(name)
    return bool(re.match("(der|die|das) ", name.casefold()))


def plain_name(name: str, language: Language) -> str:
    """Return a name folded and without its article, in its own language or in English."""
    text = folded(name, language)
    for article in {_ARTICLES[language], _ARTICLES["en"]} - {""}:
        bare = re.sub(f"^{article}", "", text)
        if bare:
            text = bare
    return text


def _inflected(name: str, language: Language) -> Iterator[str]:
    yield name
    if "-" in name or "_" in name:
        yield re.sub("[-_]+", " ", name).strip()
    if language == "de":
        yield from _german(name)


def _german(name: str) -> Iterator[str]:
    """Yield the cases of a German name: adjectives before it and its own ending change."""
    *adjectives, noun = name.split(" ")
    if len(adjectives) > _MAX_ADJECTIVES or not noun.isalpha():
        return
    stems = [re.sub("(e|en|er|es|em)$", "", word) for word in adjectives]
    if any(len(stem) < 2 for stem in stems):
        return
    for endings in product(_ADJECTIVE_ENDINGS, repeat=len(stems)):
        said = [stem + ending for stem, ending in zip(stems, endings, strict=True)]
        for ending in _NOUN_ENDINGS:
            yield " ".join([*said, noun + ending])
