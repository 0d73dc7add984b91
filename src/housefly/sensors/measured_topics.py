"""Which of the site's measuring devices speaks on which topic."""

from __future__ import annotations

from collections.abc import Iterator

from housefly.config.devices import MqttConfig
from housefly.config.measured_devices import MeasuredDeviceConfig
from housefly.errors import WireError
from housefly.wires.devices import Channel, DeviceAddress, MeasuredTopic


class MeasuredTopics:
    """The devices of ``mqtt.sensors``, by id and by topic.

    Args:
        config: broker and devices.
    """

    def __init__(self, config: MqttConfig) -> None:
        self._devices = {
            row.id: MeasuredTopic(row, config.site) for row in _with_shared_availability(config)
        }
        self._by_topic: dict[str, list[tuple[MeasuredTopic, Channel]]] = {}
        for device in self._devices.values():
            if device.is_foreign:
                self._by_topic.setdefault(device.state_topic, []).append((device, Channel.STATE))
            if topic := device.config.availability_topic:
                self._by_topic.setdefault(topic, []).append((device, Channel.AVAILABILITY))

    def __iter__(self) -> Iterator[MeasuredTopic]:
        return iter(self._devices.values())

    @property
    def topics(self) -> tuple[str, ...]:
        """What to subscribe to besides our own topics, sorted."""
        return tuple(sorted(self._by_topic))

    def on(self, topic: str) -> tuple[tuple[MeasuredTopic, Channel], ...]:
        """Return the devices that speak on a topic, and about what."""
        return tuple(self._by_topic.get(topic, ()))

    def knows(self, address: DeviceAddress) -> bool:
        """Return whether a device of the site file speaks on our own topics under an address.

        Raises:
            WireError: its id is that of a device which speaks elsewhere.
        """
        device = self._devices.get(address.id)
        if device is not None and device.is_foreign:
            raise WireError(
                f"{address.kind}/{address.id} speaks on {device.state_topic} by the site file;"
                " this is not it"
            )
        return device is not None


def _with_shared_availability(config: MqttConfig) -> Iterator[MeasuredDeviceConfig]:
    """Yield the devices; those on one state topic are one apparatus, and are offline together."""
    told = {
        row.state_topic: row.availability_topic
        for row in config.sensors
        if row.state_topic and row.availability_topic
    }
    for row in config.sensors:
        topic = row.availability_topic or told.get(row.state_topic, "")
        yield row.model_copy(update={"availability_topic": topic})
