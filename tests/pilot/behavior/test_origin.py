from __future__ import annotations

from dataclasses import replace
from math import nan

import pytest

from housefly.messages import DroneStatus, Estimate
from housefly.pilot.behavior.mission import UNHEARD, VehicleStatus
from housefly.pilot.behavior.origin import (
    PAD_DISTANCE_AGAIN,
    PAD_DISTANCE_MAX,
    PAD_HEADING_MAX,
    OriginMonitor,
)

PAD, HEADING = (1.0, 2.0), 3.0
ON_PAD = Estimate(10.0, (1.0, 2.0, 0.05), (0.0, 0.0, 0.0), HEADING, 0.02, 0.001)
STANDING = replace(UNHEARD, now=10.0, status=DroneStatus.LANDED, estimate=ON_PAD)


def confirmed(*seen: VehicleStatus) -> bool:
    """Return whether the origin is confirmed after a drone was seen so."""
    origin = OriginMonitor(PAD, HEADING)
    for vehicle in seen:
        origin.step(vehicle)
    return origin.confirmed


def tracked(**changes: object) -> VehicleStatus:
    """Return a standing drone that is tracked otherwise."""
    return replace(STANDING, estimate=replace(ON_PAD, **changes))


def test_a_drone_that_stands_on_its_pad_confirms_the_origin_and_may_stand_anywhere_later() -> None:
    assert confirmed(STANDING)
    assert confirmed(STANDING, tracked(position=(5.0, 2.0, 0.05)))


@pytest.mark.parametrize(
    "elsewhere",
    [
        UNHEARD,
        replace(STANDING, estimate=None),
        replace(STANDING, status=DroneStatus.FLYING),
        tracked(position=(1.0 + PAD_DISTANCE_MAX + 0.01, 2.0, 0.05)),
        tracked(position=(nan, 2.0, 0.05)),
        tracked(yaw=HEADING + PAD_HEADING_MAX + 0.01),
        tracked(pose_age=0.3),
    ],
)
def test_who_is_not_seen_on_the_pad_confirms_nothing(elsewhere: VehicleStatus) -> None:
    assert not confirmed(elsewhere)
    assert confirmed(elsewhere, replace(elsewhere, origin_known=True))


def test_a_heading_is_compared_the_short_way_round() -> None:
    assert confirmed(tracked(yaw=HEADING + PAD_HEADING_MAX - 0.01 - 6.283185307))


def test_tracking_that_was_found_lying_has_to_show_the_drone_where_it_stood_on_its_pad() -> None:
    lying = replace(STANDING, status=DroneStatus.FLYING, tracking_disproved=True)
    beside = tracked(position=(1.2, 2.0, 0.05))
    assert not confirmed(STANDING, lying)
    assert not confirmed(STANDING, lying, replace(beside, origin_known=True))
    assert confirmed(STANDING, lying, STANDING)
    assert confirmed(beside, lying, beside)
    near = tracked(position=(1.2 + PAD_DISTANCE_AGAIN - 0.01, 2.0, 0.05))
    far = tracked(position=(1.2 + PAD_DISTANCE_AGAIN + 0.01, 2.0, 0.05))
    assert confirmed(beside, lying, near) and not confirmed(beside, lying, far)
