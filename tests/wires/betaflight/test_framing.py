"""MSP frames in a stream: back as they were, whatever stands between them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.wires.betaflight.framing import (
    PAYLOAD_MAX,
    MspDirection,
    MspFrame,
    MspReader,
    MspVersion,
    crc8,
    encode_msp,
)

FRAMES = st.builds(
    MspFrame,
    st.integers(0, 255),
    st.binary(max_size=300),
    st.sampled_from(MspDirection),
    st.sampled_from(MspVersion),
)


@given(st.lists(FRAMES, max_size=6), st.data())
def test_frames_cut_anywhere_come_back_in_order(
    frames: list[MspFrame], data: st.DataObject
) -> None:
    stream = b"".join(map(encode_msp, frames))
    reader, found = MspReader(), []
    while stream:
        size = data.draw(st.integers(1, len(stream)))
        found += reader.feed(stream[:size])
        stream = stream[size:]
    assert found == frames and reader.broken == reader.noise == 0


@given(st.binary(max_size=200))
def test_any_bytes_are_frames_or_counted(data: bytes) -> None:
    reader = MspReader()
    reader.feed(data)
    assert reader.noise + reader.broken <= len(data)


@given(st.binary(max_size=20).filter(lambda noise: b"$" not in noise), FRAMES)
def test_noise_before_a_frame_is_dropped_and_the_frame_is_not(
    noise: bytes, frame: MspFrame
) -> None:
    reader = MspReader()
    assert reader.feed(noise + encode_msp(frame)) == [frame]
    assert reader.noise == len(noise)


@given(FRAMES, st.data())
def test_a_frame_with_a_wrong_byte_behind_its_head_does_not_pass(
    frame: MspFrame, data: st.DataObject
) -> None:
    whole = bytearray(encode_msp(frame))
    at = data.draw(st.integers(3, len(whole) - 1))
    whole[at] ^= data.draw(st.integers(1, 255))
    assert frame not in MspReader().feed(bytes(whole))


def test_a_frame_behind_a_broken_one_is_found() -> None:
    good = MspFrame(105, b"\x01\x02", MspDirection.ANSWER)
    broken = bytearray(encode_msp(MspFrame(108, b"abcdef", MspDirection.ANSWER)))
    broken[-1] ^= 0xFF
    reader = MspReader()
    assert reader.feed(bytes(broken) + encode_msp(good)) == [good]
    assert reader.broken == 1


def test_known_frames_have_the_bytes_that_the_firmware_sends() -> None:
    assert encode_msp(MspFrame(108)) == b"$M<\x00\x6c\x6c"
    assert encode_msp(MspFrame(2, b"BTFL", MspDirection.ANSWER)) == b"$M>\x04\x02BTFL\x1a"
    v2 = encode_msp(MspFrame(0x3010, b"x", version=MspVersion.V2))
    assert v2[:8] == b"$X<\x00\x10\x30\x01\x00" and v2[-1] == crc8(v2[3:-1])


def test_the_checksum_of_version_two_is_crc8_dvb_s2() -> None:
    assert crc8(b"123456789") == 0xBC, "the check value of the catalogue of CRC algorithms"


@pytest.mark.parametrize(
    "frame",
    [
        MspFrame(256),
        MspFrame(-1),
        MspFrame(1, bytes(PAYLOAD_MAX + 1)),
        MspFrame(70000, version=MspVersion.V2),
    ],
)
def test_what_no_frame_can_say_is_refused(frame: MspFrame) -> None:
    with pytest.raises(WireError, match="allowed: 0 to"):
        encode_msp(frame)
