"""Makes the endpoints and secrets of a new run, for whoever starts its processes."""

from __future__ import annotations

import os
import random
import secrets
import socket
from contextlib import suppress
from pathlib import Path

from housefly.app.run_folder import new_run_folder
from housefly.app.runtime import Runtime
from housefly.bus.endpoint import endpoint_in
from housefly.bus.stop_port import StopPort
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.hub.client.discovery import RoomAddress
from housefly.twin.faults.parse import faults_of
from housefly.web.access.exposure import console_address
from housefly.web.access.session_auth import api_key
from housefly.web.console_port import ConsolePort


def new_runtime(site: Site, folder: Path, *, web: bool = False) -> Runtime:
    """Write the site into a folder; make a folder for sockets, free ports and fresh secrets.

    Args:
        site: of the run.
        folder: where its file goes.
        web: whether there is a console, whose port is held from now on.

    Raises:
        ConfigError: the console's address cannot be had, or the site's faults make no sense.
    """
    faults_of(site)
    console = ConsolePort(site.web.host, site.web.port) if web else None
    if site.web.port == 0:
        site = changed(site, web__port=console.number if console else _free_port())
    if site.mqtt.start and site.mqtt.port == 0:
        site = changed(site, mqtt__port=_free_port())
    site_file = folder / "site.json"
    site_file.write_text(site.model_dump_json(indent=1), encoding="utf-8")
    sockets, secret = new_run_folder(), secrets.token_hex(16)
    held = {name: StopPort() for name in site.drone_names or (site.drone.name,)}
    return Runtime(
        site_file,
        bus=endpoint_in(sockets),
        stop_ports={name: port.number for name, port in held.items()},
        secret=secret,
        token=secrets.token_urlsafe(16),
        sockets=sockets,
        room_key=api_key(secret),
        held_ports=tuple(held.values()),
        console_port=console,
    )


def discovery_entry(runtime: Runtime) -> RoomAddress:
    """Return what other programs of this user need to find the room of a run."""
    site = runtime.site()
    room = str(runtime.room_socket) if site.hub.enabled else ""
    return RoomAddress(
        site.name,
        console_address(site),
        runtime.room_key,
        os.getpid(),
        room,
        runtime.bus,
        site.drone_names or (site.drone.name,),
    )


_PORTS = range(20_000, 32_000)
"""Below those that Linux gives to outgoing connections: one of these could take it meanwhile."""
_TRIES = 50


def _free_port() -> int:
    """Return a free TCP port of loopback."""
    for port in (*random.sample(_PORTS, _TRIES), 0):
        with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as probe, suppress(OSError):
            probe.bind(("127.0.0.1", port))
            return int(probe.getsockname()[1])
    raise ConfigError("the machine", "has no free TCP port of loopback")
