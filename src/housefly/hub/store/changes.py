"""A thing that stands still is written once: its row says from when until when it was so."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from housefly.geometry import distance
from housefly.messages import Observation

STILL = 0.002
"""A thing that is this close to where its row says has not moved [m]."""
UNTURNED = 5e-5
"""Two orientations whose quaternions have 1 - |a . b| below this are the same: less than 20 mrad
apart.
"""
LONGEST_SILENCE = 60.0
"""A source that says the same after a longer silence begins a new row: nobody knows what was in
between [s].
"""

Pair = tuple[str, str]


@dataclass(slots=True)
class Span:
    """A sample and until when its source went on saying just that [s, Unix time]."""

    sample: Observation
    until: float


@dataclass(frozen=True, slots=True)
class Change:
    """What a batch of samples changes: rows that begin, and rows that go on for longer."""

    begun: tuple[Span, ...]
    stretched: tuple[Span, ...]


@dataclass(slots=True)
class Changes:
    """Remembers the row in which each source's last word on each thing stands."""

    _spans: dict[Pair, Span] = field(default_factory=dict)
    _containers: dict[str, dict[str, float]] = field(default_factory=dict)
    """When each thing was last said, by anybody, to be in each container."""

    def of(self, samples: Iterable[Observation]) -> Change:
        """Return what these samples change."""
        begun: list[Span] = []
        stretched: dict[int, Span] = {}
        for sample in samples:
            if sample.inside:
                self._containers.setdefault(sample.thing, {})[sample.inside] = sample.captured_at
            pair = sample.thing, sample.source
            span = self._spans.get(pair)
            if span is not None and self._goes_on(span, sample):
                span.until = sample.captured_at
                stretched[id(span)] = span
                continue
            begun.append(Span(sample, sample.captured_at))
            if span is None or sample.captured_at >= span.until:
                self._spans[pair] = begun[-1]
        for span in begun:
            stretched.pop(id(span), None)
        return Change(tuple(begun), tuple(stretched.values()))

    def forget(self) -> None:
        """Begin new rows for everything: it is not known which rows the database has."""
        self._spans.clear()
        self._containers.clear()

    def _goes_on(self, span: Span, sample: Observation) -> bool:
        """Tell whether a sample says what its row says, and nobody said since that the thing is in
        something else.
        """
        if not (
            0.0 <= sample.captured_at - span.until <= LONGEST_SILENCE
            and is_same(span.sample, sample)
        ):
            return False
        elsewhere = (
            at
            for inside, at in self._containers.get(sample.thing, {}).items()
            if inside != sample.inside
        )
        return not (
            sample.inside and any(span.until < at <= sample.captured_at for at in elsewhere)
        )


def is_same(one: Observation, other: Observation) -> bool:
    """Tell whether two samples of one source say the same of a thing."""
    if (one.inside, one.valid, one.facts) != (other.inside, other.valid, other.facts):
        return False
    if one.position is None or other.position is None:
        return one.position is other.position and one.orientation == other.orientation
    return distance(one.position, other.position) <= STILL and _is_unturned(one, other)


def _is_unturned(one: Observation, other: Observation) -> bool:
    if one.orientation is None or other.orientation is None:
        return one.orientation is other.orientation
    return (
        1.0 - abs(sum(a * b for a, b in zip(one.orientation, other.orientation, strict=True)))
        < UNTURNED
    )
