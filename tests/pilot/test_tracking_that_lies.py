"""A tracking system that tells untruths with fresh stamps; docs/safety.md names what is noticed and
what is not.

A test that is expected to fail turns the suite red when somebody closes its gap: then change the
    page too.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import hypot
from typing import Any

import pytest

from housefly.messages import Pose, Sighting

Fly = Callable[..., Any]


def lie(flight: Any, told: Callable[[Sighting], Sighting]) -> None:
    """Let the tracking system tell something else from now on."""
    look = flight._look
    flight._look = lambda: tuple(told(sighting) for sighting in look())


def test_frozen_poses_with_fresh_stamps_count_as_no_tracking(fly: Fly) -> None:
    flight = fly()
    flight.depart(6.0)
    here = (flight.body.x, flight.body.y)
    pose = Pose((*here, flight.body.z))
    lie(
        flight,
        lambda sighting: replace(
            sighting, pose=replace(pose, orientation=sighting.pose.orientation)
        ),
    )
    flight.run(3.0)
    assert hypot(flight.body.x - here[0], flight.body.y - here[1]) < 0.6
    assert flight.outputs.reason


@pytest.mark.xfail(strict=True, reason="a tracking system that drifts slowly takes the drone along")
def test_a_drift_of_two_centimetres_a_second_is_noticed(fly: Fly) -> None:
    flight = fly()
    flight.depart(6.0)
    start = flight.now

    def drifted(sighting: Sighting) -> Sighting:
        x, y, z = sighting.pose.position
        return replace(
            sighting,
            pose=replace(sighting.pose, position=(x, y + 0.02 * (sighting.captured_at - start), z)),
        )

    lie(flight, drifted)
    flight.run(30.0)
    assert flight.outputs.reason
