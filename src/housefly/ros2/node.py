"""The node itself: the only place that knows rclpy. Messages cross as CDR, made once."""

from __future__ import annotations

import importlib
import os
import threading
import time
from collections.abc import Callable
from typing import Any

from housefly.bus.interfaces import type_store
from housefly.config.process_log import log_line, log_traceback
from housefly.config.ros2 import Ros2Config
from housefly.config.text import without_numbers
from housefly.errors import LinkError, MissingPartError
from housefly.ros2.topic_table import Quality, RosTopic

_SPIN_PERIOD = 1.0
"""How often the end of the process is looked for [s]."""
_THREADS = 6
"""Requests that are answered at once; who waits for a pilot holds up no STOP."""
_GOALS_AT_ONCE = 2
"""Of an action: the one that is flown, and the one that takes its place; each has a thread."""
_DEPTH = {Quality.SENSOR: 5, Quality.STATE: 50, Quality.LATCHED: 1}
_RANGES = {"localhost": "LOCALHOST", "subnet": "SUBNET"}
_REPEAT_PERIOD, _SAID_MAX = 2.0, 200
"""What differs in numbers only is said again after this [s]; so many texts are remembered."""
_MESSAGE_MAX = 64 * 1024
"""Larger messages from ROS are dropped [bytes]."""


