"""Runs everything for people at the console, until Ctrl-C."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

from housefly.app.launcher import Launcher, processes_of
from housefly.app.loaded_site import LoadedSite
from housefly.app.ports import refuse_taken_ports
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime, discovery_entry, new_runtime
from housefly.app.terminal import console
from housefly.bus.bus import Bus
from housefly.bus.topics import LINK_TOPIC, STEP_TOPIC, VIDEO_TOPIC
from housefly.bus.zenoh_bus import ZenohBus
from housefly.hub.client.discovery import announced
from housefly.record.recorder import FlightRecorder

_READY_TIMEOUT = 60.0
"""After this time the start says what is missing [s]; the run goes on without it."""


def run_interactively(loaded: LoadedSite, folder: Path, record: Path | None) -> int:
    """Start everything, print the console's address, and stay until Ctrl-C."""
    started = time.monotonic()
    refuse_taken_ports(loaded.site, web=True)
    runtime = new_runtime(loaded.site, folder)
    with ExitStack() as stack:
        stack.enter_context(announced(discovery_entry(runtime)))
        launcher = stack.enter_context(Launcher(runtime, folder, processes_of(runtime)))
        bus = stack.enter_context(ZenohBus(connect=runtime.bus))
        try:
            _introduce(runtime, bus, started)
            if record is not None:
                stack.callback(_record(loaded, record, bus))
                console.print(f"recording to {record}")
            _idle(launcher)
        except KeyboardInterrupt:
            console.print("\nlanding the drone, then leaving (Ctrl-C again leaves at once)")
            _land_and_leave(launcher)
    return 0


def _introduce(runtime: Runtime, bus: Bus, started: float) -> None:
    site = runtime.site()
    console.print(
        f"[bold]Housefly[/bold] in {site.name}, mode {site.mode}:"
        f" {'simulated room' if site.twin.enabled else 'real hardware'}"
    )
    console.print(
        f"console:  [bold]http://{site.web.host}:{site.web.port}/?token={runtime.token}[/bold]",
        soft_wrap=True,
    )
    console.print(f"bus:      {runtime.bus}  (who may run programs here may listen and order)")
    video = site.drone.has_video and (site.twin.video or not site.twin.enabled)
    with console.status("starting") as status:
        missing = Readiness(site, bus, web=True, video=video).wait(_READY_TIMEOUT, status.update)
    if missing:
        console.print(
            f"[bold]not everything answers:[/bold] {missing}; `housefly doctor` may know why"
        )
        return
    console.print(
        f"ready after {time.monotonic() - started:.1f} s. Open the address, choose a place, hold"
        " Go. Ctrl-C lands and ends."
    )


def _land_and_leave(launcher: Launcher) -> None:
    try:
        launcher.stop()
    except KeyboardInterrupt:
        launcher.abandon()
        console.print("left at once: a drone in the air is on its own now")


def _record(loaded: LoadedSite, folder: Path, bus: Bus) -> Callable[[], None]:
    recorder = FlightRecorder(folder, loaded.site, loaded.room, loaded.grid)
    open_ = [
        bus.subscribe(STEP_TOPIC, recorder.add_step),
        bus.subscribe(VIDEO_TOPIC, recorder.add_video),
        bus.subscribe(LINK_TOPIC, recorder.add_link),
    ]

    def close() -> None:
        for subscription in open_:
            subscription.close()
        recorder.finish("ended by the user")

    return close


def _idle(launcher: Launcher) -> None:
    restarts = dict.fromkeys((process.name for process in launcher.processes), 0)
    while True:
        time.sleep(0.5)
        for name, before in restarts.items():
            now = launcher.restarts(name)
            if now != before:
                restarts[name] = now
                console.print(
                    f"{name} died and was started again (its log:"
                    f" {launcher.folder / (name + '.log')})"
                )
