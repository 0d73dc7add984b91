"""Names for people that say nothing about them, the same in every export of a study."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from housefly.config.text import read_text_file
from housefly.errors import ConfigError
from housefly.hub.store.forget import mention_of
from housefly.messages import RoomEvent

_FREE_TEXT = frozenset({"words", "title", "by"})
"""Facts in which people say what they like, or which name who asked: left out."""


class Pseudonyms:
    """Pseudonyms of people, kept in a file apart from what is exported.

    Args:
        file: with the pseudonym of each person by id; new people are added.
        people: names of each person by id.

    Raises:
        ConfigError: the file is none of ours, or cannot be written.
    """

    def __init__(self, file: Path, people: Mapping[str, Iterable[str]]) -> None:
        self._by_id = _read(file)
        for person in sorted(set(people) - set(self._by_id)):
            self._by_id[person] = f"P{len(self._by_id) + 1:02d}"
        _write(file, self._by_id)
        self._mentions = [
            (mention_of((person, *names)), self._by_id[person]) for person, names in people.items()
        ]

    def of(self, thing: str) -> str:
        """Return the pseudonym of a person; of any other thing its id."""
        return self._by_id.get(thing, thing)

    def names(self, names: Mapping[str, str]) -> dict[str, str]:
        """Return names by id, in which people have their pseudonyms."""
        return {self.of(thing): self._by_id.get(thing, name) for thing, name in names.items()}

    def event(self, event: RoomEvent) -> RoomEvent:
        """Return an event that names nobody, and in which nobody's own words stand."""
        facts = tuple(
            (key, self._struck(value) if isinstance(value, str) else value)
            for key, value in event.facts
            if key not in _FREE_TEXT
        )
        return replace(
            event,
            kind=self._struck(event.kind),
            thing=self.of(event.thing),
            cause=self._struck(self.of(event.cause)),
            facts=facts,
        )

    def _struck(self, words: str) -> str:
        for mention, pseudonym in self._mentions:
            words = mention.sub(pseudonym, words)
        return words


def _read(file: Path) -> dict[str, str]:
    if not file.exists():
        return {}
    try:
        tree = json.loads(read_text_file(file))
        if isinstance(tree, dict) and all(isinstance(value, str) for value in tree.values()):
            return {str(key): value for key, value in tree.items()}
    except (OSError, ValueError, RecursionError):
        pass
    raise ConfigError("--pseudonyms", f"{file} is no file of pseudonyms; name a new one")


def _write(file: Path, by_id: dict[str, str]) -> None:
    try:
        descriptor = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
        with os.fdopen(descriptor, "w", encoding="utf-8") as target:
            json.dump(by_id, target, indent=1, ensure_ascii=False)
    except OSError as error:
        words = f"{file} cannot be written ({error.strerror})"
        raise ConfigError("--pseudonyms", words) from error
