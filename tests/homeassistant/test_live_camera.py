"""A picture is sent in flight only, in a mode that records, and never more than the console has."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from io import BytesIO

import numpy as np
import pytest
from filming import SIZE, video
from numpy.typing import NDArray
from PIL import Image

from housefly.clock import SteppedClock
from housefly.config.house_mode import HouseMode
from housefly.config.tasks import PrivacyZone, TasksConfig
from housefly.evidence.frame_blanker import BLANK
from housefly.homeassistant.jpeg import MAX_PICTURE, jpeg_of
from housefly.homeassistant.live_camera import LiveCamera
from housefly.messages import (
    LEVEL,
    Action,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    Outputs,
    Phase,
    PilotStep,
    Telemetry,
    VideoFrame,
)

ZONE = PrivacyZone(name="bed", polygon=((5, -2), (7, -2), (7, 2), (5, 2)), z_min=0.0, z_max=1.0)
IN_ZONE = (slice(100, 125), slice(80, 240))
FRAMES = tuple(video(4.0))


def step_at(at: float, phase: Phase, pose_age: float = 0.0) -> PilotStep:
    estimate = Estimate(at, (0.0, 0.0, 1.0), (0.0, 0.0, 0.0), 0.0, pose_age, 0.01)
    report = Telemetry(at, DroneStatus.FLYING, 0.9)
    outputs = Outputs(Command(Action.HOVER, LEVEL), estimate=estimate, phase=phase)
    return PilotStep(1, at, Inputs(telemetry=report), outputs)


class Watcher:
    """A camera with its own time, and the pictures that it sent."""

    def __init__(self, zones: tuple[PrivacyZone, ...] = ()) -> None:
        self.mode: HouseMode | None = HouseMode.HOME
        self.clock = SteppedClock(99.0)
        config = TasksConfig(privacy_zones=zones)
        self.sent: list[bytes] = []
        show = self.sent.append
        self.camera = LiveCamera(config, None, lambda: self.mode, show, self.clock)

    def watch(
        self,
        frames: Iterable[VideoFrame] = FRAMES,
        phase: Phase = Phase.LOOKING,
        pose_age: float = 0.0,
    ) -> list[NDArray[np.uint8]]:
        self.sent.clear()
        for frame in frames:
            self.clock.advance(frame.received_at - self.clock.now())
            self.camera.add_step(step_at(frame.received_at, phase, pose_age))
            self.camera.add_frame(frame)
        return [np.asarray(Image.open(BytesIO(picture))) for picture in self.sent]


def is_blank(part: NDArray[np.uint8]) -> bool:
    return bool(np.abs(part.astype(int) - BLANK).max() < 25)


def test_in_flight_key_frames_are_shown_at_most_twice_a_second() -> None:
    shown = Watcher().watch()
    assert [picture.shape[:2] for picture in shown] == [SIZE[::-1]] * 4
    assert not any(is_blank(picture) for picture in shown)
    every = [replace(frame, keyframe=True) for frame in video(4.0, group=1)]
    assert len(Watcher().watch(every)) <= 9


@pytest.mark.parametrize("mode", [None, HouseMode.PRIVACY, HouseMode.MAINTENANCE])
def test_nothing_is_shown_in_a_mode_that_records_nothing_or_that_nobody_knows(
    mode: HouseMode | None,
) -> None:
    watcher = Watcher()
    watcher.mode = mode
    assert watcher.watch() == []
    watcher.camera.look_at_end()
    assert watcher.sent == [], "what was never shown needs no blank picture"


def test_nothing_is_shown_on_the_ground() -> None:
    assert Watcher().watch(phase=Phase.IDLE) == []


def test_zones_are_blank_and_all_is_while_the_pose_is_not_known() -> None:
    shown = Watcher((ZONE,)).watch()
    assert len(shown) == 4 and is_blank(shown[0]), "nobody knew the pose before the first frame"
    assert all(is_blank(picture[IN_ZONE]) for picture in shown)
    assert all(not is_blank(picture[:60]) for picture in shown[1:])
    assert all(is_blank(picture) for picture in Watcher((ZONE,)).watch(pose_age=1.0))


def test_the_last_picture_of_a_flight_is_replaced_by_a_blank_one_once() -> None:
    for ends in ("landed", "privacy", "silent"):
        watcher = Watcher()
        assert watcher.watch()
        shown = len(watcher.sent)
        watcher.camera.look_at_end()
        assert len(watcher.sent) == shown, "it still flies"
        match ends:
            case "landed":
                watcher.camera.add_step(step_at(105.0, Phase.IDLE))
            case "privacy":
                watcher.mode = HouseMode.PRIVACY
            case "silent":
                watcher.clock.advance(5.0)
        for _ in range(3):
            watcher.camera.look_at_end()
        assert len(watcher.sent) == shown + 1
        assert is_blank(np.asarray(Image.open(BytesIO(watcher.sent[-1]))))


def test_no_picture_is_longer_than_a_broker_takes() -> None:
    noise = np.random.default_rng(1).integers(0, 255, (1080, 1920, 3), dtype=np.uint8)
    assert len(jpeg_of(noise)) <= MAX_PICTURE
    assert 0 < len(jpeg_of(np.full((360, 640, 3), 90, np.uint8))) <= MAX_PICTURE
