"""NavigateToPose as an action server, where nav2_msgs is there."""

from __future__ import annotations

import time
from contextlib import ExitStack
from threading import Condition
from typing import Any

from housefly.bus.bus import Bus
from housefly.geometry import yaw_of
from housefly.messages import PilotStep
from housefly.record.ros_messages import about_z, nanoseconds
from housefly.ros2.flight_desk import FlightDesk
from housefly.ros2.navigation import Navigation, NavigationEnd, NavigationProgress, NavigationResult
from housefly.ros2.node import RosNode
from housefly.ros2.ros_drone import RosDrone
from housefly.tasks.api.answers import TaskBoard
from housefly.tasks.api.topics import TASK_NEWS_TOPIC

NAVIGATE = "nav2_msgs/action/NavigateToPose"
"""The type."""
_FEEDBACK_PERIOD = 0.2
"""How often a client is told how far it is [s]."""
_LOOK_PERIOD = 0.05
"""How often it is looked whether a client calls its goal off [s]."""
_UNKNOWN_ERROR = 9000
"""``NavigateToPose.Result.UNKNOWN``."""


class NavigateServer:
    """Takes goals for one drone; a new one takes the place of the one before.

    Args:
        drone: the drone.
        frame: of the world.
        node: of the room.
        desk: takes wishes.
    """

    def __init__(self, drone: RosDrone, frame: str, node: RosNode, desk: FlightDesk) -> None:
        self._drone, self._name, self._frame = drone.name, drone.action, frame
        self._ros_drone = drone
        self._node, self._desk = node, desk
        self._flown: dict[bytes, Navigation] = {}
        self._news = Condition()

    def begin(self, bus: Bus, stack: ExitStack) -> None:
        """Offer the action where its package is installed, and listen."""
        if self._node.act(NAVIGATE, self._name, self._may_be, self._fly):
            self._ros_drone.on_step = self._on_step
            stack.callback(bus.subscribe(TASK_NEWS_TOPIC, self._on_board).close)

    def _on_step(self, step: PilotStep) -> None:
        holder = self._desk.holder(self._drone)
        with self._news:
            for flown in self._flown.values():
                flown.add_step(step, holder)
            self._news.notify_all()

    def _on_board(self, board: TaskBoard) -> None:
        with self._news:
            for flown in self._flown.values():
                flown.add_board(board)
            self._news.notify_all()

    def _may_be(self, goal: Any) -> str:
        """Return why a goal is not taken, in words, or ""."""
        frame, words = goal.pose.header.frame_id, ""
        if frame not in ("", self._frame):
            words = f"its frame is {frame!r}; allowed: {self._frame!r}"
        elif goal.behavior_tree:
            words = f"behavior_tree is {goal.behavior_tree[:40]!r}; allowed: none"
        else:
            place = goal.pose.pose.position
            words = self._desk.refusal((place.x, place.y))
        if words:
            self._node.warn(f"{self._name}: goal refused: {words}")
        return words

    def _fly(self, handle: Any) -> Any:
        """Fly one goal; it takes a thread until it has ended."""
        key = _key(handle)
        try:
            result = self._flown_to_its_end(key, handle)
        finally:
            with self._news:
                self._flown.pop(key, None)
        return self._told(handle, result)

    def _flown_to_its_end(self, key: bytes, handle: Any) -> NavigationResult:
        place, turn = handle.request.pose.pose.position, handle.request.pose.pose.orientation
        goal, quaternion = (place.x, place.y), (turn.w, turn.x, turn.y, turn.z)
        begun_at = time.monotonic()
        reply = self._desk.fly_to(
            self._drone, goal, yaw_of(quaternion) if any(quaternion) else None
        )
        if not reply.success:
            return NavigationResult(NavigationEnd.FAILED, reply.message)
        flown = Navigation(goal, reply.order, reply.task, begun_at)
        with self._news:
            for other in self._flown.values():
                if other.order and reply.order:
                    other.end(NavigationEnd.FAILED, "a newer goal took its place")
            self._flown[key] = flown
            self._news.notify_all()
        if reply.task:  # it may have ended already
            self._on_board(self._desk.board())
        return self._watched(flown, handle)

    def _watched(self, flown: Navigation, handle: Any) -> NavigationResult:
        """Return how a goal ends; until then the client is told how far the drone is."""
        told_at = float("-inf")
        while True:
            with self._news:
                self._news.wait_for(lambda: flown.result, _LOOK_PERIOD)
            if flown.result is not None:
                return flown.result
            if handle.is_cancel_requested:
                return self._called_off(flown)
            if self._node.is_ended:
                return NavigationResult(NavigationEnd.FAILED, "the node ends")
            now = time.monotonic()
            if flown.progress is not None and now - told_at >= _FEEDBACK_PERIOD:
                told_at = now
                handle.publish_feedback(self._feedback(flown.progress))

    def _called_off(self, flown: Navigation) -> NavigationResult:
        """Hold the drone where it is, or end the task, which comes home."""
        reply = self._desk.call_off(self._drone, flown.order, flown.task)
        if not reply.success:
            self._node.warn(f"{self._name}: {reply.message}")
        return NavigationResult(NavigationEnd.CANCELLED, reply.message)

    def _told(self, handle: Any, result: NavigationResult) -> Any:
        if result.end is NavigationEnd.ARRIVED:
            handle.succeed()
        elif result.end is NavigationEnd.CANCELLED:
            handle.canceled()
        else:
            handle.abort()
        told = self._node.interface(NAVIGATE).Result()
        is_failed = result.end is NavigationEnd.FAILED
        # Their fields differ from ROS to ROS.
        if hasattr(told, "error_code"):
            told.error_code = _UNKNOWN_ERROR if is_failed else 0
        if hasattr(told, "error_msg"):
            told.error_msg = result.words
        if is_failed:
            self._node.warn(f"{self._name}: {result.words}")
        return told

    def _feedback(self, progress: NavigationProgress) -> Any:
        told, estimate = self._node.interface(NAVIGATE).Feedback(), progress.estimate
        pose = told.current_pose
        pose.header.frame_id = self._frame
        pose.header.stamp.sec, pose.header.stamp.nanosec = divmod(time.time_ns(), 1_000_000_000)
        place, turn = pose.pose.position, pose.pose.orientation
        place.x, place.y, place.z = map(float, estimate.position)
        turn.w, turn.x, turn.y, turn.z = map(float, about_z(estimate.yaw))
        elapsed = divmod(nanoseconds(progress.elapsed), 1_000_000_000)
        told.navigation_time.sec, told.navigation_time.nanosec = elapsed
        told.distance_remaining = float(progress.remaining)
        return told


def _key(handle: Any) -> bytes:
    return bytes(handle.goal_id.uuid)
