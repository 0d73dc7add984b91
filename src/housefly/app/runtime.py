"""What each process of a run needs: endpoints, secrets and the checked site.

The launcher passes it on in a file and in environment variables.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.bus.stop_port import StopPort
from housefly.config.environment import (
    BUS_VARIABLE,
    DRIVER_SOCKET_VARIABLE,
    RECORDING_VARIABLE,
    ROOM_KEY_VARIABLE,
    ROOM_SOCKET_VARIABLE,
    SECRET_VARIABLE,
    SITE_VARIABLE,
    STOP_PORT_VARIABLE,
    TOKEN_VARIABLE,
    TRACKING_SOCKET_VARIABLE,
)
from housefly.errors import ConfigError

if TYPE_CHECKING:
    from housefly.config.site import Site
    from housefly.web.console_port import ConsolePort


@dataclass(frozen=True, slots=True)
class Runtime:
    """Endpoints and secrets of one run.

    Attributes:
        site_file: the checked site with all changes applied, as JSON.
        bus: zenoh endpoint on which the room's process listens.
        stop_port: loopback UDP port of the STOP path.
        secret: key of the STOP path.
        token: one-time token of the console's address.
        room_socket: Unix socket on which the hub answers programs of this user.
        driver_socket: Unix socket on which the driver waits for its pilot.
        tracking_socket: Unix socket on which the room's process tells pilots what is tracked.
        room_key: with which programs of this user ask the room.
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
    tracking_socket: Path
    room_key: str
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
            TRACKING_SOCKET_VARIABLE: str(self.tracking_socket),
        }
        room = {ROOM_SOCKET_VARIABLE: str(self.room_socket), ROOM_KEY_VARIABLE: self.room_key}
        recording = {RECORDING_VARIABLE: str(self.recording.absolute())} if self.recording else {}
        return {**os.environ, **mine, **room, **recording}

    def site(self) -> Site:
        """Return the site."""
        from housefly.config.site import site_from_file  # the driver knows of a part of it only

        return site_from_file(self.site_file)


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
            Path(os.environ[TRACKING_SOCKET_VARIABLE]),
            os.environ[ROOM_KEY_VARIABLE],
            Path(recording) if (recording := os.environ.get(RECORDING_VARIABLE)) else None,
        )
    except (KeyError, ValueError) as error:
        raise ConfigError(
            "environment", f"{error}: start this process with `housefly run` or `housefly demo`"
        ) from error
