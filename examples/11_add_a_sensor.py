"""Add a sensor of your own: light sensors that send a line of text over UDP.

Needs: nothing beside Housefly itself.
Learns: what a sensor driver owes the room, in four members; how a bad line is counted and named
    instead of believed.
Prints: each observation as the room would hear it, then how the driver and its two lamps do.
"""

import asyncio
import socket
import time
from collections import Counter
from math import isfinite

from housefly import MessageRate, Observation, Sensor, SensorHealth, SensorSink, WireError

SILENT = 5.0
"""A lamp that says nothing for this long [s] is not there."""
LINES = ("desk-lamp 320.5", "window 12000", "desk-lamp -7", "desk-lamp 321.0", "window 11950")


def decode(line: bytes) -> tuple[str, float]:
    """Return name and illuminance [lx] of a line; raises WireError that names what is wrong."""
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
        loop, address = asyncio.get_running_loop(), ("127.0.0.1", self._port)
        transport, _ = await loop.create_datagram_endpoint(lambda: self, address)
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
        self._lamps.setdefault(name, MessageRate()).add(time.monotonic())
        self._sink(Observation(name, name, now, now, facts=(("illuminance_lx", lux),)))

    @property
    def connected(self) -> bool:
        """Whether any lamp speaks."""
        return any(lamp.age(time.monotonic()) < SILENT for lamp in self._lamps.values())

    def health(self) -> tuple[SensorHealth, ...]:
        """Return how the port and each lamp do."""
        now, lost = time.monotonic(), tuple(self._lost.items())
        title = f"Light sensors on UDP {self._port}"
        port = SensorHealth(
            "light", "udp", title, self.connected, problem=self.problem, counts=lost
        )
        ages = {name: lamp.age(now) for name, lamp in self._lamps.items()}
        return port, *(
            SensorHealth(
                name, "light", f"Light {name}", ages[name] < SILENT, lamp.rate_hz(now), ages[name]
            )
            for name, lamp in self._lamps.items()
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
        for line in LINES:
            lamps.sendto(line.encode(), ("127.0.0.1", port))
            await asyncio.sleep(0.2)
    for row in sensors.health():
        words = f"{dict(row.counts) or 'nothing lost'}"
        print(f"{row.title}: {row.rate_hz:.1f} Hz, {', '.join(filter(None, (words, row.problem)))}")
    listening.cancel()
    await asyncio.gather(listening, return_exceptions=True)


asyncio.run(main())
