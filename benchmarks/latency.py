"""From a Vicon packet, and from STOP, to the AT command: both ends are real sockets, the pilot is the real process.

The benchmark is the wall cameras and the drone: it publishes frames as a Vicon server and takes AT commands as an AR.Drone.
A pose that steps aside by 30 mm must change the commanded tilt; STOP must clear the progressive bit.
"""

from __future__ import annotations

import asyncio
import itertools
import tempfile
import time
from pathlib import Path

from _run import bench_site, percentile, table
from housefly.app.launcher import Launcher, Part
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime, new_runtime
from housefly.bus.stop import StopSender
from housefly.bus.topics import ORDER
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config import Site
from housefly.messages import Order, OrderKind, Pose
from housefly.twin.ardrone_server import ArDroneServer
from housefly.twin.contracts import MocapFrame, Stick
from housefly.twin.kinematic import KinematicWorld
from housefly.twin.vicon_server import ViconServer

TRIALS = 200
STEP_ASIDE = 0.03
"""How far the pose jumps [m]: well inside the innovation gate."""
CADENCE = 0.030
"""Period of the AR.Drone's command stream [s]: the limit that a new setpoint waits for."""
HOME = (10.55, 1.25)


class Probe(KinematicWorld):
    """A drone that notes when which movement command arrived."""

    def __init__(self) -> None:
        super().__init__()
        self.heard: list[tuple[float, Stick]] = []

    def stick(self, stick: Stick) -> None:
        """Note the command."""
        self.heard.append((time.monotonic(), stick))
        super().stick(stick)


class Bench:
    """The wires around the pilot."""

    def __init__(self, site: Site) -> None:
        self.world = Probe()
        self.drone = ArDroneServer(self.world, site.drone.address)
        self.vicon = ViconServer(site.tracking.address, site.tracking.port)
        self.offset = 0.0
        self.published_at = 0.0
        self._body = site.tracking.body

    async def live(self) -> None:
        """Publish frames at 100 Hz and let the drone live, until cancelled."""
        start, wall = time.monotonic(), self.world.now
        for number in itertools.count():
            now = time.monotonic()
            self.world.advance(max(0.0, now - start + wall - self.world.now))
            height = self.world.truth().pose.position[2] + 0.05
            noise = 1e-6 * (number % 7)  # a place that stays the same to the last bit would count as frozen
            pose = Pose((HOME[0] + self.offset, HOME[1] + noise, height))
            self.vicon.publish(MocapFrame(number, now - 0.01, now, ((self._body, pose),)))
            self.published_at = time.monotonic()
            await asyncio.sleep(max(0.0, start + 0.01 * (number + 1) - time.monotonic()))

    async def reaction(self, matches: object, since: float, timeout: float = 1.0) -> float:
        """Return how long after ``since`` the first matching command arrived [s]."""
        assert callable(matches)
        while time.monotonic() < since + timeout:
            for at, stick in reversed(self.world.heard):
                if at < since:
                    break
                if matches(stick):
                    first = min(t for t, s in self.world.heard if t >= since and matches(s))
                    return first - since
            await asyncio.sleep(0.001)
        return timeout


async def tracking_to_command(bench: Bench) -> list[float]:
    """Measure frame sent -> first changed AT command."""
    delays = []
    for trial in range(TRIALS):
        await asyncio.sleep(0.5 + 0.007 * (trial % 10))
        still = [stick.forward for _, stick in bench.world.heard[-8:]]
        level, noise = still[-1], max(abs(a - b) for a, b in itertools.pairwise(still))
        before = bench.published_at
        bench.offset = STEP_ASIDE - bench.offset
        while bench.published_at == before:
            await asyncio.sleep(0)
        threshold = 0.005 + 3 * noise
        delays.append(
            await bench.reaction(lambda s, v=level, t=threshold: abs(s.forward - v) > t, bench.published_at)  # type: ignore[misc]
        )
    return delays


async def stop_to_command(bench: Bench, runtime: Runtime, bus: ZenohBus) -> list[float]:
    """Measure STOP sent -> first hover command."""
    delays = []
    with StopSender("127.0.0.1", runtime.stop_port, runtime.secret) as sender:
        for trial in range(TRIALS // 2):
            bus.publish(ORDER, Order(OrderKind.RESUME, issued_at=time.monotonic(), sender="benchmark"))
            await asyncio.sleep(0.3 + 0.007 * (trial % 10))
            since = time.monotonic()
            sender.send()
            delays.append(await bench.reaction(lambda s: s.hover, since))
    return delays


async def measure() -> tuple[list[float], list[float]]:
    """Start the pilot, take off, measure."""
    site = bench_site("127.9.2.1", drone__has_video=False)
    bench = Bench(site)
    await bench.drone.start()
    await bench.vicon.start()
    living = asyncio.create_task(bench.live())
    with tempfile.TemporaryDirectory() as folder:
        runtime = new_runtime(site, Path(folder))
        with Launcher(runtime, Path(folder), (Part("pilot", "housefly.app.pilot_main"),)), ZenohBus(connect=runtime.bus) as bus:
            ready = Readiness(site, bus, web=False, video=False)
            missing = await asyncio.to_thread(ready.wait, 60.0)
            if missing:
                raise SystemExit(missing)
            bus.publish(ORDER, Order(OrderKind.TAKE_OFF, issued_at=time.monotonic(), sender="benchmark"))
            await asyncio.sleep(8.0)
            tracking = await tracking_to_command(bench)
            stop = await stop_to_command(bench, runtime, bus)
            bus.publish(ORDER, Order(OrderKind.LAND, issued_at=time.monotonic(), sender="benchmark"))
            await asyncio.sleep(3.0)
    living.cancel()
    await bench.vicon.stop()
    await bench.drone.stop()
    return tracking, stop


def main() -> None:
    """Print both latencies against the AR.Drone's own command period."""
    tracking, stop = asyncio.run(measure())
    print("### From a packet to the AT command, over real sockets, the pilot in its own process\n")
    rows = []
    for name, values in (("Vicon frame sent -> changed AT command", tracking), ("STOP sent -> hover AT command", stop)):
        figures = [percentile(values, share) for share in (0.5, 0.99, 1.0)]
        rows.append([name, len(values), *(f"{v * 1e3:.1f}" for v in figures), f"{figures[0] / CADENCE:.2f}"])
    print(table(["", "trials", "p50 [ms]", "p99 [ms]", "max [ms]", "p50 over the 30 ms command period"], rows))
    print("\nA setpoint waits for the next slot of the drone's 30 ms command stream; STOP does not wait.")


if __name__ == "__main__":
    main()
