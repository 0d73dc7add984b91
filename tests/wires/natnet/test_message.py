"""The NatNet codec: round trips, skipping of what servers stream, only WireError on garbage."""

from __future__ import annotations

import struct
from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.wires.natnet import (
    CommandRequest,
    CommandResponse,
    Connect,
    Disconnect,
    Discovery,
    EchoRequest,
    EchoResponse,
    KeepAlive,
    ModelDef,
    NatNetFrame,
    NatNetMessage,
    NatNetVersion,
    RequestModelDef,
    RigidBody,
    RigidBodyDescription,
    ServerInfo,
    Unrecognized,
    decode_natnet,
    encode_natnet,
)

i32 = st.integers(-(2**31), 2**31 - 1)
u64 = st.integers(0, 2**64 - 1)
byte = st.integers(0, 255)
real = st.floats(allow_nan=False, width=32)
name = st.text(max_size=60).filter(
    lambda text: "\0" not in text and text.encode("utf-8", "replace").decode("utf-8") == text
)
four = st.tuples(byte, byte, byte, byte)
group = four.map(lambda quad: ".".join(map(str, quad)))
body = st.builds(
    RigidBody, i32, st.tuples(*[real] * 3), st.tuples(*[real] * 4), real, st.booleans()
)
described = st.builds(RigidBodyDescription, i32, name, i32, st.tuples(*[real] * 3))
item = st.one_of(
    st.builds(Connect, st.none() | st.tuples(st.integers(1, 255), byte)),
    st.builds(
        ServerInfo,
        name,
        four,
        four,
        st.integers(1, 2**64 - 1),
        st.integers(0, 65535),
        st.booleans(),
        group,
    ),
    st.builds(CommandRequest, name),
    st.builds(CommandResponse, i32),
    st.builds(ModelDef, st.lists(described, max_size=4).map(tuple)),
    st.builds(
        NatNetFrame,
        i32,
        st.lists(body, max_size=4).map(tuple),
        st.floats(allow_nan=False),
        u64,
        u64,
        u64,
        st.booleans(),
        st.booleans(),
    ),
    st.sampled_from([RequestModelDef(), Disconnect(), Discovery(), KeepAlive(), Unrecognized()]),
    st.builds(EchoRequest, u64),
    st.builds(EchoResponse, u64, u64),
)
versions = st.sampled_from([(3, 0), (3, 1), (4, 0), (4, 1), (4, 2)])

SEEN = RigidBody(7, (1.0, 2.0, 3.0), (1.0, 0.0, 0.0, 0.0), 0.25)


@given(item, versions)
def test_what_is_encoded_is_decoded(whole: NatNetMessage, version: NatNetVersion) -> None:
    assert decode_natnet(encode_natnet(whole, version), version) == whole


@given(st.binary(max_size=300), versions)
def test_any_bytes_are_a_message_or_a_wire_error(datagram: bytes, version: NatNetVersion) -> None:
    with suppress(WireError):
        decode_natnet(datagram, version)


@given(st.sampled_from([1, 2, 3, 5, 7]), st.binary(max_size=400), versions)
def test_any_body_of_a_known_kind_is_a_message_or_a_wire_error(
    kind: int, body: bytes, version: NatNetVersion
) -> None:
    with suppress(WireError):
        decode_natnet(struct.pack("<HH", kind, len(body)) + body, version)


@given(item, versions, st.data())
def test_a_damaged_message_is_a_message_or_a_wire_error(
    whole: NatNetMessage, version: NatNetVersion, data: st.DataObject
) -> None:
    datagram = bytearray(encode_natnet(whole, version))
    for _ in range(data.draw(st.integers(1, 5))):
        datagram[data.draw(st.integers(0, len(datagram) - 1))] = data.draw(byte)
    with suppress(WireError):
        decode_natnet(bytes(datagram[: data.draw(st.integers(0, len(datagram)))]), version)


@given(st.lists(body, max_size=3).map(tuple), versions, st.data())
def test_a_frame_cut_short_is_a_wire_error(
    bodies: tuple[RigidBody, ...], version: NatNetVersion, data: st.DataObject
) -> None:
    whole = encode_natnet(NatNetFrame(1, bodies), version)[4:-4]  # the end mark is not read
    cut = whole[: data.draw(st.integers(0, len(whole) - 1))]
    with pytest.raises(WireError, match="NatNet"):
        decode_natnet(struct.pack("<HH", NatNetFrame.KIND, len(cut)) + cut, version)


