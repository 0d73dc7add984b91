"""Poses of a tracking system whose axes are not the map's."""

from __future__ import annotations

from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.clock import RealClock
from housefly.config.tracking import TrackingConfig
from housefly.geometry import quaternion_from_euler
from housefly.messages import Pose, Sighting
from housefly.numeric import wrapped
from housefly.tracking.map_frame import MapFrame, MapFrameTracker
from housefly.tracking.trackers import tracker_of

ANGLES = st.floats(-pi, pi)


def seen(position=(1.0, 2.0, 3.0), yaw=0.0, body="ardrone") -> Sighting:
    return Sighting(body, Pose(position, quaternion_from_euler(0.0, 0.0, yaw)), 1.0, 1.1)


@given(ANGLES, ANGLES, ANGLES)
def test_headings_turn_with_the_frame_and_the_drones_with_its_nose(yaw, body_yaw, heading):
    frame = MapFrame(TrackingConfig(yaw=yaw, body_yaw=body_yaw))
    drone = frame.on_map(seen(yaw=heading)).pose
    other = frame.on_map(seen(yaw=heading, body="chair")).pose
    assert wrapped(drone.yaw - heading - yaw - body_yaw) == pytest.approx(0.0, abs=1e-6)
    assert wrapped(other.yaw - heading - yaw) == pytest.approx(0.0, abs=1e-6)
    assert drone.orientation[0] >= 0.0


def test_a_quarter_turn_and_an_origin_move_a_place() -> None:
    frame = MapFrame(TrackingConfig(x=10.0, y=20.0, z=-0.5, yaw=pi / 2))
    there = frame.on_map(seen((1.0, 2.0, 3.0)))
    assert there.pose.position == pytest.approx((8.0, 21.0, 2.5))
    assert (there.captured_at, there.received_at) == (1.0, 1.1)


async def test_a_site_without_such_keys_has_the_bare_client_and_others_move_its_sightings() -> None:
    clock = RealClock()
    assert not isinstance(tracker_of(TrackingConfig(), clock), MapFrameTracker)

    class Once:
        connected, problem = True, "none"

        async def run(self, sink) -> None:  # type: ignore[no-untyped-def]
            sink((seen((1.0, 0.0, 0.0)),))

    got: list[Sighting] = []
    tracker = MapFrameTracker(Once(), TrackingConfig(x=2.0))
    await tracker.run(got.extend)
    assert got[0].pose.position == (3.0, 0.0, 0.0)
    assert tracker.connected and tracker.problem == "none"
    assert isinstance(tracker_of(TrackingConfig(x=2.0), clock), MapFrameTracker)
