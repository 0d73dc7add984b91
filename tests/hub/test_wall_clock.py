"""The wall clock set back: the memory goes on, and says so."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.bus.local import LocalBus
from housefly.bus.topics import FRAME_TOPIC
from housefly.hub.api.questions import WhereQuestion
from housefly.hub.hub import Hub
from housefly.hub.wall_clock import WallClock
from housefly.messages import Pose, Sighting, TrackedFrame
from housefly.sites.loaded_site import read_site

TWO_HOURS = 7200.0


def frame(height: float) -> TrackedFrame:
    now = time.monotonic()
    return TrackedFrame((Sighting("ardrone", Pose((2.0, 1.0, height)), now, now),))


@pytest.mark.wire
def test_a_clock_set_back_does_not_freeze_where_things_are(tmp_path: Path) -> None:
    bus = LocalBus()
    hub = Hub(read_site("bsen", hub__store=str(tmp_path / "room.db")), tmp_path, bus.join())
    try:
        bus.publish(FRAME_TOPIC, frame(1.14))
        hub.clock._wall = lambda: time.time() - TWO_HOURS
        time.sleep(0.01)
        bus.publish(FRAME_TOPIC, frame(0.05))
        found = hub._queries.answer(WhereQuestion("ardrone"))
        assert found.position[2] == pytest.approx(0.05)  # type: ignore[union-attr, index]
        problems = [sensor.problem for sensor in hub.status.sensors().sensors]
        assert any("set back by 7200 s" in problem for problem in problems)
    finally:
        hub.close()


@pytest.mark.wire
def test_a_memory_from_the_future_does_not_freeze_it_either(tmp_path: Path) -> None:
    site = read_site("bsen", hub__store=str(tmp_path / "room.db"))
    first = Hub(site, tmp_path, (bus := LocalBus()))
    first.clock._wall = lambda: time.time() + TWO_HOURS
    bus.publish(FRAME_TOPIC, frame(1.14))
    first.memory.flush()
    first.close()
    second = Hub(site, tmp_path, (bus := LocalBus()))
    try:
        bus.publish(FRAME_TOPIC, frame(0.05))
        found = second._queries.answer(WhereQuestion("ardrone"))
        assert found.position[2] == pytest.approx(0.05)  # type: ignore[union-attr, index]
    finally:
        second.close()


@given(st.lists(st.tuples(st.floats(-1e5, 1e5), st.floats(0.0, 100.0)), max_size=30))
def test_time_never_goes_back_and_follows_steps_forward(steps: list[tuple[float, float]]) -> None:
    now = {"wall": 1e9, "monotonic": 50.0}
    clock = WallClock(lambda: now["wall"], lambda: now["monotonic"])
    before = clock.now()
    for jump, passed in steps:
        now["wall"] += jump + passed
        now["monotonic"] += passed
        assert clock.now() >= before
        assert clock.now() >= now["wall"] - 1e-3
        before = clock.now()
