"""The VRPN codec: round trips in any pieces, and only WireError on garbage."""

from __future__ import annotations

import struct
from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.wires.vrpn import (
    COOKIE_SIZE,
    MAX_MESSAGE,
    SENDER_DESCRIPTION,
    TYPE_DESCRIPTION,
    VRPN_HEADER_SIZE,
    TrackerPose,
    VrpnMessage,
    VrpnNames,
    VrpnStream,
    decode_cookie,
    decode_lob,
    decode_pose,
    description_message,
    encode_cookie,
    encode_lob,
    encode_message,
    encode_pose,
)

i32 = st.integers(-(2**31), 2**31 - 1)
real = st.floats(allow_nan=False)
name = st.text(max_size=30).filter(
    lambda text: "\0" not in text and text.encode("utf-8", "replace").decode("utf-8") == text
)
message = st.builds(
    VrpnMessage,
    i32,
    i32,
    st.integers(0, (2**31 - 1) * 1_000_000 + 999_999),
    st.binary(max_size=100),
)
pose = st.builds(TrackerPose, i32, st.tuples(*[real] * 3), st.tuples(*[real] * 4))


@given(st.lists(message, max_size=6), st.integers(1, 50))
def test_messages_survive_being_cut_into_pieces(messages: list[VrpnMessage], size: int) -> None:
    data = b"".join(encode_message(item, sequence) for sequence, item in enumerate(messages))
    stream = VrpnStream()
    found = [item for at in range(0, len(data), size) for item in stream.feed(data[at : at + size])]
    assert found == messages


@given(message)
def test_every_message_fills_a_multiple_of_eight_bytes(whole: VrpnMessage) -> None:
    assert len(encode_message(whole)) % 8 == 0


@given(pose)
def test_a_pose_survives(whole: TrackerPose) -> None:
    assert decode_pose(encode_pose(whole)) == whole


@given(st.sampled_from([SENDER_DESCRIPTION, TYPE_DESCRIPTION]), st.integers(0, 1999), name)
def test_a_description_names_a_number(kind: int, number: int, text: str) -> None:
    names = VrpnNames()
    assert names.learn(description_message(kind, number, text))
    assert names.sender(VrpnMessage(5, number, 0, b"")) == (
        text if kind == SENDER_DESCRIPTION else ""
    )
    assert names.kind(VrpnMessage(number, 5, 0, b"")) == (text if kind == TYPE_DESCRIPTION else "")


@given(st.lists(st.binary(max_size=200), max_size=5))
def test_any_bytes_are_messages_or_a_wire_error(pieces: list[bytes]) -> None:
    stream, names = VrpnStream(), VrpnNames()
    with suppress(WireError):
        for piece in pieces:
            for item in stream.feed(piece):
                names.learn(item)
                decode_pose(item.body)


@given(i32, st.binary(max_size=120))
def test_any_body_is_a_description_a_pose_or_a_wire_error(number: int, body: bytes) -> None:
    with suppress(WireError):
        VrpnNames().learn(VrpnMessage(SENDER_DESCRIPTION, number, 0, body))
    with suppress(WireError):
        decode_pose(body)


@given(st.binary(max_size=300))
def test_any_datagram_is_a_callback_or_a_wire_error(datagram: bytes) -> None:
    with suppress(WireError):
        host, port = decode_lob(datagram)
        assert decode_lob(encode_lob(host, port)) == (host, port)


@given(st.binary(max_size=30))
def test_any_bytes_are_a_cookie_or_a_wire_error(cookie: bytes) -> None:
    with suppress(WireError):
        decode_cookie(cookie)


def test_our_cookie_is_that_of_07_35() -> None:
    assert encode_cookie() == b"vrpn: ver. 07.35  0\0\0\0\0\0"
    assert decode_cookie(encode_cookie()) == "07.35"
    assert decode_cookie(b"vrpn: ver. 08.01  0".ljust(COOKIE_SIZE, b"\0")) == "08.01"


def test_a_callback_is_a_host_and_a_port() -> None:
    assert decode_lob(b"127.0.0.1 51221\0") == ("127.0.0.1", 51221)
    assert encode_lob("127.0.0.1", 51221) == b"127.0.0.1 51221\0"


@pytest.mark.parametrize(
    "datagram", [b"", b"127.0.0.1", b"127.0.0.1 0", b"127.0.0.1 65536", b" 80", b"a b", b"a 1 2"]
)
def test_a_callback_to_nowhere_is_refused(datagram: bytes) -> None:
    with pytest.raises(WireError, match="VRPN callback"):
        decode_lob(datagram)


@pytest.mark.parametrize(
    ("header", "field"),
    [
        (struct.pack(">IiiiiI", VRPN_HEADER_SIZE - 1, 0, 0, 0, 0, 0), "length"),
        (struct.pack(">IiiiiI", MAX_MESSAGE + 1, 0, 0, 0, 0, 0), "length"),
        (struct.pack(">IiiiiI", VRPN_HEADER_SIZE, -1, 0, 0, 0, 0), "time"),
        (struct.pack(">IiiiiI", VRPN_HEADER_SIZE, 0, 1_000_000, 0, 0, 0), "time"),
    ],
)
def test_a_bad_header_is_refused_by_the_name_of_its_field(header: bytes, field: str) -> None:
    with pytest.raises(WireError, match=f"VRPN {field}"):
        VrpnStream().feed(header)


def test_descriptions_that_cannot_be_are_refused() -> None:
    for number, body in (
        (2000, struct.pack(">I", 2) + b"a\0"),
        (-1, struct.pack(">I", 2) + b"a\0"),
        (0, b"abc"),
    ):
        with pytest.raises(WireError, match="VRPN description"):
            VrpnNames().learn(VrpnMessage(SENDER_DESCRIPTION, number, 0, body))
    with pytest.raises(WireError, match="VRPN description"):
        VrpnNames().learn(
            VrpnMessage(SENDER_DESCRIPTION, 1, 0, struct.pack(">I", 2**32 - 1) + b"a\0")
        )


def test_values_that_do_not_fit_are_refused() -> None:
    for make in (
        lambda: encode_message(VrpnMessage(2**31, 0, 0, b"")),
        lambda: encode_message(VrpnMessage(0, 0, 0, bytes(MAX_MESSAGE))),
        lambda: encode_pose(TrackerPose(2**31, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0))),
        lambda: description_message(SENDER_DESCRIPTION, 1, "x" * 100),
    ):
        with pytest.raises(WireError):
            make()
