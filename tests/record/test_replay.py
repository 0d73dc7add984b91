"""A recording read back, whole, cut short, or damaged."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from mcap.writer import MCAP0_MAGIC, Writer
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from housefly.bus.codec import to_cdr
from housefly.bus.interfaces import definition, type_store
from housefly.errors import RecordingError
from housefly.messages import (
    Command,
    Inputs,
    Order,
    OrderKind,
    OrderSource,
    Outputs,
    PilotStep,
    Setpoint,
)
from housefly.record.mcap_log import McapLog
from housefly.record.replay import STEP_CHANNEL, read_steps, verify


def write(path: Path, steps: tuple[PilotStep, ...]) -> Path:
    log = McapLog(path, {})
    for step in steps:
        log.add_own(STEP_CHANNEL, step.now, step)
    log.close()
    return path


@pytest.fixture
def recording(tmp_path: Path, flight: tuple[PilotStep, ...]) -> Path:
    return write(tmp_path / "flight.mcap", flight)


class Parrot:
    """Decides what was recorded, except where it is told to differ."""

    def __init__(self, steps: tuple[PilotStep, ...], differ_at: int | None = None) -> None:
        self._steps = iter(steps)
        self._differ_at = differ_at

    def step(self, now: float, inputs: Inputs) -> Outputs:
        step = next(self._steps)
        assert (now, inputs) == (step.now, step.inputs)
        if step.sequence != self._differ_at:
            return step.outputs
        setpoint = step.outputs.command.setpoint
        nearly = Setpoint(setpoint.theta, setpoint.phi, -setpoint.vz, setpoint.yaw_rate)
        return replace(step.outputs, command=Command(step.outputs.command.action, nearly))


def test_a_recording_gives_back_every_step_bit_for_bit(
    recording: Path, flight: tuple[PilotStep, ...]
) -> None:
    assert repr(tuple(read_steps(recording))) == repr(flight)


def test_the_folder_of_a_flight_stands_for_its_recording(
    recording: Path, flight: tuple[PilotStep, ...]
) -> None:
    assert len(list(read_steps(recording.parent))) == len(flight)


@settings(
    max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(share=st.floats(0.0, 1.0), zeros=st.integers(0, 100_000))
def test_a_recording_that_ends_in_zeros_after_a_power_cut_gives_what_is_readable(
    recording: Path, flight: tuple[PilotStep, ...], share: float, zeros: int
) -> None:
    whole = recording.read_bytes()
    cut = recording.with_name("cut.mcap")
    cut.write_bytes(whole[: max(9, int(share * len(whole)))] + bytes(zeros))
    readable = tuple(read_steps(cut))
    assert readable == flight[: len(readable)]
    assert len(readable) >= (share - 0.2) * len(flight)


@settings(
    max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(share=st.floats(0.0, 1.0))
def test_a_recording_that_was_cut_short_gives_what_is_readable(
    recording: Path, flight: tuple[PilotStep, ...], share: float
) -> None:
    whole = recording.read_bytes()
    cut = recording.with_name("cut.mcap")
    cut.write_bytes(whole[: max(9, int(share * len(whole)))])
    readable = tuple(read_steps(cut))
    assert readable == flight[: len(readable)]
    assert len(readable) >= (share - 0.2) * len(flight)


@settings(
    max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(data=st.data())
def test_a_damaged_recording_is_a_recording_error_and_nothing_else(
    recording: Path, flight: tuple[PilotStep, ...], data: st.DataObject
) -> None:
    damaged = bytearray(recording.read_bytes())
    for _ in range(data.draw(st.integers(1, 5))):
        damaged[data.draw(st.integers(0, len(damaged) - 1))] = data.draw(st.integers(0, 255))
    bad = recording.with_name("bad.mcap")
    bad.write_bytes(damaged)
    try:
        for step in read_steps(bad):
            assert step == flight[step.sequence], "what is read is what was recorded"
    except RecordingError as error:
        assert "bad.mcap" in str(error)


@pytest.mark.parametrize("content", [b"", b"not a recording at all", bytes(1000)])
def test_a_file_that_is_no_recording_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "flight.mcap").write_bytes(content)
    with pytest.raises(RecordingError, match="not a recording"):
        list(read_steps(tmp_path))


def test_a_missing_file_is_refused_by_name(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match=r"absent\.mcap cannot be read"):
        list(read_steps(tmp_path / "absent.mcap"))


def test_a_recording_with_other_definitions_is_refused(tmp_path: Path) -> None:
    with (tmp_path / "flight.mcap").open("wb") as file:
        writer = Writer(file)
        writer.start(profile="ros2")
        schema = writer.register_schema(
            "housefly_msgs/msg/PilotStep", "ros2msg", b"int64 sequence\n"
        )
        writer.add_message(
            writer.register_channel(STEP_CHANNEL, "cdr", schema), 0, b"\x00\x01\x00\x00", 0
        )
        writer.finish()
    with pytest.raises(RecordingError, match="other message definitions"):
        list(read_steps(tmp_path))


def write_older(folder: Path, step: PilotStep, lacking: str) -> None:
    """Write a recording of one step by a version that had not this line of the definitions yet."""
    kind = "housefly_msgs/msg/PilotStep"
    schema = definition(kind).replace(lacking, "")
    older = get_typestore(Stores.EMPTY)
    older.register(get_types_from_msg(schema, kind))
    report = type_store().deserialize_cdr(to_cdr(step), kind)
    with (folder / "flight.mcap").open("wb") as file:
        writer = Writer(file)
        writer.start(profile="ros2")
        number = writer.register_schema(kind, "ros2msg", schema.encode())
        channel = writer.register_channel(STEP_CHANNEL, "cdr", number)
        writer.add_message(channel, 0, bytes(older.serialize_cdr(report, kind)), 0)
        writer.finish()


def test_a_recording_whose_reports_lack_a_newer_field_is_read_with_its_default(
    recording: Path, flight: tuple[PilotStep, ...], tmp_path: Path
) -> None:
    step = next(step for step in flight if step.inputs.telemetry)
    write_older(tmp_path, step, "float64[<=1] drone_time\n")
    (found,) = read_steps(tmp_path)
    assert found.inputs.telemetry is not None and found.inputs.telemetry.drone_time is None
    assert found.outputs == step.outputs


def test_an_older_recording_knows_a_tasks_orders_by_the_name_of_their_sender(
    recording: Path, flight: tuple[PilotStep, ...], tmp_path: Path
) -> None:
    orders = (Order(OrderKind.HOME, sender="task 1: look"), Order(OrderKind.LAND, sender="kim"))
    step = replace(flight[0], inputs=replace(flight[0].inputs, orders=orders))
    write_older(tmp_path, step, "uint8 source\n")
    (found,) = read_steps(tmp_path)
    assert [one.source for one in found.inputs.orders] == [OrderSource.TASK, OrderSource.PERSON]


def test_a_pilot_that_decides_the_same_is_verified(
    recording: Path, flight: tuple[PilotStep, ...]
) -> None:
    verdict = verify(recording, lambda: Parrot(flight))
    assert (verdict.steps, verdict.missing, verdict.difference) == (len(flight), 0, None)


def test_even_the_sign_of_a_zero_counts_as_another_command(
    recording: Path, flight: tuple[PilotStep, ...]
) -> None:
    verdict = verify(recording, lambda: Parrot(flight, differ_at=400))
    assert verdict.steps == 400
    assert verdict.difference is not None
    assert verdict.difference.step.sequence == 400
    assert "step 400" in str(verdict.difference)


def test_missing_steps_are_counted(tmp_path: Path, flight: tuple[PilotStep, ...]) -> None:
    with_gap = flight[:10] + flight[15:20]
    verdict = verify(write(tmp_path / "flight.mcap", with_gap), lambda: Parrot(with_gap))
    assert (verdict.steps, verdict.missing) == (15, 5)


def test_steps_before_a_recording_began_are_missing(
    tmp_path: Path, flight: tuple[PilotStep, ...]
) -> None:
    late = flight[7:20]
    verdict = verify(write(tmp_path / "flight.mcap", late), lambda: Parrot(late))
    assert (verdict.steps, verdict.missing) == (13, 7)


def test_of_a_recording_that_was_cut_it_is_known_how_much_is_there(
    recording: Path, flight: tuple[PilotStep, ...], tmp_path: Path
) -> None:
    whole = verify(recording, lambda: Parrot(flight))
    assert (whole.is_whole, whole.recorded, whole.share) == (True, None, None)
    cut = tmp_path / "flight.mcap"
    cut.write_bytes(recording.read_bytes()[: recording.stat().st_size // 3])
    (tmp_path / "summary.json").write_text(json.dumps({"steps": len(flight)}))
    verdict = verify(tmp_path, lambda: Parrot(flight))
    assert 0 < verdict.steps < len(flight) and verdict.difference is None
    assert (verdict.is_whole, verdict.recorded) == (False, len(flight))
    assert verdict.share == verdict.steps / len(flight)


@pytest.mark.parametrize("content", [MCAP0_MAGIC, None])
def test_a_recording_without_a_step_is_not_the_same_bit_for_bit(
    tmp_path: Path, content: bytes | None
) -> None:
    path = tmp_path / "flight.mcap"
    if content is None:
        write(path, ())
    else:
        path.write_bytes(content)
    with pytest.raises(RecordingError, match="no step of a flight"):
        verify(path, lambda: Parrot(()))
