"""A tracking system that tells untruths with fresh stamps, and the drone's own report beside it.

Flights in MuJoCo, scored on the truth, are in ``estimation/test_tracking_monitor.py``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import hypot
from typing import Any

from housefly.messages import DroneStatus, Pose, Sighting

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


def test_a_drift_of_two_centimetres_a_second_is_told_at_ten_and_landed_before_thirty(
    fly: Fly,
) -> None:
    flight = fly(tick=0.01, tracking={"rate_hz": 100.0})
    flight.depart(6.0)
    start = flight.now

    def drift() -> float:
        return 0.02 * (flight.now - start)

    def drifted(sighting: Sighting) -> Sighting:
        x, y, z = sighting.pose.position
        return replace(
            sighting,
            pose=replace(sighting.pose, position=(x, y + 0.02 * (sighting.captured_at - start), z)),
        )

    lie(flight, drifted)
    flight.until(lambda o: "tracking" in o.reason, 6.0)
    assert drift() <= 0.1
    flight.until(lambda o: flight.status is DroneStatus.LANDED, 20.0)
    assert drift() < 0.3
