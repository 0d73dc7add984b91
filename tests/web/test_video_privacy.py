"""Privacy zones are blank in the live picture of every browser."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import replace
from math import pi

import av
import numpy as np
import pytest
from filming import SIZE, number_of, video
from numpy.typing import NDArray

from housefly.bus.local import LocalBus
from housefly.bus.topics import DroneTopics
from housefly.config.house_mode import HouseMode
from housefly.config.tasks import PrivacyZone, TasksConfig
from housefly.evidence.frame_blanker import BLANK
from housefly.evidence.live_blanker import LiveBlanker
from housefly.messages import (
    LEVEL,
    Action,
    Command,
    DroneStatus,
    Estimate,
    Inputs,
    Outputs,
    PilotStep,
    Telemetry,
    VideoFrame,
)
from housefly.web.camera.video import FRAME_HEADER, VideoRelay

TOPICS = DroneTopics()

ZONE = PrivacyZone(name="bed", polygon=((5, -2), (7, -2), (7, 2), (5, 2)), z_min=0.0, z_max=1.0)
IN_ZONE = (slice(100, 125), slice(80, 240))


def step_at(at: float, pose_age: float = 0.0, yaw: float = 0.0) -> PilotStep:
    estimate = Estimate(at, (0.0, 0.0, 1.0), (0.0, 0.0, 0.0), yaw, pose_age, 0.01)
    report = Telemetry(at, DroneStatus.FLYING, 0.9)
    outputs = Outputs(Command(Action.HOVER, LEVEL), estimate=estimate)
    return PilotStep(1, at, Inputs(telemetry=report), outputs)


async def watched(
    zones: tuple[PrivacyZone, ...],
    mode: Callable[[], HouseMode | None] = lambda: None,
    pose_age: float = 0.0,
    frames: tuple[VideoFrame, ...] = tuple(video(2.0)),
    yaw: Callable[[float], float] = lambda at: 0.0,
) -> list[NDArray[np.uint8]]:
    """Return what a browser sees of two seconds of video."""
    bus = LocalBus()
    relay = VideoRelay(bus, LiveBlanker(TasksConfig(privacy_zones=zones), None), mode)
    relay.listen(asyncio.get_running_loop())
    messages: list[bytes] = []
    with relay.subscribed() as queue:
        for frame in frames:
            at = frame.received_at
            bus.publish(TOPICS.step, step_at(at, pose_age, yaw(at)))
            bus.publish(TOPICS.video, frame)
            await asyncio.sleep(0)
            while (message := queue.next()) is not None:
                queue.acknowledge()
                messages.append(message)
    decoder = av.CodecContext.create("h264", "r")
    decoder.thread_count = 1
    packets = [av.Packet(message[FRAME_HEADER.size :]) for message in messages] + [None]
    shown = [frame for packet in packets for frame in decoder.decode(packet)]
    return [frame.to_ndarray(format="rgb24") for frame in shown]


def is_blank(part: NDArray[np.uint8]) -> bool:
    return bool(np.abs(part.astype(int) - BLANK).max() < 25)


async def test_a_zone_is_blank_as_soon_as_the_pose_is_known_and_before_everything_is() -> None:
    shown = await watched((ZONE,))
    assert len(shown) == 30
    assert is_blank(shown[0])
    assert all(is_blank(picture[IN_ZONE]) for picture in shown)
    assert all(not is_blank(picture[:60]) for picture in shown[10:])


async def test_while_tracking_is_lost_everything_is_blank() -> None:
    assert all(is_blank(picture) for picture in await watched((ZONE,), pose_age=1.0))


async def test_without_zones_the_picture_is_the_drones_own() -> None:
    shown = await watched(())
    assert [number_of(picture) for picture in shown] == list(range(30))


@pytest.mark.parametrize(
    ("mode", "blank"), [(HouseMode.HOME, False), (HouseMode.NIGHT, True), (None, True)]
)
async def test_a_zone_of_one_mode_counts_then_and_while_the_mode_is_unknown(
    mode: HouseMode | None, blank: bool
) -> None:
    zone = ZONE.model_copy(update={"modes": ("night",)})
    shown = await watched((zone,), lambda: mode)
    assert len(shown) == 30
    assert all(is_blank(picture[IN_ZONE]) is blank for picture in shown)


async def test_in_mode_privacy_nothing_is_shown_until_another_mode_is_told() -> None:
    """That nobody tells the mode while the tasks are started again opens nothing."""
    told = iter(
        [HouseMode.HOME] * 3 + [HouseMode.PRIVACY] * 5 + [None] * 10 + [HouseMode.HOME] * 12
    )
    shown = await watched((), lambda: next(told))
    assert [number_of(picture) for picture in shown] == [0, 1, 2]


async def test_after_privacy_the_picture_goes_on_with_a_key_frame() -> None:
    told = iter([HouseMode.PRIVACY] * 5 + [HouseMode.HOME] * 25)
    shown = await watched((), lambda: next(told))
    assert [number_of(picture) for picture in shown] == list(range(15, 30))


async def test_after_a_lost_frame_nothing_is_shown_until_the_next_key_frame() -> None:
    """What is decoded after a gap shows parts of an older picture, where no zone was."""
    frames = tuple(frame for frame in video(2.0) if frame.sequence != 4)
    shown = await watched((ZONE,), frames=frames)
    assert len(shown) == 4 + 15
    assert shown[0].shape == (*SIZE[::-1], 3)


@pytest.mark.parametrize("is_late", [False, True])
async def test_pictures_that_come_late_are_blank_where_the_zone_was_when_they_were_taken(
    is_late: bool,
) -> None:
    """The drone turns its back on the zone; the wire then holds its pictures up more and more."""
    prompt = list(video(2.0))
    begin, turned = prompt[0].received_at, prompt[8].received_at
    taken = [
        min(one.received_at, turned + 1e-3 * n) if is_late else one.received_at
        for n, one in enumerate(prompt)
    ]
    frames = tuple(
        replace(one, drone_time=50.0 + at - begin) for one, at in zip(prompt, taken, strict=True)
    )
    shown = await watched((ZONE,), frames=frames, yaw=lambda at: pi * (at > turned))
    blank = [is_blank(picture[IN_ZONE]) for picture in shown]
    assert all(blank[:9])
    assert blank[16:] == [is_late] * 14
