"""What one flight with a fault was, and how it ended on the truth."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from enum import Enum
from typing import Any

from pydantic import TypeAdapter

from housefly.lab.safety_case.fault_phase import FaultPhase


class PersonOrder(Enum):
    """What a person does soon after the fault began."""

    NOTHING = "nothing"
    STOP = "stop"
    LAND = "land"
    RESUME = "resume"
    DEAD_PILOT = "dead pilot"


@dataclass(frozen=True, slots=True)
class TrialKey:
    """One flight of the safety case.

    Attributes:
        row: of the fault matrix, with its variant: ``F13/2cm``; a pair is joined by ``+``.
        seed: of everything random; it also chooses phase and tracking rate.
        guarded: with its guards, else the negative control.
        order: what a person does.
        model: of the drone; "" is the room's own.
    """

    row: str
    seed: int
    guarded: bool = True
    order: PersonOrder = PersonOrder.NOTHING
    model: str = ""


@dataclass(frozen=True, slots=True)
class TrialResult:
    """How one flight ended; times count from the fault [s], None where there was none.

    Attributes:
        key: which flight.
        phase: where the fault began.
        violations: invariants that were broken, in words; none means safe.
        ending: how it ended, in words.
        told_after: until a person was told.
        safe_after: until it stood on the floor, or the mission went on to its end.
        deviation: farthest true distance from the path [m].
        room_clearance, person_clearance: smallest true gap to the hull while it flew [m].
        top_speed: true, after the fault [m/s].
        told: what a person was told, first words.
        walked_into: who walked into a drone that could not have been steered away in time, or "".
    """

    key: TrialKey
    phase: FaultPhase
    violations: tuple[str, ...]
    ending: str
    told_after: float | None
    safe_after: float | None
    deviation: float
    room_clearance: float | None
    person_clearance: float | None
    top_speed: float
    told: str = ""
    walked_into: str = ""

    @property
    def unsafe(self) -> bool:
        """Whether an invariant was broken."""
        return bool(self.violations)

    def to_json(self) -> dict[str, Any]:
        """Return the result as plain values."""
        key = {**asdict(self.key), "order": self.key.order.value}
        return {**asdict(self), "key": key, "phase": self.phase.value}


_RESULT: TypeAdapter[TrialResult] = TypeAdapter(TrialResult)


def result_from_json(text: str) -> TrialResult:
    """Return the result of what ``to_json`` gave; raises ValidationError for anything else."""
    return _RESULT.validate_json(text)
