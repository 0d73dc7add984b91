"""Finds a thing by its names."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable
from difflib import get_close_matches

from housefly.errors import ThingError

_MAX_SUGGESTIONS = 5
_MIN_SIMILARITY = 0.6
"""Names at least this similar (0 to 1) are suggested."""


class NameIndex:
    """Maps names to ids, case-insensitively."""

    def __init__(self) -> None:
        self._ids: dict[str, set[str]] = {}
        self._ordered: list[str] | None = None

    def add(self, thing: str, names: Iterable[str]) -> None:
        """Add names of a thing."""
        for name in names:
            self._ids.setdefault(_folded(name), set()).add(thing)
        self._ordered = None

    def remove(self, thing: str, names: Iterable[str]) -> None:
        """Remove names of a thing."""
        for name in names:
            ids = self._ids.get(_folded(name), set())
            ids.discard(thing)
            if not ids:
                self._ids.pop(_folded(name), None)
        self._ordered = None

    def find(self, words: str, among: frozenset[str] | None = None) -> str:
        """Return the id for a name, an alias, an id, or the unique beginning of one.

        Raises:
            ThingError: no thing or more than one matches; suggests what could have been meant.
        """
        wanted = _folded(words)
        for ids in (self._ids.get(wanted, set()), self._beginning(wanted)):
            meant = ids if among is None else ids & among
            if len(meant) == 1:
                return next(iter(meant))
            if meant:
                raise ThingError(f"{words!r} could be {_listed(sorted(meant))}: say which")
        raise ThingError(f"nothing is called {words!r}{self._suggestion(wanted, among)}")

    def _beginning(self, start: str) -> set[str]:
        if not start:
            return set()
        if self._ordered is None:
            self._ordered = sorted(self._ids)
        found: set[str] = set()
        for name in self._ordered[bisect_left(self._ordered, start) :]:
            if not name.startswith(start):
                break
            found |= self._ids[name]
        return found

    def _suggestion(self, wanted: str, among: frozenset[str] | None) -> str:
        names = [name for name, ids in self._ids.items() if among is None or ids & among]
        close = get_close_matches(wanted, names, n=_MAX_SUGGESTIONS, cutoff=_MIN_SIMILARITY)
        return f": did you mean {_listed(close)}?" if close else ""


def _folded(name: str) -> str:
    return " ".join(name.casefold().split())


def _listed(names: list[str]) -> str:
    shown = [repr(name) for name in names[:_MAX_SUGGESTIONS]]
    more = ["more"] if len(names) > _MAX_SUGGESTIONS else []
    *first, last = shown + more
    return f"{', '.join(first)} or {last}" if first else last
