"""From a frame's arrival to the pilot: a client in the pilot's own process, and the room's process
with its socket, in turn, in one run.

A Vicon server in a process of its own sends a frame 100 times a second. The pilot's side takes each
sighting off its socket and notes how old it is since the server published it. ``LOAD=4`` adds busy
processes at normal priority.
"""

from __future__ import annotations

import asyncio
import gc
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from _run import percentile, table
from housefly.app.priority import raise_priority
from housefly.app.room_main import RoomTracking
from housefly.bus.endpoint import endpoint_in
from housefly.bus.zenoh_bus import ZenohBus
from housefly.clock import RealClock
from housefly.config.tracking import TrackingConfig
from housefly.messages import Sighting
from housefly.tracking.contracts import Tracker
from housefly.tracking.remote_tracker import RemoteTracker
from housefly.tracking.vicon import ViconTracker
from vicon_latency import ADDRESS, PORT, stamp

SECONDS = float(os.environ.get("SECONDS", "20"))
ROUNDS = int(os.environ.get("ROUNDS", "3"))
LOAD = int(os.environ.get("LOAD", "0"))
RATE_HZ = 100.0
CONFIG = TrackingConfig(address=ADDRESS, port=PORT)


async def ages_of(tracker: Tracker) -> list[float]:
    """Return how old each sighting of the drone was when the pilot's side had it [s]."""
    ages: list[float] = []

    def sink(seen: tuple[Sighting, ...]) -> None:
        ages.append(stamp() - seen[0].pose.position[0])

    task = asyncio.create_task(tracker.run(sink))
    await asyncio.sleep(1.0 + SECONDS)
    task.cancel()
    await asyncio.gather(task, return_exceptions=True)
    return ages[round(RATE_HZ) :]


def pilots_side(socket: str) -> None:
    """Measure as a pilot does, and print the ages."""
    raise_priority()
    gc.freeze()
    tracker: Tracker = RemoteTracker(Path(socket), RealClock()) if socket else ViconTracker(CONFIG)
    print(json.dumps(asyncio.run(ages_of(tracker))))


def room(socket: str) -> None:
    """Be the room's process until killed."""
    raise_priority()
    path = Path(socket)
    with ZenohBus(listen=endpoint_in(path.parent)) as bus:
        asyncio.run(RoomTracking(ViconTracker(CONFIG), bus, path, RealClock()).run())


def measured(way: str, socket: str) -> list[float]:
    """Run a pilot's side in a process of its own and return the ages [s]."""
    command = [sys.executable, __file__, "pilot", socket if way == "room" else ""]
    output = subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout
    return [float(age) for age in json.loads(output)]


def main() -> int:
    """Print both ways; 0 when the room's way is no more than a millisecond slower at p99."""
    ages: dict[str, list[float]] = {"own": [], "room": []}
    here = [sys.executable, __file__]
    started = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(LOAD)]
    serve = [sys.executable, str(Path(__file__).with_name("vicon_latency.py")), "serve", "100"]
    started.append(subprocess.Popen(serve, stdout=subprocess.DEVNULL))
    with tempfile.TemporaryDirectory() as folder:
        socket = str(Path(folder) / "tracking")
        room_process = subprocess.Popen([*here, "room", socket])
        try:
            time.sleep(3.0)
            for _ in range(ROUNDS):
                for way, found in ages.items():
                    found += measured(way, socket)
        finally:
            room_process.terminate()
            room_process.wait()
            for process in started:
                process.kill()
                process.wait()
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    print("### A pose's way to the pilot\n")
    names = {"own": "a client in the pilot's process", "room": "the room's process and its socket"}
    rows = [
        [names[way], len(found), *(f"{1e3 * percentile(found, q):.2f}" for q in (0.5, 0.99, 1.0))]
        for way, found in ages.items()
    ]
    print(table(["way", "frames", "p50 [ms]", "p99 [ms]", "max [ms]"], rows))
    later = percentile(ages["room"], 0.99) - percentile(ages["own"], 0.99)
    print(
        f"\n{ROUNDS} rounds of {SECONDS:.0f} s each in turn at 100 Hz, {LOAD} busy processes, load"
        f" average {os.getloadavg()[0]:.0f}; through the room {1e3 * later:+.2f} ms at p99. All"
        f" processes together took {usage.ru_utime + usage.ru_stime:.1f} s of processor."
    )
    return 0 if later < 0.001 else 1


if __name__ == "__main__":
    match sys.argv[1:]:
        case ["pilot", socket_path]:
            pilots_side(socket_path)
        case ["room", socket_path]:
            room(socket_path)
        case _:
            sys.exit(main())
