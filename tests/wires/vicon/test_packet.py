"""The Vicon DataStream codec: what goes in comes out, and nothing but WireError is ever raised."""

from __future__ import annotations

import struct
from contextlib import suppress
from math import cos, pi, sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.geometry import Quaternion, normalized, rotate
from housefly.wires.vicon import (
    MAX_PACKET,
    VICON_HEADER_SIZE,
    ApplicationInfo,
    FrameContents,
    FrameInfo,
    GlobalSegments,
    LatencyInfo,
    ObjectEnums,
    RequestFrame,
    RequestNextFrame,
    Segment,
    SegmentPose,
    StreamInfo,
    SubjectInfo,
    ViconObject,
    ViconPing,
    decode_packet,
    encode_packet,
    matrix_from_quaternion,
    packet_length,
    quaternion_from_matrix,
)

u32 = st.integers(0, 2**32 - 1)
real = st.floats(allow_nan=False)
name = st.text(max_size=60).filter(
    lambda text: text.encode("utf-8", "replace").decode("utf-8") == text
)
kinds = st.frozensets(u32, max_size=8)
pose = st.builds(SegmentPose, u32, st.tuples(*[real] * 3), st.tuples(*[real] * 9))
item = st.one_of(
    st.builds(ObjectEnums, kinds),
    st.builds(RequestFrame, st.booleans()),
    st.builds(RequestNextFrame, u32),
    st.builds(ViconPing, st.integers(0, 2**64 - 1)),
    st.builds(FrameContents, st.lists(st.tuples(u32, u32), max_size=5).map(tuple), kinds),
    st.builds(StreamInfo, st.integers(-(2**63), 2**63 - 1)),
    st.builds(ApplicationInfo, st.booleans()),
    st.builds(
        SubjectInfo, u32, name, st.lists(st.builds(Segment, u32, name, u32), max_size=4).map(tuple)
    ),
    st.builds(FrameInfo, u32),
    st.builds(LatencyInfo, st.lists(st.tuples(name, real), max_size=4).map(tuple)),
    st.builds(GlobalSegments, u32, st.lists(pose, max_size=4).map(tuple)),
)
quaternion = (
    st.tuples(*[st.floats(-1, 1)] * 4)
    .filter(lambda q: sum(v * v for v in q) > 1e-3)
    .map(normalized)
)


def body_of(packet: bytes) -> bytes:
    assert packet_length(packet[:VICON_HEADER_SIZE]) == len(packet) - VICON_HEADER_SIZE
    return packet[VICON_HEADER_SIZE:]


@given(st.lists(item, max_size=6))
def test_what_is_encoded_is_decoded(items: list[ViconObject]) -> None:
    assert list(decode_packet(body_of(encode_packet(items)))) == items


@given(st.binary(max_size=300))
def test_any_bytes_are_a_packet_or_a_wire_error(body: bytes) -> None:
    with suppress(WireError):
        decode_packet(body)


@given(st.lists(item, min_size=1, max_size=4), st.data())
def test_a_damaged_packet_is_a_packet_or_a_wire_error(
    items: list[ViconObject], data: st.DataObject
) -> None:
    body = bytearray(body_of(encode_packet(items)))
    for _ in range(data.draw(st.integers(1, 5))):
        body[data.draw(st.integers(0, len(body) - 1))] = data.draw(st.integers(0, 255))
    with suppress(WireError):
        decode_packet(bytes(body[: data.draw(st.integers(0, len(body)))]))


@given(item)
def test_a_known_block_cut_short_is_a_wire_error(whole: ViconObject) -> None:
    unread = 8 if isinstance(whole, SubjectInfo) else 0
    block = body_of(encode_packet([whole]))[8 : -unread - 1]
    with pytest.raises(WireError):
        decode_packet(struct.pack("<II", whole.KIND, len(block)) + block)


def test_unknown_blocks_and_appended_fields_are_skipped() -> None:
    unknown = struct.pack("<II", 14, 5) + b"camera"[:5]
    longer = struct.pack("<IIII", FrameInfo.KIND, 8, 7, 99)
    assert decode_packet(unknown + longer + unknown) == (FrameInfo(7),)


def test_a_huge_list_is_refused_before_memory_is_asked_for() -> None:
    claim = struct.pack("<III", 2**32 - 1, 0, 0)
    with pytest.raises(WireError, match="does not fit"):
        decode_packet(struct.pack("<II", ObjectEnums.KIND, len(claim)) + claim)


def test_a_block_longer_than_its_packet_is_refused() -> None:
    with pytest.raises(WireError, match="block of 100 bytes"):
        decode_packet(struct.pack("<II", FrameInfo.KIND, 100) + b"1234")


def test_a_flood_of_empty_blocks_is_refused() -> None:
    with pytest.raises(WireError, match="blocks"):
        decode_packet(struct.pack("<II", 999, 0) * 5000)


@pytest.mark.parametrize(
    ("header", "reason"),
    [
        (struct.pack("<II", 0x1A2B0001, MAX_PACKET + 1), "limit"),
        (b"GET / HT", "not a Vicon DataStream packet"),
        (b"abc", "8 bytes"),
    ],
)
def test_a_bad_packet_header_is_refused(header: bytes, reason: str) -> None:
    with pytest.raises(WireError, match=reason):
        packet_length(header)


def test_values_that_do_not_fit_are_refused() -> None:
    with pytest.raises(WireError):
        encode_packet([FrameInfo(-1)])
    with pytest.raises(WireError):
        encode_packet([SubjectInfo(1, "x" * 300, ())])


@given(quaternion)
def test_a_rotation_survives_its_matrix(q: Quaternion) -> None:
    back = quaternion_from_matrix(matrix_from_quaternion(q))
    assert back[0] >= 0
    assert abs(sum(a * b for a, b in zip(q, back, strict=True))) == pytest.approx(1.0, abs=1e-9)


@given(quaternion)
def test_the_rows_of_the_matrix_turn_body_vectors_into_the_world(q: Quaternion) -> None:
    m = matrix_from_quaternion(q)
    assert (m[0], m[3], m[6]) == pytest.approx(rotate(q, (1.0, 0.0, 0.0)))


@pytest.mark.parametrize(
    "matrix",
    [
        (0.0,) * 9,
        (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0),
        (1.1, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
        (cos(pi / 3), -sin(pi / 3), 0.0, sin(pi / 3), cos(pi / 3), 0.0, 0.0, float("nan"), 1.0),
        (float("inf"),) * 9,
    ],
)
def test_a_matrix_that_is_no_rotation_is_refused(matrix: tuple[float, ...]) -> None:
    with pytest.raises(WireError, match="not a rotation"):
        quaternion_from_matrix(matrix)  # type: ignore[arg-type]
