"""Every fault of tracking is found from noisy samples of a clumsy person, and nothing else is."""

from __future__ import annotations

from math import pi, radians

from carried_drone import PAD_PLAN, Carrier, Lies
from hypothesis import given, settings
from hypothesis import strategies as st

from housefly.config.site import Site, changed
from housefly.lab.frames.findings import FrameFault, FrameVerdict
from housefly.lab.frames.plan import CarryPlan
from housefly.numeric import wrapped

EXAMPLES = 8
SEEDS = st.integers(0, 10_000)
PLANS = st.builds(
    CarryPlan,
    st.tuples(st.floats(-6.0, 6.0), st.floats(-6.0, 6.0)),
    st.floats(-pi, pi),
    st.sampled_from((1.0, -1.0, 1.5, -2.0)),
    st.sampled_from((1.0, -1.0, 0.8)),
)
ANGLES = st.floats(radians(30.0), pi) | st.floats(-pi, -radians(30.0))


def verdict(
    lies: Lies,
    seed: int,
    plan: CarryPlan = PAD_PLAN,
    *,
    clumsiness: float = 1.0,
    **tracking: object,
) -> FrameVerdict:
    config = changed(Site(), **{f"tracking__{k}": v for k, v in tracking.items()}).tracking
    return Carrier(plan, config, lies, seed, clumsiness).do_all().verdict()


def is_mended(lies: Lies, seed: int, plan: CarryPlan) -> bool:
    """Return whether the lines that a careful person is told mend it."""
    told = verdict(lies, seed, plan, clumsiness=0.5).mended
    return verdict(lies, seed + 1, plan, clumsiness=0.5, **told).passed


def faults(found: FrameVerdict) -> set[FrameFault]:
    return {finding.fault for finding in found.findings}


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS, st.booleans())
def test_honest_tracking_and_a_clumsy_person_pass(plan, seed, onboard):
    guide = Carrier(plan, seed=seed, clumsiness=1.0, onboard=onboard).do_all()
    found = guide.verdict()
    assert found.passed, found.findings
    assert (found.measures.lag is not None) == onboard
    assert bool(found.notes) != onboard


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS, ANGLES)
def test_a_turned_frame_is_found_with_its_angle_and_mended_by_its_lines(plan, seed, angle):
    lies = Lies(rotation=angle)
    found = verdict(lies, seed, plan)
    assert faults(found) == {FrameFault.ROTATED}
    assert found.measures.rotation is not None
    assert abs(wrapped(found.measures.rotation - angle)) < radians(12.0)
    assert is_mended(lies, seed, plan)


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS, ANGLES)
def test_a_body_defined_turned_is_found_and_mended_by_its_line(plan, seed, angle):
    lies = Lies(body_yaw=angle)
    found = verdict(lies, seed, plan)
    assert faults(found) == {FrameFault.BODY_YAW}
    assert set(found.mended) == {"body_yaw"}
    assert is_mended(lies, seed, plan)


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS, ANGLES, ANGLES, st.floats(-5.0, 5.0), st.floats(0.4, 2.0))
def test_turned_frame_turned_body_and_shift_together_are_mended_by_their_lines(
    plan, seed, rotation, body_yaw, x, z
):
    lies = Lies(rotation=rotation, body_yaw=body_yaw, shift=(x, 0.7, z))
    found = verdict(lies, seed, plan)
    assert faults(found) == {
        *(FrameFault.ROTATED, FrameFault.BODY_YAW, FrameFault.ORIGIN, FrameFault.HEIGHT)
    }
    assert is_mended(lies, seed, plan)


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS, st.sampled_from((0.0, pi / 4, pi / 2, 3 * pi / 4)), st.booleans())
def test_mirrored_axes_are_found_whether_or_not_headings_are_mirrored(plan, seed, line, headings):
    found = verdict(Lies(mirror_places=line, mirror_headings=headings), seed, plan)
    expected = {FrameFault.MIRRORED, *([FrameFault.TURN_MIRRORED] if headings else [])}
    assert faults(found) == expected
    words = {0.0: "y runs the wrong", pi / 2: "x runs the wrong"}.get(line, "are exchanged")
    assert words in found.findings[0].words
    assert not found.mended


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS)
def test_headings_alone_mirrored_or_missing_are_found(plan, seed):
    assert faults(verdict(Lies(mirror_headings=True), seed, plan)) == {FrameFault.TURN_MIRRORED}
    assert faults(verdict(Lies(no_heading=True), seed, plan)) == {FrameFault.NO_HEADING}


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS, st.floats(0.4, 3.0) | st.floats(-3.0, -0.4), st.floats(-0.2, 0.2))
def test_a_shifted_origin_and_a_wrong_height_are_found_apart(plan, seed, far, near):
    assert faults(verdict(Lies(shift=(far, near, 0.05)), seed, plan)) == {FrameFault.ORIGIN}
    assert faults(verdict(Lies(shift=(near, 0.0, far)), seed, plan)) == {FrameFault.HEIGHT}


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS, st.sampled_from((1000.0, 100.0, 3.281, 39.37, 0.6, 1.6)))
def test_a_wrong_scale_is_found_with_its_unit(plan, seed, scale):
    carrier = Carrier(plan, lies=Lies(scale=scale), seed=seed, clumsiness=1.0, noise=0.0)
    found = carrier.do_all().verdict()
    assert FrameFault.SCALE in faults(found)
    units = {1000.0: "millimetres", 100.0: "centimetres", 3.281: "feet", 39.37: "inches"}
    scales = [finding for finding in found.findings if finding.fault is FrameFault.SCALE]
    assert units.get(scale, "calibrate") in scales[0].mend


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS, st.floats(0.16, 0.45))
def test_late_tracking_is_measured(plan, seed, lag):
    found = verdict(Lies(lag=lag), seed, plan)
    assert faults(found) == {FrameFault.LATE}
    assert found.measures.lag is not None
    assert abs(found.measures.lag - lag) < 0.03


