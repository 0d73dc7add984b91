"""Client of all tracking systems that PyPI ``motioncapture`` reads, Qualisys among them.

The library gives no capture times: they are the times of arrival less ``tracking.latency``, so
network jitter moves the drone. Prefer a client of our own where there is one. The library blocks
for ever when data stop, and holds the interpreter's lock while it connects. It therefore runs in a
child process, which is killed and restarted when it falls silent.
"""

from __future__ import annotations

import asyncio
import importlib.util
import json
import socket
import sys
from asyncio.subprocess import PIPE, Process
from collections.abc import Callable
from contextlib import suppress

from housefly.bus.reconnect import ReconnectingClient
from housefly.clock import Clock
from housefly.config.tracking import TrackingConfig
from housefly.errors import LinkError, MissingPartError, WireError
from housefly.messages import Sighting
from housefly.messages.words import UNSAID, Words
from housefly.tracking.bridge_lines import BridgeLines
from housefly.tracking.contracts import SightingSink
from housefly.tracking.counts import FrameCounts


class BridgeTracker(ReconnectingClient[tuple[Sighting, ...]]):
    """Starts the child, hands its frames to a sink as they arrive, and restarts it for ever.

    Attributes:
        counts: frames and what was dropped.
    """

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        super().__init__(f"{config.bridge_system} at {config.address} (by motioncapture)", clock)
        self.counts = FrameCounts()
        self._config = config

    @property
    def problem(self) -> Words:
        """Why no poses arrive, or why they are refused; UNSAID where all is well."""
        return self._problem or self.counts.unit_problem(self._clock.now()) or super().problem

    def _no_data_problem(self) -> Words:
        return Words(
            "connected to {name}, but nothing new arrives; is {what} live, not paused?",
            name=self._where,
            what="motioncapture",
        )

    def _protocol_problem(self, error: WireError) -> Words:
        return Words(
            "what answers at {name} does not speak {protocol} ({error})",
            name=self._where,
            protocol="motioncapture",
            error=str(error),
        )

    async def _read_connection(self, sink: SightingSink) -> None:
        if importlib.util.find_spec("motioncapture") is None:
            raise MissingPartError("motioncapture", "pip install 'housefly[mocap]'")
        child = await asyncio.create_subprocess_exec(
            *(sys.executable, "-m", "housefly.tracking.bridge_child", self._config.bridge_system),
            json.dumps(connection_settings(self._config)),
            stdin=PIPE,
            stdout=PIPE,
        )
        try:
            lines = BridgeLines(self._config.latency, self._config.y_up, self.counts)
            while True:
                line = await self._line(child)
                now = self._clock.now()
                sightings = lines.read(line, now)
                self._problem = UNSAID
                if sightings is not None:
                    self._data_arrived(now)
                    sink(sightings)
        finally:
            with suppress(ProcessLookupError):
                child.kill()
            await child.wait()

    async def _line(self, child: Process) -> bytes:
        assert child.stdout is not None
        silence = f"{self._where} is silent; is it there, streaming, and this body seen?"
        try:
            line = await self._before_timeout(child.stdout.readline(), silence)
        except ValueError as error:
            raise WireError("bridge line: longer than 64 kB") from error
        if not line:
            raise LinkError(f"the bridge to {self._where} ended")
        return line


def connection_settings(config: TrackingConfig) -> dict[str, str]:
    """Return the settings with which ``motioncapture`` connects to a system."""
    more: Callable[[TrackingConfig], dict[str, str]] = _SETTINGS.get(
        config.bridge_system, lambda _: {}
    )
    return {"hostname": config.address} | more(config)


def _our_address(config: TrackingConfig) -> str:
    """Return our address on the route to the system; sends nothing."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect((config.address, config.natnet_port))
        except OSError as error:
            raise LinkError(f"{config.address} cannot be reached ({error.strerror})") from error
        return str(probe.getsockname()[0])


_SETTINGS: dict[str, Callable[[TrackingConfig], dict[str, str]]] = {
    "vicon": lambda config: {"hostname": f"{config.address}:{config.port}"},
    "optitrack": lambda config: {
        "port_command": str(config.natnet_port),
        "interface_ip": _our_address(config),
    },
    "vrpn": lambda config: {"hostname": f"{config.address}:{config.vrpn_port}"},
}
