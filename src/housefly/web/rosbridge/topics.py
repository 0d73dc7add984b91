"""The topics of the room for clients of rosbridge: what there is, who hears it."""

from __future__ import annotations

from collections.abc import Callable
from threading import Lock
from typing import Any

from housefly.ros2.ros_json import json_tree
from housefly.ros2.topic_table import Quality, RosTopic
from housefly.web.rosbridge.outbox import Outbox
from housefly.web.rosbridge.subscription import Pace
from housefly.web.rosbridge.texts import message_text


class BridgeTopics:
    """Carries the room's topics (``ros2.carrier.RosCarrier``); thread-safe."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._offered: dict[str, RosTopic] = {}
        self._latched: dict[str, Callable[[], Any]] = {}
        self._listeners: dict[str, tuple[Outbox, ...]] = {}

    def advertise(self, topic: RosTopic, name: str) -> None:
        """Offer a topic under its full name."""
        with self._lock:
            self._offered[name] = topic

    def publish(self, topic: RosTopic, name: str, make: Callable[[], Any]) -> None:
        """Tell who hears a topic; what is latched is kept for who comes later."""
        with self._lock:
            if name not in self._offered:
                return
            if topic.quality is Quality.LATCHED:
                self._latched[name] = make
            listeners = self._listeners.get(name, ())
        if listeners:
            text = message_text(name, json_tree(make()))
            for outbox in listeners:
                outbox.offer(name, text)

    def is_heard(self, name: str) -> bool:
        """Whether somebody hears a topic."""
        return bool(self._listeners.get(name))

    def offered(self) -> dict[str, RosTopic]:
        """Return what there is, by full name."""
        with self._lock:
            return dict(self._offered)

    def hear(self, name: str, outbox: Outbox, ident: str | int | None, pace: Pace) -> None:
        """Let a client hear a topic, beginning with what is latched.

        Raises:
            WireError: the client hears too many.
        """
        outbox.subscribe(name, ident, pace)
        with self._lock:
            others = tuple(one for one in self._listeners.get(name, ()) if one is not outbox)
            self._listeners[name] = (*others, outbox)
            # Within the lock: a newer message must not be overtaken by the one that was kept.
            if (make := self._latched.get(name)) is not None:
                outbox.offer(name, message_text(name, json_tree(make())))

    def leave(self, name: str, outbox: Outbox) -> None:
        """Let a client hear a topic no more."""
        with self._lock:
            left = tuple(one for one in self._listeners.get(name, ()) if one is not outbox)
            if left:
                self._listeners[name] = left
            else:
                self._listeners.pop(name, None)
