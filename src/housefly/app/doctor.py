"""Checks what this machine lacks for a flight in the simulated room, and how to install it."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass

from housefly.app.browser_video import video_of_the_browser
from housefly.app.machine_load import OVERLOAD_REMEDY, machine_load, measured_lateness
from housefly.app.ports import PortNeed, port_needs
from housefly.config.site import Site
from housefly.errors import HouseflyError
from housefly.hub.client.discovery import running
from housefly.room.edits import is_reached, reached_from
from housefly.sites.loaded_site import open_site
from housefly.twin.installed import INSTALL, is_installed

_RENDER_PROBE = "import mujoco; c = mujoco.GLContext(8, 8); c.make_current(); c.free()"


@dataclass(frozen=True, slots=True)
class MachineCheck:
    """One check: its name, whether it passed, what was found, and what mends it."""

    name: str
    well: bool
    found: str
    remedy: str = ""
    optional: bool = False


def check_machine(site: Site) -> tuple[MachineCheck, ...]:
    """Check this machine for a site."""
    checks: tuple[Callable[[Site], MachineCheck], ...] = (
        _python, _physics, _renderer, _encoder, _browser, _cores, _load, check_room, _hardware,
        _priority,
    )  # fmt: skip
    return (*(check(site) for check in checks), *_ports(site))


def _python(_: Site) -> MachineCheck:
    version = ".".join(str(part) for part in sys.version_info[:3])
    return MachineCheck(
        "Python", sys.version_info >= (3, 11), version, "apt-get install python3.11"
    )


def _physics(site: Site) -> MachineCheck:
    there = is_installed()
    found = "installed" if there else "missing"
    optional = not site.twin.enabled
    return MachineCheck("simulated room (MuJoCo)", there, found, INSTALL, optional)


def _renderer(_: Site) -> MachineCheck:
    working = [backend for backend in ("egl", "osmesa") if _renders(backend)]
    found = (
        f"works with {', '.join(working)}"
        if working
        else "none: the drone's camera shows a plain card"
    )
    remedy = "apt-get install -y --no-install-recommends libosmesa6"
    return MachineCheck(
        "renderer for the simulated camera", bool(working), found, remedy, optional=True
    )


def _renders(backend: str) -> bool:
    environment = {**os.environ, "MUJOCO_GL": backend}
    done = subprocess.run(
        [sys.executable, "-c", _RENDER_PROBE],
        env=environment,
        capture_output=True,
        timeout=60,
        check=False,
    )
    return done.returncode == 0


def _encoder(_: Site) -> MachineCheck:
    import av

    there = "libx264" in av.codecs_available
    return MachineCheck(
        "H.264 encoder",
        there,
        "libx264" if there else "missing",
        "pip install --force-reinstall av",
        optional=True,
    )


def _browser(_: Site) -> MachineCheck:
    found = video_of_the_browser()
    remedy = "apt-get install -y chromium (the console works without video in any browser)"
    return MachineCheck(
        "browser that shows the video", found.shows, found.words, remedy, optional=True
    )


def _cores(_: Site) -> MachineCheck:
    cores = (
        len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    )
    return MachineCheck(
        "processor cores",
        cores >= 2,
        str(cores),
        "two cores are the target; one is too few for the twin with video",
    )


def _load(_: Site) -> MachineCheck:
    load = machine_load(measured_lateness())
    well = not load.is_too_high
    return MachineCheck("load of this machine", well, load.words, OVERLOAD_REMEDY, optional=True)


def _ports(site: Site) -> tuple[MachineCheck, ...]:
    runs = any(room.site == site.name for room in running())
    return tuple(
        MachineCheck(
            f"ports of the {need.name}",
            (not need.taken or runs) and not need.problem,
            f"used by {site.name}, which runs" if need.taken and runs else _found_at(need),
            f"{'' if need.problem else 'end the program that uses it, or '}change {need.remedy}",
        )
        for need in port_needs(site, web=True)
    )


def _found_at(need: PortNeed) -> str:
    if need.problem:
        return f"nothing can listen at {need.address}: {need.problem}"
    if need.taken:
        return f"taken at {need.address}: {', '.join(need.taken)}"
    return f"free at {need.address}"


def check_room(site: Site) -> MachineCheck:
    """Check that the drone can start in the room of a site and fly to each of its places."""
    remedy = "move or leave out those places: housefly room show draws the room"
    try:
        loaded = open_site(site)
    except HouseflyError as error:
        return MachineCheck("room", False, str(error), "mend that file, or: housefly new")
    x_min, y_min, x_max, y_max = loaded.room.bounds
    size = f"{x_max - x_min:.1f} m x {y_max - y_min:.1f} m"
    if not site.drone_names:
        return MachineCheck("room", True, size)
    reached = reached_from(loaded.grid, loaded.room.home)
    places = loaded.room.places
    lost = [place.name for place in places if not is_reached(reached, loaded.grid, place.viewpoint)]
    if "home" in lost:
        found = "the drone cannot start: the pad is too close to something"
        return MachineCheck("room", False, found, "move the pad: housefly room show draws the room")
    found = f"{size}, {len(places)} places"
    if lost:
        return MachineCheck("room", False, f"{found}; no way leads to {', '.join(lost)}", remedy)
    return MachineCheck("room", True, f"{found}, a way leads to each")


def _hardware(site: Site) -> MachineCheck:
    without = [
        name
        for name, there in (("drone", bool(site.drone_names)), ("tracking", site.tracking.enabled))
        if not there
    ]
    if site.twin.enabled:
        none = f"; no {' and no '.join(without)}" if without else ""
        return MachineCheck("drone and tracking", True, f"simulated{none}")
    if without == ["drone", "tracking"]:
        return MachineCheck("drone and tracking", True, "neither is asked for")
    wire = site.tracking.wire
    tracking = (
        f"{site.tracking.address}:{site.tracking.port_of(wire)}" if wire else site.tracking.address
    )
    drones = [drone.address for drone in site.all_drones if drone.enabled]
    expected = " and ".join([*drones, *([tracking] if site.tracking.enabled else [])])
    return MachineCheck("drone and tracking", True, f"real, expected at {expected}")


def _priority(_: Site) -> MachineCheck:
    well = os.geteuid() == 0
    found = (
        "the pilot may take a higher priority"
        if well
        else "the pilot runs at normal priority, the others below it"
    )
    return MachineCheck(
        "privileges",
        well,
        found,
        "not needed; on a busy machine: sudo setcap cap_sys_nice+ep on a python of its own",
        optional=True,
    )
