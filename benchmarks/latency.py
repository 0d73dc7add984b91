"""From a Vicon packet, from STOP, and from a click in a browser to the AT command, over real
sockets, with the real processes.

The benchmark is the wall cameras and the drone: it publishes frames as a Vicon server and takes AT
commands as an AR.Drone.
A pose that steps aside by 8 mm must change the commanded tilt. STOP and Land are flown by the
pilot's own setpoints: the command that obeys is the first with the setpoint of a step that is
stopped or lands; poses tremble by a millimetre, so that no two steps ask for the same. Clicks are
measured once more under attack: a flood of idle connections, greedy sockets of one session, and a
disk that is written and synced without a pause.
"""

from __future__ import annotations

import asyncio
import itertools
import os
import sys
import tempfile
import time
from bisect import bisect_left
from collections import deque
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, closing
from math import pi, sin
from operator import itemgetter
from pathlib import Path
from typing import cast

from playwright.async_api import Locator, Page, async_playwright

from _chromium import CHROMIUM_FLAGS
from _run import bench_site, percentile, table
from housefly.app.browser_video import chromium_path
from housefly.app.launcher import Launcher, processes_of
from housefly.app.new_runtime import new_runtime
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime
from housefly.bus.stop_sender import StopSender
from housefly.bus.topics import DroneTopics
from housefly.bus.zenoh_bus import ZenohBus
from housefly.config.site import Site
from housefly.messages import (
    Action,
    Command,
    Order,
    OrderKind,
    Outputs,
    Phase,
    PilotStep,
    Pose,
    SafetyMode,
)
from housefly.messages.stick import Maxima, Stick
from housefly.twin.ardrone.server import ArDroneServer
from housefly.twin.contracts import MocapFrame, TwinDrone
from housefly.twin.mocap.vicon_server import ViconServer
from housefly.wires.ardrone.conversions import (
    pcmd_from_setpoint,
    stick_from_pcmd,
)
from stop_under_load import attack

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "support"))
from kinematic_world import KinematicWorld

TOPICS = DroneTopics()

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


TREMBLE = 0.001
"""How far poses tremble while STOP and Land are measured [m]: what a mocap's noise may be."""
SAME = 1e-5
"""Two sticks this close are one command; AT carries single precision."""


class Probe(KinematicWorld):
    """A drone on its pad that notes when which movement command arrived."""

    def __init__(self) -> None:
        super().__init__()
        self._psi = HEADING
        self.heard: list[tuple[float, Stick]] = []

    def set_stick(self, stick: Stick) -> None:
        """Note the command."""
        self.heard.append((time.monotonic(), stick))
        super().set_stick(stick)

    def is_asked(self, stick: Stick, command: Command) -> bool:
        """Return whether a stick is this command of the pilot."""
        if command.action is not Action.FLY or stick.hover:
            return command.action is Action.HOVER and stick.hover
        limits = self.limits
        maxima = Maxima(limits.tilt, limits.climb, limits.yaw_rate)
        wanted = stick_from_pcmd(pcmd_from_setpoint(command.setpoint, maxima))
        return all(
            abs(getattr(stick, part) - getattr(wanted, part)) < SAME
            for part in ("forward", "left", "up", "turn")
        )


class Bench:
    """The wires around the pilot."""

    def __init__(self, site: Site) -> None:
        self.world = Probe()
        self.drone = ArDroneServer(cast(TwinDrone, self.world), site.drone.address)
        self.vicon = ViconServer(site.tracking.address, site.tracking.port)
        self.offset = 0.0
        self.published_at = 0.0
        self.trembles = 0.0
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
        # What is the same to the last bit counts as frozen.
        noise = 1e-6 * (number % 7) + self.trembles * sin(2.399 * number)
        true = self.world.truth().pose
        x, y, z = true.position
        at = (HOME[0] + x + self.offset, HOME[1] + y + noise, z + 0.05)
        return Pose(at, true.orientation)

    async def reaction(
        self, matches: Callable[[Stick], bool], since: float, timeout: float = 1.0
    ) -> float:
        """Return how long after ``since`` the first matching command arrived [s]."""
        while time.monotonic() < since + timeout:
            first = bisect_left(self.world.heard, since, key=itemgetter(0))
            for at, stick in self.world.heard[first:]:
                if matches(stick):
                    return at - since
            await asyncio.sleep(0.001)
        return timeout

    async def obedience(
        self, steps: Steps, obeys: Callable[[Outputs], bool], since: float
    ) -> float:
        """Return how long after ``since`` the first command of a step that obeys arrived [s]."""

        def matches(stick: Stick) -> bool:
            return any(self.world.is_asked(stick, command) for command in steps.that(obeys, since))

        return await self.reaction(matches, since)


class Steps:
    """The newest steps of the pilot, as its bus has them."""

    def __init__(self, bus: ZenohBus) -> None:
        self._steps: deque[PilotStep] = deque(maxlen=500)
        bus.subscribe(TOPICS.step, self._steps.append)

    def that(self, obeys: Callable[[Outputs], bool], since: float) -> list[Command]:
        """Return what the steps since then ask for that obey."""
        return [
            step.outputs.command
            for step in tuple(self._steps)
            if step.now >= since and obeys(step.outputs)
        ]


