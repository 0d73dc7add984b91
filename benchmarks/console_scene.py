"""The console's one screen in real Chromium, over a fake pilot at 100 Hz.

The drone's 30 pictures a second are of the simulated camera on a flight through its room.

``SECONDS`` over which the processor is looked at (60 by default) and ``PRESSES`` of STOP (100) may
be set for a short run. What the page keeps in a long flight is in ``console_heap.py``.
"""

from __future__ import annotations

import asyncio
import os
import secrets
import socket
import sys
import tempfile
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass, replace
from itertools import pairwise
from math import dist
from pathlib import Path

import numpy as np
from playwright.async_api import Browser, CDPSession, Page, ViewportSize

from _chromium import headless_chromium
from _pictures import flight_pictures
from console_latency import HOST, feed
from housefly.bus.local import LocalBus
from housefly.bus.stop import StopListener
from housefly.bus.stop_sender import StopSender
from housefly.bus.topics import DroneTopics
from housefly.clock import RealClock
from housefly.geometry import Vec2
from housefly.messages import (
    DroneStatus,
    Order,
    OrderKind,
    Phase,
    PlannedTrajectory,
    SafetyMode,
    Severity,
    TrajectoryPoint,
)
from housefly.messages import Path as FlightPath
from housefly.web.flights.flight_log import (
    FlightEnd,
    FlightHead,
    Line,
    LoggedPose,
    LoggedStage,
    line_text,
)
from housefly.web.process import make_server
from housefly.web.server import create_app

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "support"))
from fake_pilot import FakePilot
from fake_room import example_room

TOPICS = DroneTopics()

SECONDS = float(os.environ.get("SECONDS", "60"))
"""Over which the processor's share is taken [s]."""
PRESSES = int(os.environ.get("PRESSES", "100"))
THROTTLE = 6
REPLAYED = 600.0
"""How long the flight in the time bar is [s]."""
SCRUBBED = 5.0
LEG = 0.12
"""Between two points of a curve in space [m]."""
SIZE: ViewportSize = {"width": 1280, "height": 800}
WATCH_STOP = """
window.confirmed = [];
window.pressed = [];
addEventListener("pointerdown", (e) => window.pressed.push(e.timeStamp), {capture: true});
new MutationObserver(() => {
  const now = document.querySelector(".stop")?.dataset.progress ?? "none";
  if (now === "confirmed" && window.confirmed.length < window.pressed.length)
    requestAnimationFrame(() => setTimeout(() => window.confirmed.push(performance.now())));
}).observe(document, {subtree: true, attributes: true, attributeFilter: ["data-progress"]});
"""
"""A press begins with the browser's stamp of it, and ends after the frame that shows the word."""
OPEN_FLIGHT = """() => new Promise((done) => {
  const began = performance.now();
  document.querySelector(".time-bar .block").click();
  const look = () =>
    document.querySelector(".recorded-layer .then")?.getAttribute("transform")
      ? done(performance.now() - began) : requestAnimationFrame(look);
  look();
})"""
SCRUB = """(seconds) => new Promise((done) => {
  const bar = document.querySelector(".time-bar input");
  const began = performance.now();
  let frames = 0;
  const draw = (now) => {
    const share = (now - began) / 1000 / seconds;
    if (share >= 1) return done(frames / seconds);
    frames += 1;
    bar.value = String(share * Number(bar.max));
    bar.dispatchEvent(new Event("input", {bubbles: true}));
    requestAnimationFrame(draw);
  };
  requestAnimationFrame(draw);
})"""


@dataclass
class Scene:
    """A page that shows a flight, and whoever flies it."""

    pilot: FakePilot
    bus: LocalBus
    page: Page
    devtools: CDPSession
    browser: CDPSession


def kept_flight(folder: Path) -> None:
    """Write the log of a flight that ended half a minute ago."""
    began = time.time() - REPLAYED - 30.0
    lines: list[Line] = [FlightHead(1, "Benchmark", began)]
    lines.append(LoggedStage(0.0, Phase.OUTBOUND, SafetyMode.NOMINAL, "Entrance"))
    for k in range(round(10 * REPLAYED)):
        lines.append(LoggedPose(k / 10, (1.0 + 5.0 * k / 10 / REPLAYED, 1.0, 1.1), 0.1, 0.4, 0.9))
    lines.append(FlightEnd(REPLAYED, "Entrance", Severity.INFO))
    folder.mkdir()
    (folder / "20270115T080000250Z.jsonl").write_text("".join(map(line_text, lines)))


