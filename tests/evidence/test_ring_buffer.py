"""The last seconds in memory: enough of them, from a key frame on, and never too many bytes."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from housefly.evidence.privacy_mask import FrameToMask
from housefly.evidence.ring_buffer import RingBuffer
from housefly.messages import VideoFrame

STREAMS = st.lists(st.tuples(st.booleans(), st.integers(0, 400), st.floats(0.0, 1.0)), max_size=80)


def frames_of(stream: list[tuple[bool, int, float]]) -> list[FrameToMask]:
    at, frames = 50.0, []
    for n, (keyframe, size, pause) in enumerate(stream):
        at += pause
        frames.append(FrameToMask(VideoFrame(bytes(size), keyframe, 640, 360, n, at)))
    return frames


@given(STREAMS, st.floats(0.0, 6.0))
def test_what_comes_out_is_the_end_of_what_went_in_from_a_key_frame_on(
    stream: list[tuple[bool, int, float]], before: float
) -> None:
    ring, offered = RingBuffer(5.0, 3000), frames_of(stream)
    for frame in offered:
        ring.add(frame)
    kept = list(ring.newest_frames(before))
    if kept:
        assert kept == offered[-len(kept) :]
        assert kept[0].frame.keyframe
    assert ring.size <= 3000


@given(STREAMS, st.floats(0.0, 5.0))
def test_it_reaches_as_far_back_as_asked_and_no_further_than_needed(
    stream: list[tuple[bool, int, float]], before: float
) -> None:
    ring, offered = RingBuffer(5.0, 10**9), frames_of(stream)
    for frame in offered:
        ring.add(frame)
    kept = list(ring.newest_frames(before))
    keys = [n for n, frame in enumerate(offered) if frame.frame.keyframe]
    if not keys:
        assert not kept
        return
    start = offered[-1].frame.received_at - before
    early = [n for n in keys if offered[n].frame.received_at <= start]
    assert kept == offered[early[-1] if early else keys[0] :]


def test_without_a_key_frame_memory_stays_bounded() -> None:
    ring = RingBuffer(5.0, 3000)
    for frame in frames_of([(True, 100, 0.03)] + [(False, 100, 0.03)] * 500):
        ring.add(frame)
        assert ring.size <= 3000


def test_clearing_forgets_everything() -> None:
    ring = RingBuffer(5.0)
    for frame in frames_of([(True, 100, 0.03)] * 5):
        ring.add(frame)
    ring.clear()
    assert (ring.size, ring.newest_frames(5.0)) == (0, ())


def test_a_clock_that_went_back_starts_anew() -> None:
    ring = RingBuffer(5.0)
    late, early = frames_of([(True, 1, 100.0)]), frames_of([(True, 1, 0.0)])
    ring.add(late[0])
    ring.add(early[0])
    assert ring.newest_frames(5.0) == (early[0],)
