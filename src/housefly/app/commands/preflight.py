"""``housefly preflight``: everything that is looked at before a take-off, without one."""

from __future__ import annotations

import tempfile
import time
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from rich.markup import escape

from housefly.app.commands.shared import (
    add_drone_argument,
    add_fault_argument,
    add_instance_argument,
    add_site_arguments,
    chosen_drone,
    load,
    load_drone,
)
from housefly.app.commands.subcommand import Subcommand
from housefly.app.terminal import console
from housefly.errors import LinkError

if TYPE_CHECKING:
    from housefly.bus.bus import Bus
    from housefly.config.site import Site
    from housefly.hub.api.pilot_queries import PreflightView

_START_TIMEOUT = 60.0
"""Longest time until pilot, tracking and drone answer [s]."""
_SETTLING_TIME = 3.0
"""Time for tracking and the drone's settings to settle after a start [s]."""
_EPILOG = """\
A running house is asked; where none runs, everything is started without the console, looked at, \
and ended.
Nothing takes off. The exit code is 0 when a take-off would be allowed.

--frames, before the first flight of a room and after each change of its tracking:
  You carry the drone by hand: onto its pad, 1 m along its nose, 1 m to its side, 0.5 m up, a
  quarter turn to the left, and back onto the pad to verify. You read what tracking and the drone
  itself make of it while you carry. Found are mirrored axes, a turned or shifted frame, a body
  defined turned, another body under the drone's name, millimetres for metres, a wrong up axis,
  and tracking that is late. Each is told with the line of the site file that mends it.
  Two minutes; a tape measure of 1 m. The driver and tracking are started, but no pilot: nothing
  can take off in your hands. What is asked about is what looks as if you had done something else
  than asked: put it right, or press Enter again and stand by it.
  The exit code is 0 when tracking, drone and map agree. The result is kept beside the memory of
  the site, and the list above tells it until [tracking] changes.

examples:
  housefly preflight --site mylab.toml                          # may it take off?
  housefly preflight --site mylab.toml --frames                 # carry the drone
  housefly preflight --frames                                   # simulated hands carry it
  housefly preflight --frames --fault mocap.map:wrong           # ... in a mirrored room
  housefly preflight --frames --fault mocap.yaw:wrong=1.57      # ... with its body turned
"""


def _run(options: Namespace) -> int:
    """Look, or let a person carry the drone; 0 when nothing forbids a take-off."""
    if options.frames:
        return _check_frames(options)
    site = load(options).site
    drone = chosen_drone(site, options)
    view = _of_running_house(site, drone) or _of_fresh_house(site, drone)
    if not view.checks:
        raise LinkError(f"{site.name} has looked at nothing yet, or runs without a drone")
    for check in view.checks:
        mark = "[green]ok  [/green]" if check.passed else _MARKS[check.required]
        what = check.title if check.passed else check.fault
        words = f"  {what}: {check.value}  ({check.limit})"
        console.print(f"{mark}{escape(words)}", soft_wrap=True)
        if not check.passed:  # [tracking] in it is a table of the site file, no style
            console.print(f"        {check.why}", markup=False, soft_wrap=True)
            console.print(f"        -> {check.mend}", markup=False, soft_wrap=True)
    console.print("[bold]READY[/bold]" if view.ready else "[bold]NOT READY[/bold]")
    return 0 if view.ready else 1


def _check_frames(options: Namespace) -> int:
    from housefly.app.frame_check.run import run_frame_check

    loaded = load_drone(options, with_edits=True)
    try:
        return 0 if run_frame_check(loaded).passed else 1
    except KeyboardInterrupt:
        console.print("\ngiven up: nothing is kept; put the drone down")
        return 130


_MARKS = {True: "[red]no  [/red]", False: "[yellow]look[/yellow]"}


def _of_running_house(site: Site, drone: str) -> PreflightView | None:
    from housefly.bus.zenoh_bus import ZenohBus
    from housefly.hub.client.discovery import running

    for house in running():
        if house.site == site.name and house.bus:
            with ZenohBus(connect=house.bus) as bus:
                return _asked(bus, drone)
    return None


def _of_fresh_house(site: Site, drone: str) -> PreflightView:
    from housefly.app.end_signals import EndSignals
    from housefly.app.launcher import Launcher, processes_of
    from housefly.app.new_runtime import new_runtime
    from housefly.app.ports import refuse_taken_ports
    from housefly.app.readiness import Readiness
    from housefly.bus.zenoh_bus import ZenohBus

    refuse_taken_ports(site, web=False)
    with tempfile.TemporaryDirectory() as name, EndSignals():
        folder = Path(name)
        runtime = new_runtime(site, folder)
        with (
            Launcher(runtime, folder, processes_of(runtime)) as launcher,
            ZenohBus(connect=runtime.bus) as bus,
            console.status("starting") as status,
        ):
            missing = Readiness(site, bus, web=False, video=False).wait(
                _START_TIMEOUT, status.update, lambda: launcher.given_up != ()
            )
            if launcher.given_up:
                raise LinkError(str(launcher.given_up[0]))
            if missing:
                console.print(f"after {_START_TIMEOUT:.0f} s: {missing}", markup=False)
            status.update("looking")
            time.sleep(_SETTLING_TIME)
            return _asked(bus, drone)


def _asked(bus: Bus, drone: str) -> PreflightView:
    from housefly.bus.topics import DroneTopics
    from housefly.hub.api.pilot_queries import PreflightView
    from housefly.hub.api.pilot_queries_json import from_json

    return from_json(PreflightView, bus.ask(DroneTopics(drone).preflight, ""))


def _add_arguments(parser: ArgumentParser) -> None:
    add_site_arguments(parser)
    add_drone_argument(parser)
    add_instance_argument(parser)
    parser.add_argument(
        "--frames",
        action="store_true",
        help="carry the drone through six places, to compare tracking, drone and map",
    )
    add_fault_argument(parser)


PREFLIGHT_COMMAND = Subcommand(
    name="preflight",
    help="everything that is looked at before a take-off, without one",
    add_arguments=_add_arguments,
    run=_run,
    epilog=_EPILOG,
)
