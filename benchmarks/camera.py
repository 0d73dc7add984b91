"""The drone's camera: what a picture costs, with which smoothing, and what the whole child takes at
30 pictures a second.
"""

from __future__ import annotations

import asyncio
import os
import statistics
import time
from math import cos, pi, sin

os.environ.setdefault("MUJOCO_GL", "egl")
os.environ.setdefault("LP_NUM_THREADS", "0")

import psutil

from housefly.config.site import Site
from housefly.geometry import quaternion_from_euler
from housefly.messages import Pose
from housefly.room.files import load_room
from housefly.room.mjcf import room_to_mjcf
from housefly.twin.camera.encoder import Encoder
from housefly.twin.camera.messages import PictureRequest
from housefly.twin.camera.process import CameraProcess
from housefly.twin.camera.view import SUPERSAMPLING, CameraView
from housefly.twin.contracts import DroneCamera, EncodedPicture
from housefly.twin.quadrotor.body import PICTURE_SIZE, drone_body

RATE_HZ = 30.0
PICTURES = 240
ROOM = load_room("bsen")
SCENE = room_to_mjcf(ROOM, bodies=drone_body(Site().drone, ROOM.home, ROOM.home_yaw))


def pose(turn: float) -> Pose:
    """A round trip while turning once, at a flight's pace; turn goes from 0 to 1."""
    x_min, y_min, x_max, y_max = ROOM.bounds
    x = (x_min + x_max) / 2 + 0.35 * (x_max - x_min) * cos(2 * pi * turn)
    y = (y_min + y_max) / 2 + 0.15 * (y_max - y_min) * sin(2 * pi * turn)
    return Pose((x, y, 1.1), quaternion_from_euler(0.0, 0.0, 2 * pi * turn))


def cost(supersampling: float, samples: int) -> tuple[float, float]:
    """Return processor time [s] of rendering and of encoding one picture."""
    view, encoder = (
        CameraView(SCENE, *PICTURE_SIZE, supersampling=supersampling, samples=samples),
        Encoder(*PICTURE_SIZE, RATE_HZ),
    )
    requests = [
        PictureRequest(pose(n / PICTURES), True, DroneCamera.FRONT, n / RATE_HZ)
        for n in range(PICTURES)
    ]
    encoder.encode(view.picture(requests[0]))
    rendering = encoding = 0.0
    for request in requests:
        start = time.process_time()
        picture = view.picture(request)
        middle = time.process_time()
        encoder.encode(picture)
        rendering, encoding = rendering + middle - start, encoding + time.process_time() - middle
    return rendering / PICTURES, encoding / PICTURES


async def whole_child(name: str, flight: float) -> str:
    """Run the child as the twin does, along this much of the flight, and return a table row."""
    camera = CameraProcess(Site(), ROOM)
    pictures: list[EncodedPicture] = []
    delays: list[float] = []
    asked: dict[float, float] = {}

    def take(picture: EncodedPicture) -> None:
        pictures.append(picture)
        delays.append(time.monotonic() - asked[picture.at])

    camera.on_picture(take)
    start = time.monotonic()
    camera.start()
    while not pictures:
        await asyncio.sleep(0.01)
        asked[0.0] = time.monotonic()
        camera.request_picture(pose(0.0), True, DroneCamera.FRONT, 0.0)
    ready = time.monotonic() - start
    child = psutil.Process(camera.pid)
    before = sum(child.cpu_times()[:2])
    pictures.clear()
    delays.clear()
    start = time.monotonic()
    for n in range(PICTURES):
        await asyncio.sleep(start + n / RATE_HZ - time.monotonic())
        at = 1.0 + n / RATE_HZ
        asked[at] = time.monotonic()
        camera.request_picture(pose(flight * n / PICTURES), True, DroneCamera.FRONT, at)
    await asyncio.sleep(0.2)
    seconds = PICTURES / RATE_HZ
    share = (sum(child.cpu_times()[:2]) - before) / seconds
    memory = child.memory_info().rss / 2**20
    camera.close()
    cuts = statistics.quantiles(delays, n=100)
    rate, bits = (
        len(pictures) / seconds,
        8e-6 * sum(len(picture.data) for picture in pictures) / seconds,
    )
    return (
        f"| {name} | {rate:.1f} of {RATE_HZ:.0f} | {share:.2f} | {1e3 * cuts[49]:.0f} ms /"
        f" {1e3 * cuts[98]:.0f} ms | {bits:.2f} Mbit/s | {memory:.0f} MiB | {ready:.2f} s |"
    )


def main() -> None:
    print("### Camera picture, 640 x 360\n")
    print(
        "| smoothing | render | convert and encode | pictures/s possible | cores at 30/s"
        " |\n|---|---|---|---|---|"
    )
    variants = (
        ("none", 1.0, 0),
        (f"rendered {SUPERSAMPLING:g} x larger (used)", SUPERSAMPLING, 0),
        ("MSAA 4", 1.0, 4),
    )
    for name, supersampling, samples in variants:
        rendering, encoding = cost(supersampling, samples)
        both = rendering + encoding
        print(
            f"| {name} | {1e3 * rendering:.1f} ms | {1e3 * encoding:.1f} ms | {1 / both:.0f} |"
            f" {RATE_HZ * both:.2f} |",
            flush=True,
        )
    print("\nProcessor time of one thread, the same flight through the room for each row.\n")
    print(
        "| drone | pictures/s | cores | request to picture p50 / p99 | stream | memory | start to"
        " first picture |"
    )
    print("|---|---|---|---|---|---|---|")
    for name, flight in (("flies", 1.0), ("stands", 0.0)):
        print(asyncio.run(whole_child(name, flight)), flush=True)
    print(
        "\nThe child process as the twin runs it, rendering and encoding; the goal is 0.25 cores."
    )


if __name__ == "__main__":
    main()
