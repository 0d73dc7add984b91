"""The room as a ROS 2 node."""
