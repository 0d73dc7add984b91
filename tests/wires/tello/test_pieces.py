"""Pictures in pieces: whole ones come out as they went in, lost pieces spoil one picture."""

from __future__ import annotations

import random

from hypothesis import given
from hypothesis import strategies as st

from housefly.wires.annex_b import can_begin
from housefly.wires.tello.pieces import (
    PICTURE_BYTES_MAX,
    PIECE_BYTES,
    PictureJoiner,
    pieces_of,
)

KEY = b"\0\0\0\1\x67sps\0\0\0\1\x68pps\0\0\0\1\x65"
SLICE = b"\0\0\0\1\x41"


def picture(head: bytes, length: int) -> bytes:
    return head + b"\x99" * (length - len(head))


pictures = st.lists(
    st.tuples(st.sampled_from([KEY, SLICE]), st.integers(30, 5 * PIECE_BYTES)).map(
        lambda told: picture(*told)
    ),
    min_size=1,
    max_size=6,
)
edges = [
    picture(KEY, PIECE_BYTES - 1),
    picture(SLICE, PIECE_BYTES),
    picture(SLICE, PIECE_BYTES + 1),
    picture(KEY, 3 * PIECE_BYTES),
]


@given(pictures | st.just(edges))
def test_pictures_come_out_as_they_went_in(sent):
    joiner = PictureJoiner()
    seen = [got for one in sent for piece in pieces_of(one) for got in joiner.feed(piece)]
    assert [got.rstrip(b"\0") for got in seen] == [one.rstrip(b"\0") for one in sent]
    assert joiner.broken == 0
    assert all(len(piece) <= PIECE_BYTES for one in sent for piece in pieces_of(one))
    assert all(len(pieces_of(one)[-1]) < PIECE_BYTES for one in sent)


def test_a_real_drone_that_ends_with_a_full_piece_ends_where_the_next_begins():
    joiner = PictureJoiner()
    first, second = picture(KEY, 2 * PIECE_BYTES), picture(SLICE, 100)
    assert joiner.feed(first[:PIECE_BYTES]) == joiner.feed(first[PIECE_BYTES:]) == ()
    assert joiner.feed(second) == (first, second)


@given(pictures, st.integers(0, 2**30))
def test_lost_pieces_never_join_two_pictures_and_never_raise(sent, seed):
    chance, joiner, seen = random.Random(seed), PictureJoiner(), []
    for one in sent:
        for piece in pieces_of(one):
            if chance.random() < 0.8:
                seen += joiner.feed(piece)
    assert all(got.startswith(b"\0\0\0\1") and got.count(b"\0\0\0\1") <= 3 for got in seen)
    assert len(seen) <= len(sent)


def test_what_has_no_beginning_or_no_end_is_thrown_away():
    joiner = PictureJoiner()
    assert joiner.feed(b"\x99" * PIECE_BYTES) == joiner.feed(b"\x99" * 20) == ()
    assert joiner.broken == 1
    joiner.feed(picture(KEY, PIECE_BYTES))
    for _ in range(2 * PICTURE_BYTES_MAX // PIECE_BYTES):
        assert joiner.feed(b"\x99" * PIECE_BYTES) == ()
    assert joiner.broken == 2


def test_decoding_may_begin_with_a_key_frame_only():
    assert can_begin(picture(KEY, 90))
    assert not can_begin(picture(SLICE, 90)) and not can_begin(b"\0\0\1")
