"""From a click or key in real Chromium to the order on the bus and the STOP datagram at the pilot's
side.

The time begins with the browser's own time stamp of the input event and ends in the handler on the
pilot's side, on one machine.
"""

from __future__ import annotations

import asyncio
import secrets
import socket
import sys
import time
from collections.abc import Awaitable, Callable
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from itertools import cycle
from pathlib import Path

import av
import numpy as np
from playwright.async_api import Browser, Page

from _chromium import headless_chromium
from housefly.bus.local import LocalBus
from housefly.bus.stop import StopListener
from housefly.bus.stop_sender import StopSender
from housefly.bus.topics import DroneTopics
from housefly.messages import DroneStatus, Order, OrderKind, Phase, VideoFrame
from housefly.web.process import make_server
from housefly.web.server import create_app

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "support"))
from fake_pilot import FakePilot
from fake_room import example_room

TOPICS = DroneTopics()

PRESSES = 200
PAUSE = 0.06
WATCHERS = 4
HOST = "127.0.0.1"
LIMITS = {"click": ("p95", 50.0), "STOP": ("p99", 30.0)}
STAMPS = """
window.stamps = [];
for (const kind of ["pointerdown", "click", "keydown"]) {
  const push = (e) => window.stamps.push([kind, performance.timeOrigin + e.timeStamp]);
  window.addEventListener(kind, push, {capture: true});
}
"""


@dataclass
class Arrivals:
    """When things arrived at the pilot's side, in milliseconds of the wall clock, which the browser
    shares.
    """

    orders: list[float] = field(default_factory=list)
    stops: list[float] = field(default_factory=list)

    def order(self, order: Order) -> None:
        """Note an order on the bus."""
        if order.kind is OrderKind.HOVER:
            self.orders.append(1000 * time.time())

    def stop(self) -> None:
        """Note a STOP on its own path."""
        self.stops.append(1000 * time.time())


def noise_pictures() -> list[tuple[bytes, bool]]:
    """Return two seconds of 640 x 360 H.264, harder to decode than any room."""
    encoder = av.CodecContext.create("libx264", "w")
    encoder.width, encoder.height, encoder.pix_fmt, encoder.time_base = (
        640,
        360,
        "yuv420p",
        Fraction(1, 30),
    )
    encoder.options = {
        "preset": "ultrafast",
        "tune": "zerolatency",
        "x264-params": "keyint=30:annexb=1:repeat-headers=1",
    }
    noise = np.random.default_rng(1).integers(0, 60, (360, 640, 3), np.uint8)
    moved = (np.roll(noise, 3 * number, axis=1) for number in range(60))
    frames = (av.VideoFrame.from_ndarray(picture, format="rgb24") for picture in moved)
    return [
        (bytes(packet), bool(packet.is_keyframe))
        for frame in frames
        for packet in encoder.encode(frame)
    ]


async def feed(bus: LocalBus, pictures: list[tuple[bytes, bool]]) -> None:
    """Publish pictures, 30 a second, as the drone would."""
    for number, (data, keyframe) in enumerate(cycle(pictures)):
        bus.publish(TOPICS.video, VideoFrame(data, keyframe, 640, 360, number, time.monotonic()))
        await asyncio.sleep(1 / 30)


async def measure(
    page: Page, kind: str, press: Callable[[], Awaitable[None]], arrived: list[float]
) -> list[float]:
    """Press again and again; return the delays [ms]."""
    await page.evaluate("window.stamps.length = 0")
    arrived.clear()
    for number in range(1, PRESSES + 1):
        await press()
        deadline = time.monotonic() + 5
        while len(arrived) < number:
            if time.monotonic() > deadline:
                raise SystemExit(f"press {number} did not arrive")
            await asyncio.sleep(0.001)
        await asyncio.sleep(PAUSE)
    stamps = [at for seen, at in await page.evaluate("window.stamps") if seen == kind]
    return [end - start for start, end in zip(stamps, arrived, strict=True)]


async def rows(browser: Browser, *, busy: bool) -> list[tuple[str, str, list[float]]]:
    """Serve a console, fly the fake pilot, and measure three ways to press."""
    arrivals, bus = Arrivals(), LocalBus()
    with socket.socket() as listener:
        listener.bind((HOST, 0))
        secret = secrets.token_hex(16)
        stop = StopListener(HOST, 0, secret, arrivals.stop)
        await stop.start()
        sender = StopSender(HOST, stop.address[1], secret)
        token = secrets.token_urlsafe(16)
        server = make_server(create_app(bus, token, sender.send))
        pilot = FakePilot(bus.join(), example_room())
        pilot.status, pilot.phase, pilot.height = DroneStatus.FLYING, Phase.HOLDING, 1.1
        bus.subscribe(TOPICS.order, arrivals.order)
        tasks = [asyncio.create_task(server.serve([listener])), asyncio.create_task(pilot.run())]
        address = f"http://{HOST}:{listener.getsockname()[1]}"
        context = await browser.new_context()
        page = await context.new_page()
        await page.add_init_script(STAMPS)
        await page.goto(f"{address}/?token={token}")
        await page.wait_for_selector(".drone")
        if busy:
            tasks.append(asyncio.create_task(feed(bus.join(), noise_pictures())))
            for _ in range(WATCHERS):
                await (await context.new_page()).goto(address)
            await page.bring_to_front()
            await page.wait_for_selector("canvas[data-picture]")
        where = f"{WATCHERS} watchers, video" if busy else "alone"
        results = []
        for label, selector, kind, arrived in (
            ("click → order on the bus", ".action:has-text('Hover')", "click", arrivals.orders),
            ("STOP clicked → datagram at the pilot", ".stop", "pointerdown", arrivals.stops),
        ):
            box = await page.locator(selector).bounding_box()
            assert box is not None
            x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
            results.append(
                (label, where, await measure(page, kind, partial(page.mouse.click, x, y), arrived))
            )
        space = await measure(
            page, "keydown", partial(page.keyboard.press, "Space"), arrivals.stops
        )
        results.append(("STOP by Space → datagram at the pilot", where, space))
        await context.close()
        for task in tasks[1:]:
            task.cancel()
        server.should_exit = True
        await tasks[0]
        stop.close()
        return results


async def main() -> None:
    """Print the table."""
    async with headless_chromium() as browser:
        measured = [row for busy in (False, True) for row in await rows(browser, busy=busy)]
    print("### Console: from the hand to the pilot\n")
    print("| what | with | p50 ms | p95 ms | p99 ms | max ms | limit | limit / measured |")
    print("|---|---|---|---|---|---|---|---|")
    for label, where, delays in measured:
        name, limit = LIMITS[label.split()[0]]
        at = {f"p{n}": float(np.percentile(delays, n)) for n in (50, 95, 99)}
        numbers = " | ".join(f"{value:.1f}" for value in (*at.values(), max(delays)))
        print(
            f"| {label} | {where} | {numbers} | {name} < {limit:.0f} ms | {limit / at[name]:.1f} |"
        )
    print(
        f"\n{PRESSES} presses each in headless Chromium on the same machine; time from the"
        " browser's stamp of the input event to the handler on the pilot's side, against the"
        " limits that the console's design set before it was built."
    )


if __name__ == "__main__":
    asyncio.run(main())
