"""Reads a recording, and replays it with a fresh pilot."""

from __future__ import annotations

import json
import os
import struct
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from io import BytesIO
from pathlib import Path
from typing import BinaryIO, Protocol

from mcap.exceptions import EndOfFile, McapError
from mcap.opcode import Opcode
from mcap.records import Channel, McapRecord, Message, Schema
from mcap.stream_reader import StreamReader
from mcap.writer import MCAP0_MAGIC
from rosbags.typesys.store import Typestore
from zstandard import ZstdError

from housefly.bus.codec import check_types, from_cdr
from housefly.bus.interfaces import recorded_store, ros_name, type_store
from housefly.errors import RecordingError, WireError
from housefly.messages import Command, Inputs, OrderSource, Outputs, PilotStep

STEP_CHANNEL = "/housefly/step"
_STEP_TYPE = ros_name("PilotStep")
_RECORD_LIMIT = 64 * 2**20
"""Largest record in a sane recording [bytes]; a damaged length must not exhaust the memory."""
_PIECE = 2**20
_HEAD = struct.Struct("<BQ")
"""Kind and length [bytes] of an MCAP record."""


def read_steps(path: Path) -> Iterator[PilotStep]:
    """Yield the steps of a recording in order; a truncated one ends at its last readable step.

    Args:
        path: ``flight.mcap``, or the folder that holds it.

    Raises:
        RecordingError: the file is absent, is not a recording of Housefly, or is damaged in the
            middle.
    """
    path = path / "flight.mcap" if path.is_dir() else path
    try:
        file = path.open("rb")
    except OSError as error:
        raise RecordingError(f"{path} cannot be read: {error.strerror}") from error
    with file:
        yield from _steps(file, path)


def _steps(file: BinaryIO, path: Path) -> Iterator[PilotStep]:
    schemas: dict[int, Schema] = {}
    step_channel, types, tells_sources = -1, type_store(), True
    for record in _records(file, path):
        if isinstance(record, Schema):
            schemas[record.id] = record
        elif isinstance(record, Channel) and record.topic == STEP_CHANNEL:
            types = _types_of(schemas.get(record.schema_id), path)
            tells_sources = "source" in dict(types.fielddefs[ros_name("Order")][1])
            step_channel = record.id
        elif isinstance(record, Message) and record.channel_id == step_channel:
            try:
                step = from_cdr(PilotStep, record.data, types)
            except WireError as error:
                raise RecordingError(f"{path} is damaged: {error}") from error
            yield step if tells_sources else _with_sources(step)


def _records(file: BinaryIO, path: Path) -> Iterator[McapRecord]:
    """Yield the records of an MCAP file; ends quietly after the last complete one."""
    if file.read(len(MCAP0_MAGIC)) != MCAP0_MAGIC:
        raise RecordingError(f"{path} is not a recording")
    while len(head := file.read(_HEAD.size)) == _HEAD.size:
        opcode, length = _HEAD.unpack(head)
        if length > _RECORD_LIMIT:
            raise RecordingError(f"{path} is damaged: a record of {length} bytes")
        body = file.read(length)
        if len(body) < length or opcode == Opcode.FOOTER:
            return
        try:
            yield from StreamReader(
                BytesIO(head + body), skip_magic=True, validate_crcs=True
            ).records
        except EndOfFile:
            # The end of this one record, which is whole.
            continue
        except (
            McapError,
            ZstdError,
            struct.error,
            ValueError,
            OverflowError,
            MemoryError,
        ) as error:
            if _is_torn_end(file):
                return
            raise RecordingError(f"{path} is damaged: {error}") from error


def _is_torn_end(file: BinaryIO) -> bool:
    """Return whether nothing follows a record that cannot be read, or what a power cut leaves.

    Some file systems know how long a file is before they have what is in it: that reads as zeros.
    """
    return not any(piece.strip(b"\0") for piece in iter(lambda: file.read(_PIECE), b""))


def _with_sources(step: PilotStep) -> PilotStep:
    """Return a step of an older version, whose tasks showed only in the names of their senders."""
    given = step.inputs.orders
    orders = tuple(
        replace(order, source=OrderSource.TASK) if order.sender.startswith("task ") else order
        for order in given
    )
    return step if orders == given else replace(step, inputs=replace(step.inputs, orders=orders))


def _types_of(schema: Schema | None, path: Path) -> Typestore:
    """Return the types of the recorded steps: ours, or older ones that lack newer fields."""
    try:
        if schema is None or schema.name != _STEP_TYPE:
            raise WireError("no steps")
        types = recorded_store(_STEP_TYPE, schema.data.decode(errors="replace"))
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
