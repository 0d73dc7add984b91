"""Things and times in the words of a language."""

from __future__ import annotations

import re
from datetime import datetime
from typing import Any

from housefly.tasks.intents.intent import Language
from housefly.tasks.intents.names import NamedSubject, Names
from housefly.tasks.intents.phrases import Phrases, phrases
from housefly.tasks.intents.sentence_book import SentenceBook
from housefly.tasks.intents.spoken_names import native_names, plain_name

_JUST_NOW = 2.0
"""Ages below this are "now" [s]."""
_UNITS = ((86400.0, "day"), (3600.0, "hour"), (60.0, "minute"), (1.0, "second"))
_CASES: dict[str, tuple[str, str]] = {
    "der": ("dem", "den"), "die": ("der", "die"), "das": ("dem", "das"),
}  # fmt: skip
"""German articles: dative and accusative."""
_CONTRACTIONS = (
    ("in dem ", "im "), ("an dem ", "am "), ("bei dem ", "beim "), ("von dem ", "vom "),
    ("zu dem ", "zum "), ("zu der ", "zur "),
)  # fmt: skip
_ENGLISH_ARTICLE = re.compile(r"^(the|a|an|my|our) ", re.IGNORECASE)


class Speech:
    """Speaks one language of the things of one room.

    Args:
        book: the native names of a language.
        names: of the room.
        now: Unix time [s].
    """

    def __init__(self, book: SentenceBook, names: Names, now: float) -> None:
        self.language: Language = book.language
        self.say: Phrases = phrases(book.language)
        self.now = now
        self._book, self._names = book, names

    def __call__(self, key: str, **values: Any) -> str:
        """Return a phrase; a subject or its id at the hub becomes its name, in each case.

        ``{thing}`` is the name, ``{Thing}`` at the beginning of a sentence, ``{thing_dat}`` and
        ``{thing_acc}`` are German cases.
        """
        filled: dict[str, object] = {}
        for name, value in values.items():
            filled |= self._forms(name, value) if isinstance(value, NamedSubject) else {name: value}
        return self._contracted(self.say(key, **filled))

    def name(self, thing: str) -> NamedSubject:
        """Return what a thing of the hub is called here; an unknown one is called by its id."""
        from housefly.tasks.intents.intent import NameKind

        known = self._names.of_thing(thing)
        return known or NamedSubject(thing, NameKind.THING, (thing,), thing)

    def joined(self, *sentences: str) -> str:
        """Return sentences one after the other."""
        return self.say.joined(*sentences)

    def listed(self, things: list[str], key: str = "thing_in_list") -> str:
        """Return the names of things as a list."""
        return self.say.listed([self(key, thing=self.name(one)) for one in things])

    def ago(self, age: float) -> str:
        """Return how long ago [s]: "now", "3 minutes ago"."""
        if age < _JUST_NOW:
            return self.say("now")
        length, unit = next((one for one in _UNITS if age >= one[0]), _UNITS[-1])
        count = int(age / length)
        return self.say(f"{unit}_ago" if count == 1 else f"{unit}s_ago", count=count)

    def clock(self, at: float) -> str:
        """Return a local time [Unix time, s], with its day when that is not today."""
        when, today = datetime.fromtimestamp(at), datetime.fromtimestamp(self.now)
        key = "clock" if when.minute else "clock_full"
        clock = self.say(key, hour=f"{when.hour}", minute=f"{when.minute:02d}")
        days = (today.date() - when.date()).days
        if days == 0:
            return clock
        if days == 1:
            return self.say("yesterday_at", clock=clock)
        return self.say("on_day_at", day=when.day, month=when.month, clock=clock)

    def percent(self, confidence: float) -> str:
        """Return a confidence, 0 to 1, in percent."""
        return f"{max(1, round(100 * confidence))} %"

    def _forms(self, key: str, subject: NamedSubject) -> dict[str, object]:
        shown = native_names(subject, self._book)[0]
        if self.language == "de":
            nominative, dative, accusative = _german(shown)
        else:
            nominative = _english(shown, subject) if self.language == "en" else shown
            dative = accusative = nominative
        return {
            key: nominative,
            key.capitalize(): nominative[:1].upper() + nominative[1:],
            f"{key}_dat": dative,
            f"{key}_acc": accusative,
            f"{key}_bare": plain_name(shown, self.language),
        }

    def _contracted(self, text: str) -> str:
        if self.language == "de":
            for long, short in _CONTRACTIONS:
                text = text.replace(long, short).replace(long.capitalize(), short.capitalize())
        return text


def _english(name: str, subject: NamedSubject) -> str:
    """Return a name as it stands in a sentence: "stove" is "the stove", "grandma" stays."""
    if _ENGLISH_ARTICLE.match(name) or subject.kind.value == "person":
        return name
    shown = name if name.isupper() else name.lower() if subject.kind.value == "place" else name
    is_plain = (shown[:1].islower() or shown.isupper()) and not any(map(str.isdigit, shown))
    return f"the {shown}" if is_plain else shown


def _german(name: str) -> tuple[str, str, str]:
    """Return a name in nominative, dative and accusative, by its article; without one it stays."""
    article, _, rest = name.partition(" ")
    if article.lower() not in _CASES or not rest:
        bare = _ENGLISH_ARTICLE.sub("", name)
        return bare, bare, bare
    dative, accusative = _CASES[article.lower()]
    *adjectives, noun = rest.split(" ")
    weak = " ".join([*(f"{word}n" if word.endswith("e") else word for word in adjectives), noun])
    masculine = article.lower() == "der"
    return (
        f"{article.lower()} {rest}",
        f"{dative} {weak}",
        (f"{accusative} {weak if masculine else rest}"),
    )
