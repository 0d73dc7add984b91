"""Run-length encoding of samples: a thing that stands still is one row with a begin and an end."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from housefly.geometry import distance
from housefly.messages import Observation

STILL_DISTANCE = 0.002
"""A thing that moved less than this stands still [m]."""
_SAME_ROTATION = 5e-5
"""Orientations with 1 - |a . b| below this are equal: less than 20 mrad apart."""
MAX_SILENCE = 60.0
"""A longer silence ends a run [s]: nobody knows what happened in between."""

_Pair = tuple[str, str]


@dataclass(slots=True)
class Run:
    """A sample, and until when its source repeated it [s, Unix time]."""

    sample: Observation
    until: float


@dataclass(frozen=True, slots=True)
class _EncodedRuns:
    """Runs that a batch of samples begins, and runs that it extends."""

    begun: tuple[Run, ...]
    extended: tuple[Run, ...]


@dataclass(slots=True)
class RunLengthEncoder:
    """Keeps the current run of each source on each thing."""

    _runs: dict[_Pair, Run] = field(default_factory=dict)
    _containers: dict[str, dict[str, float]] = field(default_factory=dict)
    """When each thing was last reported in each container, by any source."""

    def encode(self, samples: Iterable[Observation]) -> _EncodedRuns:
        """Encode a batch of samples."""
        begun: list[Run] = []
        extended: dict[int, Run] = {}
        for sample in samples:
            if sample.inside:
                self._containers.setdefault(sample.thing, {})[sample.inside] = sample.captured_at
            pair = sample.thing, sample.source
            run = self._runs.get(pair)
            if run is not None and self._goes_on(run, sample):
                run.until = sample.captured_at
                extended[id(run)] = run
                continue
            begun.append(Run(sample, sample.captured_at))
            if run is None or sample.captured_at >= run.until:
                self._runs[pair] = begun[-1]
        for run in begun:
            extended.pop(id(run), None)
        return _EncodedRuns(tuple(begun), tuple(extended.values()))

    def reset(self) -> None:
        """Begin new runs for everything: it is unknown which rows the database has."""
        self._runs.clear()
        self._containers.clear()

    def _goes_on(self, run: Run, sample: Observation) -> bool:
        """Return whether a sample repeats its run, and nobody reported another container since."""
        if not (
            0.0 <= sample.captured_at - run.until <= MAX_SILENCE and _is_same(run.sample, sample)
        ):
            return False
        elsewhere = (
            at
            for inside, at in self._containers.get(sample.thing, {}).items()
            if inside != sample.inside
        )
        return not (sample.inside and any(run.until < at <= sample.captured_at for at in elsewhere))


def _is_same(one: Observation, other: Observation) -> bool:
    """Return whether two samples of one source say the same about a thing."""
    if (one.inside, one.valid, one.facts) != (other.inside, other.valid, other.facts):
        return False
    if one.position is None or other.position is None:
        return one.position is other.position and one.orientation == other.orientation
    return distance(one.position, other.position) <= STILL_DISTANCE and _is_unturned(one, other)


def _is_unturned(one: Observation, other: Observation) -> bool:
    if one.orientation is None or other.orientation is None:
        return one.orientation is other.orientation
    return (
        1.0 - abs(sum(a * b for a, b in zip(one.orientation, other.orientation, strict=True)))
        < _SAME_ROTATION
    )
