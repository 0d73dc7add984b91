"""Where orders, events and MQTT of the tasks go out."""

from __future__ import annotations

import logging

from housefly.bus.bus import Bus
from housefly.bus.topics import ROOM_EVENT_TOPIC, DroneTopics
from housefly.config.drone import DRONE_NAME
from housefly.config.process_log import log_line
from housefly.errors import HouseflyError
from housefly.messages import Order, RoomEvent
from housefly.tasks.rules.mqtt_link import MqttLink
from housefly.wires.devices import task_topic

_log = logging.getLogger(__name__)


class BusTaskOutlet:
    """Publishes on the bus; what cannot be sent is told in the log.

    Args:
        bus: of the run.
        site: its name on MQTT.

    Attributes:
        mqtt: publishes to devices; None without a broker.
    """

    def __init__(self, bus: Bus, site: str) -> None:
        self.mqtt: MqttLink | None = None
        self._bus, self._said = bus, task_topic(site, "said")

    def order(self, order: Order, drone: str) -> None:
        """Give a drone's pilot an order."""
        try:
            self._bus.publish(DroneTopics(drone).order, order)
        except HouseflyError as error:
            _log.error("an order could not be given: %s", error)
        to = "" if drone == DRONE_NAME else f" to {drone}"
        log_line(f"order{to}: {order.kind.value} by {order.sender}")

    def tell(self, event: RoomEvent) -> None:
        """Tell the room's memory what happened."""
        try:
            self._bus.publish(ROOM_EVENT_TOPIC, event)
        except HouseflyError as error:
            _log.error("%s could not be told: %s", event.kind, error)

    def say(self, words: str) -> None:
        """Say something to whoever listens on MQTT."""
        self.publish_mqtt(self._said, words)

    def publish_mqtt(self, topic: str, payload: str) -> None:
        """Publish to a device of the room."""
        if self.mqtt is not None:
            self.mqtt.publish(topic, payload)