@asynccontextmanager
async def scene(browser: Browser, folder: Path) -> AsyncIterator[Scene]:
    """Serve a console, and open it."""
    bus = LocalBus()
    pilot = FakePilot(bus.join(), example_room())

    def stop_pilot() -> None:
        bus.publish(TOPICS.order, Order(OrderKind.STOP, issued_at=RealClock().now(), sender="STOP"))

    with socket.socket() as listener:
        listener.bind((HOST, 0))
        secret, token = secrets.token_hex(16), secrets.token_urlsafe(16)
        stop = StopListener(HOST, 0, secret, stop_pilot)
        await stop.start()
        sender = StopSender(HOST, stop.address[1], secret)
        server = make_server(create_app(bus, token, sender.send, flights=folder))
        tasks = [asyncio.create_task(server.serve([listener])), asyncio.create_task(pilot.run())]
        tasks.append(asyncio.create_task(feed(bus.join(), flight_pictures())))
        context = await browser.new_context(viewport=SIZE)
        page = await context.new_page()
        await page.add_init_script(WATCH_STOP)
        await page.goto(f"http://{HOST}:{listener.getsockname()[1]}/?token={token}")
        await page.wait_for_selector("canvas[data-picture]")
        devtools = await context.new_cdp_session(page)
        await devtools.send("Performance.enable")
        yield Scene(pilot, bus, page, devtools, await browser.new_browser_cdp_session())
        await context.close()
        for task in tasks[1:]:
            task.cancel()
        server.should_exit = True
        await tasks[0]
        stop.close()


async def fly(one: Scene) -> None:
    """Fly to and fro, for ever."""
    places, number = ("entrance", "sofa"), 0
    while True:
        one.pilot.battery = 0.86
        if one.pilot.phase in (Phase.HOLDING, Phase.IDLE) and not one.pilot.stopped:
            number += 1
            order(one, OrderKind.GO, places[number % 2])
        await asyncio.sleep(0.25)


def order(one: Scene, kind: OrderKind, place: str = "") -> None:
    """Give an order as another client of the bus."""
    one.bus.publish(TOPICS.order, Order(kind, place, issued_at=RealClock().now(), sender="bench"))


async def stops(one: Scene, presses: int) -> list[float]:
    """Press STOP again and again; return the times until the screen says STOPPED [ms]."""
    await one.page.evaluate("() => { window.pressed.length = window.confirmed.length = 0; }")
    box = await one.page.locator(".stop").bounding_box()
    assert box is not None
    for number in range(1, presses + 1):
        await until(one.page, "document.querySelector('.stop').dataset.progress === 'none'")
        await asyncio.sleep(0.1)
        await one.page.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        await until(one.page, f"window.confirmed.length === {number}")
        order(one, OrderKind.RESUME)
    pairs = await one.page.evaluate("[window.pressed, window.confirmed]")
    return [end - start for start, end in zip(*pairs, strict=True)]


async def until(page: Page, holds: str, patience: float = 30.0) -> None:
    """Wait until an expression holds in the page."""
    end = time.monotonic() + patience
    while not await page.evaluate(holds):
        if time.monotonic() > end:
            raise SystemExit(f"not within {patience:.0f} s: {holds}")
        await asyncio.sleep(0.02)


async def processor_times(one: Scene) -> dict[str, float]:
    """Return the processor time of each kind of Chromium's processes [s], and the page's thread."""
    found = await one.browser.send("SystemInfo.getProcessInfo")
    times: dict[str, float] = {}
    for process in found["processInfo"]:
        times[process["type"]] = times.get(process["type"], 0.0) + process["cpuTime"]
    metrics = (await one.devtools.send("Performance.getMetrics"))["metrics"]
    thread = next(each["value"] for each in metrics if each["name"] == "TaskDuration")
    return {"page": times.get("renderer", 0.0), "thread": thread, "all": sum(times.values())}


def row(what: str, figure: str, goal: str) -> None:
    """Print a row of the table."""
    print(f"| {what} | {figure} | {goal} |")


def told(delays: list[float]) -> str:
    """Return the percentiles of some times [ms], in words."""
    low, high = np.percentile(delays, (50, 99))
    return f"p50 {low:.0f}, p99 {high:.0f} ms, {len(delays)} presses"


