"""Room and pilot over their socket: bytes and back."""

from __future__ import annotations

import contextlib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.messages import Pose, Sighting, TrackedFrame
from housefly.tracking.tracking_messages import (
    TrackerStatus,
    TrackingMessage,
    TrackingMessageReader,
    encode_tracking_message,
)

numbers = st.floats(-1e6, 1e6)
poses = st.builds(Pose, st.tuples(numbers, numbers, numbers))
frames = st.builds(
    TrackedFrame,
    st.lists(st.builds(Sighting, st.text(max_size=20), poses, numbers, numbers), max_size=4).map(
        tuple
    ),
)
states = st.builds(TrackerStatus, st.booleans(), st.text(max_size=40))


@given(
    st.lists(st.one_of(frames, states), min_size=1, max_size=5),
    st.lists(st.integers(1, 60), min_size=1, max_size=40),
)
def test_messages_arrive_as_they_were_however_the_stream_is_cut(
    messages: list[TrackingMessage], cuts: list[int]
) -> None:
    stream = b"".join(map(encode_tracking_message, messages))
    reader, arrived = TrackingMessageReader(), []
    for cut in cuts:
        arrived += reader.feed(stream[:cut])
        stream = stream[cut:]
    assert [*arrived, *reader.feed(stream)] == messages


@given(st.integers(0, 2), st.binary(max_size=120))
def test_no_body_makes_the_reader_raise_anything_else(kind: int, body: bytes) -> None:
    data = b"HFt1" + bytes([kind]) + len(body).to_bytes(4, "little") + body
    with contextlib.suppress(WireError):
        TrackingMessageReader().feed(data)


@pytest.mark.parametrize("header", [b"HFd1" + bytes(5), b"HFt1\x00\xff\xff\xff\xff"])
def test_another_language_or_a_body_without_end_is_refused_at_its_header(header: bytes) -> None:
    with pytest.raises(WireError):
        TrackingMessageReader().feed(header)
