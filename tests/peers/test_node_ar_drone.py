"""npm ar-drone and ardrone-autonomy fly the twin by its real ports."""

from __future__ import annotations

from math import hypot

import pytest

from housefly.twin.contracts import FlightState

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]


async def test_ar_drone_takes_off_moves_and_lands_the_twin(twin, run_node):
    (seen,) = await run_node("fly.js", twin.address)

    assert seen["errors"] == []
    assert seen["events"][:3] == ["takeoff", "hovering", "flying"]
    assert seen["events"][-2:] == ["landing", "landed"]
    assert twin.flight is FlightState.LANDED
    assert twin.highest == pytest.approx(seen["altitude"], abs=0.2)
    assert twin.highest > 0.7
    forward, left = twin.displacement
    assert forward > 0.2, "front() flies forward"
    assert twin.turned < -0.3, "clockwise() turns right"
    assert hypot(forward, left) < 4.0


async def test_ar_drone_gets_pictures_and_the_acknowledgement_of_a_setting(twin, run_node):
    (seen,) = await run_node("watch.js", twin.address)

    assert seen["errors"] == []
    assert seen["config"] == "null", "a callback without an error is an acknowledgement"
    assert twin.server.settings.limits.altitude == 2.5
    numbers = [frame[0] for frame in seen["frames"]]
    assert numbers == list(range(numbers[0], numbers[0] + 40))
    assert seen["keyFrames"] >= 2
    assert {tuple(frame[1:]) for frame in seen["frames"]} == {(640, 360, 64)}


async def test_autonomy_closes_its_own_loop_over_our_navdata(twin, run_node):
    (seen,) = await run_node("mission.js", twin.address)

    assert seen["error"] is None
    reached = dict(seen["reached"])
    assert list(reached) == ["takeoff", "altitude", "forward"]
    assert reached["altitude"]["z"] == pytest.approx(1.3, abs=0.15)
    assert reached["forward"]["x"] == pytest.approx(1.0, abs=0.15)
    assert twin.flight is FlightState.LANDED
    assert twin.highest == pytest.approx(1.3, abs=0.3)
    forward, left = twin.displacement
    assert forward == pytest.approx(1.0, abs=0.5)
    assert left == pytest.approx(0.0, abs=0.5)
