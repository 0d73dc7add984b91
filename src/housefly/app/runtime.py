"""What each process of a run needs: endpoints, secrets and the checked site.

The launcher passes it on in a file and in environment variables.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from housefly.bus.stop_port import StopPort
from housefly.config.drone import DRONE_NAME
from housefly.config.environment import (
    BUS_VARIABLE,
    RECORDING_VARIABLE,
    ROOM_KEY_VARIABLE,
    SECRET_VARIABLE,
    SITE_VARIABLE,
    SOCKETS_VARIABLE,
    STOP_PORTS_VARIABLE,
    TOKEN_VARIABLE,
    stop_ports_of_text,
    stop_ports_to_text,
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
        stop_ports: loopback UDP ports of the STOP path, by the names of the drones.
        secret: key of the STOP path.
        token: one-time token of the console's address.
        sockets: folder of the private sockets, where each driver waits for its pilot.
        room_key: with which programs of this user ask the room.
        recording: folder into which the whole run is recorded, or None.
        held_ports: keep other users from the ports of STOP; only with whoever started the run.
        console_port: the same for the console's, where there is a console.
    """

    site_file: Path
    bus: str
    stop_ports: dict[str, int]
    secret: str
    token: str
    sockets: Path
    room_key: str
    recording: Path | None = None
    held_ports: tuple[StopPort, ...] = field(default=(), compare=False, repr=False)
    console_port: ConsolePort | None = field(default=None, compare=False, repr=False)

    @property
    def has_console(self) -> bool:
        """Whether there is a console."""
        return self.console_port is not None

    @property
    def room_socket(self) -> Path:
        """Unix socket on which the hub answers programs of this user."""
        return self.sockets / "room"

    @property
    def tracking_socket(self) -> Path:
        """Unix socket on which the room's process tells pilots what is tracked."""
        return self.sockets / "tracking"

    def driver_socket(self, drone: str) -> Path:
        """Return the Unix socket on which the driver of a drone waits for its pilot."""
        return self.sockets / f"driver-{drone}"

    def environment(self) -> dict[str, str]:
        """Return the environment for a child process."""
        mine = {
            SITE_VARIABLE: str(self.site_file),
            BUS_VARIABLE: self.bus,
            STOP_PORTS_VARIABLE: stop_ports_to_text(self.stop_ports),
            SECRET_VARIABLE: self.secret,
            TOKEN_VARIABLE: self.token,
            SOCKETS_VARIABLE: str(self.sockets),
            ROOM_KEY_VARIABLE: self.room_key,
        }
        recording = {RECORDING_VARIABLE: str(self.recording.absolute())} if self.recording else {}
        return {**os.environ, **mine, **recording}

    def site(self) -> Site:
        """Return the site."""
        from housefly.config.site import site_from_file  # the driver knows of a part of it only

        return site_from_file(self.site_file)


def runtime_from_environment() -> Runtime:
    """Return the run of this process; raises ConfigError when the launcher did not start it."""
    try:
        return Runtime(
            Path(os.environ[SITE_VARIABLE]),
            os.environ[BUS_VARIABLE],
            stop_ports_of_text(os.environ[STOP_PORTS_VARIABLE]),
            os.environ[SECRET_VARIABLE],
            os.environ[TOKEN_VARIABLE],
            Path(os.environ[SOCKETS_VARIABLE]),
            os.environ[ROOM_KEY_VARIABLE],
            Path(recording) if (recording := os.environ.get(RECORDING_VARIABLE)) else None,
        )
    except (KeyError, ValueError) as error:
        raise ConfigError(
            "environment", f"{error}: start this process with `housefly run` or `housefly demo`"
        ) from error


def drone_argument(arguments: Sequence[str] | None = None) -> str:
    """Return for which drone a process is; ``--drone NAME``, or the only one of its site."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--drone", default=DRONE_NAME, help="name of the drone")
    return str(parser.parse_args(arguments).drone)
