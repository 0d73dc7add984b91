"""Depth images on the bus become obstacles on the bus."""

from __future__ import annotations

import asyncio
from dataclasses import replace
from math import hypot
from pathlib import Path

import numpy as np
import pytest

from housefly.app.depth_service import CAMERA_SILENT_AFTER, REFUSED_IMAGE_SHOWN_FOR, DepthService
from housefly.app.launcher import processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.perception_main import PerceptionProcess
from housefly.bus.codec import from_cdr, to_cdr
from housefly.bus.local import LocalBus
from housefly.bus.topics import DEPTH_TOPIC, OBSTACLE_TOPIC, DroneTopics
from housefly.clock import RealClock, SteppedClock
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.messages import (
    Action,
    Command,
    DepthImage,
    DroneStatus,
    Estimate,
    Inputs,
    Obstacle,
    Outputs,
    PilotStep,
    Pose,
    Telemetry,
)
from housefly.sites.loaded_site import open_site, read_site

TOPICS = DroneTopics()

CAMERAS = [{"name": "depth-1"}]
ALONG_X = (0.5, -0.5, 0.5, -0.5)
"""Orientation of a level camera that looks along the room."""


def board(at: float, seed: int = 0) -> DepthImage:
    """Return an image of an upright board only, 0.6 m wide, two metres before the camera."""
    metres = np.zeros((120, 160))
    metres[30:100, 60:100] = 2.0 + np.random.default_rng(seed).normal(0.0, 0.005, (70, 40))
    data = (1000.0 * metres).astype("<u2").tobytes()
    return DepthImage(
        "depth-1", at, 160, 120, data, 130.0, 130.0, 80.0, 60.0, Pose((5.0, 3.0, 1.1), ALONG_X)
    )


def problems(desk: DepthService) -> list[str]:
    return [report.problem for report in desk.reports() if report.problem]


def site() -> Site:
    return changed(read_site("bsen"), depth_cameras=CAMERAS)


def test_images_become_obstacles_and_what_is_wrong_is_told_for_a_while() -> None:
    bus, clock, heard = LocalBus(), SteppedClock(100.0), list[Obstacle]()
    bus.subscribe(OBSTACLE_TOPIC, heard.append)
    desk = DepthService(open_site(site()), bus, clock)
    assert problems(desk) == ["depth-1: no depth images"]
    for n in range(5):
        clock.advance(0.1)
        bus.publish(DEPTH_TOPIC, from_cdr(DepthImage, to_cdr(board(clock.now() - 0.02, n))))
    assert not problems(desk) and len(heard) == 3
    (report,) = desk.reports()
    assert (report.id, report.connected, report.rate_hz) == ("depth-1", True, pytest.approx(10.0))
    assert hypot(heard[-1].position[0] - 7.0, heard[-1].position[1] - 3.0) < 0.35
    bus.publish(DEPTH_TOPIC, replace(board(clock.now()), source="stranger"))
    bus.publish(DEPTH_TOPIC, board(clock.now() + 3.0))
    assert sorted(words.split(": ")[1] for words in problems(desk)) == [
        "an image from the future",
        "not a depth camera of this site",
    ]
    assert len(heard) == 3
    clock.advance(max(CAMERA_SILENT_AFTER, REFUSED_IMAGE_SHOWN_FOR) + 0.1)
    assert problems(desk) == ["depth-1: no depth images"]
    desk.close()
    bus.publish(DEPTH_TOPIC, board(clock.now()))
    assert len(heard) == 3


async def test_perception_takes_in_images_without_any_scanner_and_leaves_out_the_drone() -> None:
    bus, heard = LocalBus(), list[Obstacle]()
    bus.subscribe(OBSTACLE_TOPIC, heard.append)
    looking = asyncio.create_task(PerceptionProcess(open_site(site()), bus, RealClock()).run())
    flying = Telemetry(0.0, DroneStatus.FLYING, 1.0)
    for place, told in (((7.0, 3.0), False), ((2.0, 3.0), True)):
        estimate = Estimate(0.0, (*place, 1.1), (0.0, 0.0, 0.0), 0.0, 0.0, 0.0)
        await asyncio.sleep(0.01)
        bus.publish(
            TOPICS.step,
            PilotStep(0, 0.0, Inputs(telemetry=flying), Outputs(Command(Action.FLY), estimate)),
        )
        for n in range(4):
            await asyncio.sleep(0.1)
            bus.publish(DEPTH_TOPIC, board(RealClock().now(), n + 10 * told))
        assert bool(heard) == told
    looking.cancel()
    await asyncio.gather(looking, return_exceptions=True)


def test_a_site_without_depth_cameras_listens_to_none() -> None:
    bus = LocalBus()
    desk = DepthService(open_site(read_site("bsen")), bus, SteppedClock(100.0))
    bus.publish(DEPTH_TOPIC, board(100.0))
    assert desk.reports() == ()
    desk.close()


def test_perception_runs_where_there_are_depth_cameras(tmp_path: Path) -> None:
    assert "perception" in [spec.name for spec in processes_of(new_runtime(site(), tmp_path))]


def test_who_looks_for_people_is_as_urgent_as_the_pilot(tmp_path: Path) -> None:
    niceness = {spec.name: spec.niceness for spec in processes_of(new_runtime(site(), tmp_path))}
    assert niceness["perception"] == niceness["pilot"]
    assert niceness["perception"] < min(niceness["hub"], niceness["tasks"])


def test_two_depth_cameras_with_one_name_are_refused() -> None:
    with pytest.raises(ConfigError, match="same name"):
        changed(site(), depth_cameras=CAMERAS * 2)
