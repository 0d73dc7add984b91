"""From a Vicon packet, from STOP, and from a click in a browser to the AT command, over real
sockets, with the real processes.

The benchmark is the wall cameras and the drone: it publishes frames as a Vicon server and takes AT
    commands as an AR.Drone.
A pose that steps aside by 8 mm must change the commanded tilt; STOP must clear the progressive
bit. Clicks are measured once more under attack: a flood of idle connections, greedy sockets of one
session, and a disk that is written and synced without a pause.
"""

from __future__ import annotations

import asyncio
import itertools
import os
import re
import shutil
import sys
import tempfile
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, closing
from math import pi
from pathlib import Path

from playwright.async_api import Page, async_playwright

from _chromium import CHROMIUM_FLAGS
from _run import bench_site, percentile, table
from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime
from housefly.bus.stop_sender import StopSender
from housefly.bus.topics import ORDER_TOPIC
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site
from housefly.messages import Order, OrderKind, Pose
from housefly.twin.ardrone.server import ArDroneServer
from housefly.twin.contracts import MocapFrame
from housefly.twin.mocap.vicon_server import ViconServer
from housefly.wires.ardrone.conversions import Stick
from stop_under_load import attack

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "support"))
from kinematic_world import KinematicWorld

TRIALS = 200
CLICKS, LANDINGS = 100, 10
UNDER_ATTACK = "the same under attack"
STEP_ASIDE = 0.008
"""How far the pose jumps [m]: well inside the innovation gate."""
CADENCE = 0.030
"""Period of the AR.Drone's command stream [s]: the limit that a new setpoint waits for."""
HOME, HEADING = (10.55, 1.25), pi
BATTERY_LASTS = 1800.0
"""A gauge that stood still would keep the drone on the ground [s]."""
STOP_LIMIT = 0.050
"""STOP clicked reaches the drone's wire within this, also under attack, in 99 of 100 [s]."""


class Probe(KinematicWorld):
    """A drone on its pad that notes when which movement command arrived."""

    def __init__(self) -> None:
        super().__init__()
        self._psi = HEADING
        self.heard: list[tuple[float, Stick]] = []
        self.landings: list[float] = []

    def set_stick(self, stick: Stick) -> None:
        """Note the command."""
        self.heard.append((time.monotonic(), stick))
        super().set_stick(stick)

    def request_land(self) -> None:
        """Note the order."""
        self.landings.append(time.monotonic())
        super().request_land()


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
            self.world.battery = 1.0 - (now - start) / BATTERY_LASTS
            self.vicon.publish(
                MocapFrame(number, now - 0.01, now, ((self._body, self._pose(number)),))
            )
            self.published_at = time.monotonic()
            await asyncio.sleep(max(0.0, start + 0.01 * (number + 1) - time.monotonic()))

    def _pose(self, number: int) -> Pose:
        """Return where a frame has the drone: where it is, or a step aside of it."""
        noise = 1e-6 * (number % 7)  # what is the same to the last bit counts as frozen
        true = self.world.truth().pose
        x, y, z = true.position
        at = (HOME[0] + x + self.offset, HOME[1] + y + noise, z + 0.05)
        return Pose(at, true.orientation)

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
            await bench.reaction(
                lambda s, v=level, t=threshold: abs(s.forward - v) > t, bench.published_at
            )
        )
    return delays


