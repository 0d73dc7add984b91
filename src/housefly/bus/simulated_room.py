"""What a person does to a simulated room from the console: one query, one answer, as JSON."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import Annotated, ClassVar

from pydantic import ConfigDict, Field, TypeAdapter, ValidationError

from housefly.config.pydantic_words import words_of
from housefly.config.validation import dotted
from housefly.errors import WireError
from housefly.messages.words import Words

SIMULATION_QUERY = "twin/simulation"
"""Query: JSON of a SimulatedAct -> JSON of a SimulatedOutcome; only a simulated room answers."""
LASTS_MIN, LASTS_MAX = 1.0, 300.0
"""How long a fault that a person makes may last [s]."""

_Name = Annotated[str, Field(max_length=64)]


class SimulatedDeed(Enum):
    """What can be done to a simulated room, beside ringing its bell."""

    LOOK = "look"
    PUT_BACK = "put back"
    CHARGE = "charge"
    WALK = "walk"
    FAULT = "fault"
    MEND = "mend"


@dataclass(frozen=True, slots=True)
class SimulatedAct:
    """One thing to be done.

    Attributes:
        deed: what; LOOK does nothing.
        drone: to which, "" for the first.
        fault: which of the faults that an outcome lists; for FAULT only.
        seconds: how long it lasts, 1 to 300 [s]; for FAULT only.
    """

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")
    deed: SimulatedDeed
    drone: _Name = ""
    fault: _Name = ""
    seconds: Annotated[float, Field(ge=LASTS_MIN, le=LASTS_MAX, allow_inf_nan=False)] = 10.0


@dataclass(frozen=True, slots=True)
class SimulatedFault:
    """A fault that can be made: its row in the catalogue, and what happens."""

    row: str
    words: Words


@dataclass(frozen=True, slots=True)
class SimulatedOutcome:
    """What came of it.

    Attributes:
        done: whether it was done.
        words: what happens now, or why nothing does.
        faults: those that can be made here.
        failing: how many faults that a person made are there now.
    """

    done: bool
    words: Words
    faults: tuple[SimulatedFault, ...] = ()
    failing: int = 0


_ACT: TypeAdapter[SimulatedAct] = TypeAdapter(SimulatedAct)
_OUTCOME: TypeAdapter[SimulatedOutcome] = TypeAdapter(SimulatedOutcome)


def act_to_json(act: SimulatedAct) -> str:
    """Return the JSON text of an act."""
    return _ACT.dump_json(act).decode()


def act_from_json(text: str | bytes) -> SimulatedAct:
    """Return an act; raises WireError naming the key, the value and what is allowed."""
    try:
        return _ACT.validate_json(text)
    except ValidationError as error:
        first = error.errors()[0]
        raise WireError(f"{dotted(first['loc']) or 'act'}: {words_of(first)}") from error


def outcome_to_json(outcome: SimulatedOutcome) -> str:
    """Return the JSON text of an outcome."""
    return _OUTCOME.dump_json(outcome).decode()


def outcome_from_json(text: str) -> SimulatedOutcome:
    """Return an outcome; raises WireError when it is none."""
    try:
        return _OUTCOME.validate_json(text)
    except ValidationError as error:
        raise WireError("the simulated room answers what is no outcome") from error
