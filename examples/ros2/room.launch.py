"""The simulated room, its ROS 2 node and RViz: `ros2 launch examples/ros2/room.launch.py`."""

from pathlib import Path

from launch import LaunchDescription
from launch.actions import ExecuteProcess, TimerAction
from launch_ros.actions import Node

HERE = Path(__file__).resolve().parent


def generate_launch_description() -> LaunchDescription:
    """Start the room, then what looks at it."""
    room = ExecuteProcess(cmd=["housefly", "demo"], output="screen")
    node = ExecuteProcess(cmd=["housefly", "ros2", "--requests", "ask"], output="screen")
    rviz = Node(package="rviz2", executable="rviz2", arguments=["-d", str(HERE / "room.rviz")])
    return LaunchDescription([room, TimerAction(period=20.0, actions=[node, rviz])])
