"""A client of NavigateToPose as a user writes one."""

from __future__ import annotations

import importlib
from typing import Any

from ros_stage import RosClient

SUCCEEDED, CANCELED, ABORTED = 4, 5, 6
"""Of action_msgs/GoalStatus."""


class SentGoal:
    """A goal that was sent.

    Args:
        client: a node.
        action: full name of the action.
        x: where to [m].
        y: likewise.
        changes: fields of the goal, and ``frame``.

    Attributes:
        handle: of the goal.
        feedback: that came.
    """

    def __init__(self, client: RosClient, action: str, x: float, y: float, **changes: Any) -> None:
        kind = importlib.import_module("nav2_msgs.action").NavigateToPose
        actions = importlib.import_module("rclpy.action").ActionClient(client.node, kind, action)
        self._client = client
        assert client.spin(actions.server_is_ready), f"{action} is not served"
        goal = kind.Goal()
        goal.pose.header.frame_id = changes.pop("frame", "map")
        goal.pose.pose.position.x, goal.pose.pose.position.y = x, y
        goal.pose.pose.orientation.w = 1.0
        for name, value in changes.items():
            setattr(goal, name, value)
        self.feedback: list[Any] = []
        sent = actions.send_goal_async(goal, lambda one: self.feedback.append(one.feedback))
        assert client.spin(sent.done)
        self.handle = sent.result()
        self._result = self.handle.get_result_async() if self.handle.accepted else None

    def ended(self, seconds: float = 60.0) -> tuple[int, str]:
        """Return the status and the words of the end."""
        assert self._result is not None and self._client.spin(self._result.done, seconds)
        told = self._result.result()
        return told.status, told.result.error_msg

    def is_open(self) -> bool:
        """Whether it has not ended."""
        return self._result is not None and not self._result.done()

    def cancel(self) -> None:
        """Call it off."""
        assert self._client.spin(self.handle.cancel_goal_async().done)
