"""What each process of a run needs: endpoints, secrets and the checked site.

The launcher passes it on in a file and in environment variables.
"""

from __future__ import annotations

import os
import secrets
import socket
from dataclasses import dataclass, field
from pathlib import Path

from housefly.app.run_folder import new_run_folder
from housefly.bus.endpoint import endpoint_in
from housefly.bus.stop_port import StopPort
from housefly.config.environment import (
    BUS_VARIABLE,
    DRIVER_SOCKET_VARIABLE,
    RECORDING_VARIABLE,
    ROOM_SOCKET_VARIABLE,
    SECRET_VARIABLE,
    SITE_VARIABLE,
    STOP_PORT_VARIABLE,
    TOKEN_VARIABLE,
)
from housefly.config.site import Site, changed, site_from_file
from housefly.errors import ConfigError
from housefly.hub.client.discovery import ROOM_KEY, RoomAddress
from housefly.web.console_port import ConsolePort
from housefly.web.exposure import console_address
from housefly.web.session_auth import api_key


@dataclass(frozen=True, slots=True)
class Runtime:
    """Endpoints and secrets of one run.

    Attributes:
        site_file: the checked site with all changes applied, as JSON.
        bus: zenoh endpoint on which the pilot listens.
        stop_port: loopback UDP port of the STOP path.
        secret: key of the STOP path.
        token: one-time token of the console's address.
        room_socket: Unix socket on which the hub answers programs of this user.
        driver_socket: Unix socket on which the driver waits for its pilot.
        recording: folder into which the whole run is recorded, or None.
        held_port: keeps other users from the port of STOP; only with whoever started the run.
        console_port: the same for the console's, where there is a console.
    """

    site_file: Path
    bus: str
    stop_port: int
    secret: str
    token: str
    room_socket: Path
    driver_socket: Path
    recording: Path | None = None
    held_port: StopPort | None = field(default=None, compare=False, repr=False)
    console_port: ConsolePort | None = field(default=None, compare=False, repr=False)

    @property
    def has_console(self) -> bool:
        """Whether there is a console."""
        return self.console_port is not None

    def environment(self) -> dict[str, str]:
        """Return the environment for a child process."""
        mine = {
            SITE_VARIABLE: str(self.site_file),
            BUS_VARIABLE: self.bus,
            STOP_PORT_VARIABLE: str(self.stop_port),
            SECRET_VARIABLE: self.secret,
            TOKEN_VARIABLE: self.token,
            DRIVER_SOCKET_VARIABLE: str(self.driver_socket),
        }
        room = {ROOM_SOCKET_VARIABLE: str(self.room_socket), ROOM_KEY: api_key(self.secret)}
        recording = {RECORDING_VARIABLE: str(self.recording.absolute())} if self.recording else {}
        return {**os.environ, **mine, **room, **recording}

    def site(self) -> Site:
        """Return the site."""
        return site_from_file(self.site_file)


def new_runtime(site: Site, folder: Path, *, web: bool = False) -> Runtime:
    """Write the site into a folder; make a folder for sockets, a free port and fresh secrets.

    Args:
        site: of the run.
        folder: where its file goes.
        web: whether there is a console, whose port is held from now on.

    Raises:
        ConfigError: the console's address cannot be had.
    """
    console = ConsolePort(site.web.host, site.web.port) if web else None
    if site.web.port == 0:
        site = changed(site, web__port=console.number if console else _free_port())
    if site.mqtt.start and site.mqtt.port == 0:
        site = changed(site, mqtt__port=_free_port())
    site_file = folder / "site.json"
    site_file.write_text(site.model_dump_json(indent=1), encoding="utf-8")
    sockets, held = new_run_folder(), StopPort()
    return Runtime(
        site_file,
        bus=endpoint_in(sockets),
        stop_port=held.number,
        secret=secrets.token_hex(16),
        token=secrets.token_urlsafe(16),
        room_socket=sockets / "room",
        driver_socket=sockets / "driver",
        held_port=held,
        console_port=console,
    )


def discovery_entry(runtime: Runtime) -> RoomAddress:
    """Return what other programs of this user need to find the room of a run."""
    site = runtime.site()
    room = str(runtime.room_socket) if site.hub.enabled else ""
    return RoomAddress(
        site.name,
        console_address(site),
        api_key(runtime.secret),
        os.getpid(),
        room,
        runtime.bus,
    )


def runtime_from_environment() -> Runtime:
    """Return the run of this process; raises ConfigError when the launcher did not start it."""
    try:
        site_file, stop_port, room_socket = (
            Path(os.environ[SITE_VARIABLE]),
            int(os.environ[STOP_PORT_VARIABLE]),
            Path(os.environ[ROOM_SOCKET_VARIABLE]),
        )
        return Runtime(
            site_file,
            os.environ[BUS_VARIABLE],
            stop_port,
            os.environ[SECRET_VARIABLE],
            os.environ[TOKEN_VARIABLE],
            room_socket,
            Path(os.environ[DRIVER_SOCKET_VARIABLE]),
            Path(recording) if (recording := os.environ.get(RECORDING_VARIABLE)) else None,
        )
    except (KeyError, ValueError) as error:
        raise ConfigError(
            "environment", f"{error}: start this process with `housefly run` or `housefly demo`"
        ) from error


def _free_port() -> int:
    """Return a free TCP port of loopback."""
    with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])
