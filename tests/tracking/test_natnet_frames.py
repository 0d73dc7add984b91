"""From NatNet frames to sightings: names, time stamps, and what is dropped."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.tracking.counts import FrameCounts
from housefly.tracking.natnet_frames import NatNetFrames
from housefly.wires.natnet import ModelDef, NatNetFrame, RigidBody, RigidBodyDescription

HERE = RigidBody(7, (1.0, 2.0, 3.0), (1.0, 0.0, 0.0, 0.0))
LATENCY, HZ = 0.02, 1_000_000
u64 = st.integers(0, 2**64 - 1)


def reader(y_up: bool = False) -> tuple[NatNetFrames, FrameCounts]:
    counts = FrameCounts()
    frames = NatNetFrames(HZ, LATENCY, y_up, counts)
    frames.learn_names(ModelDef((RigidBodyDescription(7, "ardrone"),)))
    return frames, counts


@given(st.lists(st.tuples(u64, u64, st.floats(0.0, 2.0)), min_size=1, max_size=40))
def test_whatever_is_stamped_captures_neither_run_backwards_nor_into_the_future(
    stamps: list[tuple[int, int, float]],
) -> None:
    frames, _ = reader()
    now, last = 100.0, float("-inf")
    for number, (exposed, sent, pause) in enumerate(stamps):
        now += pause
        for seen in (
            frames.read(NatNetFrame(number, (HERE,), exposed=exposed, sent=sent), now) or ()
        ):
            assert last <= seen.captured_at <= now
            last = seen.captured_at


def test_the_latency_is_what_the_stamps_say() -> None:
    (seen,) = (
        reader()[0].read(NatNetFrame(1, (HERE,), exposed=5 * HZ, sent=5 * HZ + 8000), 100.0) or ()
    )
    assert seen.captured_at == pytest.approx(100.0 - 0.008)
    assert (seen.body, seen.received_at, seen.pose.position) == ("ardrone", 100.0, HERE.position)


def test_cameras_that_do_not_tell_the_exposure_are_taken_at_the_configured_latency() -> None:
    frames, counts = reader()
    for number in range(10):
        now = 100.0 + 0.01 * number
        (seen,) = (
            frames.read(NatNetFrame(number, (HERE,), exposed=0, sent=5 * HZ + 10_000 * number), now)
            or ()
        )
        assert seen.captured_at == pytest.approx(now - LATENCY)
    assert counts.misstamped == 0


def test_poses_in_millimetres_are_refused_with_a_question_about_the_unit() -> None:
    frames, counts = reader()
    body = RigidBody(7, (3200.0, 1500.0, 400.0), (1.0, 0.0, 0.0, 0.0))
    assert frames.read(NatNetFrame(1, (body,), exposed=5 * HZ, sent=5 * HZ), 100.0) == ()
    assert counts.unit_problem(100.5).startswith(
        "poses are refused, 'ardrone' at (3200, 1500, 400) m: is its unit millimetres?"
    )
    assert counts.unit_problem(110.0) == ""


def test_names_are_wanted_at_first_after_a_change_after_a_leap_and_for_an_unknown_number() -> None:
    fresh = NatNetFrames(HZ, LATENCY, False, FrameCounts())
    assert fresh.wants_names
    frames, counts = reader()
    assert not frames.wants_names
    frames.read(NatNetFrame(1, (HERE,), exposed=HZ, sent=HZ, changed=True), 100.0)
    assert frames.wants_names
    frames.learn_names(ModelDef((RigidBodyDescription(7, "ardrone"),)))
    frames.read(NatNetFrame(2, (HERE,), exposed=9 * HZ, sent=9 * HZ), 100.01)
    assert frames.wants_names
    frames.learn_names(ModelDef(()))
    assert (
        frames.read(NatNetFrame(3, (HERE,), exposed=9 * HZ + 100, sent=9 * HZ + 100), 100.02) == ()
    )
    assert (frames.wants_names, counts.unnamed) == (True, 1)


def test_a_server_that_may_be_another_one_names_nobody_until_it_is_asked() -> None:
    frames, _ = reader()
    frames.forget_names()
    assert frames.read(NatNetFrame(1, (HERE,), exposed=HZ, sent=HZ), 100.0) == ()
    assert frames.wants_names


def test_an_untracked_body_is_no_sighting_whatever_its_pose() -> None:
    frames, counts = reader()
    lost = RigidBody(7, (float("nan"), 0.0, 0.0), (0.0, 0.0, 0.0, 0.0), tracked=False)
    assert frames.read(NatNetFrame(1, (lost,), exposed=HZ, sent=HZ), 100.0) == ()
    assert counts.refused == 0
