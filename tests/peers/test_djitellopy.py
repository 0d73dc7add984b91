"""PyPI djitellopy, the makers' usual client, flies the simulated Tello and decodes its video."""

from __future__ import annotations

import asyncio
import json
from fractions import Fraction
from math import cos, sin
from pathlib import Path

import av
import numpy as np
import pytest
from tello_ports import tello_ports

from housefly.bus.rate import Rate
from housefly.clock import RealClock
from housefly.config.site import Site, changed
from housefly.room.model import Place, Room
from housefly.twin.contracts import EncodedPicture, FlightState
from housefly.twin.real_time import RealTimeRunner
from housefly.twin.tello.server import TelloServer
from housefly.twin.world import SimulatedWorld

pytestmark = [
    pytest.mark.wire,
    pytest.mark.realtime,
    pytest.mark.slow,
    pytest.mark.interop,
]

HERE = Path(__file__).resolve().parent
PYTHON = HERE.parents[1] / ".venv" / "djitellopy" / "bin" / "python"
PORT = 18889
"""djitellopy takes 8889 of this machine."""
HALL = Room(
    "hall",
    (0.0, 0.0, 12.0, 6.0),
    2.6,
    (),
    (Place("home", (4.0, 3.0), (5.0, 3.0, 1.0)),),
    (),
    (4.0, 3.0),
    0.0,
    None,
)


def pictures() -> list[EncodedPicture]:
    """Return thirty pictures, dark on the left and bright on the right, H.264 in groups of 15."""
    encoder = av.CodecContext.create("libx264", "w")
    encoder.width, encoder.height, encoder.pix_fmt = 960, 720, "yuv420p"
    encoder.time_base = Fraction(1, 30)
    encoder.options = {
        "preset": "ultrafast",
        "tune": "zerolatency",
        "profile": "baseline",
        "x264-params": "keyint=15:min-keyint=15:scenecut=0:repeat-headers=1",
    }
    made: list[EncodedPicture] = []
    for number in range(30):
        image = np.full((720, 960, 3), 20, np.uint8)
        image[:, 480 + number :] = 200
        for packet in encoder.encode(av.VideoFrame.from_ndarray(image, format="rgb24")):
            made.append(EncodedPicture(number, bytes(packet), packet.is_keyframe, 960, 720, 0.0))
    return made


async def film(server: TelloServer) -> None:
    known, rate, number = pictures(), Rate(30.0), 0
    while True:
        await rate.sleep()
        server.publish(known[number % len(known)])
        number += 1


async def test_it_connects_flies_steps_turns_and_sticks_watches_and_lands(loopback: str) -> None:
    if not PYTHON.exists():
        pytest.skip("djitellopy is not installed: make interop")
    world = SimulatedWorld(changed(Site(), drone__kind="tello"), HALL)
    server = TelloServer(world, loopback, port=PORT)
    with tello_ports(alone=True):
        await server.start()
        tasks = [
            asyncio.create_task(work)
            for work in (RealTimeRunner(world, RealClock()).run(), film(server))
        ]
        try:
            client = await asyncio.create_subprocess_exec(
                *(str(PYTHON), str(HERE / "fly_tello.py"), loopback, str(PORT)),
                stdout=asyncio.subprocess.PIPE,
                stderr=asyncio.subprocess.PIPE,
            )
            output, complaints = await asyncio.wait_for(client.communicate(), 120.0)
        finally:
            for task in tasks:
                task.cancel()
            await asyncio.gather(*tasks, return_exceptions=True)
            await server.stop()
    assert client.returncode == 0, complaints.decode()
    seen = json.loads(output)
    assert (seen["battery"], seen["sdk"]) == (100, "20")
    assert {"pitch", "roll", "yaw", "tof", "h", "bat", "time", "agz"} <= set(seen["state"])
    assert 70 <= seen["tof"] <= 130 and 70 <= seen["height"] <= 130
    assert seen["risen"] - seen["tof"] == pytest.approx(30, abs=15)
    assert seen["yaw"] == pytest.approx(90, abs=8)
    assert seen["filmed"], complaints.decode()
    dark, bright = seen["picture"]
    assert dark < 50 < 170 < bright
    assert seen["landed"] and seen["motors_s"] > 10
    assert world.onboard().flight is FlightState.LANDED
    x, y, _ = world.truth().pose.position
    assert x - 4.0 == pytest.approx(0.6, abs=0.3), "60 cm ahead"
    assert y - 3.0 == pytest.approx(-1.2, abs=0.4), "two seconds of 0.6 m/s, to the right of that"
    yaw = world.truth().pose.yaw
    assert (cos(yaw), sin(yaw)) == pytest.approx((0.0, -1.0), abs=0.2)
