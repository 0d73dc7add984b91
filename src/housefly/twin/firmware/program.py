"""A firmware's program as a process, in a folder of its own that ends with it."""

from __future__ import annotations

import os
import shutil
import socket
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from housefly.errors import ConfigError, LinkError
from housefly.twin.address import check_address
from housefly.twin.contracts import TwinDrone
from housefly.twin.simulated_drone import SimulatedDrone
from housefly.twin.world import SimulatedWorld

_END_TIMEOUT = 2.0
_PREPARATION_TIMEOUT = 20.0
_LOG_NAME = "program.log"
_LOG_TOLD = 400


class Program:
    """One process; it ends with this one, whatever ends this one.

    Args:
        path: of the program.

    Attributes:
        folder: where it runs and writes; gone after ``stop``.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self.folder = Path(tempfile.mkdtemp(prefix="housefly-firmware-"))
        self._process: subprocess.Popen[bytes] | None = None

    def prepare(self, arguments: Sequence[str]) -> None:
        """Run it until it ends, to be set; raises LinkError when it does not end well."""
        self.start(arguments)
        assert self._process is not None
        try:
            code = self._process.wait(_PREPARATION_TIMEOUT)
        except subprocess.TimeoutExpired as error:
            self._process.kill()
            self._process.wait()
            raise LinkError(f"{self._path} was not set in time: {self.said}") from error
        if code:
            raise LinkError(f"{self._path} cannot be set (code {code}): {self.said}")

    def start(self, arguments: Sequence[str]) -> None:
        """Start it; raises LinkError when it cannot be started."""
        if not os.access(self._path, os.X_OK) or not self._path.is_file():
            raise LinkError(f"{self._path} is no program that can be started")
        leash = [sys.executable, "-m", "housefly.twin.firmware.leashed", str(os.getpid())]
        with (self.folder / _LOG_NAME).open("ab") as log:
            self._process = subprocess.Popen(
                [*leash, str(self._path.resolve()), *arguments],
                cwd=self.folder,
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=subprocess.STDOUT,
            )

    @property
    def has_ended(self) -> bool:
        """Whether it ended by itself."""
        return self._process is not None and self._process.poll() is not None

    @property
    def said(self) -> str:
        """The end of what it printed."""
        log = self.folder / _LOG_NAME
        if not log.exists():
            return ""
        return log.read_text(errors="replace")[-_LOG_TOLD:].strip()

    def stop(self) -> None:
        """End it and remove its folder."""
        if self._process is not None and self._process.poll() is None:
            self._process.terminate()
            try:
                self._process.wait(_END_TIMEOUT)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


def drone_to_board(
    name: str, drone: TwinDrone, address: str, beyond_loopback: bool
) -> SimulatedDrone:
    """Return the simulated drone that a program is to fly.

    Args:
        name: of the firmware, for people.
        drone: or the world of one.
        address: IP address that the program is to be reached at.
        beyond_loopback: whether the user asked to serve other machines.

    Raises:
        ConfigError: no such drone; an address, or an interface, that other machines can reach.
    """
    check_address("drone.address", address, beyond_loopback)
    check_alone(name, beyond_loopback)
    boarded = drone.first if isinstance(drone, SimulatedWorld) else drone
    if not isinstance(boarded, SimulatedDrone):
        raise ConfigError("drone.kind", f"is no simulated drone that {name} could fly")
    return boarded


def check_alone(name: str, beyond_loopback: bool) -> None:
    """Refuse to start a program that listens on every interface where others can reach it.

    Args:
        name: of the firmware, for people.
        beyond_loopback: whether the user asked to serve other machines.

    Raises:
        ConfigError: there is another interface than loopback.
    """
    others = [interface for _, interface in socket.if_nameindex() if interface != "lo"]
    if others and not beyond_loopback:
        raise ConfigError(
            "drone.kind",
            f"the program of {name} listens on every interface ({', '.join(others)} too); start it"
            " in a network namespace of its own (unshare -rn), or with --beyond-loopback",
        )