def test_late_tracking_has_a_line_only_where_the_system_does_not_stamp_its_frames() -> None:
    assert verdict(Lies(lag=0.3), 1, kind="vrpn").mended == {"latency": 0.32}
    assert verdict(Lies(lag=0.3), 1, kind="vicon").mended == {}


@settings(max_examples=EXAMPLES)
@given(PLANS, SEEDS)
def test_an_up_axis_that_is_not_up_is_found_and_its_line_is_the_other_one(plan, seed):
    found = verdict(Lies(up="y"), seed, plan, kind="vrpn")
    assert faults(found) == {FrameFault.UP_AXIS}
    assert 'up_axis = "y"' in found.findings[0].mend
    found = verdict(Lies(up="-y"), seed, plan, kind="natnet")
    assert 'up_axis = "z"' in found.findings[0].mend
    found = verdict(Lies(up="-y"), seed, plan, kind="vrpn")
    assert faults(found) == {FrameFault.UP_AXIS} and "up_axis" not in found.findings[0].mend
    assert faults(verdict(Lies(up="down"), seed, plan)) == {FrameFault.UP_AXIS}


def test_a_body_that_stays_where_it_is_does_not_move() -> None:
    found = verdict(Lies(frozen=True), 1)
    assert faults(found) == {FrameFault.NO_MOVEMENT}


def test_another_body_that_is_carried_is_the_drone() -> None:
    found = verdict(Lies(other_name="quad2"), 1)
    assert faults(found) == {FrameFault.WRONG_BODY}
    assert '[tracking] body = "quad2"' in found.findings[0].mend


def test_a_body_that_nobody_sees_is_told() -> None:
    carrier = Carrier(PAD_PLAN, lies=Lies(other_name="ardrone2", frozen=True))
    found = carrier.do_all().verdict()
    assert faults(found) == {FrameFault.NOT_SEEN}
    assert "'ardrone2'" in found.findings[0].words
