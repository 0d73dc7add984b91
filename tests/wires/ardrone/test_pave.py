"""PaVE headers and the cutting of a TCP stream into pictures."""

from __future__ import annotations

import contextlib
from pathlib import Path

import av
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.wires.ardrone import pave

KEY_PICTURE = b"\0\0\0\1\x67abc\0\0\0\1\x68de\0\0\0\1\x65" + bytes(40)
P_PICTURE = b"\0\0\0\1\x41" + bytes(20)


def _frame(number: int, payload: bytes = P_PICTURE, header_size: int = 64) -> bytes:
    return pave.encode_frame(
        pave.PaveHeader(len(payload), number, header_size=header_size), payload
    )


@pytest.fixture(
    params=["pave_64byte_headers_node-ar-drone.bin", "pave_68byte_headers_node-ar-drone.bin"]
)
def recorded(request: pytest.FixtureRequest, shared_data: Path) -> bytes:
    return (shared_data / "ardrone" / str(request.param)).read_bytes()


def test_all_recorded_pictures_come_out(recorded: bytes) -> None:
    cutter = pave.VideoReassembler()
    frames = cutter.feed(recorded)
    assert len(frames) == {102747: 20, 24971: 5}[len(recorded)]
    assert sum(frame.header.header_size + len(frame.payload) for frame in frames) == len(recorded)
    assert (cutter.skipped_bytes, cutter.bad_headers) == (0, 0)
    for frame in frames:
        assert (
            frame.header.display_width,
            frame.header.display_height,
            frame.header.encoded_height,
        ) == (640, 360, 368)
        assert frame.keyframe == (frame.header.frame_type == pave.FrameType.IDR)


def test_recorded_headers_are_written_again_as_they_were(recorded: bytes) -> None:
    meaningful = 52  # the rest is unused, or not published
    header = pave.decode_header(recorded)
    assert pave.encode_header(header)[:meaningful] == recorded[:meaningful]
    assert len(pave.encode_header(header)) == header.header_size


def test_a_decoder_takes_the_recorded_pictures_from_the_first_key_frame_on(recorded: bytes) -> None:
    gate, decoder = pave.KeyframeGate(), av.CodecContext.create("h264", "r")
    passed = [frame for frame in pave.VideoReassembler().feed(recorded) if gate.passes(frame)]
    assert len(passed) == {102747: 17, 24971: 5}[len(recorded)]
    pictures = [
        picture for frame in passed for picture in decoder.decode(av.Packet(frame.payload))
    ] + decoder.decode(None)
    assert len(pictures) == len(passed)
    assert {(picture.width, picture.height) for picture in pictures} == {(640, 360)}


@given(st.lists(st.integers(1, 5000), max_size=40))
def test_it_does_not_matter_how_tcp_cuts_the_stream(cuts: list[int]) -> None:
    stream = b"".join(
        _frame(n, KEY_PICTURE if n % 5 == 0 else P_PICTURE, 64 if n % 2 else 68) for n in range(30)
    )
    cutter, got, at = pave.VideoReassembler(), [], 0
    for cut in cuts:
        got += cutter.feed(stream[at : at + cut])
        at += cut
    got += cutter.feed(stream[at:])
    assert [frame.header.frame_number for frame in got] == list(range(30))


@given(
    st.binary(max_size=400).filter(
        lambda garbage: b"PaVE" not in garbage and not garbage.endswith((b"P", b"Pa", b"PaV"))
    )
)
def test_after_garbage_the_next_picture_comes_out(garbage: bytes) -> None:
    cutter = pave.VideoReassembler()
    frames = cutter.feed(_frame(1) + garbage + _frame(2))
    assert [frame.header.frame_number for frame in frames] == [1, 2]
    assert cutter.skipped_bytes == len(garbage)


@given(
    st.lists(
        st.one_of(st.binary(max_size=200), st.just(b"PaVE"), st.builds(_frame, st.integers(0, 9))),
        max_size=30,
    )
)
def test_no_stream_makes_the_cutter_raise(parts: list[bytes]) -> None:
    cutter = pave.VideoReassembler()
    for part in parts:
        for frame in cutter.feed(part):
            assert len(frame.payload) == frame.header.payload_size <= pave.MAX_PAYLOAD


@given(st.binary(max_size=80))
def test_no_bytes_make_the_header_parser_raise_anything_else(data: bytes) -> None:
    for candidate in (data, b"PaVE" + data):
        with contextlib.suppress(WireError):
            pave.decode_header(candidate)


def test_a_header_that_asks_for_too_much_memory_is_skipped() -> None:
    greedy = bytearray(_frame(1))
    greedy[8:12] = (2**31).to_bytes(4, "little")
    cutter = pave.VideoReassembler()
    assert [frame.header.frame_number for frame in cutter.feed(bytes(greedy) + _frame(2))] == [2]
    assert cutter.bad_headers == 1


def test_garbage_that_looks_like_headers_costs_little_and_the_next_picture_comes_out() -> None:
    cutter = pave.VideoReassembler()
    assert cutter.feed(b"PaVE" * 250_000) == ()
    assert cutter.bad_headers == pave.BAD_HEADERS_MAX
    (picture,) = cutter.feed(b"PaVE" + _frame(9))
    assert picture.payload == P_PICTURE


def test_pictures_pass_from_a_key_frame_on_and_again_after_a_gap_only_from_the_next() -> None:
    gate = pave.KeyframeGate()
    frames = [
        (1, P_PICTURE),
        (2, KEY_PICTURE),
        (3, P_PICTURE),
        (5, P_PICTURE),
        (6, P_PICTURE),
        (7, KEY_PICTURE),
        (8, P_PICTURE),
    ]
    passed = [
        number
        for number, payload in frames
        if gate.passes(pave.PaveFrame(pave.PaveHeader(len(payload), number), payload))
    ]
    assert passed == [2, 3, 7, 8]
    gate.reset()
    assert not gate.passes(pave.PaveFrame(pave.PaveHeader(len(P_PICTURE), 9), P_PICTURE))


def test_headers_that_make_no_sense_are_not_written() -> None:
    with pytest.raises(WireError, match="64"):
        pave.encode_header(pave.PaveHeader(1, 1, header_size=60))
    with pytest.raises(WireError, match="does not fit"):
        pave.encode_header(pave.PaveHeader(1, -1))
    with pytest.raises(WireError, match="picture has 3"):
        pave.encode_frame(pave.PaveHeader(1, 1), b"abc")
