"""Every pre-flight check can fail, says why and what to do, and refuses only what it must."""

from __future__ import annotations

from dataclasses import replace
from math import inf, nan

import pytest

from housefly.config.airframe import Ability
from housefly.config.limits import LimitsConfig
from housefly.messages import DroneFault, DroneStatus, Estimate, OrderOutcome, Telemetry
from housefly.messages.preflight import FrameCheckState, FramesKnown
from housefly.pilot.behavior.mission import PeopleSilence, VehicleStatus
from housefly.pilot.behavior.preflight import (
    PREFLIGHT_RULES,
    PreflightInputs,
    preflight,
    preflight_refusal,
)
from housefly.pilot.estimation.consistency import TrackingConsistency

TELEMETRY = Telemetry(10.0, DroneStatus.LANDED, 0.9)
VEHICLE = VehicleStatus(
    now=10.0,
    status=DroneStatus.LANDED,
    battery=0.9,
    telemetry_age=0.0,
    estimate=Estimate(10.0, (1.0, 2.0, 0.05), (0.0, 0.0, 0.0), 0.0, 0.02, 0.001),
    landing_forced=False,
    telemetry=TELEMETRY,
    consistency=TrackingConsistency(height_error=0.01),
)
READY = PreflightInputs(VEHICLE, LimitsConfig())


def told(**changes: object) -> PreflightInputs:
    """Return inputs in which the drone says something else."""
    return replace(READY, vehicle=replace(VEHICLE, telemetry=replace(TELEMETRY, **changes)))


def known(**changes: object) -> PreflightInputs:
    """Return inputs in which something else is known of the drone."""
    return replace(READY, vehicle=replace(VEHICLE, **changes))


BROKEN = {
    "drone_answers": known(telemetry_age=inf),
    "drone_landed": known(status=DroneStatus.EMERGENCY),
    "drone_upright": told(phi=3.1),
    "drone_still": told(velocity=(0.3, 0.0, 0.0)),
    "drone_configured": told(configured=False),
    "drone_healthy": told(faults=(DroneFault.MOTORS_PROBLEM,)),
    "charge": known(battery=nan),
    "gauge": known(gauge_stuck=True),
    "tracking": known(estimate=None),
    "tracked_height": known(consistency=TrackingConsistency(height_error=-0.6)),
    "tracked_place": known(consistency=TrackingConsistency(drift=0.2)),
    "stop": replace(READY, stopped=True),
    "take_off_column": replace(READY, take_off_fault="a chair stands 0.3 m away"),
    "settings": told(notes=("the tilt limit is 0.3 rad",)),
    "pad": replace(READY, off_pad=0.5),
    "origin": replace(READY, turned=0.5, origin_confirmed=False),
    "sees_people": known(silence=PeopleSilence(3.2)),
    "abilities": replace(READY, lacks=frozenset({Ability.HOVER})),
    "frames_right": replace(READY, frames=FramesKnown(FrameCheckState.WRONG, "mirrored")),
    "frames_checked": replace(READY, frames=FramesKnown(FrameCheckState.STALE)),
}


def test_a_drone_that_stands_well_is_ready() -> None:
    checks = preflight(READY)
    assert all(check.passed for check in checks)
    assert preflight_refusal(checks) is None


def test_every_check_is_broken_here_once() -> None:
    assert set(BROKEN) == {rule.code for rule in PREFLIGHT_RULES}


@pytest.mark.parametrize("rule", PREFLIGHT_RULES, ids=lambda rule: rule.code)
def test_what_is_wrong_fails_its_own_check_and_refuses_only_where_it_must(rule) -> None:  # type: ignore[no-untyped-def]
    checks = preflight(BROKEN[rule.code])
    assert [check.code for check in checks if not check.passed] == [rule.code]
    refused = preflight_refusal(checks)
    assert (refused is not None) == rule.required
    if refused:
        said = rule.says(BROKEN[rule.code]) or rule.fault
        assert refused.reason.startswith(said) and rule.mend in refused.reason
        assert (refused.outcome is OrderOutcome.BATTERY) == (rule.code == "charge")


def test_who_stands_too_close_is_told_as_people_say_it() -> None:
    refused = preflight_refusal(preflight(BROKEN["take_off_column"]))
    assert refused is not None
    assert refused.reason == "a chair stands 0.3 m away; make room around the drone"


def test_what_the_drone_lacks_is_told_and_keeps_nothing_down() -> None:
    lacking = replace(READY, lacks=frozenset({Ability.HOVER, Ability.VELOCITY, Ability.CAMERA}))
    (told,) = (check for check in preflight(lacking) if check.code == "abilities")
    assert not told.passed and not told.required
    assert told.value == "a hover of its own, its own velocity"
    assert "abilities" not in {check.code for check in preflight(READY)}
