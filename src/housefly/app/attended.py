"""A run with people: processes, console, optional recording, until Ctrl-C."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

from rich.console import Console

from housefly.app.launcher import Launcher, parts_of
from housefly.app.ports import refuse_taken_ports
from housefly.app.premises import Premises
from housefly.app.readiness import Readiness
from housefly.app.runtime import Runtime, meeting_place, new_runtime
from housefly.bus.bus import Bus
from housefly.bus.topics import LINK, STEP, VIDEO
from housefly.bus.zenoh_bus import ZenohBus
from housefly.hub.asking.discovery import announced
from housefly.record.recorder import FlightRecorder

READY_TIMEOUT = 60.0
"""How long a start may take before it is said what is missing [s]; the run goes on and picks up
what comes later.
"""


def stay(premises: Premises, folder: Path, record: Path | None, console: Console) -> int:
    """Start everything, say where the console is and when it is ready, stay until Ctrl-C."""
    started = time.monotonic()
    refuse_taken_ports(premises.site, web=True)
    runtime = new_runtime(premises.site, folder)
    with ExitStack() as stack:
        stack.enter_context(announced(meeting_place(runtime)))
        launcher = stack.enter_context(Launcher(runtime, folder, parts_of(runtime)))
        bus = stack.enter_context(ZenohBus(connect=runtime.bus))
        try:
            _introduce(runtime, bus, console, started)
            if record is not None:
                stack.callback(_record(premises, record, bus))
                console.print(f"recording to {record}")
            _idle(launcher, console)
        except KeyboardInterrupt:
            console.print("\nlanding the drone, then leaving (Ctrl-C again leaves at once)")
            _land_and_leave(launcher, console)
    return 0


def _introduce(runtime: Runtime, bus: Bus, console: Console, started: float) -> None:
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
        missing = Readiness(site, bus, web=True, video=video).wait(READY_TIMEOUT, status.update)
    if missing:
        console.print(
            f"[bold]not everything answers:[/bold] {missing}; `housefly doctor` may know why"
        )
        return
    console.print(
        f"ready after {time.monotonic() - started:.1f} s. Open the address, choose a place, hold"
        " Go. Ctrl-C lands and ends."
    )


def _land_and_leave(launcher: Launcher, console: Console) -> None:
    try:
        launcher.stop()
    except KeyboardInterrupt:
        launcher.abandon()
        console.print("left at once: a drone in the air is on its own now")


def _record(premises: Premises, folder: Path, bus: Bus) -> Callable[[], None]:
    recorder = FlightRecorder(folder, premises.site, premises.room, premises.grid)
    open_ = [
        bus.subscribe(STEP, recorder.step),
        bus.subscribe(VIDEO, recorder.video),
        bus.subscribe(LINK, recorder.link),
    ]

    def close() -> None:
        for subscription in open_:
            subscription.close()
        recorder.finish("ended by the user")

    return close


def _idle(launcher: Launcher, console: Console) -> None:
    restarts = dict.fromkeys((part.name for part in launcher.parts), 0)
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
