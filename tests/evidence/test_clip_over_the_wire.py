"""From the twin's camera over the drone's real video port to a clip that plays."""

from __future__ import annotations

import asyncio
import time
from itertools import pairwise
from math import atan2
from pathlib import Path

import av
import numpy as np
import pytest
from numpy.typing import NDArray

from housefly.clock import RealClock
from housefly.config.house_mode import HouseMode
from housefly.config.site import Site
from housefly.config.tasks import PrivacyZone, TasksConfig
from housefly.drones.ardrone.video import VideoLink
from housefly.evidence.camera_pose import CameraPose
from housefly.evidence.clip_recorder import ClipRecorder
from housefly.evidence.clip_result import ClipOrigin
from housefly.evidence.clip_values import ClipsQuestion, StartClip
from housefly.evidence.frame_blanker import BLANK
from housefly.evidence.zone_projection import ZoneProjector
from housefly.geometry import quaternion_from_euler
from housefly.messages import DroneStatus, Pose, VideoFrame
from housefly.room.files import load_room
from housefly.room.level_camera import LevelCamera
from housefly.twin.ardrone.video_server import VideoServer
from housefly.twin.camera.process import CameraProcess
from housefly.twin.contracts import DroneCamera
from housefly.twin.link_counters import Counters

pytestmark = [pytest.mark.wire, pytest.mark.realtime, pytest.mark.slow]

ROOM = load_room("bsen")
ENTRANCE = ROOM.place("entrance")
RATE_HZ = 15.0
DOOR = PrivacyZone(
    name="door", polygon=((0.0, 3.4), (1.2, 3.4), (1.2, 5.0), (0.0, 5.0)), z_min=0.0, z_max=1.0
)


def looking(turn: float) -> Pose:
    """Return the pose at the entrance's viewpoint, turned from the door [rad]."""
    (x, y), (to_x, to_y, _) = ENTRANCE.viewpoint, ENTRANCE.look_at
    yaw = atan2(to_y - y, to_x - x) + turn
    return Pose((x, y, 1.1), quaternion_from_euler(0.0, 0.0, yaw))


def pictures(path: Path) -> list[NDArray[np.uint8]]:
    with av.open(str(path)) as clip:
        return [frame.to_ndarray(format="rgb24") for frame in clip.decode(video=0)]


async def test_a_clip_of_the_twin_has_the_five_seconds_before_and_the_zone_blank(
    tmp_path: Path, loopback: str
) -> None:
    site = Site()
    site = site.model_copy(update={"twin": site.twin.model_copy(update={"video_rate_hz": RATE_HZ})})
    open_to_all = ClipRecorder(tmp_path / "open", TasksConfig(), site.drone)
    private = ClipRecorder(tmp_path / "private", TasksConfig(privacy_zones=(DOOR,)), site.drone)
    recorders = (open_to_all, private)
    camera, server = CameraProcess(site, ROOM), VideoServer(Counters())
    link = VideoLink(loopback, RealClock())
    frames: list[VideoFrame] = []
    pose = looking(0.3)
    asked_at: list[float] = []

    def received(frame: VideoFrame) -> None:
        frames.append(frame)
        for recorder in recorders:
            recorder.tick(time.monotonic(), time.time(), DroneStatus.FLYING, HouseMode.HOME)
            recorder.add(frame, CameraPose(frame.received_at, pose.position, pose.orientation))

    async def until(seconds: float, turning: bool = True) -> None:
        nonlocal pose
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            pose = looking(0.3 * np.sin(time.monotonic())) if turning else pose
            asked_at.append(time.monotonic())
            camera.request_picture(pose, True, DroneCamera.FRONT, time.monotonic())
            await asyncio.sleep(1 / RATE_HZ)

    camera.on_picture(server.publish)
    link.handlers.append(received)
    await server.start(loopback)
    camera.start()
    link.start()
    try:
        while not frames:  # the renderer needs a moment
            await until(0.2)
        if camera.problem:
            pytest.skip(camera.problem)
        await until(6.5)
        asked = time.monotonic()
        names = [
            recorder.start(StartClip(5.0, "entrance"), ClipOrigin(1)) for recorder in recorders
        ]
        await until(1.0)
        await until(2.0, turning=False)  # however late the last picture is, this was its pose
    finally:
        await link.close()
        camera.close()
        await server.stop()
    for recorder in recorders:
        recorder.stop()
        assert recorder.flush()
    path = open_to_all.index.file(names[0])
    (info,) = open_to_all.index.find(ClipsQuestion(place="entrance")).clips
    before = asked - (info.began_at - time.time() + time.monotonic())
    # Three times as long where the camera is slow.
    assert 5.0 <= before <= 5.0 + 3.0 * 16 / RATE_HZ, "from the last key frame before that"
    with av.open(str(path)) as clip:
        packets = [packet for packet in clip.demux(video=0) if packet.dts is not None]
        assert packets[0].is_keyframe
        assert float(clip.duration or 0) / av.time_base == pytest.approx(info.duration, abs=0.2)
        times = [float(packet.pts * packet.time_base) for packet in packets]
    first = next(
        n for n, f in enumerate(frames) if f.received_at == pytest.approx(asked - before, abs=0.02)
    )
    told = [frame.received_at - frames[first].received_at for frame in frames[first:]]
    assert times == pytest.approx(told, abs=1e-3), "each picture stands when it came"
    assert all(b > a for a, b in pairwise(times))
    assert [picture.shape for picture in pictures(path)] == [(360, 640, 3)] * len(times)
    (blanked,) = private.index.find(ClipsQuestion()).clips
    assert blanked.blanked
    shown = pictures(private.index.file(names[1]))
    assert len(shown) == len(times)
    # Where the door's lower half is in the last picture, whichever of the last poses it shows.
    still = ZoneProjector(
        (DOOR.model_copy(update={"z_min": 0.3, "z_max": 0.6}),), LevelCamera.of(None), 0.0
    )
    last = CameraPose(0.0, pose.position, pose.orientation)
    mask = still.mask((last,), 640, 360).pixels(640, 360)
    assert mask.sum() > 5000
    assert any(picture[:60].std() > 5 for picture in shown), "the rest of the room is seen"
    # One that came too late to know its pose is blank all over, and so is the zone in it.
    assert np.abs(shown[-1][mask].astype(int) - BLANK).mean() < 5
    for recorder in recorders:
        recorder.close()
