"""What cabinets and refrigerators say of their contents, made into moves: by their own reports, or
by what is missing and new.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, field

from housefly.hub.situations.move import PUT, TAKEN, Move
from housefly.hub.situations.situation import Item, fact, number
from housefly.hub.situations.trust import KNOWN, trust
from housefly.messages import Facts, Happening, Observation

HEARTBEAT = 30.0
"""A container speaks at least this often [s]."""
ABSENT = 1.5
"""A thing must be missing from the contents for this long before it counts as taken [s]: tag
readers blink.
"""
SETTLE = 2.0
"""For this long after a container reported a move, contents that say otherwise are not believed
[s]: they are older.
"""
REPORTED = 0.95
"""Confidence in a move that the container reports itself."""
COMPARED = 0.85
"""Confidence in a move seen in the contents only."""
UNDATED = 0.6
"""The same, where the container was silent meanwhile."""


@dataclass(slots=True)
class _Container:
    """One container: its contents, None until it names them; what is missing, and what it reported
    [s, Unix time].
    """

    heard: float
    inside: set[str] | None = None
    missing: dict[str, tuple[float, bool]] = field(default_factory=dict)
    reported: dict[str, tuple[float, bool]] = field(default_factory=dict)

    def believed(self, named: set[str], at: float) -> set[str]:
        """Return the contents that it names, mended by what it has just reported."""
        fresh = {thing: put for thing, (when, put) in self.reported.items() if at - when < SETTLE}
        return (named | {thing for thing, put in fresh.items() if put}) - {
            thing for thing, put in fresh.items() if not put
        }


class Contents:
    """Watches everything that says what is in it.

    Args:
        expected: ids of the containers that should speak.
    """

    def __init__(self, expected: Collection[str]) -> None:
        self._expected = expected
        self._containers: dict[str, _Container] = {}
        self._moves: list[Move] = []

    def take(self, item: Item) -> None:
        """Take a report of a move, or the contents."""
        if isinstance(item, Happening):
            if item.kind in (TAKEN, PUT) and item.thing != item.source:
                self._report(item)
        elif (
            item.valid
            and item.thing == item.source
            and isinstance(named := fact(item, "contents"), str)
        ):
            self._compare(item, {name for name in named.split(",") if name})

    def moves(self, now: float) -> tuple[Move, ...]:
        """Return the moves since the last call; what is missing counts once it was so for a while."""
        done, self._moves = self._moves + list(self._lost(now)), []
        return tuple(sorted(done, key=lambda move: (move.at, move.thing)))

    def where(self, thing: str) -> str:
        """Return the id of the container that a thing is in, "" for none."""
        return next(
            (name for name, box in sorted(self._containers.items()) if thing in (box.inside or ())),
            "",
        )

    def known(self, now: float) -> bool:
        """Tell whether all containers still speak, so that what is in none of them is known."""
        heard = {
            **dict.fromkeys(self._expected, float("-inf")),
            **{name: box.heard for name, box in self._containers.items()},
        }
        return all(trust(now - at, HEARTBEAT) >= KNOWN for at in heard.values())

    def _report(self, told: Happening) -> None:
        box, put = self._containers.setdefault(told.source, _Container(told.at)), told.kind == PUT
        box.heard, box.reported[told.thing] = told.at, (told.at, put)
        box.missing.pop(told.thing, None)
        if box.inside is not None:
            if (told.thing in box.inside) == put:
                return
            (box.inside.add if put else box.inside.discard)(told.thing)
        self._moves.append(_reported(told))

    def _compare(self, said: Observation, named: set[str]) -> None:
        at, source = said.captured_at, said.source
        box = self._containers.setdefault(source, _Container(at))
        dated, box.heard = trust(at - box.heard, HEARTBEAT) == 1.0, at
        believed = box.believed(named, at)
        if box.inside is None:
            box.inside = set(believed)
        for thing in sorted(believed - box.inside):
            box.inside.add(thing)
            self._moves.append(_compared(PUT, thing, at, source, dated))
        for thing in sorted(box.inside - believed):
            box.missing.setdefault(thing, (at, dated))
        for thing in believed:
            box.missing.pop(thing, None)

    def _lost(self, now: float) -> Iterator[Move]:
        for source, box in sorted(self._containers.items()):
            lost = [
                (thing, at, dated)
                for thing, (at, dated) in sorted(box.missing.items())
                if now - at >= ABSENT
            ]
            for thing, at, dated in lost:
                del box.missing[thing]
                (box.inside or set()).discard(thing)
                yield _compared(TAKEN, thing, at, source, dated)


def _reported(told: Happening) -> Move:
    weight = number(told, "weight")
    facts: Facts = () if weight is None else (("weight", weight),)
    confidence = REPORTED * min(1.0, max(0.0, told.confidence))
    return Move(
        told.kind,
        told.thing,
        told.at,
        told.source,
        None,
        confidence,
        f"{told.source}: reports it",
        facts=facts,
    )


def _compared(kind: str, thing: str, at: float, source: str, dated: bool) -> Move:
    words = (
        f"{source}: {'no longer' if kind == TAKEN else 'now'} among its"
        f" contents{'' if dated else ', after a silence'}"
    )
    return Move(kind, thing, at, source, None, COMPARED if dated else UNDATED, words, dated)
