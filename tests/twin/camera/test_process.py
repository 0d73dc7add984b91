"""The camera process: pictures of the room from a child that may die, hang or fail to render."""

from __future__ import annotations

import asyncio
import os
import signal
import socket
import subprocess
import sys
from collections.abc import AsyncIterator, Callable, Iterator
from contextlib import asynccontextmanager
from dataclasses import replace
from itertools import pairwise
from math import atan2

import av
import numpy as np
import pytest
from numpy.typing import NDArray

from housefly.config.site import Site
from housefly.geometry import Vec2, quaternion_from_euler
from housefly.messages import Pose
from housefly.room.files import load_room
from housefly.twin.camera.process import CameraProcess
from housefly.twin.contracts import DroneCamera, EncodedPicture
from housefly.twin.people import Posture, scene_from_tree
from housefly.twin.people.bodies import body_pose

ROOM = load_room("bsen")
ENTRANCE = ROOM.place("entrance")
SPS, PPS, IDR = 7, 8, 5


def looking(at: Vec2, towards: Vec2) -> Pose:
    return Pose(
        (*at, 1.1), quaternion_from_euler(0.0, 0.0, atan2(towards[1] - at[1], towards[0] - at[0]))
    )


DOOR = looking(ENTRANCE.viewpoint, ENTRANCE.look_at[:2])
BACK = looking(ENTRANCE.look_at[:2], ENTRANCE.viewpoint)


class Filming:
    """A camera at work: what it is to show, and the pictures so far."""

    def __init__(self, camera: CameraProcess) -> None:
        self.camera = camera
        self.pictures: list[EncodedPicture] = []
        self.pose, self.visitor, self.which = DOOR, True, DroneCamera.FRONT
        camera.on_picture(self.pictures.append)

    async def ask(self) -> None:
        at = 0.0
        while True:
            at += 1 / 30
            self.camera.request_picture(self.pose, self.visitor, self.which, at)
            await asyncio.sleep(1 / 30)

    async def until(self, condition: Callable[[], bool], seconds: float = 60.0) -> None:
        async with asyncio.timeout(seconds):
            while not condition():
                await asyncio.sleep(0.005)

    async def more(self, number: int) -> list[EncodedPicture]:
        """Wait for this many pictures asked for from now on, and return them."""
        start = len(self.pictures) + 2
        await self.until(lambda: len(self.pictures) >= start + number)
        return self.pictures[start : start + number]


@asynccontextmanager
async def filming() -> AsyncIterator[Filming]:
    film = Filming(CameraProcess(Site(), ROOM))
    film.camera.start()
    asking = asyncio.create_task(film.ask())
    try:
        yield film
    finally:
        asking.cancel()
        film.camera.close()


def unit_types(data: bytes) -> list[int]:
    """Return the NAL unit types of an Annex B access unit."""
    return [unit[0] & 0x1F for unit in data.replace(b"\0\0\0\1", b"\0\0\1").split(b"\0\0\1")[1:]]


def decoded(pictures: list[EncodedPicture]) -> list[NDArray[np.uint8]]:
    decoder = av.CodecContext.create("h264", "r")
    frames = [frame for picture in pictures for frame in decoder.decode(av.Packet(picture.data))]
    return [frame.to_ndarray(format="rgb24") for frame in [*frames, *decoder.decode(None)]]


@pytest.fixture(autouse=True)
def _any_renderer(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.delenv("HOUSEFLY_RENDERER", raising=False)
    yield


def alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


async def test_pictures_decode_and_every_fifteenth_can_be_started_from() -> None:
    async with filming() as film:
        await film.until(lambda: len(film.pictures) >= 32)
    assert not film.camera.problem
    assert [picture.number for picture in film.pictures] == list(range(1, len(film.pictures) + 1))
    keys = [n for n, picture in enumerate(film.pictures) if picture.keyframe]
    assert keys[:3] == [0, 15, 30]
    for n in keys:
        types = unit_types(film.pictures[n].data)
        assert types[:2] == [SPS, PPS]
        assert types[-1] == IDR
    pictures = decoded(film.pictures)
    assert len(pictures) == len(film.pictures)
    assert pictures[0].shape == (360, 640, 3)
    assert pictures[-1].std() > 20, "a picture of a room is not of one colour"


async def test_the_view_follows_pose_visitor_and_camera() -> None:
    async with filming() as film:
        await film.more(1)
        with_visitor = len(film.pictures)
        film.visitor = False
        await film.more(1)
        without = len(film.pictures)
        film.pose = BACK
        await film.more(1)
        back = len(film.pictures)
        film.pose, film.which = DOOR, DroneCamera.BOTTOM
        await film.more(1)
    views = decoded(film.pictures)
    chosen = [views[n - 1].astype(float) for n in (with_visitor, without, back, len(views))]
    for one, other in pairwise(chosen):
        assert np.abs(one - other).mean() > 5
    red, green, blue = np.moveaxis(chosen[-1], -1, 0)
    assert ((red > green + 10) & (green > blue + 10)).mean() > 0.95, (
        "the bottom camera sees nothing but the wooden floor"
    )


async def test_a_still_view_is_sent_on_at_the_full_rate() -> None:
    async with filming() as film:
        first, *_, last = await film.more(20)
    assert last.number - first.number == 19
    assert last.at > first.at


async def test_the_visitor_at_the_door_wears_red() -> None:
    async with filming() as film:
        await film.more(1)
        there = len(film.pictures)
        film.visitor = False
        await film.more(1)
    views = decoded(film.pictures)

    def red(picture: NDArray[np.uint8]) -> float:
        r, g, b = (picture[..., n].astype(int) for n in range(3))
        return float(((r > 120) & (g < 90) & (b < 90)).mean())

    assert red(views[there - 1]) > 0.05
    assert red(views[-1]) < 0.01


async def test_a_killed_child_is_replaced_and_starts_with_a_key_frame() -> None:
    async with filming() as film:
        await film.more(3)
        first, restarts = film.camera.pid, film.camera.restarts
        assert first is not None
        os.kill(first, signal.SIGKILL)
        await film.until(lambda: film.camera.pid != first)
        before = len(film.pictures)
        await film.until(lambda: len(film.pictures) > before)
        assert film.camera.restarts > restarts  # a busy machine may starve the next one, too
        assert film.pictures[before].keyframe
        assert film.pictures[before].number == before + 1


@pytest.mark.interop
@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="only Linux has a policy for idle time")
async def test_a_child_that_starves_at_idle_priority_is_replaced_by_one_that_competes() -> None:
    async with filming() as film:
        await film.more(1)
        first, restarts = film.camera.pid, film.camera.restarts
        assert first is not None
        if restarts == 0:  # else a busy machine has starved it already
            assert os.sched_getscheduler(first) == os.SCHED_IDLE
            os.kill(first, signal.SIGSTOP)
            await film.until(lambda: film.camera.restarts > restarts)
        await film.more(1)
        assert (
            film.camera.pid is not None and os.sched_getscheduler(film.camera.pid) == os.SCHED_OTHER
        )


