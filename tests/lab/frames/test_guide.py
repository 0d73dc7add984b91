"""A clumsy person is told in words what to do again; who stands by it is believed."""

from __future__ import annotations

from dataclasses import replace
from math import pi, radians

import pytest
from carried_drone import PAD_PLAN, STANDING, Carrier, Lies

from housefly.lab.frames.findings import FrameFault
from housefly.lab.frames.guide import Answer
from housefly.lab.frames.plan import STEPS, CarryStep
from housefly.lab.frames.samples import CarryTrack


def carrier_at(step: CarryStep, **options: object) -> Carrier:
    """Return a carrier who has done all steps before this one."""
    carrier = Carrier(PAD_PLAN, **options)  # type: ignore[arg-type]
    for earlier in STEPS[: STEPS.index(step)]:
        assert carrier.do(earlier).accepted
    return carrier


def offered(carrier: Carrier, track: CarryTrack) -> Answer:
    return carrier.guide.offer(track, carrier.now)


def redone(carrier: Carrier, step: CarryStep) -> bool:
    """Put it right; return whether that is accepted at once."""
    x, y, z = PAD_PLAN.place(step)
    turn = PAD_PLAN.nose(step) - carrier.yaw
    return offered(carrier, carrier.carry((x, y, z + STANDING), turn)).accepted


def moved(carrier: Carrier, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> tuple[float, ...]:
    return tuple(a + b for a, b in zip(carrier.place, (x, y, z), strict=True))


# PAD_PLAN looks along +y: ahead is +y, left is -x.
CLUMSY = {
    "beside the pad": (CarryStep.PAD, (0.6, 0.0, 0.0), 0.0, "beside the pad"),
    "nose elsewhere": (CarryStep.PAD, (0.0, 0.0, 0.0), 0.9, "nose 52 deg to the left"),
    "not far enough": (CarryStep.AHEAD, (0.0, 0.4, 0.0), 0.0, "a way of 0.40 m"),
    "wrong order": (CarryStep.AHEAD, (-1.0, 0.0, 0.0), 0.0, "1.00 m to the left"),
    "turned on the way": (CarryStep.AHEAD, (0.0, 1.0, 0.0), 0.7, "its own gyros say 40 deg"),
    "the other side": (CarryStep.SIDE, (1.0, 0.0, 0.0), 0.0, "1.00 m to the right"),
    "not lifted": (CarryStep.LIFT, (0.0, 0.0, 0.1), 0.0, "0.10 m higher"),
    "turned right": (CarryStep.TURN, (0.0, 0.0, -0.5), -pi / 2, "90 deg to the right"),
    "not turned": (CarryStep.TURN, (0.0, 0.0, -0.5), 0.0, "it was not turned"),
    "turned elsewhere": (CarryStep.TURN, (0.5, 0.0, -0.5), pi / 2, "0.50 m aside"),
    "not back": (CarryStep.BACK, (0.0, -1.0, 0.0), 0.0, "from where it lay on the pad"),
}


@pytest.mark.parametrize(("step", "way", "turn", "words"), CLUMSY.values(), ids=CLUMSY)
def test_what_was_not_asked_is_told_and_done_again(step, way, turn, words):
    carrier = carrier_at(step)
    answer = offered(carrier, carrier.carry(moved(carrier, *way), turn))
    assert not answer.accepted
    assert words in " ".join(answer.words)
    assert carrier.guide.step is step
    assert redone(carrier, step)
    for later in STEPS[STEPS.index(step) + 1 :]:
        assert carrier.do(later).accepted
    assert carrier.guide.verdict().passed


def test_what_was_moved_too_fast_is_done_again() -> None:
    carrier = carrier_at(CarryStep.AHEAD)
    fast = carrier.carry(moved(carrier, y=1.0), seconds=0.3)
    assert "too fast" in " ".join(offered(carrier, fast).words)


def test_what_still_moves_is_no_sample_and_the_same_step_goes_on() -> None:
    carrier = carrier_at(CarryStep.AHEAD)
    track = carrier.carry(moved(carrier, y=1.0), seconds=2.0)
    answer = carrier.guide.offer(track, carrier.now - 2.0)
    assert "still moves" in answer.words[0] and not answer.begins_anew
    assert carrier.guide.offer(track, carrier.now).accepted


def without(track: CarryTrack, start: float, end: float) -> CarryTrack:
    """Return a track with a hole in the drone's body."""
    points = tuple(point for point in track.bodies["ardrone"] if not start < point.at < end)
    return replace(track, bodies={"ardrone": points})


def test_tracking_that_lost_it_half_way_or_now_is_told_and_the_step_repeated() -> None:
    carrier = carrier_at(CarryStep.SIDE)
    began = carrier.now
    track = carrier.carry(moved(carrier, x=-1.0))
    gone = carrier.guide.offer(without(track, began + 1.0, 1e9), carrier.now)
    assert "does not see 'ardrone' for 3." in gone.words[0] and not gone.accepted
    assert "If it cannot be seen" not in " ".join(gone.words)
    half = carrier.guide.offer(without(track, began + 0.5, began + 2.0), carrier.now)
    assert "lost it for 1.5 s" in half.words[0] and not half.accepted
    assert redone(carrier, CarryStep.SIDE)


def test_silent_tracking_is_not_a_body_that_is_not_seen() -> None:
    carrier = carrier_at(CarryStep.PAD)
    track = carrier.carry(carrier.place)
    for _ in range(4):
        answer = carrier.guide.offer(track, carrier.now + 2.0)
        assert "silent for 2.0 s" in answer.words[0] and not answer.accepted


def test_a_body_that_is_seen_at_last_begins_anew_from_the_pad() -> None:
    carrier = carrier_at(CarryStep.PAD)
    blind = replace(carrier.carry(carrier.place), bodies={})
    assert not offered(carrier, blind).accepted
    assert offered(carrier, blind).accepted
    answer = offered(carrier, carrier.carry(moved(carrier, y=1.0)))
    assert "begin anew" in answer.words[0]
    assert carrier.guide.step is CarryStep.PAD


def test_who_stands_by_it_is_not_asked_about_the_same_again() -> None:
    carrier = Carrier(PAD_PLAN, lies=Lies(rotation=radians(90.0)))
    asked = 0
    for step in STEPS:
        to, turn = carrier.asked(step)
        answer = offered(carrier, carrier.carry(to, turn))
        while not answer.accepted:
            asked += 1
            answer = offered(carrier, carrier.carry(carrier.place))
    assert asked == 2  # the nose on the pad, the way ahead
    assert [found.fault for found in carrier.guide.verdict().findings] == [FrameFault.ROTATED]


def test_a_turn_that_is_done_again_is_still_measured() -> None:
    carrier = carrier_at(CarryStep.TURN, lies=Lies(lag=0.3))
    to, turn = carrier.asked(CarryStep.TURN)
    offered(carrier, carrier.carry(to, turn + 0.9))
    offered(carrier, carrier.carry(to))
    assert carrier.guide.lag == pytest.approx(0.3, abs=0.03)
