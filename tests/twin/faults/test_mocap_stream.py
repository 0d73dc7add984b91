"""Each lie of the tracking system, seen in its frames."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import cos, hypot, isnan, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.geometry import normalized, quaternion_from_euler, rotate, wrap_angle
from housefly.messages import Pose
from housefly.twin.contracts import MocapFrame
from housefly.twin.faults.fault import FaultSchedule
from housefly.twin.faults.mocap_stream import MocapStream
from housefly.twin.faults.parse import parse_fault
from housefly.twin.mocap.frames import FrameMaker

DRONE, VISITOR = "ardrone", "Visitor"
PAD = (1.0, 2.0)
AT_DOOR = Pose((5.0, -1.0, 1.5), quaternion_from_euler(0.0, 0.0, 0.7))
PERIOD = 0.01
START = 2.0
SIZES = st.floats(0.05, 2.0)
ANGLES = st.floats(-3.1, 3.1)


def true_pose(at: float) -> Pose:
    """Return where the drone is while it flies a circle that begins on its pad."""
    x, y = PAD[0] + sin(0.5 * at), PAD[1] + 1.0 - cos(0.5 * at)
    return Pose((x, y, 0.1 + 0.2 * at), quaternion_from_euler(0.05, -0.1, 0.3 * at))


def true_frames(seconds: float = 4.0) -> list[MocapFrame]:
    return [
        MocapFrame(n, at := n * PERIOD, at + 0.02, ((DRONE, true_pose(at)), (VISITOR, AT_DOOR)))
        for n in range(round(seconds / PERIOD))
    ]


def told(*faults: str, seconds: float = 4.0) -> list[MocapFrame]:
    """Return the frames that arrive, polled as a tracking client does."""
    stream = MocapStream(DRONE, 1.0 / PERIOD)
    schedule = FaultSchedule(tuple(one for text in faults for one in parse_fault(text)))
    waiting, arrived = true_frames(seconds), []
    for tick in range(round((seconds + 3.0) / PERIOD)):
        now = tick * PERIOD
        due = [frame for frame in waiting if frame.due_at <= now]
        waiting = waiting[len(due) :]
        frames = stream.passed(due, schedule, now)
        assert all(frame.due_at <= now for frame in frames)
        arrived += frames
    return arrived


def pose_of(frame: MocapFrame, body: str = DRONE) -> Pose:
    pose = dict(frame.bodies)[body]
    assert pose is not None
    return pose


def pairs(frames: list[MocapFrame]) -> list[tuple[float, Pose, Pose]]:
    """Return time, true and told pose of the drone in each frame from the start of the fault."""
    return [
        (frame.captured_at, true_pose(frame.captured_at), pose_of(frame))
        for frame in frames
        if frame.captured_at >= START
    ]


def same(a: Pose, b: Pose) -> bool:
    near = np.allclose(a.position, b.position)
    turned = min(
        np.abs(np.subtract(a.orientation, b.orientation)).max(),
        np.abs(np.add(a.orientation, b.orientation)).max(),
    )
    return bool(near and turned < 1e-6)


def off(a: Pose, b: Pose) -> tuple[float, float, float]:
    x, y, z = (told - true for told, true in zip(b.position, a.position, strict=True))
    return x, y, z


def test_without_faults_the_frames_are_the_same_objects() -> None:
    frames, stream = true_frames(1.0), MocapStream(DRONE, 100.0)
    for frame in frames:
        assert stream.passed((frame,), FaultSchedule(), frame.due_at)[0] is frame


@pytest.mark.parametrize("lie", ["position", "yaw", "map", "bodies", "origin_z"])
def test_before_and_after_a_lie_the_frames_are_true(lie: str) -> None:
    frames = told(f"mocap.{lie}:wrong@{START}s+1s")
    quiet = [f for f in frames if not START <= f.captured_at < START + 1.0]
    assert quiet == [f for f in true_frames() if not START <= f.captured_at < START + 1.0]
    assert any(
        not same(true_pose(frame.captured_at), pose_of(frame))
        for frame in frames
        if START <= frame.captured_at < START + 1.0
    )


def test_no_frames_come_while_it_is_off() -> None:
    times = [frame.captured_at for frame in told(f"mocap:off@{START}s+0.8s")]
    assert [t for t in times if START <= t < START + 0.8] == []
    assert len(times) == 400 - 80


@pytest.mark.parametrize("size", [0.3, 1.0, 3.0])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_jump_that_stays_has_the_size_that_was_asked_for(size: float, seed: int) -> None:
    """F04 is the same for three samples."""
    shifts = [off(true, lie) for _, true, lie in pairs(told(f"mocap:wrong@{START}s={size}#{seed}"))]
    assert len(shifts) == 200
    assert all(hypot(x, y) == pytest.approx(size) and z == 0.0 for x, y, z in shifts)
    assert np.std(shifts, axis=0) == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)


def test_a_spike_lasts_three_frames() -> None:
    frames = told("F04@2s")
    lies = [f for f in frames if not same(true_pose(f.captured_at), pose_of(f))]
    assert [f.number for f in lies] == [200, 201, 202]


@pytest.mark.parametrize(("gap", "offset"), [(0.3, 0.3), (0.8, 0.4), (1.9, 1.0)])
def test_a_gap_is_followed_by_another_place(gap: float, offset: float) -> None:
    frames = told(f"F05/gap{gap:g}s_{offset:g}m@{START}s", seconds=5.0)
    seen = pairs(frames)
    assert seen[0][0] == pytest.approx(START + gap, abs=1.5 * PERIOD)
    assert all(hypot(*off(true, lie)[:2]) == pytest.approx(offset) for _, true, lie in seen)


@pytest.mark.parametrize("axis", ["x", "y", "z"])
@given(size=SIZES)
def test_an_axis_is_shifted_alone(axis: str, size: float) -> None:
    for _, true, lie in pairs(told(f"mocap.{axis}:wrong@{START}s={size}"))[::50]:
        wanted = tuple(size if name == axis else 0.0 for name in "xyz")
        assert off(true, lie) == pytest.approx(wanted)


@pytest.mark.parametrize("speed", [0.02, 0.05])
def test_a_drift_grows_from_nothing_at_its_speed(speed: float) -> None:
    for at, true, lie in pairs(told(f"mocap.drift:wrong@{START}s={speed}")):
        assert hypot(*off(true, lie)[:2]) == pytest.approx(speed * (at - START), abs=1e-9)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_drift_along_an_axis_stays_on_it(axis: int) -> None:
    at, true, lie = pairs(told(f"mocap.drift_{'xyz'[axis]}:wrong@{START}s=-0.1"))[-1]
    wanted = [0.0, 0.0, 0.0]
    wanted[axis] = -0.1 * (at - START)
    assert off(true, lie) == pytest.approx(wanted)


def test_steps_come_once_a_second() -> None:
    seen = pairs(told(f"mocap.steps:wrong@{START}s=0.14"))
    sizes = [round(hypot(*off(true, lie)[:2]), 6) for _, true, lie in seen]
    assert sizes[:100] == [0.14] * 100
    assert sizes[100:] == [0.28] * 100


@given(angle=ANGLES)
def test_a_turned_body_is_off_by_its_angle_about_its_own_axis(angle: float) -> None:
    for _, true, lie in pairs(told(f"mocap.yaw:wrong@{START}s={angle}", seconds=2.3))[::10]:
        assert lie.position == true.position
        turned = rotate(lie.orientation, (1.0, 0.0, 0.0))
        wanted = rotate(true.orientation, (cos(angle), sin(angle), 0.0))
        assert turned == pytest.approx(wanted, abs=1e-6)
        up = (0.0, 0.0, 1.0)
        assert rotate(lie.orientation, up) == pytest.approx(rotate(true.orientation, up), abs=1e-6)


def test_a_mirrored_map_turns_left_into_right_and_keeps_the_pad() -> None:
    for _, true, lie in pairs(told("mocap.map:wrong")):
        x, y, z = true.position
        assert lie.position == pytest.approx((x, 2.0 * PAD[1] - y, z))
        assert lie.yaw == pytest.approx(wrap_angle(-true.yaw))
        w = lie.orientation
        assert normalized(w) == pytest.approx(w)


def test_mirrored_axes_leave_the_heading_true() -> None:
    for _, true, lie in pairs(told("mocap.axes:wrong")):
        assert lie.position[1] == pytest.approx(2.0 * PAD[1] - true.position[1])
        assert lie.orientation == true.orientation


@given(angle=ANGLES)
def test_a_turned_map_turns_places_and_headings_about_the_pad(angle: float) -> None:
    for _, true, lie in pairs(told(f"mocap.map_yaw:wrong={angle}", seconds=2.3))[::10]:
        before = complex(true.position[0] - PAD[0], true.position[1] - PAD[1])
        after = complex(lie.position[0] - PAD[0], lie.position[1] - PAD[1])
        assert abs(after - before * complex(cos(angle), sin(angle))) < 1e-6
        assert wrap_angle(lie.yaw - true.yaw - angle) == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_shifted_origin_shifts_every_body(axis: int) -> None:
    wanted = [0.0, 0.0, 0.0]
    wanted[axis] = 0.5
    for frame in told(f"mocap.origin_{'xyz'[axis]}:wrong=0.5"):
        assert off(true_pose(frame.captured_at), pose_of(frame)) == pytest.approx(wanted)
        assert off(AT_DOOR, pose_of(frame, VISITOR)) == pytest.approx(wanted)


def test_exchanged_bodies_bear_each_others_names() -> None:
    for frame in told("mocap.bodies:wrong"):
        assert pose_of(frame) == AT_DOOR
        assert pose_of(frame, VISITOR) == true_pose(frame.captured_at)


def test_a_drone_alone_cannot_be_exchanged() -> None:
    stream = MocapStream(DRONE, 100.0)
    frame = MocapFrame(0, 0.0, 0.0, ((DRONE, true_pose(0.0)),))
    schedule = FaultSchedule(parse_fault("F06"))
    assert stream.passed((frame,), schedule, 0.0) == (frame,)


def test_frozen_poses_have_fresh_stamps_and_numbers() -> None:
    frozen = [f for f in told(f"mocap:stuck@{START}s+1s") if START <= f.captured_at < START + 1.0]
    assert len(frozen) == 100
    assert {frame.bodies for frame in frozen} == {frozen[0].bodies}
    assert len({frame.captured_at for frame in frozen}) == 100
    assert [frame.number for frame in frozen] == list(range(200, 300))


def test_garbage_is_no_numbers_or_no_rotation() -> None:
    assert all(isnan(lie.position[0]) for _, _, lie in pairs(told(f"mocap:garbage@{START}s")))
    for _, _, lie in pairs(told(f"mocap.orientation:garbage@{START}s")):
        assert abs(hypot(*lie.orientation) - 1.0) > 0.3


@pytest.mark.parametrize("rate", [5.0, 10.0, 30.0])
def test_a_slow_system_gives_as_many_frames_as_it_says(rate: float) -> None:
    assert len(pairs(told(f"mocap:slow@{START}s={rate}"))) == pytest.approx(2.0 * rate, abs=1)


def test_lost_frames_are_a_share_of_all() -> None:
    assert len(pairs(told(f"mocap:intermittent@{START}s=0.3"))) == pytest.approx(140, abs=25)


@pytest.mark.parametrize("latency", [0.1, 0.3])
def test_late_frames_say_how_late_they_are_or_hide_it(latency: float) -> None:
    honest = told(f"mocap:delayed@{START}s={latency}")
    for frame in honest:
        late = latency if frame.captured_at >= START else 0.0
        assert frame.due_at - frame.captured_at == pytest.approx(0.02 + late)
        assert same(pose_of(frame), true_pose(frame.captured_at))
    for frame in told(f"mocap.latency:wrong@{START}s={latency}"):
        assert frame.due_at - frame.captured_at == pytest.approx(0.02)
        lied = frame.number >= round(START / PERIOD)
        assert same(pose_of(frame), true_pose(frame.captured_at - latency * lied))


def test_frames_stay_in_order_when_a_delay_ends() -> None:
    frames = told(f"mocap:delayed@{START}s+1s=0.5")
    assert [frame.number for frame in frames] == list(range(400))
    assert [f.due_at for f in frames] == sorted(f.due_at for f in frames)


def test_stamps_are_shifted_doubled_or_mixed_up() -> None:
    backward = [f for f in told(f"mocap.stamp:wrong@{START}s=-0.3") if f.due_at >= START + 0.02]
    assert all(f.due_at - f.captured_at == pytest.approx(0.32) for f in backward)
    future = [f for f in told(f"mocap.stamp:wrong@{START}s=0.5") if f.due_at >= START + 0.02]
    assert all(f.captured_at > f.due_at for f in future)
    doubled = [f for f in told(f"mocap.stamp:stuck@{START}s") if f.due_at >= START + 0.02]
    assert {(f.captured_at, f.number) for f in doubled} == {(doubled[0].captured_at, 200)}
    mixed = [f.captured_at for f in told(f"mocap.stamp:garbage@{START}s")]
    assert any(later < earlier for earlier, later in pairwise(mixed))


LIES: tuple[Callable[[float], str], ...] = tuple(
    (lambda size, text=text: text.format(size=size))
    for text in ("mocap:wrong@1s={size}", "mocap.drift:wrong@1s={size}", "mocap:slow@1s=7")
)


@given(st.integers(1, 10**6), st.floats(0.01, 1.0), st.sampled_from(LIES))
def test_the_same_seed_tells_the_same_lies(
    seed: int, size: float, lie: Callable[[float], str]
) -> None:
    text = f"{lie(size)}#{seed}"
    loss = f"mocap:intermittent@1s=0.5#{seed}"
    assert told(text, loss, seconds=1.5) == told(text, loss, seconds=1.5)


@pytest.mark.parametrize("rate", [10.0, 30.0, 100.0])
def test_frames_of_the_real_maker_are_lied_about_at_every_rate(rate: float) -> None:
    site = changed(Site(), twin__mocap_rate_hz=rate, twin__mocap_noise=0.0)
    maker, stream = FrameMaker(site, np.random.default_rng(1)), MocapStream(DRONE, rate)
    schedule = FaultSchedule(parse_fault(f"mocap.yaw:wrong@1s={pi / 2}"))
    told_yaws = []
    for tick in range(600):
        now = tick * 0.005
        if maker.is_due(now):
            maker.expose(now, ((DRONE, Pose((0.0, 0.0, 1.0))),))
        for frame in stream.passed(maker.due_frames(now), schedule, now):
            told_yaws.append((frame.captured_at, pose_of(frame).yaw))
    assert all(yaw == pytest.approx(pi / 2 * (at >= 1.0)) for at, yaw in told_yaws)
    assert len(told_yaws) == pytest.approx(3.0 * rate, abs=5)
