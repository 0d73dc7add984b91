"""Start-up time, processor share, memory and punctuality of the whole demo during one service, with
a real browser watching.

    python benchmarks/demo.py
    python benchmarks/demo.py --drone crazyflie
"""

from __future__ import annotations

import argparse
import re
import time

import psutil
from playwright.sync_api import Page, sync_playwright

from _chromium import CHROMIUM_FLAGS
from _run import Running, bench_site, percentile, running, table
from housefly.app.browser_video import chromium_path
from housefly.config.airframe import airframe_names
from housefly.messages import OrderKind, Phase

CPU_GOAL, START_GOAL_S = 1.2, 8.0


def name_of(process: psutil.Process, state: Running) -> str:
    """Return which part of the demo a process is."""
    line = " ".join(process.cmdline())
    for part in state.launcher.processes:
        if process.pid == state.launcher.pid(part.name):
            return part.name
    return "camera" if "camera" in line else "other"


def processes(state: Running) -> dict[str, psutil.Process]:
    """Return the demo's processes by name."""
    found = {}
    for part in state.launcher.processes:
        root = psutil.Process(state.launcher.pid(part.name))
        for process in (root, *root.children(recursive=True)):
            found[name_of(process, state)] = process
    return found


def picture_ages(page: Page) -> list[float]:
    """Read the age of the picture off the console's details for ten seconds [ms]."""
    page.get_by_role("button", name="Details", exact=True).click()
    shown = page.locator(".reading", has_text="Picture").locator("dd")
    ages = []
    for _ in range(100):
        ages.append(float(re.findall(r"(\d+) ms", shown.inner_text())[0]))
        page.wait_for_timeout(100)
    return ages


def seconds(process: psutil.Process) -> float:
    """Return the processor time used so far [s]."""
    times = process.cpu_times()
    return float(times.user + times.system)


def main() -> None:
    """Fly one service with a browser on the console and print what it cost."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--drone", default="ardrone", choices=airframe_names(), metavar="MODEL")
    model = parser.parse_args().drone
    site = bench_site("127.9.1.1", drone__kind=model)
    with running(site) as state, sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium_path(), args=CHROMIUM_FLAGS)
        page = browser.new_page(viewport={"width": 1280, "height": 800})
        web = state.runtime.site().web
        page.goto(f"http://{web.host}:{web.port}/?token={state.runtime.token}")
        page.wait_for_timeout(11_000)  # the window of the lateness figures must not hold the start
        parts = processes(state)
        before, start = (
            {name: seconds(process) for name, process in parts.items()},
            time.monotonic(),
        )
        state.links.clear()
        state.order(OrderKind.SERVICE, "entrance")
        ages = picture_ages(page) if site.has_picture else []
        state.wait_for(Phase.LOOKING, 90.0)
        state.wait_for(Phase.IDLE, 120.0)
        elapsed = time.monotonic() - start
        shares = {
            name: (seconds(process) - before[name]) / elapsed for name, process in parts.items()
        }
        memory = {name: process.memory_full_info().uss / 2**20 for name, process in parts.items()}
        links = list(state.links)
        browser.close()
    print(
        f"### The whole demo ({model}) during one service ({elapsed:.0f} s), a browser watching the"
        " map and the video\n"
    )
    rows: list[list[object]] = [
        [name, f"{shares[name]:.2f}", f"{memory[name]:.0f}"] for name in sorted(shares)
    ]
    rows.append(["**all**", f"**{sum(shares.values()):.2f}**", f"**{sum(memory.values()):.0f}**"])
    print(table(["process", "cores", "memory of its own [MiB]"], rows))
    whole = sum(shares.values()) / CPU_GOAL
    print(
        f"\nGoal: under {CPU_GOAL} cores in all; this is {whole:.2f} of it. The browser is not"
        " counted.\n"
    )
    late = [
        ("median", percentile([link.loop_p50_s for link in links], 0.5)),
        ("99th percentile (worst ten seconds)", max(link.loop_p99_s for link in links)),
        ("maximum", max(link.loop_max_s for link in links)),
    ]
    print(
        "Lateness of the pilot loop's ticks at 100 Hz, video and console on, as a share of its 10"
        " ms period:\n"
    )
    print(
        table(
            ["", "lateness [ms]", "share of the period"],
            [[n, f"{v * 1e3:.2f}", f"{v / 0.01:.2f}"] for n, v in late],
        )
    )
    print(f"\nTicks missed: {links[-1].missed_ticks - links[0].missed_ticks}.")
    rate = percentile([link.video_rate_hz for link in links], 0.5)
    print(f"Pictures per second at the pilot: {rate:.0f}.")
    if ages:
        newest, oldest = percentile(ages, 0.5), percentile(ages, 0.99)
        print(
            f"Age of the picture on the console since the pilot had it: p50 {newest:.0f} ms, p99"
            f" {oldest:.0f} ms (a period is 33 ms)."
        )
    share = state.ready_after / START_GOAL_S
    print(
        f"Warm start to ready: {state.ready_after:.1f} s (goal: under {START_GOAL_S:.0f} s;"
        f" {share:.2f} of it)."
    )


if __name__ == "__main__":
    main()
