"""Tracking latency over the loopback: from the server's publish to our client's sink, with the
genuine SDK client as peer.
"""

from __future__ import annotations

import asyncio
import json
import statistics
import subprocess
import sys
import time

from housefly.config.tracking import TrackingConfig
from housefly.messages import Pose, Sighting
from housefly.tracking.vicon import ViconTracker
from housefly.twin.contracts import MocapFrame
from housefly.twin.mocap.vicon_server import ViconServer

ADDRESS, PORT = "127.77.1.1", 8010
SECONDS = 5.0
EPOCH_STEP = 500.0
"""The publish time travels as x [m] within this period [s], so that it stays within the client's
kilometre.
"""


def stamp() -> float:
    return time.monotonic() % EPOCH_STEP


async def serve(rate_hz: float) -> None:
    server = ViconServer(ADDRESS, PORT, rate_hz)
    await server.start()
    print("ready", flush=True)
    start, number = time.monotonic(), 0
    while True:
        number += 1
        await asyncio.sleep(start + number / rate_hz - time.monotonic())
        bodies = (("ardrone", Pose((stamp(), 0.0, 0.0))), ("visitor", Pose((1.0, 1.0, 0.0))))
        server.publish(MocapFrame(number, number / rate_hz, number / rate_hz, bodies))


async def read_ours() -> list[float]:
    delays: list[float] = []

    def sink(seen: tuple[Sighting, ...]) -> None:
        delays.append(stamp() - seen[0].pose.position[0])

    task = asyncio.create_task(ViconTracker(TrackingConfig(address=ADDRESS, port=PORT)).run(sink))
    await asyncio.sleep(SECONDS)
    task.cancel()
    return delays


def read_genuine() -> list[float]:
    import motioncapture

    client = motioncapture.connect("vicon", {"hostname": f"{ADDRESS}:{PORT}"})
    delays: list[float] = []
    end = time.monotonic() + SECONDS
    while time.monotonic() < end:
        client.waitForNextFrame()
        body = client.rigidBodies.get("ardrone")
        if body is not None:  # the SDK asks for segments only after its first frame
            delays.append(stamp() - float(body.position[0]))
    return delays


def measured(reader: str, rate_hz: float) -> list[float]:
    """Run server and reader in processes of their own and return the delays [s]."""
    here = [sys.executable, __file__]
    with subprocess.Popen([*here, "serve", str(rate_hz)], stdout=subprocess.PIPE) as server:
        assert server.stdout is not None
        server.stdout.readline()
        try:
            output = subprocess.run(
                [*here, reader], stdout=subprocess.PIPE, check=True, timeout=60
            ).stdout
        finally:
            server.kill()
    return [float(delay) for delay in json.loads(output)]


def main() -> None:
    print("### Vicon frame to sighting\n")
    print("| client | rate | frames/s read | p50 | p99 | max |\n|---|---|---|---|---|---|")
    for rate_hz in (100.0, 300.0):
        for reader, name in (("ours", "Housefly"), ("genuine", "Vicon SDK in `motioncapture`")):
            delays = sorted(measured(reader, rate_hz))
            cuts = statistics.quantiles(delays, n=100)
            row = f"{1e3 * cuts[49]:.2f} ms | {1e3 * cuts[98]:.2f} ms | {1e3 * delays[-1]:.2f} ms"
            print(
                f"| {name} | {rate_hz:.0f} Hz | {len(delays) / SECONDS:.1f} | {row} |", flush=True
            )
    print(
        "\nFrom `publish` in the server's process to the pose in the reader's process, loopback,"
        " two bodies, same run."
    )


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["serve", rate]:
            asyncio.run(serve(float(rate)))
        case ["ours"]:
            print(json.dumps(asyncio.run(read_ours())))
        case ["genuine"]:
            print(json.dumps(read_genuine()))
        case _:
            main()
