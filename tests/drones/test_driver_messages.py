"""What pilot and driver tell each other, and what anybody else might."""

from __future__ import annotations

import contextlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.capabilities import (
    Capabilities,
    OnboardCamera,
    OwnManoeuvre,
    OwnMeasurement,
    SetpointForm,
    Silence,
    SilenceAnswer,
)
from housefly.drones.driver_messages import (
    DriverMessage,
    DriverStatus,
    LightOrder,
    MessageReader,
    PoseNews,
    TimedCommand,
    encode_driver_message,
)
from housefly.errors import WireError
from housefly.messages import (
    Action,
    Command,
    DroneFault,
    DroneStatus,
    KnownMotion,
    Pose,
    PositionSetpoint,
    Setpoint,
    Sighting,
    Telemetry,
    VelocitySetpoint,
    VideoFrame,
)
from housefly.messages.steering import commanded
from housefly.messages.words import Words, literal

numbers = st.floats(allow_nan=False)
vectors = st.tuples(numbers, numbers, numbers)
problems = st.text(max_size=30).map(literal) | st.builds(
    lambda name: Words("not connected to {name} yet", name=name), st.text(max_size=30)
)
words = st.lists(problems, max_size=3).map(tuple)
motions = st.builds(KnownMotion, numbers, numbers, numbers, numbers, st.booleans()) | st.builds(
    KnownMotion, theta=numbers, phi=numbers, hovers=st.booleans()
)
setpoints = st.one_of(
    st.builds(form, numbers, numbers, numbers, numbers)
    for form in (Setpoint, VelocitySetpoint, PositionSetpoint)
)
commands = st.builds(
    TimedCommand,
    st.builds(commanded, st.sampled_from(Action), setpoints),
    st.floats(allow_nan=False, allow_infinity=False),
    st.none() | motions,
)
reports = st.builds(
    Telemetry,
    received_at=numbers,
    status=st.sampled_from(DroneStatus),
    battery=numbers,
    phi=numbers,
    theta=numbers,
    psi=numbers,
    height=numbers,
    velocity=vectors,
    faults=st.lists(st.sampled_from(DroneFault)).map(tuple),
    acceleration=st.none() | vectors,
    configured=st.booleans(),
    hears_us=st.booleans(),
    notes=words,
)
cameras = st.builds(
    OnboardCamera,
    field_of_view=st.floats(0.1, 3.1),
    field_of_view_up=st.floats(0.1, 3.1),
    width=st.integers(16, 8192),
    height=st.integers(16, 8192),
    ahead=st.floats(-1.0, 1.0),
)
forms = st.lists(st.sampled_from(SetpointForm), min_size=1).map(tuple)
to_places = {SetpointForm.POSITION, SetpointForm.TRAJECTORY}
rates = st.floats(0.1, 1000.0)
told_places = st.tuples(forms, rates) | st.tuples(
    forms.filter(lambda some: to_places.isdisjoint(some)), st.none()
)
abilities = told_places.flatmap(
    lambda told: st.builds(
        Capabilities,
        setpoints=st.just(told[0]),
        external_pose_rate=st.just(told[1]),
        manoeuvres=st.frozensets(st.sampled_from(OwnManoeuvre)),
        measures=st.frozensets(st.sampled_from(OwnMeasurement)),
        arms=st.booleans(),
        light=st.booleans(),
        camera=st.none() | cameras,
        silence=st.builds(
            Silence, after=st.floats(0.0, 60.0), answer=st.sampled_from(SilenceAnswer)
        ),
    )
)
states = st.builds(
    DriverStatus,
    st.booleans(),
    st.booleans(),
    numbers,
    problems,
    st.none() | abilities,
)
lights = st.builds(LightOrder, st.booleans())
finite = st.floats(allow_nan=False, allow_infinity=False)
poses = st.builds(Pose, st.tuples(finite, finite, finite), st.tuples(*[finite] * 4))
seen = st.builds(PoseNews, st.builds(Sighting, st.text(max_size=20), poses, finite, finite))
pictures = st.builds(
    VideoFrame,
    data=st.binary(max_size=500),
    keyframe=st.booleans(),
    width=st.integers(0, 65535),
    height=st.integers(0, 65535),
    sequence=st.integers(0, 2**32 - 1),
    received_at=numbers,
    drone_time=numbers,
)


@given(
    st.lists(st.one_of(commands, reports, states, pictures, lights, seen), min_size=1, max_size=5),
    st.lists(st.integers(1, 60), min_size=1, max_size=40),
)
def test_messages_arrive_as_they_were_however_the_stream_is_cut(
    messages: list[DriverMessage], cuts: list[int]
) -> None:
    stream = b"".join(map(encode_driver_message, messages))
    reader, arrived = MessageReader(), []
    for cut in cuts:
        arrived += reader.feed(stream[:cut])
        stream = stream[cut:]
    assert [*arrived, *reader.feed(stream)] == messages


@given(st.lists(st.binary(max_size=60), max_size=8))
def test_no_bytes_make_the_reader_raise_anything_else(parts: list[bytes]) -> None:
    reader = MessageReader()
    try:
        for part in parts:
            assert reader.feed(part) == []
    except WireError:
        pass


@given(st.integers(0, 5), st.binary(max_size=120))
def test_no_body_makes_the_reader_raise_anything_else(kind: int, body: bytes) -> None:
    data = b"HFd1" + bytes([kind]) + len(body).to_bytes(4, "little") + body
    with contextlib.suppress(WireError):
        MessageReader().feed(data)


@pytest.mark.parametrize(
    "header",
    [
        b"GET / HTTP/1.1\r\n",
        b"HFd1\x09\x00\x00\x00\x00",
        b"HFd1\x00\xff\xff\xff\xff",
    ],
)
def test_another_language_or_a_body_without_end_is_refused_at_its_header(header: bytes) -> None:
    with pytest.raises(WireError):
        MessageReader().feed(header)


def test_a_time_that_is_no_number_is_refused() -> None:
    for time in (float("nan"), float("inf")):
        with pytest.raises(WireError, match="finite"):
            MessageReader().feed(encode_driver_message(TimedCommand(Command(Action.FLY), time)))
