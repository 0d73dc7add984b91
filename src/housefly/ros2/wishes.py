"""What may be asked of the room in the terms of ROS, by name: services and incoming topics."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from housefly.errors import HouseflyError
from housefly.ros2.order_line import RosReply
from housefly.ros2.topic_table import RosTopic

TRIGGER = "std_srvs/srv/Trigger"
"""Type of every service: a wish without parameters, answered in words."""
Wish = Callable[[], RosReply]
Tell = Callable[[RosTopic, str, Callable[[], Any]], None]
"""Publishes a message under a full name, to whoever may hear it."""


@dataclass(frozen=True, slots=True)
class RosService:
    """One service.

    Attributes:
        name: in full.
        wish: what it does.
        is_safer: whether it only makes drones safer, and passes whatever else waits.
        stops: drones that it stops.
    """

    name: str
    wish: Wish
    is_safer: bool = False
    stops: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class RosInput:
    """One topic to which others publish.

    Attributes:
        name: in full.
        topic: its type.
        wish: what a message does; an empty reply has nothing to say.
        is_safer: whether it only makes drones safer.
    """

    name: str
    topic: RosTopic
    wish: Callable[[Any], RosReply]
    is_safer: bool = False


Offered = Iterator[RosService | RosInput]
NOTHING_TO_SAY = RosReply(True, "")


def replied(wish: Wish) -> RosReply:
    """Return what became of a wish; what stands against it in words."""
    try:
        return wish()
    except HouseflyError as error:
        return RosReply(False, str(error))


def triggered(wish: Wish) -> Callable[[Any, Any], Any]:
    """Return the handler of a node's service of type ``TRIGGER``."""

    def handler(request: Any, response: Any) -> Any:
        reply = replied(wish)
        response.success, response.message = reply.success, reply.message
        return response

    return handler
