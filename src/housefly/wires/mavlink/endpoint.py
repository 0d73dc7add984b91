"""Where a vehicle answers, as ``drone.address`` says it."""

from __future__ import annotations

import re
from dataclasses import dataclass

from housefly.errors import ConfigError
from housefly.wires.mavlink.autopilots import Autopilot

_FORM = re.compile(r"(?:(udp|tcp):)?([\w.-]+|\[[0-9a-fA-F:]+\])(?::(\d{1,5}))?", re.ASCII)


@dataclass(frozen=True, slots=True)
class Endpoint:
    """A vehicle's end of a wire.

    Attributes:
        is_stream: TCP, else UDP.
        host, port: its own.
        own_port: ours on UDP, 0 for any.
    """

    is_stream: bool
    host: str
    port: int
    own_port: int

    def __str__(self) -> str:
        return f"{'tcp' if self.is_stream else 'udp'}:{self.host}:{self.port}"


def endpoint_of(address: str, autopilot: Autopilot) -> Endpoint:
    """Return the endpoint of an address: ``HOST``, ``udp:HOST:PORT`` or ``tcp:HOST:PORT``.

    What is left out is UDP, and the autopilot's usual port.

    Raises:
        ConfigError: another form, or no such port.
    """
    found = _FORM.fullmatch(address)
    port = int(found[3] or 0) if found else -1
    if found is None or not 0 <= port < 65536:
        raise ConfigError(
            "drone.address",
            f"is {address!r}; allowed: an IP address, or udp:ADDRESS:PORT, or tcp:ADDRESS:PORT",
        )
    is_stream = found[1] == "tcp"
    usual = autopilot.tcp_port if is_stream else autopilot.udp_port
    own_port = autopilot.own_port if not is_stream and port in (0, usual) else 0
    return Endpoint(is_stream, found[2].strip("[]"), port or usual, own_port)
