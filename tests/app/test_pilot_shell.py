"""What leaves the pilot's process besides commands."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import pytest

from housefly.app.launcher import Launcher, processes_of
from housefly.app.loaded_site import read_site
from housefly.app.readiness import Readiness
from housefly.app.runtime import new_runtime
from housefly.bus.topics import FRAME_TOPIC, STEP_TOPIC
from housefly.bus.zenoh_bus import ZenohBus
from housefly.messages import PilotStep, Sighting, TrackedFrame

pytestmark = pytest.mark.wire


def test_frames_are_told_as_they_come_and_not_at_the_next_step(
    tmp_path: Path, write_site: Any
) -> None:
    told: list[Sighting] = []
    stepped: list[Sighting] = []
    waited: list[float] = []
    enough = threading.Event()

    def on_frame(frame: TrackedFrame) -> None:
        told.extend(frame.sightings)

    def on_step(step: PilotStep) -> None:
        if told:
            stepped.extend(step.inputs.sightings)
            waited.extend(step.now - sighting.received_at for sighting in step.inputs.sightings)
        if len(stepped) > 200:
            enough.set()

    site = read_site(str(write_site()), hub__enabled=False)
    runtime = new_runtime(site, tmp_path)
    with (
        Launcher(runtime, tmp_path, processes_of(runtime, web=False)),
        ZenohBus(connect=runtime.bus) as bus,
    ):
        assert Readiness(site, bus, web=False, video=False).wait(60.0) == ""
        subscriptions = [bus.subscribe(FRAME_TOPIC, on_frame), bus.subscribe(STEP_TOPIC, on_step)]
        assert enough.wait(30.0)
        for subscription in subscriptions:
            subscription.close()
    missing = [sighting for sighting in stepped if sighting not in told]
    assert len(missing) <= 5, "steps know of frames that were never told"
    assert max(waited) > 0.002, "the pilot steps on its own clock"