class RosNode:
    """A ROS 2 node.

    Args:
        name: of the node.
        config: domain, and who finds it.

    Raises:
        MissingPartError: there is no rclpy.
    """

    def __init__(self, name: str, config: Ros2Config) -> None:
        os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = _RANGES[config.discovery]
        self._rclpy = _rclpy()
        self._rclpy.init(
            args=[],
            domain_id=config.domain,
            signal_handler_options=self._rclpy.signals.SignalHandlerOptions.NO,
        )
        self._node = self._rclpy.create_node(name)
        group = importlib.import_module("rclpy.callback_groups")
        self._group = group.ReentrantCallbackGroup()
        self._publishers: dict[str, Any] = {}
        self._ended = threading.Event()
        self._executor: Any = None
        self._lock = threading.Lock()
        self._said: dict[str, float] = {}
        self._threads = _THREADS

    def advertise(self, topic: RosTopic, name: str) -> None:
        """Offer a topic under its full name; one whose package is not installed is left out."""
        if (kind := _interface(topic.type, name)) is not None:
            publisher = self._node.create_publisher(kind, name, self._qos(topic.quality))
            self._publishers[name] = publisher

    def publish(self, topic: RosTopic, name: str, make: Callable[[], Any]) -> None:
        """Publish a message; it is made only for a topic that is latched or heard."""
        publisher = self._publishers.get(name)
        if publisher is None:
            return
        if topic.quality is not Quality.LATCHED and not publisher.get_subscription_count():
            return
        publisher.publish(bytes(type_store().serialize_cdr(make(), topic.type)))

    def is_heard(self, name: str) -> bool:
        """Whether somebody subscribes to a topic of ours."""
        publisher = self._publishers.get(name)
        return publisher is not None and publisher.get_subscription_count() > 0

    def subscribe(self, topic: RosTopic, name: str, handler: Callable[[Any], None]) -> None:
        """Call the handler with each message; what cannot be read is dropped and said."""

        def received(data: bytes) -> None:
            if len(data) > _MESSAGE_MAX:
                self.warn(f"{name}: {len(data)} bytes; allowed: {_MESSAGE_MAX}")
                return
            try:
                message = type_store().deserialize_cdr(data, topic.type)
            except Exception as error:  # whatever the reader raises on foreign bytes
                self.warn(f"{name}: not a {topic.type}: {error}")
                return
            _guarded(handler, message)

        if (kind := _interface(topic.type, name)) is not None:
            quality = self._qos(topic.quality)
            self._node.create_subscription(
                kind, name, received, quality, callback_group=self._group, raw=True
            )

    def serve(self, kind: str, name: str, handler: Callable[[Any, Any], Any]) -> None:
        """Answer a service: the handler fills in the response and returns it."""
        if (service := _interface(kind, name)) is not None:
            self._node.create_service(service, name, handler, callback_group=self._group)

    def act(
        self,
        kind: str,
        name: str,
        refusal: Callable[[Any], str],
        execute: Callable[[Any], Any],
    ) -> bool:
        """Serve an action; return whether its package is installed.

        Args:
            kind: its type.
            name: in full.
            refusal: returns why a goal is not taken, in words, or "".
            execute: works on a goal until it ends, or is called off (``is_cancel_requested``), and
                returns the result; it has a thread for that.
        """
        if (action := _interface(kind, name)) is None:
            return False
        module = importlib.import_module("rclpy.action")
        goal, cancelling = module.GoalResponse, module.CancelResponse
        module.ActionServer(
            self._node,
            action,
            name,
            execute,
            goal_callback=lambda wish: goal.REJECT if refusal(wish) else goal.ACCEPT,
            cancel_callback=lambda _: cancelling.ACCEPT,
            callback_group=self._group,
        )
        self._threads += _GOALS_AT_ONCE
        return True

    def interface(self, kind: str) -> Any:
        """Return the class of a type that is installed."""
        return _interface(kind, kind)

    @property
    def is_ended(self) -> bool:
        """Whether ``end`` was called."""
        return self._ended.is_set()

    def warn(self, words: str) -> None:
        """Tell ROS (/rosout) and our log why something was not done."""
        if self._is_new(words):
            self._node.get_logger().warning(words)

    def inform(self, words: str) -> None:
        """Tell ROS (/rosout) and our log."""
        if self._is_new(words):
            self._node.get_logger().info(words)

    def spin(self) -> None:
        """Answer until ``end``; an error of one request ends nothing."""
        executors = importlib.import_module("rclpy.executors")
        executor = executors.MultiThreadedExecutor(num_threads=self._threads)
        executor.add_node(self._node)
        self._executor = executor
        while not self._ended.is_set():
            try:
                executor.spin_once(timeout_sec=_SPIN_PERIOD)
            except executors.ExternalShutdownException:
                break
            except Exception:  # of a callback: the node stays
                log_traceback()
        executor.shutdown(timeout_sec=1.0)

    def end(self) -> None:
        """Let ``spin`` return; may be called from a signal."""
        self._ended.set()
        if self._executor is not None:
            self._executor.wake()

    def close(self) -> None:
        """Leave ROS."""
        with self._lock:
            self._publishers = {}
        self._node.destroy_node()
        self._rclpy.try_shutdown()

    def _is_new(self, words: str) -> bool:
        """Whether the same was not said just now: a flood of wishes fills no disk."""
        now, same = time.monotonic(), without_numbers(words)
        with self._lock:
            if now - self._said.get(same, -_REPEAT_PERIOD) < _REPEAT_PERIOD:
                return False
            if len(self._said) >= _SAID_MAX:
                self._said.clear()
            self._said[same] = now
            return True

    def _qos(self, quality: Quality) -> Any:
        qos = importlib.import_module("rclpy.qos")
        best_effort = quality is Quality.SENSOR
        return qos.QoSProfile(
            depth=_DEPTH[quality],
            history=qos.HistoryPolicy.KEEP_LAST,
            reliability=(
                qos.ReliabilityPolicy.BEST_EFFORT if best_effort else qos.ReliabilityPolicy.RELIABLE
            ),
            durability=(
                qos.DurabilityPolicy.TRANSIENT_LOCAL
                if quality is Quality.LATCHED
                else qos.DurabilityPolicy.VOLATILE
            ),
        )


def _guarded(handler: Callable[[Any], None], message: Any) -> None:
    try:
        handler(message)
    except LinkError as error:
        log_line(f"ros2: {error}")


def _rclpy() -> Any:
    try:
        module = importlib.import_module("rclpy")
        importlib.import_module("rclpy.signals")
    except ImportError as error:
        raise MissingPartError(
            f"rclpy ({error})",
            "source /opt/ros/<distro>/setup.bash, where Housefly is installed for the same Python,"
            " or pip install 'housefly[ros2]' on x86-64 Linux",
        ) from error
    return module


def _interface(kind: str, name: str) -> Any:
    """Return the class of an interface by its full name; None where it is not installed."""
    package, group, interface = kind.split("/")
    try:
        return getattr(importlib.import_module(f"{package}.{group}"), interface)
    except (ImportError, AttributeError):
        log_line(f"ros2: {name} is left out: {package} is not installed")
        return None