async def measure_flight(one: Scene) -> None:
    """Print what a flight costs, and how fast STOP is in it."""
    one.pilot.status, one.pilot.phase, one.pilot.height = DroneStatus.FLYING, Phase.HOLDING, 1.1
    flying = asyncio.create_task(fly(one))
    await asyncio.sleep(3.0)
    row("STOP pressed → STOPPED on the screen", told(await stops(one, PRESSES)), "p99 150 ms")
    await one.devtools.send("Emulation.setCPUThrottlingRate", {"rate": THROTTLE})
    slow = told(await stops(one, PRESSES))
    row(f"... on a processor {THROTTLE} times slower", slow, "p99 400 ms")
    await one.devtools.send("Emulation.setCPUThrottlingRate", {"rate": 1})
    await asyncio.sleep(2.0)
    await measure_processor(one, "share of a core: the page's process")
    bending = asyncio.create_task(bend(one))
    await asyncio.sleep(2.0)
    await measure_processor(one, "the same while a curve with heights and speeds is flown")
    bending.cancel()
    flying.cancel()
    one.pilot.status, one.pilot.phase, one.pilot.height = DroneStatus.LANDED, Phase.IDLE, 0.0
    one.pilot.position, one.pilot.path = one.pilot.room.home, None


async def measure_processor(one: Scene, what: str) -> None:
    """Print what the page takes."""
    before, began = await processor_times(one), time.monotonic()
    await asyncio.sleep(SECONDS)
    after, took = await processor_times(one), time.monotonic() - began
    share = {name: 100.0 * (after[name] - before[name]) / took for name in after}
    row(what, f"{share['page']:.0f} %", "25 %")
    row("... of that its main thread", f"{share['thread']:.0f} %", "")
    row("... with the rest of Chromium, without a GPU", f"{share['all']:.0f} %", "")


async def bend(one: Scene) -> None:
    """Give each path of the fake pilot heights and speeds, as the real one plans them."""
    bent: FlightPath | None = None
    while True:
        path = one.pilot.path
        if path is not None and path is not bent:
            legs = pairwise(path.waypoints)
            way = [path.waypoints[0], *(point for leg in legs for point in between(*leg))]
            bent = one.pilot.path = replace(path, waypoints=tuple(way))
            one.pilot.waypoint = 1
            last = len(way) - 1
            points = tuple(
                TrajectoryPoint((*place, 1.1), LEG * k / 0.4, 0.8 * min(k, last - k) / last)
                for k, place in enumerate(way)
            )
            one.bus.publish(TOPICS.trajectory, PlannedTrajectory(0.0, points))
        await asyncio.sleep(0.05)


def between(start: Vec2, end: Vec2) -> list[Vec2]:
    """Return points on a straight line, without its start."""
    count = max(1, round(dist(start, end) / LEG))
    return [
        (start[0] + (end[0] - start[0]) * k / count, start[1] + (end[1] - start[1]) * k / count)
        for k in range(1, count + 1)
    ]


async def measure_time_bar(one: Scene) -> None:
    """Print how a kept flight opens and is drawn."""
    await one.page.reload()
    await one.page.wait_for_selector(".drone")
    await one.page.get_by_label("How far back").select_option("3600")
    await one.page.wait_for_selector(".time-bar .block")
    await asyncio.sleep(2.0)
    opened = await one.page.evaluate(OPEN_FLIGHT)
    row(f"a flight of {REPLAYED / 60:.0f} min opens", f"{opened:.0f} ms", "1000 ms")
    frames = await one.page.evaluate(SCRUB, SCRUBBED)
    row("frames a second while it is scrubbed", f"{frames:.0f}", "60")


async def main() -> None:
    """Print the table."""
    print("### Console: the one screen\n")
    print("| what | measured | goal |\n|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        kept_flight(Path(folder) / "flights")
        async with (
            headless_chromium() as browser,
            scene(browser, Path(folder) / "flights") as one,
        ):
            await measure_flight(one)
            await measure_time_bar(one)
    load = ", ".join(f"{value:.1f}" for value in os.getloadavg())
    print(
        f"\nHeadless Chromium at {SIZE['width']} x {SIZE['height']} and a fake pilot on one"
        f" machine, which draws without a GPU; load {load} on {os.cpu_count()} cores."
    )


if __name__ == "__main__":
    asyncio.run(main())
