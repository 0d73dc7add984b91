"""Reads a recording, and replays it with a fresh pilot."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Protocol

from mcap.writer import MCAP0_MAGIC
from rosbags.typesys.store import Typestore

from housefly.bus.codec import check_types, from_cdr
from housefly.bus.interfaces import recorded_store, ros_name, type_store
from housefly.errors import RecordingError, WireError
from housefly.messages import Command, Inputs, OrderSource, Outputs, PilotStep
from housefly.record.mcap_reader import RecordedMessage, flight_file, read_messages

STEP_CHANNEL = "/housefly/step"
_STEP_TYPE = ros_name("PilotStep")


def read_steps(path: Path) -> Iterator[PilotStep]:
    """Yield the steps of a recording in order; a truncated one ends at its last readable step.

    Args:
        path: ``flight.mcap``, or the folder that holds it.

    Raises:
        RecordingError: the file is absent, is not a recording of Housefly, or is damaged in the
            middle.
    """
    for _, step in read_dated_steps(path):
        yield step


def read_dated_steps(path: Path) -> Iterator[tuple[float, PilotStep]]:
    """Yield the steps as ``read_steps``, each with the Unix time of its recording [s]."""
    path = flight_file(path)
    types, schema, tells_sources = type_store(), None, True
    for message in read_messages(path):
        if message.topic != STEP_CHANNEL:
            continue
        if message.schema is not schema:
            types, schema = _types_of(message, path), message.schema
            tells_sources = "source" in dict(types.fielddefs[ros_name("Order")][1])
        try:
            step = from_cdr(PilotStep, message.data, types)
        except WireError as error:
            raise RecordingError(f"{path} is damaged: {error}") from error
        yield message.at, step if tells_sources else _with_sources(step)


def _with_sources(step: PilotStep) -> PilotStep:
    """Return a step of an older version, whose tasks showed only in the names of their senders."""
    given = step.inputs.orders
    orders = tuple(
        replace(order, source=OrderSource.TASK) if order.sender.startswith("task ") else order
        for order in given
    )
    return step if orders == given else replace(step, inputs=replace(step.inputs, orders=orders))


def _types_of(message: RecordedMessage, path: Path) -> Typestore:
    """Return the types of the recorded steps: ours, or older ones that lack newer fields."""
    try:
        if message.type_name != _STEP_TYPE:
            raise WireError("no steps")
        types = recorded_store(_STEP_TYPE, message.schema)
        check_types(PilotStep, types)
    except WireError as error:
        raise RecordingError(
            f"{path} was recorded with other message definitions ({error}); replay it with the"
            " version that recorded it"
        ) from error
    return types


class SteppedPilot(Protocol):
    """The part of the pilot that a replay needs."""

    def step(self, now: float, inputs: Inputs) -> Outputs:
        """Return what the pilot decides."""
        ...


@dataclass(frozen=True, slots=True)
class Difference:
    """The first step at which a fresh pilot decided differently."""

    step: PilotStep
    replayed: Command

    def __str__(self) -> str:
        recorded = self.step.outputs.command
        return (
            f"step {self.step.sequence} at {self.step.now:.3f} s: recorded {recorded}, replayed"
            f" {self.replayed}"
        )


@dataclass(frozen=True, slots=True)
class ReplayResult:
    """How a replay compares with its recording.

    Attributes:
        steps: steps compared.
        missing: steps that the recording lacks, those before its first, too; a pilot that never
            saw them may rightly decide otherwise.
        difference: the first difference, or None when every command is the same bit for bit.
        recorded: steps that the summary beside the recording speaks of; None without one.
        is_whole: whether the recording has its end: a cut copy, a full disk and a power cut leave
            none.
    """

    steps: int
    missing: int
    difference: Difference | None
    recorded: int | None = None
    is_whole: bool = True

    @property
    def share(self) -> float | None:
        """Share of the recorded steps that are there, None where nobody has counted them."""
        return min(1.0, self.steps / self.recorded) if self.recorded else None


def verify(path: Path, pilot_factory: Callable[[], SteppedPilot]) -> ReplayResult:
    """Replay a recording with a fresh pilot and compare each command bit for bit.

    Raises RecordingError like ``read_steps``, and where there is no step at all.
    """
    path = path / "flight.mcap" if path.is_dir() else path
    pilot, recorded, is_whole = pilot_factory(), _steps_in_summary(path), _has_end(path)
    count, missing, last = 0, 0, -1
    for step in read_steps(path):
        missing += max(0, step.sequence - last - 1)
        last = step.sequence
        command = pilot.step(step.now, step.inputs).command
        if repr(command) != repr(step.outputs.command):
            return ReplayResult(count, missing, Difference(step, command), recorded, is_whole)
        count += 1
    if count == 0:
        raise RecordingError(f"{path} holds no step of a flight: there is nothing to compare")
    return ReplayResult(count, missing, None, recorded, is_whole)


def _has_end(path: Path) -> bool:
    """Return whether a recording ends as it does when its writer has closed it."""
    try:
        with path.open("rb") as file:
            file.seek(-len(MCAP0_MAGIC), os.SEEK_END)
            return file.read() == MCAP0_MAGIC
    except OSError:
        return False


def _steps_in_summary(path: Path) -> int | None:
    """Return how many steps the summary beside a recording counts, None without one."""
    try:
        steps = json.loads(path.with_name("summary.json").read_text("utf-8"))["steps"]
    except (OSError, ValueError, TypeError, KeyError):
        return None
    return steps if isinstance(steps, int) and steps > 0 else None
