"""A ROS 2 node that follows the drone of a room: `python examples/ros2/see_the_room.py b_sen`."""

import sys

import rclpy
from nav_msgs.msg import Odometry
from rclpy.qos import qos_profile_sensor_data


def main() -> None:
    """Print where the drone is, once a second, until Ctrl-C or ten lines."""
    room = sys.argv[1] if len(sys.argv) > 1 else "b_sen"
    rclpy.init()
    node = rclpy.create_node("see_the_room")
    newest: list[Odometry] = []
    node.create_subscription(
        Odometry, f"/{room}/drone/odom", newest.append, qos_profile_sensor_data
    )
    lines = 0
    while lines < 10:
        rclpy.spin_once(node, timeout_sec=1.0)
        if newest:
            at = newest[-1].pose.pose.position
            print(f"x {at.x:.2f} m, y {at.y:.2f} m, height {at.z:.2f} m", flush=True)
            newest.clear()
            lines += 1
    node.destroy_node()
    rclpy.shutdown()


if __name__ == "__main__":
    main()
