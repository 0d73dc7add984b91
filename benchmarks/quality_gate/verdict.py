"""Red or green: the limits of a row against what was flown."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from quality_gate.flown_row import FlownRow
from quality_gate.rows import PAPER_RATIO
from quality_gate.scenario import FlightKind, Limit, Scenario, Way


@dataclass(frozen=True, slots=True)
class Finding:
    """One limit of one row.

    Attributes:
        row, way: whose.
        limit: which.
        value: what was flown.
        holds: whether it is kept.
    """

    row: str
    way: str
    limit: Limit
    value: float
    holds: bool


def limit_findings(
    scenario: Scenario, flown: Sequence[FlownRow], *, whole: bool = True
) -> tuple[Finding, ...]:
    """Return what the limits of a row say about it, for every way that flew it.

    Args:
        scenario: the row.
        flown: by each way.
        whole: all of its errands were flown; else sums over them are not judged, and every one
            that was flown must have arrived.
    """
    found = []
    for row in flown:
        for limit in scenario.limits:
            if Way(row.way) not in limit.ways or (not whole and limit.measure in ("time", "whole")):
                continue
            value = float(getattr(row.measures, limit.measure))
            if not whole and limit.measure == "arrived":
                limit = Limit("arrived", least=max(1.0, row.measures.legs), source=limit.source)
            found.append(Finding(row.row, row.way, limit, value, limit.holds(value)))
    return (*found, *_beside_paper(scenario, flown))


def _beside_paper(scenario: Scenario, flown: Sequence[FlownRow]) -> tuple[Finding, ...]:
    """Return whether trajectories keep to the eight so much better than mode paper."""
    by_way = {row.way: row.measures.path_rms for row in flown}
    paper, space = by_way.get(Way.PAPER.value), by_way.get(Way.SPACE.value)
    if scenario.kind is not FlightKind.EIGHT or paper is None or space is None:
        return ()
    limit = Limit("path_rms", most=paper / PAPER_RATIO, source=f"1/{PAPER_RATIO:.0f} of paper")
    return (Finding(scenario.name, Way.SPACE.value, limit, space, limit.holds(space)),)
