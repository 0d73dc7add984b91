"""What a tracking system said in a few seconds, told in words."""

from __future__ import annotations

import asyncio

import pytest
from tracking_bench import Bench

from housefly.app.new_site.live import hear_tracking
from housefly.clock import RealClock
from housefly.config.tracking import TrackingConfig
from housefly.messages.words import UNSAID
from housefly.room.draft.model import DraftTracking
from housefly.tracking.counts import UNIT_QUESTION, FrameCounts
from housefly.tracking.live_check import Heard, HeardBody, heard_from, heard_words
from housefly.tracking.vicon import ViconTracker
from housefly.twin.mocap.vicon_server import ViconServer

pytestmark = pytest.mark.wire


async def test_bodies_and_rate_are_heard_as_they_are(loopback: str) -> None:
    server = ViconServer(loopback, 8010, 50.0)
    await server.start()
    async with Bench.running(Bench.feed(server, 50.0)):
        tracking = DraftTracking("vicon", loopback, 8010)
        heard = await asyncio.to_thread(hear_tracking, tracking, 1.0)
    await server.stop()
    assert heard.rate_hz == pytest.approx(50.0, rel=0.5)
    assert [body.name for body in heard.bodies] == ["ardrone", "visitor"]
    drone = heard.body("ardrone")
    assert drone is not None and drone.is_still
    assert drone.position == pytest.approx(Bench.DRONE.position, abs=1e-6)
    told = heard_words(heard, "ardrone")
    assert "frames a second" in told[0] and loopback in told[0]
    assert not any("not among them" in line for line in told)
    assert "'cf1' is not among them (seen: 'ardrone', 'visitor')" in " ".join(
        heard_words(heard, "cf1")
    )


async def test_a_system_that_does_not_answer_is_told_with_what_to_look_for(loopback: str) -> None:
    config = TrackingConfig(address=loopback)
    heard = await heard_from(ViconTracker(config), RealClock(), 0.2, "vicon", patience=0.5)
    assert heard.rate_hz == 0.0 and heard.bodies == ()
    assert "nobody answers" in heard_words(heard, "ardrone")[0]


async def test_a_server_without_bodies_says_so(loopback: str) -> None:
    server = ViconServer(loopback, 8010, 50.0)
    await server.start()
    async with Bench.running(Bench.feed(server, 50.0, drone=None)):
        config = TrackingConfig(address=loopback)
        heard = await heard_from(ViconTracker(config), RealClock(), 0.3)
    await server.stop()
    assert "seen: 'visitor'" in heard_words(heard, "ardrone")[-1]


def test_poses_in_millimetres_are_asked_about_and_markers_are_not() -> None:
    far = Heard(
        "vrpn", 100.0, (HeardBody("ardrone", (400.0, 300.0, 50.0), 0.0, 100.0, 0.0),), UNSAID
    )
    assert UNIT_QUESTION in heard_words(far, "ardrone")[-1]
    counts = FrameCounts()
    counts.refuse("ardrone", (3200.0, 0.0, 0.0), 1.0)
    refused = Heard("vrpn", 100.0, (), counts.unit_problem(1.0))
    told = " ".join(heard_words(refused, "ardrone"))
    assert UNIT_QUESTION in told and "uncover" not in told
