"""What is answered, in the words of a language: phrases from a file, filled with values."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path

import yaml

from housefly.tasks.intents.intent import Language


class Phrases:
    """The phrases of one language.

    Attributes:
        language: which.
        texts: by key.
    """

    def __init__(self, language: Language) -> None:
        path = Path(__file__).with_name(f"phrases_{language}.yaml")
        self.language = language
        self.texts: Mapping[str, str] = yaml.load(
            path.read_text(encoding="utf-8"), yaml.CSafeLoader
        )

    def __call__(self, key: str, **values: object) -> str:
        """Return a phrase with its values; raises KeyError when there is none."""
        return self.texts[key].format(**values)

    def joined(self, *sentences: str) -> str:
        """Return sentences one after the other."""
        return self("space").join(one for one in sentences if one)

    def listed(self, words: Iterable[str], join: str = "and") -> str:
        """Return words as a list in a sentence; ``join`` is "and" or "or"."""
        *first, last = words
        return f"{self('comma').join(first)}{self(join)}{last}" if first else last


@cache
def phrases(language: Language) -> Phrases:
    """Return the phrases of a language; they are loaded once."""
    return Phrases(language)
