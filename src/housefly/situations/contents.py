"""What cabinets and refrigerators say of their contents, made into moves: by their own reports, or by what is missing and new."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from housefly.messages import Happening, Observation
from housefly.situations.move import PUT, TAKEN, Move
from housefly.situations.situation import Item, fact, number
from housefly.situations.trust import KNOWN, trust

HEARTBEAT = 30.0
"""A container speaks at least this often [s]."""
ABSENT = 1.5
"""A thing must be missing from the contents for this long before it counts as taken [s]: tag readers blink."""
SETTLE = 2.0
"""For this long after a container reported a move, contents that say otherwise are not believed [s]: they are older."""
REPORTED = 0.95
"""Confidence in a move that the container reports itself."""
COMPARED = 0.85
"""Confidence in a move seen in the contents only."""
UNDATED = 0.6
"""The same, where the container was silent meanwhile."""


@dataclass(slots=True)
class _Container:
    """One container: its contents as far as known, None at first, and since when things are missing [s, Unix time]."""

    heard: float
    inside: set[str] | None = None
    missing: dict[str, tuple[float, bool]] = field(default_factory=dict)
    reported: dict[str, float] = field(default_factory=dict)


class Contents:
    """Watches everything that says what is in it."""

    def __init__(self) -> None:
        self._containers: dict[str, _Container] = {}
        self._moves: list[Move] = []

    def take(self, item: Item) -> None:
        """Take a report of a move, or the contents."""
        if isinstance(item, Happening):
            if item.kind in (TAKEN, PUT) and item.thing != item.source:
                self._report(item)
        elif item.valid and item.thing == item.source and isinstance(named := fact(item, "contents"), str):
            self._compare(item, {name for name in named.split(",") if name})

    def moves(self, now: float) -> tuple[Move, ...]:
        """Return the moves since the last call; what is missing counts once it was so for a while."""
        done, self._moves = self._moves + list(self._lost(now)), []
        return tuple(sorted(done, key=lambda move: (move.at, move.thing)))

    def where(self, thing: str) -> str:
        """Return the id of the container that a thing is in, "" for none."""
        return next((name for name, box in sorted(self._containers.items()) if thing in (box.inside or ())), "")

    def known(self, now: float) -> bool:
        """Tell whether all containers still speak, so that what is in none of them is known."""
        return all(trust(now - box.heard, HEARTBEAT) >= KNOWN for box in self._containers.values())

    def things(self) -> Mapping[str, str]:
        """Return the container of each thing that is in one."""
        return {thing: name for name, box in sorted(self._containers.items()) for thing in box.inside or ()}

    def _report(self, told: Happening) -> None:
        box = self._containers.setdefault(told.source, _Container(told.at))
        box.heard, box.reported[told.thing] = told.at, told.at
        box.missing.pop(told.thing, None)
        inside = box.inside if box.inside is not None else set()
        known = box.inside is not None
        if known and (told.thing in inside) == (told.kind == PUT):
            return
        (inside.add if told.kind == PUT else inside.discard)(told.thing)
        weight = number(told, "weight")
        facts = () if weight is None else (("weight", weight),)
        words = f"{told.source}: reports it"
        self._moves.append(
            Move(told.kind, told.thing, told.at, told.source, None, REPORTED * told.confidence, words, facts=facts)
        )

    def _compare(self, said: Observation, named: set[str]) -> None:
        at, source = said.captured_at, said.source
        box = self._containers.setdefault(source, _Container(at))
        silent = trust(at - box.heard, HEARTBEAT) < 1.0
        box.heard = at
        if box.inside is None:
            box.inside = {thing for thing in named if not self._settling(box, thing, at)}
            return
        for thing in sorted(named - box.inside):
            if not self._settling(box, thing, at):
                box.inside.add(thing)
                self._moves.append(_compared(PUT, thing, at, source, dated=not silent))
        for thing in sorted(box.inside - named):
            if not self._settling(box, thing, at):
                box.missing.setdefault(thing, (at, not silent))
        for thing in named:
            box.missing.pop(thing, None)

    def _lost(self, now: float) -> Iterator[Move]:
        for source, box in sorted(self._containers.items()):
            lost = [(thing, at, dated) for thing, (at, dated) in sorted(box.missing.items()) if now - at >= ABSENT]
            for thing, at, dated in lost:
                del box.missing[thing]
                (box.inside or set()).discard(thing)
                yield _compared(TAKEN, thing, at, source, dated)

    def _settling(self, box: _Container, thing: str, at: float) -> bool:
        return at - box.reported.get(thing, float("-inf")) < SETTLE


def _compared(kind: str, thing: str, at: float, source: str, dated: bool) -> Move:
    words = f"{source}: {'no longer' if kind == TAKEN else 'now'} among its contents{'' if dated else ', after a silence'}"
    return Move(kind, thing, at, source, None, COMPARED if dated else UNDATED, words, dated)
