"""Client of poses on ROS 2 topics: of a mocap driver, a SLAM node, any node that tells poses.

rclpy has threads of its own and may not be reloaded; it runs in a child process.
"""

from __future__ import annotations

from housefly.bus.ros2_child import ros2_command
from housefly.clock import Clock
from housefly.config.tracking import TrackingConfig
from housefly.messages import Sighting
from housefly.messages.words import Words
from housefly.tracking.child_tracker import ChildTracker
from housefly.tracking.ros2_lines import Ros2Lines


class Ros2Tracker(ChildTracker):
    """Reads what the child hears on the topics of ``tracking.ros_topic``."""

    def __init__(self, config: TrackingConfig, clock: Clock | None = None) -> None:
        super().__init__(f"ROS 2, topics {config.ros_topic}", clock)
        self._config = config
        self._begin()

    def _no_data_problem(self) -> Words:
        if not self._lines.topics:
            where = f"{self._where} (nobody publishes there)"
            return Words("not connected to {name} yet", name=where)
        return Words(
            "connected to {name}, but nothing new arrives; is {what} live, not paused?",
            name=self._where,
            what=", ".join(self._lines.topics[:3]),
        )

    def _command(self) -> tuple[str, ...]:
        config = self._config
        settings = {
            "topic": config.ros_topic,
            "domain": config.ros_domain,
            "discovery": config.ros_discovery,
        }
        return ros2_command("housefly.tracking.ros2_child", settings)

    def _begin(self) -> None:
        self._lines = Ros2Lines(self._config.latency, self._config.y_up, self.counts)

    def _read(self, line: bytes, received_at: float) -> tuple[Sighting, ...] | None:
        return self._lines.read(line, received_at)
