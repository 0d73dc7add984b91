"""What this machine lacks to fly the simulated room with a console, and the line that mends it."""

from __future__ import annotations

import importlib.util
import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass

from housefly.config import Site

PROBE = "import mujoco; c = mujoco.GLContext(8, 8); c.make_current(); c.free()"
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "firefox", "microsoft-edge")


@dataclass(frozen=True, slots=True)
class Finding:
    """One check: what was looked at, whether it is well, what was found, and the line that mends it."""

    name: str
    well: bool
    found: str
    remedy: str = ""
    optional: bool = False


def examine(site: Site) -> tuple[Finding, ...]:
    """Check this machine for a site."""
    checks: tuple[Callable[[Site], Finding], ...] = (
        _python, _physics, _renderer, _encoder, _browser, _cores, _drone_ports, _tracking_port, _console_port, _priority,
    )  # fmt: skip
    return tuple(check(site) for check in checks)


def _python(_: Site) -> Finding:
    version = ".".join(str(part) for part in sys.version_info[:3])
    return Finding("Python", sys.version_info >= (3, 11), version, "apt-get install python3.11")


def _physics(_: Site) -> Finding:
    there = importlib.util.find_spec("mujoco") is not None
    return Finding("simulated room (MuJoCo)", there, "installed" if there else "missing", "pip install 'housefly[twin]'")


def _renderer(_: Site) -> Finding:
    working = [backend for backend in ("egl", "osmesa") if _renders(backend)]
    found = f"works with {', '.join(working)}" if working else "none: the drone's camera shows a plain card"
    remedy = "apt-get install -y --no-install-recommends libosmesa6"
    return Finding("renderer for the simulated camera", bool(working), found, remedy, optional=True)


def _renders(backend: str) -> bool:
    environment = {**os.environ, "MUJOCO_GL": backend}
    done = subprocess.run([sys.executable, "-c", PROBE], env=environment, capture_output=True, timeout=60, check=False)
    return done.returncode == 0


def _encoder(_: Site) -> Finding:
    import av

    there = "libx264" in av.codecs_available
    return Finding("H.264 encoder", there, "libx264" if there else "missing", "pip install --force-reinstall av", optional=True)


def _browser(_: Site) -> Finding:
    there = [name for name in BROWSERS if shutil.which(name)]
    found = f"{there[0]} (any browser that knows WebCodecs shows the video)" if there else "none found on this machine"
    return Finding("browser", bool(there), found, "apt-get install -y chromium", optional=True)


def _cores(_: Site) -> Finding:
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return Finding("processor cores", cores >= 2, str(cores), "two cores are the target; one is too few for the twin with video")


def _drone_ports(site: Site) -> Finding:
    if not site.twin.enabled:
        return Finding("drone", True, f"real, expected at {site.drone.address}")
    taken = [f"UDP {port}" for port in (5554, 5556) if not _free(site.drone.address, port, socket.SOCK_DGRAM)]
    taken += [f"TCP {port}" for port in (5555, 5559) if not _free(site.drone.address, port, socket.SOCK_STREAM)]
    return _ports("ports of the simulated drone", taken, site.drone.address, "drone.address, for example 127.0.0.2")


def _tracking_port(site: Site) -> Finding:
    address, port = site.tracking.address, site.tracking.port
    if not site.twin.enabled:
        return Finding("tracking system", True, f"real, expected at {address}:{port}")
    taken = [] if _free(address, port, socket.SOCK_STREAM) else [f"TCP {port}"]
    return _ports("port of the simulated tracking system", taken, address, "tracking.port")


def _console_port(site: Site) -> Finding:
    taken = [] if _free(site.web.host, site.web.port, socket.SOCK_STREAM) else [f"TCP {site.web.port}"]
    return _ports("port of the console", taken, site.web.host, "web.port (or use --port)")


def _ports(name: str, taken: list[str], address: str, key: str) -> Finding:
    found = f"taken at {address}: {', '.join(taken)}" if taken else f"free at {address}"
    return Finding(name, not taken, found, f"end the program that uses it, or change {key} in the site file")


def _free(address: str, port: int, kind: socket.SocketKind) -> bool:
    with socket.socket(socket.AF_INET, kind) as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((address, port))
        except OSError:
            return False
    return True


def _priority(_: Site) -> Finding:
    well = os.geteuid() == 0
    found = "the pilot may take a higher priority" if well else "the pilot runs at normal priority, the others below it"
    return Finding(
        "privileges",
        well,
        found,
        "not needed; on a busy machine: sudo setcap cap_sys_nice+ep on a python of its own",
        optional=True,
    )