@pytest.mark.slow
async def test_a_child_that_hangs_is_replaced_each_time() -> None:
    async with filming() as film:
        for _ in range(2):
            await film.more(1)
            hung, restarts = film.camera.pid, film.camera.restarts
            assert hung is not None
            os.kill(hung, signal.SIGSTOP)
            await film.until(lambda restarts=restarts: film.camera.restarts > restarts)
            await film.more(1)
            await film.until(lambda hung=hung: not alive(hung))


async def test_without_a_renderer_a_card_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOUSEFLY_RENDERER", "none")
    async with filming() as film:
        await film.until(lambda: len(film.pictures) >= 2)
        assert film.camera.problem == "HOUSEFLY_RENDERER=none"
    assert all(picture.keyframe for picture in film.pictures)
    card = decoded(film.pictures)[0]
    assert card.shape == (360, 640, 3)
    assert card.max() > 200
    assert np.median(card) < 60, "light words on a dark ground"


async def test_a_broken_renderer_ends_in_the_card_that_names_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("HOUSEFLY_RENDERER", "egl")
    monkeypatch.setenv("MUJOCO_EGL_DEVICE_ID", "99")
    async with filming() as film:
        await film.until(lambda: len(film.pictures) >= 1)
        assert film.camera.problem.startswith("egl: ")
        assert film.camera.restarts == 0
    assert film.pictures[0].keyframe


async def test_closing_ends_the_child() -> None:
    async with filming() as film:
        await film.more(1)
        pid = film.camera.pid
    assert pid is not None
    await film.until(lambda: not alive(pid))


async def test_a_child_ends_when_its_parent_is_gone() -> None:
    ours, theirs = socket.socketpair()
    with theirs:
        child = subprocess.Popen(
            [sys.executable, "-m", "housefly.twin.camera.child", str(theirs.fileno())],
            pass_fds=[theirs.fileno()],
        )
    ours.close()
    assert await asyncio.to_thread(child.wait, 30) == 0


async def test_asking_never_waits_even_without_a_child() -> None:
    camera = CameraProcess(Site(), ROOM)
    camera.request_picture(DOOR, True, DroneCamera.FRONT, 0.0)
    camera.close()


async def test_somebody_of_a_scene_who_stands_before_the_camera_is_in_the_picture() -> None:
    scene = scene_from_tree(
        {"name": "t", "people": [{"name": "ann", "start": [3.0, 4.2], "steps": []}]}
    )
    camera = CameraProcess(Site(), ROOM, scene.script.people)
    pictures: list[EncodedPicture] = []
    camera.on_picture(pictures.append)
    camera.start()
    try:
        for n, away in enumerate((True, False)):
            person = replace(
                scene.at(0.0).people[0], posture=Posture.AWAY if away else Posture.STANDING
            )
            async with asyncio.timeout(60.0):
                while len(pictures) < 3 * (n + 1):
                    camera.request_picture(
                        looking((5.0, 4.2), (0.0, 4.2)),
                        False,
                        DroneCamera.FRONT,
                        n,
                        (body_pose(person, 1.65),),
                    )
                    await asyncio.sleep(0.03)
    finally:
        camera.close()
    views = decoded(pictures)
    before, after = views[2].astype(float), views[5].astype(float)
    assert np.abs(before - after)[100:, 280:360].mean() > 30.0
    assert np.abs(before - after)[:, :100].mean() < 10.0
