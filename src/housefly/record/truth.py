"""The true course of a flight in the simulated room, as its process wrote it.

Real hardware knows no truth: without the file nothing is scored on it.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray
from pydantic import ConfigDict, TypeAdapter, ValidationError

from housefly.geometry import Vec3
from housefly.numeric import FloatArray

TRUTH_FILE = "truth.jsonl"
COMPLETED = "completed"
"""Outcome of a service of which everything happened, and in which nothing was touched."""
HOME_RADIUS = 1.0
"""A service must end within this distance of the pad [m]."""
_WITH_CONTACT = "with contact: "
_FINITE = ConfigDict(allow_inf_nan=False)


@dataclass(frozen=True, slots=True)
class ContactRecord:
    """One touch of anything but the floor.

    Attributes:
        at_s: when it began: since the start of the recording [s], of its clock in ``TrueFlight``.
        kind, name: what or who was touched.
        speed: relative to it, just before [m/s].
        height: of the touch above the floor [m].
        duration_s: how long it lasted [s].
        motors_turned: whether the motors turned meanwhile.
    """

    at_s: float
    kind: str
    name: str
    speed: float
    height: float
    duration_s: float
    motors_turned: bool


@dataclass(frozen=True, slots=True, eq=False)
class TrueFlight:
    """The truth, sampled.

    Attributes:
        time: on the clock of the pilot's steps [s], shape (n,).
        position: world [m], shape (n, 3).
        airborne: whether the drone's motors kept it up, shape (n,).
        solid, person: from hull to the next solid and person [m], shape (n,); not a number where
            there is none.
        contacts: in order of time, on the same clock.
    """

    time: FloatArray
    position: FloatArray
    airborne: NDArray[np.bool_]
    solid: FloatArray
    person: FloatArray
    contacts: tuple[ContactRecord, ...]


@dataclass(frozen=True, slots=True)
class _Sample:
    __pydantic_config__: ClassVar[ConfigDict] = _FINITE
    at: float
    position: Vec3
    airborne: bool
    solid: float | None
    person: float | None


@dataclass(frozen=True, slots=True)
class _Touch:
    __pydantic_config__: ClassVar[ConfigDict] = _FINITE
    at: float
    began: float
    kind: str
    contact: str
    speed: float
    height: float
    duration: float
    motors: bool


_LINE: TypeAdapter[_Sample | _Touch] = TypeAdapter(_Sample | _Touch)


def read_truth(path: Path) -> TrueFlight | None:
    """Return the truth of a flight; None without a file or without a sample in it.

    What is no line of such a file is left out: the last one may be cut off, by a process that was
    killed.
    """
    try:
        lines = path.read_bytes().splitlines()
    except OSError:
        return None
    values = [value for line in lines if (value := _parsed(line)) is not None]
    samples = [value for value in values if isinstance(value, _Sample)]
    if not samples:
        return None
    contacts = {
        (value.began, value.kind, value.contact): _contact(value)
        for value in values
        if isinstance(value, _Touch)
    }
    return TrueFlight(
        _column([sample.at for sample in samples]),
        _column([sample.position for sample in samples]),
        np.array([sample.airborne for sample in samples], dtype=np.bool_),
        _column([sample.solid for sample in samples]),
        _column([sample.person for sample in samples]),
        tuple(contacts.values()),
    )


def judged_outcome(
    outcome: str, contacts: Iterable[ContactRecord], landed_error: float | None = None
) -> str:
    """Return an outcome as the truth has it.

    Args:
        outcome: as the pilot's steps have it.
        contacts: what the drone touched; with motors at rest it does not count.
        landed_error: true distance from the pad at the end [m]; None where it is not known.
    """
    if outcome == COMPLETED and landed_error is not None and landed_error > HOME_RADIUS:
        outcome = f"landed {landed_error:.1f} m from the pad in truth"
    touched = [contact for contact in contacts if contact.motors_turned]
    if not touched or _WITH_CONTACT in outcome:
        return outcome
    names = dict.fromkeys(contact.name for contact in touched)
    fastest = max(contact.speed for contact in touched)
    words = f"{_WITH_CONTACT}{', '.join(names)} (at up to {fastest:.2f} m/s)"
    return f"{outcome} {words}" if outcome == COMPLETED else f"{outcome}; {words}"


def _parsed(line: bytes) -> _Sample | _Touch | None:
    try:
        return _LINE.validate_json(line)
    except ValidationError:
        return None


def _column(values: Sequence[float | Vec3 | None]) -> FloatArray:
    return np.array(values, dtype=np.float64)


def _contact(value: _Touch) -> ContactRecord:
    return ContactRecord(
        at_s=value.at,
        kind=value.kind,
        name=value.contact,
        speed=value.speed,
        height=value.height,
        duration_s=value.duration,
        motors_turned=value.motors,
    )
