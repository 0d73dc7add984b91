"""Add a sensor of your own: light sensors that send a line of text over UDP.

Learns: what a sensor driver owes the room, in four members; how a bad line is counted and named
    instead of believed.
Prints: each observation as the room would hear it, then how the driver and its two lamps do.
"""

import asyncio
import socket
import time
from collections import Counter
from math import isfinite

from housefly.errors import WireError
from housefly.messages import Observation
from housefly.sensors.contracts import Sensor, SensorHealth, SensorSink
from housefly.sensors.message_rate import MessageRate

SILENT = 5.0
"""A lamp that says nothing for this long [s] is not there."""


def decode(line: bytes) -> tuple[str, float]:
    """Return name and illuminance [lx] of a line like ``desk-lamp 320.5``; raises WireError that
    names what is wrong.
    """
    try:
        name, number = line.decode("ascii").split()
        lux = float(number)
    except ValueError as error:
        raise WireError(f"{line[:40]!r} is not a name and a number") from error
    if not (isfinite(lux) and 0.0 <= lux <= 200_000.0):
        raise WireError(f"{name} is {lux:g}; allowed: a number from 0 to 200000 lx")
    return name, lux


class LightSensors(asyncio.DatagramProtocol):
    """Every lamp that speaks to one UDP port of loopback."""

    def __init__(self, port: int) -> None:
        self.problem, self._port, self._lost = "", port, Counter[str]()
        self._lamps: dict[str, MessageRate] = {}

    async def run(self, sink: SensorSink) -> None:
        """Listen until cancelled."""
        self._sink = sink
        transport, _ = await asyncio.get_running_loop().create_datagram_endpoint(
            lambda: self, ("127.0.0.1", self._port)
        )
        try:
            await asyncio.Event().wait()
        finally:
            transport.close()

    def datagram_received(self, data: bytes, addr: tuple[str, int]) -> None:
        """Read one line; a bad one harms no other."""
        now = time.time()
        try:
            name, lux = decode(data)
        except WireError as error:
            self._lost["malformed"] += 1
            self.problem = str(error)
            return
        self._lamps.setdefault(name, MessageRate()).beat(time.monotonic())
        self._sink(
            Observation(
                name, name, captured_at=now, received_at=now, facts=(("illuminance_lx", lux),)
            )
        )

    @property
    def connected(self) -> bool:
        """Whether any lamp speaks."""
        return any(pulse.age(time.monotonic()) < SILENT for pulse in self._lamps.values())

    def health(self) -> tuple[SensorHealth, ...]:
        """Return how the port and each lamp do."""
        now, lost = time.monotonic(), tuple(self._lost.items())
        port = SensorHealth(
            "light",
            "udp",
            f"Light sensors on UDP {self._port}",
            self.connected,
            problem=self.problem,
            counts=lost,
        )
        lamps = [(name, pulse.rate_hz(now), pulse.age(now)) for name, pulse in self._lamps.items()]
        return (
            port,
            *(
                SensorHealth(name, "light", f"Light {name}", age < SILENT, rate, age)
                for name, rate, age in lamps
            ),
        )


async def main() -> None:
    """Listen for a second to two lamps, one of which talks nonsense once."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as lamps:
        lamps.bind(("127.0.0.1", 0))
        port = lamps.getsockname()[1]
    sensors: Sensor = LightSensors(port)
    listening = asyncio.create_task(sensors.run(print))
    await asyncio.sleep(0.1)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as lamps:
        for line in (
            "desk-lamp 320.5",
            "window 12000",
            "desk-lamp -7",
            "desk-lamp 321.0",
            "window 11950",
        ):
            lamps.sendto(line.encode(), ("127.0.0.1", port))
            await asyncio.sleep(0.2)
    for row in sensors.health():
        print(
            f"{row.title}: {row.rate_hz:.1f} Hz,"
            f" {dict(row.counts) or 'nothing lost'}{', ' + row.problem if row.problem else ''}"
        )
    listening.cancel()
    await asyncio.gather(listening, return_exceptions=True)


asyncio.run(main())