def is_stopped(outputs: Outputs) -> bool:
    """Return whether a step obeys STOP."""
    return outputs.safety is SafetyMode.STOPPED


def lands(outputs: Outputs) -> bool:
    """Return whether a step obeys Land."""
    return outputs.phase is Phase.LANDING


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

        def stepped(
            stick: Stick, level: float = level, threshold: float = 0.005 + 3 * noise
        ) -> bool:
            return abs(stick.forward - level) > threshold

        delays.append(await bench.reaction(stepped, bench.published_at))
    return delays


async def stop_to_command(
    bench: Bench, runtime: Runtime, bus: ZenohBus, steps: Steps
) -> list[float]:
    """Measure STOP sent -> first command of a pilot that is stopped."""
    delays = []
    with closing(StopSender("127.0.0.1", runtime.stop_ports["drone"], runtime.secret)) as sender:
        for trial in range(TRIALS // 2):
            bus.publish(
                TOPICS.order,
                Order(OrderKind.RESUME, issued_at=time.monotonic(), sender="benchmark"),
            )
            await asyncio.sleep(0.3 + 0.007 * (trial % 10))
            since = time.monotonic()
            sender.send()
            delays.append(await bench.obedience(steps, is_stopped, since))
    return delays


async def pressed_at(button: Locator) -> float:
    """Click a button and return when the pointer came down [s, monotonic]."""
    await button.click()
    epoch = float(await button.page.evaluate("window.pressedAt")) / 1000
    return epoch - time.time() + time.monotonic()


async def stops_to_command(bench: Bench, page: Page, bus: ZenohBus, steps: Steps) -> list[float]:
    """Measure STOP clicked -> first command of a pilot that is stopped."""
    stops = []
    for _ in range(CLICKS):
        bus.publish(
            TOPICS.order,
            Order(OrderKind.RESUME, issued_at=time.monotonic(), sender="benchmark"),
        )
        await asyncio.sleep(0.4)
        stops.append(
            await bench.obedience(steps, is_stopped, await pressed_at(page.locator(".stop")))
        )
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
    bench: Bench, runtime: Runtime, bus: ZenohBus, steps: Steps
) -> tuple[list[float], list[float], list[float]]:
    """Measure STOP clicked -> first command that obeys, idle and under attack, and the same of
    Land.
    """
    landings = []
    web = runtime.site().web
    async with async_playwright() as play:
        browser = await play.chromium.launch(executable_path=chromium_path(), args=CHROMIUM_FLAGS)
        page = await browser.new_page(viewport={"width": 1280, "height": 800})
        await page.goto(f"http://{web.host}:{web.port}/?token={runtime.token}")
        await page.evaluate(
            "addEventListener('pointerdown', () => { window.pressedAt = performance.timeOrigin +"
            " performance.now() }, true)"
        )
        stops = await stops_to_command(bench, page, bus, steps)
        async with attacked(page, web.port):
            hard = await stops_to_command(bench, page, bus, steps)
        bus.publish(
            TOPICS.order,
            Order(OrderKind.RESUME, issued_at=time.monotonic(), sender="benchmark"),
        )
        for _ in range(LANDINGS):
            bus.publish(
                TOPICS.order,
                Order(OrderKind.TAKE_OFF, issued_at=time.monotonic(), sender="benchmark"),
            )
            await asyncio.sleep(4.0)
            landings.append(
                await bench.obedience(
                    steps,
                    lands,
                    await pressed_at(page.get_by_role("button", name="Land", exact=True)),
                )
            )
            await asyncio.sleep(4.0)
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
                TOPICS.order,
                Order(OrderKind.TAKE_OFF, issued_at=time.monotonic(), sender="benchmark"),
            )
            await asyncio.sleep(8.0)
            tracking = await tracking_to_command(bench)
            bench.trembles, steps = TREMBLE, Steps(bus)
            stop = await stop_to_command(bench, runtime, bus, steps)
            clicked, hard, landed = await clicks_to_command(bench, runtime, bus, steps)
    living.cancel()
    await bench.vicon.stop()
    await bench.drone.stop()
    return [
        ("Vicon frame sent -> changed AT command", tracking),
        ("STOP sent -> AT command that obeys", stop),
        ("STOP clicked in Chromium -> AT command that obeys", clicked),
        (UNDER_ATTACK, hard),
        ("Land clicked in Chromium -> AT command that obeys", landed),
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
        "\nA setpoint waits for the next slot of the drone's 30 ms command stream; STOP's leaves"
        f" at once. Limit for STOP under attack: {1e3 * STOP_LIMIT:.0f} ms in 99 of 100. The"
        " attack: a flood of idle connections, 40 greedy sockets of one session, and a disk that is"
        f" synced without a pause; load average {os.getloadavg()[0]:.0f}."
    )
    return 0 if percentile(dict(measured)[UNDER_ATTACK], 0.99) <= STOP_LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
