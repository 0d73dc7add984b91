"""Where a flight controller answers, as ``drone.address`` says it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import Enum

from housefly.errors import ConfigError

TCP_PORT = 5761
"""Of Betaflight's own simulation, and of ours; bridges from Wi-Fi to serial choose theirs."""
BAUD = 115200
_NETWORK = re.compile(r"(?:(udp|tcp):)?([\w.-]+|\[[0-9a-fA-F:]+\])(?::(\d{1,5}))?", re.ASCII)
_SERIAL = re.compile(r"serial:(/[\w./-]+)(?::(\d{4,7}))?", re.ASCII)


class Carrier(Enum):
    """What carries the bytes."""

    TCP = "tcp"
    UDP = "udp"
    SERIAL = "serial"


@dataclass(frozen=True, slots=True)
class MspEndpoint:
    """A controller's end of a wire.

    Attributes:
        carrier: what carries the bytes.
        place: host, or file of the serial port.
        number: port, or baud rate.
    """

    carrier: Carrier
    place: str
    number: int

    def __str__(self) -> str:
        return f"{self.carrier.value}:{self.place}:{self.number}"


def msp_endpoint_of(address: str) -> MspEndpoint:
    """Return the endpoint of an address: ``HOST``, ``tcp:HOST:PORT``, ``udp:...``, ``serial:FILE``.

    What is left out is TCP, port 5761, and 115200 baud.

    Raises:
        ConfigError: another form, or no such port.
    """
    serial = _SERIAL.fullmatch(address)
    if serial is not None:
        return MspEndpoint(Carrier.SERIAL, serial[1], int(serial[2] or BAUD))
    found = _NETWORK.fullmatch(address)
    port = int(found[3] or TCP_PORT) if found else 0
    if found is None or not 0 < port < 65536:
        raise ConfigError(
            "drone.address",
            f"is {address!r}; allowed: an IP address, tcp:ADDRESS:PORT, udp:ADDRESS:PORT, or"
            " serial:/dev/ttyACM0:BAUD",
        )
    return MspEndpoint(Carrier(found[1] or "tcp"), found[2].strip("[]"), port)
