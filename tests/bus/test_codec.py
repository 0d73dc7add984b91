"""Messages to bytes and back."""

from __future__ import annotations

import contextlib
import math
import types
import typing
from dataclasses import fields, is_dataclass, replace
from enum import Enum, StrEnum
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mcap_ros2._dynamic import generate_dynamic

from housefly import messages
from housefly.bus.codec import from_cdr, to_cdr
from housefly.bus.interfaces import definition, recorded_store, ros_name, type_store
from housefly.bus.topics import ROOM_TOPICS, DroneTopics
from housefly.errors import WireError
from housefly.messages import (
    Action,
    Command,
    DroneFault,
    Estimate,
    Event,
    EventCode,
    Fact,
    Inputs,
    LinkStatus,
    Order,
    OrderKind,
    Outputs,
    Path,
    PilotStep,
    Pose,
    Setpoint,
    Severity,
    Sighting,
    Telemetry,
    VideoFrame,
)
from housefly.messages.words import Words, figure, flat, literal

NUMBERS = st.integers(-99, 99).map(figure)
PLAIN: dict[Any, st.SearchStrategy[Any]] = {
    float: st.floats(allow_nan=False),
    int: st.integers(-(2**31), 2**31 - 1),
    bool: st.booleans(),
    str: st.text(st.characters(exclude_categories=["Cs"]), max_size=20),
    bytes: st.binary(max_size=50),
    type(None): st.none(),
}
PLAIN[Words] = st.one_of(
    PLAIN[str].map(literal),
    st.builds(lambda who, d: Words("{who} is {d} m away", who=who, d=d), PLAIN[str], NUMBERS),
)


