"""What the flights of one row say together."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from scipy import stats

from housefly.lab.safety_case.trial import TrialResult
from housefly.twin.faults.fault_row import FaultRow

_CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class Spread:
    """Median, 95th percentile and largest of some numbers."""

    median: float
    p95: float
    largest: float


@dataclass(frozen=True, slots=True)
class RowFigures:
    """The flights of one row together.

    Attributes:
        flights, unsafe: how many.
        walked_into: flights in which somebody walked into a drone that nothing could steer away.
        bound: no more than this share is unsafe, with 95 % confidence.
        untold: flights in which nobody was told anything.
        told, safe: seconds from the fault until a person was told, and until the drone stood.
        deviation: farthest from the path [m].
        room_clearance, person_clearance: smallest gap of all flights [m]; None when not measured.
    """

    flights: int
    unsafe: int
    walked_into: int
    bound: float
    untold: int
    told: Spread | None
    safe: Spread | None
    deviation: Spread | None
    room_clearance: float | None
    person_clearance: float | None


def row_figures(results: Sequence[TrialResult]) -> RowFigures:
    """Return the figures of some flights."""
    unsafe = sum(result.unsafe for result in results)
    return RowFigures(
        flights=len(results),
        unsafe=unsafe,
        walked_into=sum(bool(result.walked_into) for result in results),
        bound=upper_bound(unsafe, len(results)),
        untold=sum(result.told_after is None for result in results),
        told=spread(result.told_after for result in results),
        safe=spread(result.safe_after for result in results),
        deviation=spread(result.deviation for result in results),
        room_clearance=_smallest(result.room_clearance for result in results),
        person_clearance=_smallest(result.person_clearance for result in results),
    )


def harmless_controls(
    results: Iterable[TrialResult], catalogue: Iterable[FaultRow]
) -> tuple[str, ...]:
    """Return the rows that are said to be harmful and did no harm in any flight without guards."""
    controls = [result for result in results if not result.key.guarded]
    flown = {row_number(result) for result in controls}
    harmed = {row_number(result) for result in controls if result.unsafe}
    harmful = {row.number for row in catalogue if row.harmful}
    return tuple(sorted((flown - harmed) & harmful))


def row_number(result: TrialResult) -> str:
    """Return the row of a flight, without its variant; "" for a pair and without a fault."""
    return "" if "+" in result.key.row else result.key.row.partition("/")[0]


def upper_bound(hits: int, total: int) -> float:
    """Return the share that is exceeded with 5 % confidence only (Clopper and Pearson, 1934)."""
    if hits >= total:
        return 1.0
    return float(stats.beta.ppf(_CONFIDENCE, hits + 1, total - hits))


def spread(numbers: Iterable[float | None]) -> Spread | None:
    """Return the spread of the numbers that are there; None without any."""
    known = sorted(number for number in numbers if number is not None)
    if not known:
        return None
    last = len(known) - 1
    return Spread(known[last // 2], known[round(0.95 * last)], known[last])


def _smallest(numbers: Iterable[float | None]) -> float | None:
    return min((number for number in numbers if number is not None), default=None)
