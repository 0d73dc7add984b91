from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.messages import VideoFrame
from housefly.web.camera.video import FRAME_HEADER, MAX_QUEUED_FRAMES, FrameQueue, pack_frame


def test_a_picture_is_packed_behind_its_header() -> None:
    message = pack_frame(VideoFrame(b"\0\0\1\x65picture", True, 640, 360, 77, 12.5))
    assert FRAME_HEADER.unpack_from(message) == (1, 1, 640, 360, 77, 12.5)
    assert message[FRAME_HEADER.size :] == b"\0\0\1\x65picture"


def test_the_header_is_as_long_as_the_browser_thinks() -> None:
    assert FRAME_HEADER.size == 24


@given(st.lists(st.tuples(st.booleans(), st.integers(0, 30)), max_size=300))
def test_what_a_queue_gets_can_always_be_decoded(story: list[tuple[bool, int]]) -> None:
    """Each frame sent is a key frame (k) or continues the one before, however slow the browser."""
    queue, sent = FrameQueue(skipping=True), []
    for number, (keyframe, reads) in enumerate(story):
        queue.add(f"{'k' if keyframe else 'd'}{number}".encode(), keyframe=keyframe)
        assert len(queue.waiting) <= MAX_QUEUED_FRAMES
        for _ in range(min(reads, len(queue.waiting))):
            sent.append(queue.waiting.popleft().decode())
    for before, after in zip(["", *sent], sent, strict=False):
        assert after[0] == "k" or int(after[1:]) == int(before[1:]) + 1


def test_a_browser_that_is_far_behind_goes_on_at_the_next_key_frame() -> None:
    queue = FrameQueue(skipping=True)
    queue.add(b"k0", keyframe=True)
    for number in range(1, MAX_QUEUED_FRAMES + 5):
        queue.add(b"d%d" % number, keyframe=False)
    assert not queue.waiting
    queue.add(b"k50", keyframe=True)
    queue.add(b"d51", keyframe=False)
    assert list(queue.waiting) == [b"k50", b"d51"]
