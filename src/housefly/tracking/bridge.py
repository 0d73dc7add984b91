"""Client of all tracking systems that PyPI ``motioncapture`` reads, Qualisys among them.

The library gives no capture times: they are the times of arrival less ``tracking.latency``, so
network jitter moves the drone. Prefer a client of our own where there is one. The library blocks
for ever when data stop, and holds the interpreter's lock while it connects. It therefore runs in a
child process, which is killed and restarted when it falls silent.
"""

from __future__ import annotations

import importlib.util
import json
import socket
import sys
from collections.abc import Callable

from housefly.clock import Clock
from housefly.config.tracking import TrackingConfig
from housefly.errors import LinkError, MissingPartError, WireError
from housefly.messages import Sighting
from housefly.messages.words import Words
from housefly.tracking.bridge_lines import BridgeLines
from housefly.tracking.child_tracker import ChildTracker


class BridgeTracker(ChildTracker):
    """Reads what ``motioncapture`` tells in its child."""

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        super().__init__(f"{config.bridge_system} at {config.address} (by motioncapture)", clock)
        self._config = config
        self._begin()

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

    def _command(self) -> tuple[str, ...]:
        if importlib.util.find_spec("motioncapture") is None:
            raise MissingPartError("motioncapture", "pip install 'housefly[mocap]'")
        settings = json.dumps(connection_settings(self._config))
        child = "housefly.tracking.bridge_child"
        return sys.executable, "-m", child, self._config.bridge_system, settings

    def _begin(self) -> None:
        self._lines = BridgeLines(self._config.latency, self._config.y_up, self.counts)

    def _read(self, line: bytes, received_at: float) -> tuple[Sighting, ...] | None:
        return self._lines.read(line, received_at)


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