async def stop_to_command(bench: Bench, runtime: Runtime, bus: ZenohBus) -> list[float]:
    """Measure STOP sent -> first hover command."""
    delays = []
    with closing(StopSender("127.0.0.1", runtime.stop_port, runtime.secret)) as sender:
        for trial in range(TRIALS // 2):
            bus.publish(
                ORDER_TOPIC, Order(OrderKind.RESUME, issued_at=time.monotonic(), sender="benchmark")
            )
            await asyncio.sleep(0.3 + 0.007 * (trial % 10))
            since = time.monotonic()
            sender.send()
            delays.append(await bench.reaction(lambda s: s.hover, since))
    return delays


async def pressed_at(page: Page, name: str) -> float:
    """Click a button and return when the pointer came down [s, monotonic]."""
    await page.get_by_role("button", name=re.compile(f"^{name}")).first.click()
    epoch = float(await page.evaluate("window.pressedAt")) / 1000
    return epoch - time.time() + time.monotonic()


async def stops_to_command(bench: Bench, page: Page, bus: ZenohBus) -> list[float]:
    """Measure STOP clicked -> first hover command."""
    stops = []
    for _ in range(CLICKS):
        bus.publish(
            ORDER_TOPIC, Order(OrderKind.RESUME, issued_at=time.monotonic(), sender="benchmark")
        )
        await asyncio.sleep(0.4)
        stops.append(await bench.reaction(lambda s: s.hover, await pressed_at(page, "STOP")))
    return stops


@asynccontextmanager
async def attacked(page: Page, port: int) -> AsyncIterator[None]:
    """Attack the console from processes of their own until the block ends."""
    (known,) = await page.context.cookies()
    proof = await page.evaluate("localStorage.getItem('housefly proof')")
    seat = (str(port), f"{known['name']}={known['value']}", proof)
    attacks = [attack("connections", str(port)), attack("sockets", *seat), attack("disk")]
    try:
        await asyncio.sleep(5.0)
        yield
    finally:
        for one in attacks:
            one.kill()
            one.wait()


async def clicks_to_command(
    bench: Bench, runtime: Runtime, bus: ZenohBus
) -> tuple[list[float], list[float], list[float]]:
    """Measure STOP clicked -> first hover command, idle and under attack, and Land clicked -> first
    landing command.
    """
    landings = []
    web = runtime.site().web
    async with async_playwright() as play:
        browser = await play.chromium.launch(
            executable_path=shutil.which("chromium"), args=CHROMIUM_FLAGS
        )
        page = await browser.new_page(viewport={"width": 1280, "height": 800})
        await page.goto(f"http://{web.host}:{web.port}/?token={runtime.token}")
        await page.evaluate(
            "addEventListener('pointerdown', () => { window.pressedAt = performance.timeOrigin +"
            " performance.now() }, true)"
        )
        stops = await stops_to_command(bench, page, bus)
        async with attacked(page, web.port):
            hard = await stops_to_command(bench, page, bus)
        bus.publish(
            ORDER_TOPIC, Order(OrderKind.RESUME, issued_at=time.monotonic(), sender="benchmark")
        )
        for _ in range(LANDINGS):
            bus.publish(
                ORDER_TOPIC,
                Order(OrderKind.TAKE_OFF, issued_at=time.monotonic(), sender="benchmark"),
            )
            await asyncio.sleep(4.0)
            bench.world.landings.clear()
            since = await pressed_at(page, "Land")
            await asyncio.sleep(4.0)
            landings.append(bench.world.landings[0] - since)
        await browser.close()
    return stops, hard, landings


async def measure() -> list[tuple[str, list[float]]]:
    """Start pilot and console, take off, measure."""
    site = bench_site("127.9.2.1", drone__has_video=False, limits__hold_timeout=600.0)
    bench = Bench(site)
    await bench.drone.start()
    await bench.vicon.start()
    living = asyncio.create_task(bench.live())
    with tempfile.TemporaryDirectory() as folder:
        runtime = new_runtime(site, Path(folder), web=True)
        processes = tuple(spec for spec in processes_of(runtime) if spec.name != "twin")
        with Launcher(runtime, Path(folder), processes), ZenohBus(connect=runtime.bus) as bus:
            ready = Readiness(runtime.site(), bus, web=True, video=False)
            missing = await asyncio.to_thread(ready.wait, 60.0)
            if missing:
                raise SystemExit(missing)
            bus.publish(
                ORDER_TOPIC,
                Order(OrderKind.TAKE_OFF, issued_at=time.monotonic(), sender="benchmark"),
            )
            await asyncio.sleep(8.0)
            tracking = await tracking_to_command(bench)
            stop = await stop_to_command(bench, runtime, bus)
            clicked, hard, landed = await clicks_to_command(bench, runtime, bus)
    living.cancel()
    await bench.vicon.stop()
    await bench.drone.stop()
    return [
        ("Vicon frame sent -> changed AT command", tracking),
        ("STOP sent -> hover AT command", stop),
        ("STOP clicked in Chromium -> hover AT command", clicked),
        (UNDER_ATTACK, hard),
        ("Land clicked in Chromium -> landing AT command", landed),
    ]


def main() -> int:
    """Print the latencies against the AR.Drone's own command period; 0 when the limit is kept."""
    print("### To the AT command, over real sockets, pilot and console in processes of their own\n")
    rows, measured = [], asyncio.run(measure())
    for name, values in measured:
        figures = [percentile(values, share) for share in (0.5, 0.99, 1.0)]
        rows.append(
            [name, len(values), *(f"{v * 1e3:.1f}" for v in figures), f"{figures[0] / CADENCE:.2f}"]
        )
    print(
        table(
            ["", "trials", "p50 [ms]", "p99 [ms]", "max [ms]", "p50 over the 30 ms command period"],
            rows,
        )
    )
    print(
        "\nA setpoint waits for the next slot of the drone's 30 ms command stream; STOP and Land do"
        f" not wait. Limit for STOP under attack: {1e3 * STOP_LIMIT:.0f} ms in 99 of 100. The"
        " attack: a flood of idle connections, 40 greedy sockets of one session, and a disk that is"
        f" synced without a pause; load average {os.getloadavg()[0]:.0f}."
    )
    return 0 if percentile(dict(measured)[UNDER_ATTACK], 0.99) <= STOP_LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
