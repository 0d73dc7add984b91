"""A client of a scanner that a ROS 2 node reads: sensor_msgs/LaserScan on a topic.

rclpy runs in a child process.
"""

from __future__ import annotations

from housefly.bus.child_client import ChildClient
from housefly.bus.ros2_child import ros2_command
from housefly.clock import Clock
from housefly.config.laser import LaserConfig
from housefly.messages import Scan
from housefly.messages.words import Words
from housefly.sensors.ros2_scan import LASER_SCAN, SCAN_BYTES_MAX
from housefly.sensors.ros2_scan_lines import SCAN_RATE_MAX, Ros2ScanLines


class Ros2LaserClient(ChildClient[Scan]):
    """Hands every scan of a topic to a sink.

    What is no scan is dropped and said; the connection stays.

    Args:
        config: topic and place of the scanner.
        clock: for ages.
    """

    LINE_MAX = 2 * SCAN_BYTES_MAX  # as base64, and what is around it

    def __init__(self, config: LaserConfig, clock: Clock | None = None) -> None:
        super().__init__(f"ROS 2, topic {config.ros_topic}", clock)
        self._config = config
        self._begin()

    @property
    def problem(self) -> Words:
        """Why no scans arrive, or why some are refused; UNSAID where all is well."""
        return self._problem or self._lines.refusal(self._clock.now()) or super().problem

    @property
    def stale(self) -> int:
        """How many scans were dropped because they were not newer than the last."""
        return self._lines.stale

    def _no_data_problem(self) -> Words:
        there = self._lines.publishers
        if there.nodes:
            return Words("connected to {name}, but no scans arrive", name=self._where)
        if there.other_types:
            return Words(
                "what is published there ({name}) is {found}; allowed: {words}",
                name=self._where,
                found=", ".join(there.other_types),
                words=LASER_SCAN,
            )
        where = f"{self._where} (nobody publishes there)"
        return Words("not connected to {name} yet", name=where)

    def _command(self) -> tuple[str, ...]:
        config = self._config
        settings = {
            "topic": config.ros_topic,
            "domain": config.ros_domain,
            "discovery": config.ros_discovery,
            "rate_max": SCAN_RATE_MAX,
            "bytes_max": SCAN_BYTES_MAX,
        }
        return ros2_command("housefly.sensors.ros2_laser_child", settings)

    def _begin(self) -> None:
        self._lines = Ros2ScanLines(self._config)

    def _read(self, line: bytes, received_at: float) -> Scan | None:
        return self._lines.read(line, received_at)
