from __future__ import annotations

from collections import deque

from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import VideoFrame
from housefly.web.video import HEADER, WAITING_MAX, Watcher, pack


def test_a_picture_is_packed_behind_its_header() -> None:
    message = pack(VideoFrame(b"\0\0\1\x65picture", True, 640, 360, 77, 12.5))
    assert HEADER.unpack_from(message) == (1, 1, 640, 360, 77, 12.5)
    assert message[HEADER.size :] == b"\0\0\1\x65picture"


def test_the_header_is_as_long_as_the_browser_thinks() -> None:
    assert HEADER.size == 24


@given(st.lists(st.tuples(st.booleans(), st.integers(0, 30)), max_size=300))
def test_what_a_watcher_gets_can_always_be_decoded(story: list[tuple[bool, int]]) -> None:
    """Each picture is a key frame (k) or continues the picture before it, however slowly the
    browser reads.
    """
    watcher, sent = Watcher(deque(), skipping=True), []
    for number, (keyframe, reads) in enumerate(story):
        watcher.offer(f"{'k' if keyframe else 'd'}{number}".encode(), keyframe=keyframe)
        assert len(watcher.waiting) <= WAITING_MAX
        for _ in range(min(reads, len(watcher.waiting))):
            sent.append(watcher.waiting.popleft().decode())
    for before, after in zip(["", *sent], sent, strict=False):
        assert after[0] == "k" or int(after[1:]) == int(before[1:]) + 1


def test_a_browser_that_is_far_behind_goes_on_at_the_next_key_frame() -> None:
    watcher = Watcher(deque(), skipping=True)
    watcher.offer(b"k0", keyframe=True)
    for number in range(1, WAITING_MAX + 5):
        watcher.offer(b"d%d" % number, keyframe=False)
    assert not watcher.waiting
    watcher.offer(b"k50", keyframe=True)
    watcher.offer(b"d51", keyframe=False)
    assert list(watcher.waiting) == [b"k50", b"d51"]
