"""What the safe outcome of a row promises in numbers, and which flights stayed within it.

An invariant that is broken is unsafe. A flight that was safe and still told somebody late, or
strayed farther than its row says, is not unsafe: it is counted by itself, and shown.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import inf

from housefly.lab.safety_case.fault_phase import GROUND_FAULT_PHASES, FaultPhase
from housefly.lab.safety_case.plan import FAULT_FREE
from housefly.lab.safety_case.trial import TrialResult

_STEERED = frozenset(FaultPhase) - {*GROUND_FAULT_PHASES, FaultPhase.LANDING}
"""Phases from whose faults on time is counted: before, it stands, and afterwards it soon does."""


@dataclass(frozen=True, slots=True)
class OutcomeBounds:
    """What a row promises.

    Attributes:
        told_within: a person is told so long after a fault that begins in flight [s].
        on_floor_within: it stands so long after it [s].
        deviation: farthest true distance from the path, whenever the fault begins [m].
        is_silent: nothing is to be told.
    """

    told_within: float = inf
    on_floor_within: float = inf
    deviation: float = inf
    is_silent: bool = False


_UNNOTICED = OutcomeBounds(deviation=0.1, is_silent=True)
_HELD_THEN_LANDED = OutcomeBounds(told_within=0.5, on_floor_within=10.0, deviation=0.1)
_DISBELIEVED = OutcomeBounds(told_within=1.0, on_floor_within=10.0, deviation=0.1)
_LATE_ORDERS = OutcomeBounds(told_within=0.5, deviation=0.3)
_ON_ITS_OWN = OutcomeBounds(told_within=1.1, on_floor_within=10.0, deviation=0.6)

OUTCOME_BOUNDS: dict[str, OutcomeBounds] = {
    FAULT_FREE: _UNNOTICED,
    "F01": OutcomeBounds(deviation=0.05),
    "F02": OutcomeBounds(told_within=0.5, deviation=0.05),
    "F03": _HELD_THEN_LANDED,
    "F03/above_child": OutcomeBounds(told_within=1.5),
    "F03/above_lying": OutcomeBounds(told_within=1.5),
    "F04": _UNNOTICED,
    "F05": _DISBELIEVED,
    "F06": _DISBELIEVED,
    "F07": OutcomeBounds(told_within=1.0, on_floor_within=10.0, deviation=0.3),
    "F08": _DISBELIEVED,
    "F09": OutcomeBounds(deviation=0.2),
    "F10": _DISBELIEVED,
    "F11": _UNNOTICED,
    "F12": OutcomeBounds(deviation=0.25),
    "F12/unstamped_0.3s": OutcomeBounds(told_within=5.0, deviation=0.25),
    "F13/2cm": OutcomeBounds(told_within=5.0, deviation=0.3),
    "F13/5cm": OutcomeBounds(told_within=2.0, deviation=0.3),
    "F13/steps": OutcomeBounds(told_within=1.0, deviation=0.3),
    "F13/up_5cm": OutcomeBounds(told_within=8.0, deviation=0.3),
    "F13/jumps_5cm": OutcomeBounds(told_within=9.0, deviation=0.3),
    "F14": _UNNOTICED,
    "F15": _UNNOTICED,
    "F16/down_1s": OutcomeBounds(deviation=0.1),
    "F16/up_0.5s": _LATE_ORDERS,
    "F16/up_1s": _LATE_ORDERS,
    "F16/up_2s": OutcomeBounds(told_within=0.5),
    "F17": _ON_ITS_OWN,
    "F18": OutcomeBounds(told_within=1.1, on_floor_within=10.0, deviation=0.1),
    "F20": _HELD_THEN_LANDED,
    "F21/stuck": _UNNOTICED,
    "F21/garbage": OutcomeBounds(told_within=1.1, on_floor_within=10.0, deviation=0.1),
    "F24": OutcomeBounds(on_floor_within=10.0, deviation=0.1),
    "F25": _ON_ITS_OWN,
    "F32": OutcomeBounds(deviation=0.1),
    "F42": OutcomeBounds(deviation=0.1),
}
"""By row, or by variant where they differ; what is not here promises no numbers."""


def bounds_of(row: str) -> OutcomeBounds:
    """Return what a row promises, named with its variant; a pair promises no numbers."""
    number = row.partition("/")[0]
    return OUTCOME_BOUNDS.get(row, OUTCOME_BOUNDS.get(number, OutcomeBounds()))


def missed_bounds(result: TrialResult) -> tuple[str, ...]:
    """Return what a flight missed of what its row promises, in words."""
    bounds, told = bounds_of(result.key.row), result.told_after
    missed = []
    if bounds.is_silent and told is not None:
        missed.append(f"told: {result.told}")
    if result.phase in _STEERED:
        missed += _late("told", told, bounds.told_within)
        missed += _late("on the floor", result.safe_after, bounds.on_floor_within)
    if result.deviation > bounds.deviation:
        missed.append(f"{result.deviation:.2f} m from its path (promised {bounds.deviation:g} m)")
    return tuple(missed)


def _late(what: str, after: float | None, limit: float) -> list[str]:
    if limit == inf or (after is not None and after <= limit):
        return []
    when = "never" if after is None else f"after {after:.1f} s"
    return [f"{what} {when} (promised {limit:g} s)"]
