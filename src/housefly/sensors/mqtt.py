"""Driver of the devices that speak through an MQTT broker: door contacts, doorbells, floors,
cabinets and their like.
"""

from __future__ import annotations

import asyncio
import time
from collections import Counter
from collections.abc import Callable
from math import inf

import aiomqtt

from housefly.bus.mqtt import TROUBLES, client, words
from housefly.clock import Clock, RealClock
from housefly.config.devices import MqttConfig
from housefly.errors import ConfigError, WireError
from housefly.messages import Happening, Observation
from housefly.sensors.contracts import SensorHealth, Sink
from housefly.sensors.device_watch import DeviceWatch
from housefly.sensors.pulse import Pulse
from housefly.wires.devices import (
    LARGEST,
    Address,
    Channel,
    ClockBounds,
    Delivered,
    Placement,
    decode,
    kind_of,
    listener_topic,
    parse_topic,
    subscription,
)

MOST_DEVICES = 256
"""More devices than this are not listened to: each costs memory."""
_ENVELOPE = 1024
"""Room for topic and properties beside the longest payload [bytes]."""
_FIRST_PAUSE, _LONGEST_PAUSE = 0.1, 2.0


class MqttSensors:
    """Implements ``sensors.contracts.Sensor`` for every device of a site.

    Args:
        config: broker, site, limits, where devices stand.
        clock: for ages and rates.
        wall: Unix time [s], for stamps.

    Attributes:
        counts: messages that belong to no device, and connections.
    """

    def __init__(
        self, config: MqttConfig, clock: Clock | None = None, wall: Callable[[], float] = time.time
    ) -> None:
        self.counts: Counter[str] = Counter()
        self._config, self._clock, self._wall = config, clock or RealClock(), wall
        self._bounds = ClockBounds(config.clock_ahead, config.clock_behind)
        self._things = {row.tag: row.thing for row in config.tags}
        self._placements = {
            row.id: Placement(row.position, row.yaw, self._things) for row in config.devices
        }
        self._watches: dict[str, tuple[Address, DeviceWatch]] = {}
        self._pulse = Pulse()
        self._complaint = (-inf, "")
        self._connected = False
        self._problem = f"not connected to the MQTT broker at {config.broker}:{config.port} yet"

    @property
    def connected(self) -> bool:
        """Whether the broker is there."""
        return self._connected

    @property
    def problem(self) -> str:
        """Why the broker is not there, or what nobody's device says, in words, or ""."""
        at, complaint = self._complaint
        return self._problem or (complaint if self._clock.now() - at <= _RECENT else "")

    async def run(self, sink: Sink) -> None:
        """Listen, and reconnect for ever; ends only when cancelled."""
        pause = _FIRST_PAUSE
        while True:
            self._connected = False
            try:
                await self._session(sink)
            except TROUBLES as error:
                self._problem = words(error, self._config, self._connected)
            except ConfigError as error:
                self._problem = str(error)
            pause = _FIRST_PAUSE if self._connected else min(2 * pause, _LONGEST_PAUSE)
            self._connected = False
            await asyncio.sleep(pause)

    def health(self) -> tuple[SensorHealth, ...]:
        """Return how the link and each device do now, the link first."""
        now, config = self._clock.now(), self._config
        link = SensorHealth(
            id="mqtt",
            kind="mqtt",
            title=f"MQTT broker {config.broker}:{config.port}",
            connected=self.connected,
            rate_hz=self._pulse.rate_hz(now),
            age=self._pulse.age(now),
            problem=self.problem,
            counts=tuple(sorted(self.counts.items())),
        )
        return (link, *(watch.health(now, self._problem) for _, watch in self._watches.values()))

    async def _session(self, sink: Sink) -> None:
        """Read one connection to its end."""
        presence = listener_topic(self._config.site)
        will = aiomqtt.Will(presence, b"offline", qos=1, retain=True)
        async with client(self._config, will, LARGEST + _ENVELOPE) as link:
            await link.subscribe(subscription(self._config.site), qos=1)
            await link.publish(presence, b"online", qos=1, retain=True)
            self._connected, self._problem = True, ""
            self.counts["connections"] += 1
            async for message in link.messages:
                if message.topic.value != presence:
                    self._take(message, sink)

    def _take(self, message: aiomqtt.Message, sink: Sink) -> None:
        """Read one message; whatever it holds, the next one is read, too."""
        now = self._clock.now()
        self._pulse.beat(now)
        try:
            address, channel = parse_topic(message.topic.value)
            watch = self._watch(address)
        except WireError as error:
            self.counts["strange"] += 1
            self._complaint = (now, str(error))
            return
        if watch.admit(now):
            payload = message.payload if isinstance(message.payload, bytes) else b""
            self._read(
                Delivered(address, channel, payload, self._wall(), message.retain), watch, now, sink
            )

    def _read(self, message: Delivered, watch: DeviceWatch, now: float, sink: Sink) -> None:
        if message.retained and message.channel is Channel.EVENT:
            watch.passed_over()
            return
        if not message.payload:
            return  # how one clears what the broker keeps: it says nothing about the device
        try:
            reading = decode(
                message,
                self._placements.get(message.address.id, Placement(things=self._things)),
                self._bounds,
            )
        except WireError as error:
            watch.malformed(str(error), now)
            return
        watch.heard(reading, now, message.retained)
        told: tuple[Observation | Happening, ...] = (*reading.observations, *reading.happenings)
        for value in told:
            sink(value)

    def _watch(self, address: Address) -> DeviceWatch:
        """Return the book of a device; raises WireError for a device that we do not listen to."""
        if address.id not in self._watches:
            if len(self._watches) >= MOST_DEVICES:
                raise WireError(
                    f"{address.id}: more than {MOST_DEVICES} devices; this one is not listened to"
                )
            self._watches[address.id] = (
                address,
                DeviceWatch(address, kind_of(address), self._config.rate_max_hz),
            )
        known, watch = self._watches[address.id]
        if known != address:
            raise WireError(
                f"{address.id} is a {known.kind} already; a {address.kind} needs another id"
            )
        return watch


_RECENT = 5.0
"""For this long [s] a message of nobody's device is a problem."""
