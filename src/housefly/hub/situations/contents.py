"""Turns the contents that cabinets and refrigerators report into moves."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, field

from housefly.hub.situations.confidence import KNOWN_THRESHOLD, freshness
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.move import Move
from housefly.hub.situations.situation import DetectorInput, Evidence, fact, number
from housefly.messages import Facts, Observation, RoomEvent

CONTAINER_HEARTBEAT = 30.0
"""Longest time between two messages of a container [s]."""
ABSENT_AFTER = 1.5
"""How long a thing must be missing before it counts as taken [s]: tag readers blink."""
_SETTLE_TIME = 2.0
"""How long contents that contradict a reported move are ignored [s]: they are older."""
_REPORTED_CONFIDENCE = 0.95
"""Confidence in a move that the container itself reports."""
_COMPARED_CONFIDENCE = 0.85
"""Confidence in a move seen only as a change of contents."""
_UNDATED_CONFIDENCE = 0.6
"""The same, if the container was silent in between."""


@dataclass(slots=True)
class _Container:
    """One container.

    Attributes:
        heard: when it was last heard [s, Unix time].
        inside: its contents, None until it lists them.
        missing: when each thing went missing [s, Unix time], and whether that time is exact.
        reported: when it reported a move of each thing [s, Unix time], and whether it was put in.
    """

    heard: float
    inside: set[str] | None = None
    missing: dict[str, tuple[float, bool]] = field(default_factory=dict)
    reported: dict[str, tuple[float, bool]] = field(default_factory=dict)

    def corrected(self, named: set[str], at: float) -> set[str]:
        """Return the listed contents, corrected by the moves that it has just reported."""
        fresh = {
            thing: put for thing, (when, put) in self.reported.items() if at - when < _SETTLE_TIME
        }
        return (named | {thing for thing, put in fresh.items() if put}) - {
            thing for thing, put in fresh.items() if not put
        }


class ContentsDetector:
    """Detects moves in and out of everything that reports its contents.

    Args:
        expected: ids of the containers that should speak.
    """

    def __init__(self, expected: Collection[str]) -> None:
        self._expected = expected
        self._containers: dict[str, _Container] = {}
        self._moves: list[Move] = []

    def add(self, item: DetectorInput) -> None:
        """Add a report of a move, or a list of contents."""
        if isinstance(item, RoomEvent):
            if (
                item.kind in (SituationKind.OBJECT_TAKEN, SituationKind.OBJECT_PUT)
                and item.thing != item.source
            ):
                self._report(item)
        elif (
            item.valid
            and item.thing == item.source
            and isinstance(named := fact(item, "contents"), str)
        ):
            self._compare(item, {name for name in named.split(",") if name})

    def moves(self, now: float) -> tuple[Move, ...]:
        """Return the moves since the last call; a thing counts as taken after ``ABSENT_AFTER``."""
        done, self._moves = self._moves + list(self._lost(now)), []
        return tuple(sorted(done, key=lambda move: (move.at, move.thing)))

    def container_of(self, thing: str) -> str:
        """Return the id of the container that a thing is in, "" for none."""
        return next(
            (name for name, box in sorted(self._containers.items()) if thing in (box.inside or ())),
            "",
        )

    def all_live(self, now: float) -> bool:
        """Return whether all containers are alive, so that what is in none of them is known."""
        heard = {
            **dict.fromkeys(self._expected, float("-inf")),
            **{name: box.heard for name, box in self._containers.items()},
        }
        return all(
            freshness(now - at, CONTAINER_HEARTBEAT) >= KNOWN_THRESHOLD for at in heard.values()
        )

    def _report(self, event: RoomEvent) -> None:
        box, put = (
            self._containers.setdefault(event.source, _Container(event.at)),
            event.kind == SituationKind.OBJECT_PUT,
        )
        box.heard, box.reported[event.thing] = event.at, (event.at, put)
        box.missing.pop(event.thing, None)
        if box.inside is not None:
            if (event.thing in box.inside) == put:
                return
            (box.inside.add if put else box.inside.discard)(event.thing)
        self._moves.append(_reported(event))

    def _compare(self, sample: Observation, named: set[str]) -> None:
        at, source = sample.captured_at, sample.source
        box = self._containers.setdefault(source, _Container(at))
        dated, box.heard = freshness(at - box.heard, CONTAINER_HEARTBEAT) == 1.0, at
        contents = box.corrected(named, at)
        if box.inside is None:
            box.inside = set(contents)
        for thing in sorted(contents - box.inside):
            box.inside.add(thing)
            self._moves.append(_compared(SituationKind.OBJECT_PUT, thing, at, source, dated))
        for thing in sorted(box.inside - contents):
            box.missing.setdefault(thing, (at, dated))
        for thing in contents:
            box.missing.pop(thing, None)

    def _lost(self, now: float) -> Iterator[Move]:
        for source, box in sorted(self._containers.items()):
            lost = [
                (thing, at, dated)
                for thing, (at, dated) in sorted(box.missing.items())
                if now - at >= ABSENT_AFTER
            ]
            for thing, at, dated in lost:
                del box.missing[thing]
                (box.inside or set()).discard(thing)
                yield _compared(SituationKind.OBJECT_TAKEN, thing, at, source, dated)


def _reported(event: RoomEvent) -> Move:
    weight = number(event, "weight")
    facts: Facts = () if weight is None else (("weight", weight),)
    confidence = _REPORTED_CONFIDENCE * min(1.0, max(0.0, event.confidence))
    return Move(
        SituationKind(event.kind),
        event.thing,
        event.at,
        event.source,
        None,
        confidence,
        Evidence("reports it", event.source),
        facts=facts,
    )


def _compared(kind: SituationKind, thing: str, at: float, source: str, dated: bool) -> Move:
    now = "no longer" if kind is SituationKind.OBJECT_TAKEN else "now"
    silence = "" if dated else ", after a silence"
    return Move(
        kind,
        thing,
        at,
        source,
        None,
        _COMPARED_CONFIDENCE if dated else _UNDATED_CONFIDENCE,
        Evidence(f"{now} among its contents{silence}", source),
        dated,
    )