def crowded_frame(version: NatNetVersion) -> bytes:
    """Return a frame with something in every section, as Motive streams it."""
    sized = version >= (4, 1)

    def section(number: int, body: bytes) -> bytes:
        return struct.pack("<i", number) + (struct.pack("<i", len(body)) if sized else b"") + body

    bone = struct.pack("<i8fH", 1, *[0.5] * 8, 1)
    # The sets inside a section are never sized.
    marker_set = b"all\0" + struct.pack("<i6f", 2, *[1.0] * 6)
    plate = struct.pack("<iiifif", 1, 2, 1, 0.5, 1, 0.25)
    parts = [
        struct.pack("<i", 42),
        section(2, marker_set * 2),
        section(1, struct.pack("<3f", 1, 2, 3)),
        section(1, struct.pack("<i3f4ffH", 7, 1, 2, 3, 0, 0, 0, 1, 0.25, 1)),
        section(1, struct.pack("<ii", 3, 2) + bone * 2),
        section(1, struct.pack("<iii", 9, 0, 0)) if sized else b"",
        section(1, struct.pack("<i4fHf", 65537, 1, 2, 3, 0.01, 2, 0.0)),
        section(1, plate),
        section(1, plate),
        struct.pack("<IIdQQQ", 1, 2, 12.5, 100, 110, 120),
        struct.pack("<II", 5, 6) if sized else b"",
        struct.pack("<Hi", 3, 0),
    ]
    body = b"".join(parts)
    return struct.pack("<HH", 7, len(body)) + body


@pytest.mark.parametrize("version", [(3, 1), (4, 1), (4, 2)])
def test_sections_that_we_do_not_use_are_stepped_over(version: NatNetVersion) -> None:
    assert decode_natnet(crowded_frame(version), version) == NatNetFrame(
        42, (SEEN,), 12.5, 100, 110, 120, True, True
    )


@pytest.mark.parametrize("version", [(3, 1), (4, 1)])
def test_descriptions_that_we_do_not_use_are_stepped_over(version: NatNetVersion) -> None:
    sized = version >= (4, 1)

    def data_set(kind: int, body: bytes) -> bytes:
        return struct.pack("<i", kind) + (struct.pack("<i", len(body)) if sized else b"") + body

    names = b"a\0b\0" if version >= (4, 0) else b""
    rigid = (
        b"drone\0"
        + struct.pack("<ii3f", 7, -1, 0, 0, 0)
        + struct.pack("<i6f2i", 2, *[0.0] * 6, 1, 2)
        + names
    )
    plate = (
        struct.pack("<i", 1) + b"serial\0" + bytes(4 * 161) + struct.pack("<iii", 0, 0, 1) + b"Fx\0"
    )
    sets = [
        data_set(0, b"all\0" + struct.pack("<i", 2) + b"m1\0m2\0"),
        data_set(2, b"Bob\0" + struct.pack("<ii", 1, 1) + rigid),
        data_set(3, plate),
        data_set(
            4, struct.pack("<i", 1) + b"dev\0serial\0" + struct.pack("<iii", 0, 0, 1) + b"ch\0"
        ),
        data_set(5, b"cam\0" + bytes(28)),
        data_set(1, rigid),
    ]
    body = struct.pack("<i", len(sets)) + b"".join(sets)
    assert decode_natnet(struct.pack("<HH", 5, len(body)) + body, version) == ModelDef(
        (RigidBodyDescription(7, "drone"),)
    )


@pytest.mark.parametrize(
    ("datagram", "field"),
    [
        (b"abc", "header"),
        (struct.pack("<HH", 7, 10), "length"),
        (struct.pack("<HH", 77, 0), "kind"),
        (struct.pack("<HHii", 7, 8, 1, -1), "marker set count"),
        (struct.pack("<HHiiiii", 7, 20, 1, 0, 0, 2**31 - 1, 0), "rigid body count"),
        (struct.pack("<HHii", 5, 8, 1, 0), "data set count"),
        (struct.pack("<HHii4x", 5, 12, 1, 99), "data set kind"),
        (struct.pack("<HHii", 5, 8, 100, 1), "data set count"),
        (struct.pack("<HH", 2, 3) + b"abc", "command"),
        (struct.pack("<HH", 1, 279) + bytes(279), "clock frequency"),
    ],
)
def test_garbage_is_refused_by_the_name_of_its_field(datagram: bytes, field: str) -> None:
    with pytest.raises(WireError, match=f"NatNet {field}"):
        decode_natnet(datagram, (3, 1))


def test_a_section_of_another_size_than_its_bodies_is_refused() -> None:
    body = struct.pack("<iiiiiii", 1, 0, 0, 0, 0, 1, 40) + bytes(40)
    with pytest.raises(WireError, match="rigid body count"):
        decode_natnet(struct.pack("<HH", 7, len(body)) + body, (4, 1))


def test_greetings_of_all_clients_are_understood() -> None:
    assert decode_natnet(b"\0\0\0\0", (3, 1)) == Connect()
    assert decode_natnet(b"\0\0\x05\0Ping\0", (3, 1)) == Connect()
    assert decode_natnet(b"\x04\0\0\0\0", (3, 1)) == RequestModelDef()


def test_values_that_do_not_fit_are_refused() -> None:
    with pytest.raises(WireError):
        encode_natnet(CommandRequest("x" * 300), (3, 1))
    with pytest.raises(WireError):
        encode_natnet(
            NatNetFrame(1, (RigidBody(1, (1e300, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)),)), (3, 1)
        )
    with pytest.raises(WireError):
        encode_natnet(NatNetFrame(1, (SEEN,) * 2000), (3, 1))
    with pytest.raises(WireError, match="group"):
        encode_natnet(ServerInfo("x", (0, 0, 0, 0), (3, 1, 0, 0), 1, 1, True, "nowhere"), (3, 1))
