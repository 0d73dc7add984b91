"""Driver of devices on an MQTT broker: door contacts, doorbells, floors, cabinets and others."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable
from functools import partial
from math import inf

import aiomqtt

from housefly.bus.mqtt import MQTT_ERRORS, mqtt_client, mqtt_problem
from housefly.bus.reconnect import ReconnectingClient, stop_if_cancelled
from housefly.clock import Clock
from housefly.config.devices import MqttConfig
from housefly.errors import ConfigError, LinkError, WireError
from housefly.messages import Observation, RoomEvent
from housefly.messages.words import UNSAID, Words, error_words
from housefly.sensors.contracts import SensorHealth, SensorSink
from housefly.sensors.device_monitor import DeviceMonitor
from housefly.sensors.measured_topics import MeasuredTopics
from housefly.sensors.message_rate import MessageRate
from housefly.wires.devices import (
    MAX_DEVICE_PAYLOAD,
    Channel,
    ClockBounds,
    Delivered,
    DeviceAddress,
    Placement,
    Reading,
    decode_reading,
    device_kind,
    listener_topic,
    parse_topic,
    site_subscription,
    task_topic,
)

_MAX_DEVICES = 256
"""Further devices are ignored: each costs memory."""
_ENVELOPE = 1024
"""Room for topic and properties beside the longest payload [bytes]."""


class MqttSensors(ReconnectingClient[Observation | RoomEvent]):
    """Implements ``sensors.contracts.Sensor`` for every MQTT device of a site.

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
        super().__init__(f"the MQTT broker at {config.broker}:{config.port}", clock)
        self.counts: Counter[str] = Counter()
        self._config, self._wall = config, wall
        self._bounds = ClockBounds(config.clock_ahead, config.clock_behind)
        self._things = {row.tag: row.thing for row in config.tags}
        self._placements = {
            row.id: Placement(row.position, row.yaw, self._things) for row in config.devices
        }
        self._allowed = frozenset(config.allow)
        self._measured = MeasuredTopics(config)
        self._monitors = {
            known.address.id: (
                known.address,
                DeviceMonitor(known.address, known.kind, config.rate_max_hz),
            )
            for known in self._measured
        }
        self._rate = MessageRate()
        self._complaint = (-inf, UNSAID)
        self._connected = False

    @property
    def connected(self) -> bool:
        """Whether the broker is there."""
        return self._connected

    @property
    def problem(self) -> Words:
        """Why the broker is not there, or what an unknown device sent; UNSAID for nothing."""
        at, complaint = self._complaint
        return self._problem or (
            complaint if self._clock.now() - at <= _COMPLAINT_SHOWN else UNSAID
        )

    def health(self) -> tuple[SensorHealth, ...]:
        """Return the health of the link, then of each device."""
        now, config = self._clock.now(), self._config
        link = SensorHealth(
            id="mqtt",
            kind="mqtt",
            title=f"MQTT broker {config.broker}:{config.port}",
            connected=self.connected,
            rate_hz=self._rate.rate_hz(now),
            age=self._rate.age(now),
            problem=self.problem,
            counts=tuple(sorted(self.counts.items())),
        )
        return (
            link,
            *(monitor.health(now, self._problem) for _, monitor in self._monitors.values()),
        )

    async def _read_connection(self, sink: SensorSink) -> None:
        try:
            await self._session(sink)
        except MQTT_ERRORS as error:
            raise LinkError(await mqtt_problem(error, self._config, self._connected)) from error
        except ConfigError as error:
            raise LinkError(str(error)) from error
        finally:
            self._connected = False

    async def _session(self, sink: SensorSink) -> None:
        presence = listener_topic(self._config.site)
        tasks = task_topic(self._config.site, "#")
        will = aiomqtt.Will(presence, b"offline", qos=1, retain=True)
        async with mqtt_client(self._config, will, MAX_DEVICE_PAYLOAD + _ENVELOPE) as link:
            await link.subscribe(site_subscription(self._config.site), qos=1)
            for topic in self._measured.topics:
                await link.subscribe(topic, qos=1)
            await link.publish(presence, b"online", qos=1, retain=True)
            stop_if_cancelled()
            self._connected, self._problem = True, UNSAID
            self._data_arrived(self._clock.now())
            self.counts["connections"] += 1
            async for message in link.messages:
                if message.topic.value != presence and not message.topic.matches(tasks):
                    self._take(message, sink)

    def _take(self, message: aiomqtt.Message, sink: SensorSink) -> None:
        """Handle one message; an error does not affect the next one."""
        now = self._clock.now()
        self._rate.add(now)
        if self._measured.on(message.topic.value):
            self._take_measured(message, now, sink)
            return
        try:
            address, channel = parse_topic(message.topic.value)
            monitor = self._monitor(address)
        except WireError as error:
            self.counts["strange"] += 1
            self._complaint = (now, error_words(error))
            return
        if monitor.admit(now):
            payload = message.payload if isinstance(message.payload, bytes) else b""
            self._read(
                Delivered(address, channel, payload, self._wall(), message.retain),
                monitor,
                now,
                sink,
            )

    def _read(
        self, message: Delivered, monitor: DeviceMonitor, now: float, sink: SensorSink
    ) -> None:
        if message.retained and message.channel is Channel.EVENT:
            monitor.record_past_event()
            return
        if not message.payload:
            return  # how one clears what the broker keeps: it says nothing about the device
        placement = self._placements.get(message.address.id, Placement(things=self._things))
        decode = partial(decode_reading, message, placement, self._bounds, monitor.kind)
        self._record(decode, monitor, now, sink, message)

    def _take_measured(self, message: aiomqtt.Message, now: float, sink: SensorSink) -> None:
        """Handle a message on a topic that the site file names, for each device that it is of."""
        payload = message.payload if isinstance(message.payload, bytes) else b""
        for device, channel in self._measured.on(message.topic.value):
            _, monitor = self._monitors[device.address.id]
            if not payload or not monitor.admit(now):
                continue
            if channel is Channel.AVAILABILITY or not monitor.repeats(payload, message.retain):
                delivered = Delivered(
                    device.address, channel, payload, self._wall(), message.retain
                )
                self._record(partial(device.decode, delivered), monitor, now, sink, delivered)

    def _record(
        self,
        decode: Callable[[], Reading],
        monitor: DeviceMonitor,
        now: float,
        sink: SensorSink,
        message: Delivered,
    ) -> None:
        """Decode a message of one device, count it, and hand on what it says."""
        try:
            reading = decode()
        except WireError as error:
            monitor.record_malformed(error_words(error), message.channel)
            return
        monitor.record(reading, now, message.retained, message.channel)
        told: tuple[Observation | RoomEvent, ...] = (*reading.observations, *reading.events)
        for value in told:
            if monitor.admit_thing(value.thing, now):
                sink(value)

    def _monitor(self, address: DeviceAddress) -> DeviceMonitor:
        """Return the monitor of a device; raises WireError for one that is ignored."""
        name = f"{address.kind}/{address.id}"
        if not self._measured.knows(address) and self._allowed and name not in self._allowed:
            raise WireError(f"{name} is not in mqtt.allow; it is ignored")
        if address.id not in self._monitors:
            if len(self._monitors) >= _MAX_DEVICES:
                raise WireError(
                    f"{address.id}: more than {_MAX_DEVICES} devices; this one is not listened to"
                )
            self._monitors[address.id] = (
                address,
                DeviceMonitor(address, device_kind(address), self._config.rate_max_hz),
            )
        known, monitor = self._monitors[address.id]
        if known != address:
            raise WireError(
                f"{address.id} is a {known.kind} already; a {address.kind} needs another id"
            )
        return monitor


_COMPLAINT_SHOWN = 600.0
"""How long a message from an unknown device counts as a problem [s]."""
