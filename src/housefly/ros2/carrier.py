"""What carries the room's topics to whoever listens: a ROS 2 node, or rosbridge on a WebSocket."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from housefly.ros2.topic_table import RosTopic


class RosCarrier(Protocol):
    """Publishes under full names; thread-safe."""

    def advertise(self, topic: RosTopic, name: str) -> None:
        """Offer a topic under its full name."""

    def publish(self, topic: RosTopic, name: str, make: Callable[[], Any]) -> None:
        """Publish a message; it is made only for a topic that is latched or heard."""

    def is_heard(self, name: str) -> bool:
        """Whether somebody subscribes to a topic of ours."""