def values_of(hint: Any) -> st.SearchStrategy[Any]:
    """Return a strategy for every valid value of an annotation, dataclasses field by field."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if hint == Fact:
        return st.one_of([values_of(choice) for choice in (*typing.get_args(hint), Words)])
    if hint in PLAIN:
        return PLAIN[hint]
    if origin in (typing.Union, types.UnionType):
        return st.one_of([values_of(choice) for choice in arguments])
    if origin is tuple and arguments[-1] is Ellipsis:
        return st.lists(values_of(arguments[0]), max_size=3).map(tuple)
    if origin is tuple:
        return st.tuples(*[values_of(part) for part in arguments])
    if issubclass(hint, Enum):
        return st.sampled_from(hint)
    assert is_dataclass(hint)
    hints = typing.get_type_hints(hint)
    return st.builds(hint, **{field.name: values_of(hints[field.name]) for field in fields(hint)})


MESSAGES = [topic.type for topic in (*ROOM_TOPICS, *DroneTopics().all)]
EXAMPLE = PilotStep(
    7,
    2.0,
    Inputs(
        (Sighting("ardrone", Pose((1.0, 2.0, 3.0)), 1.98, 1.99),),
        Telemetry(1.9, messages.DroneStatus.FLYING, 0.5),
    ),
    Outputs(
        Command(Action.FLY, Setpoint(0.1, -0.2, 0.3, 0.4)),
        Estimate(2.0, (1.0, 2.0, 3.0), (0.1, 0.2, 0.3), 0.5, 0.02, 0.01),
        path=Path(((0.0, 1.0), (2.0, 3.0), (4.0, 5.0)), 8.0, 0.4),
        goal_name="entrance",
    ),
)


@pytest.mark.parametrize("kind", MESSAGES, ids=lambda kind: kind.__name__)
def test_every_valid_message_comes_back_bit_for_bit(kind: type[Any]) -> None:
    @settings(max_examples=100, deadline=None)
    @given(values_of(kind))
    def check(message: Any) -> None:
        decoded = from_cdr(kind, to_cdr(message))
        assert decoded == message
        assert repr(decoded) == repr(message), (
            "equal values may differ in the sign of zero or in type"
        )

    check()


@pytest.mark.parametrize("kind", MESSAGES, ids=lambda kind: kind.__name__)
def test_another_writer_writes_the_same_bytes_and_its_other_byte_order_is_read(
    kind: type[Any],
) -> None:
    store, name = type_store(), ros_name(kind.__name__)

    @settings(max_examples=50, deadline=None)
    @given(values_of(kind))
    def check(message: Any) -> None:
        ours = to_cdr(message)
        theirs = store.deserialize_cdr(ours, name)
        assert bytes(store.serialize_cdr(theirs, name)) == ours
        other_order = bytes(store.serialize_cdr(theirs, name, little_endian=False))
        assert repr(from_cdr(kind, other_order)) == repr(message)

    check()


def test_not_a_number_survives() -> None:
    decoded = from_cdr(LinkStatus, to_cdr(LinkStatus(at=math.nan)))
    assert math.isnan(decoded.at)


@pytest.mark.parametrize("kind", MESSAGES, ids=lambda kind: kind.__name__)
def test_garbage_is_a_wire_error_and_nothing_else(kind: type[Any]) -> None:
    @settings(max_examples=200, deadline=None)
    @given(
        st.one_of(
            st.binary(max_size=300),
            st.binary(max_size=300).map(lambda tail: b"\x00\x01\x00\x00" + tail),
        )
    )
    def check(data: bytes) -> None:
        with contextlib.suppress(WireError):
            from_cdr(kind, data)

    check()


@settings(max_examples=300, deadline=None)
@given(st.data())
def test_damaged_steps_are_a_wire_error_or_another_step(data: st.DataObject) -> None:
    whole = bytearray(to_cdr(EXAMPLE))
    for _ in range(data.draw(st.integers(1, 4))):
        whole[data.draw(st.integers(0, len(whole) - 1))] = data.draw(st.integers(0, 255))
    cut = data.draw(st.integers(0, len(whole)))
    for damaged in (bytes(whole), bytes(whole[:cut])):
        with contextlib.suppress(WireError):
            assert isinstance(from_cdr(PilotStep, damaged), PilotStep)


def test_a_number_that_no_enum_member_has_is_refused() -> None:
    good = to_cdr(Order(OrderKind.STOP))
    assert good[4] == list(OrderKind).index(OrderKind.STOP)
    with pytest.raises(WireError, match="not a Order"):
        from_cdr(Order, good[:4] + b"\xff" + good[5:])


def test_two_values_where_one_is_allowed_are_refused() -> None:
    store = type_store()
    point = store.types["housefly_msgs/msg/Point2"](x=1.0, y=2.0)
    wire = store.types["housefly_msgs/msg/Order"](
        kind=3,
        place="",
        goal=[point, point],
        look_at=[],
        look_s=5.0,
        issued_at=0.0,
        sender="",
        velocity=[],
        id="",
        source=0,
    )
    with pytest.raises(WireError, match="at most one"):
        from_cdr(Order, bytes(store.serialize_cdr(wire, "housefly_msgs/msg/Order")))


@pytest.mark.parametrize(
    "message",
    [
        Order(OrderKind.GO, place="\ud800"),
        replace(EXAMPLE, sequence=2**70),
        VideoFrame(b"", True, "wide", 1, 1, 0.0),  # type: ignore[arg-type]
    ],
)
def test_a_value_that_does_not_fit_its_field_is_refused(message: object) -> None:
    with pytest.raises(WireError, match="cannot be encoded"):
        to_cdr(message)


def is_numbered(hint: object) -> bool:
    """Return whether a hint is an enum that goes over the wire by number, not by its text."""
    return isinstance(hint, type) and issubclass(hint, Enum) and not issubclass(hint, StrEnum)


def test_the_texts_name_every_field_and_every_enum_member_in_order() -> None:
    seen = 0
    for name in dir(messages):
        kind = getattr(messages, name)
        if ros_name(name) not in type_store().fielddefs or not is_dataclass(kind):
            continue
        constants, wire_fields = type_store().fielddefs[ros_name(name)]
        assert [field for field, _ in wire_fields] == [field.name for field in fields(kind)]
        hints = typing.get_type_hints(kind)
        told = [
            (field.name, next(iter(typing.get_args(hints[field.name])), hints[field.name]))
            for field in fields(kind)
        ]
        enums = [(field, enum) for field, enum in told if is_numbered(enum)]
        expected = [f"{field.upper()}_{member.name}" for field, enum in enums for member in enum]
        assert [constant for constant, _, _ in constants] == expected
        seen += 1
    assert seen == 26


def test_an_independent_reader_understands_a_step() -> None:
    readers = generate_dynamic(ros_name("PilotStep"), definition(ros_name("PilotStep")))
    step = readers[ros_name("PilotStep")](to_cdr(EXAMPLE))
    assert step.sequence == 7
    assert step.outputs.command.setpoint.phi == -0.2
    assert list(step.outputs.path[0].waypoints) == [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]
    assert step.outputs.goal_name == "entrance"
    assert step.inputs.sightings[0].pose.orientation.w == 1.0


@settings(max_examples=50, deadline=None)
@given(values_of(PilotStep))
def test_an_independent_reader_finds_the_same_end_of_every_step(step: PilotStep) -> None:
    readers = generate_dynamic(ros_name("PilotStep"), definition(ros_name("PilotStep")))
    read = readers[ros_name("PilotStep")](to_cdr(step))
    assert list(read.outputs.reason.parts) == flat(step.outputs.reason)
    assert [list(event.text.parts) for event in read.outputs.events] == [
        flat(event.text) for event in step.outputs.events
    ]


def test_the_code_of_another_version_is_another_one() -> None:
    event = Event(1.0, Severity.INFO, EventCode.GOING_ON, literal("the way is free"))
    data = to_cdr(event).replace(b"going_on", b"going_up")
    assert from_cdr(Event, data) == replace(event, code=EventCode.OTHER)


def test_faults_that_an_older_version_recorded_in_words_are_read_as_what_they_are() -> None:
    name = ros_name("Telemetry")
    older = recorded_store(name, definition(name).replace("uint8[] faults", "string[] faults"))
    velocity = older.types["geometry_msgs/msg/Vector3"](1.0, 2.0, 3.0)
    numbers, words = [0.0, 3, 0.9, 0.1, 0.2, 0.3, 1.0], ["battery low", "too much wind"]
    told = older.types[name](*numbers, velocity, words, [], True, [], np.array([]), True)
    read = from_cdr(Telemetry, bytes(older.serialize_cdr(told, name)), older)
    assert read.faults == (DroneFault.BATTERY_LOW, DroneFault.WIND)
