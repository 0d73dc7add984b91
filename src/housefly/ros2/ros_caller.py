"""Who wishes something in the terms of ROS, and what they may."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.config.ros2 import RosRequests

NODE_SENDER, NODE_OWNER = "ROS 2", "ros2"
FLIGHTS_ARE_OFF = "flights are off for you: requests in the site file, or your role"


@dataclass(frozen=True, slots=True)
class RosCaller:
    """Somebody who calls services and publishes to topics of ours.

    Attributes:
        name: shown to everybody, and the sender of their orders.
        owner: id of whose requests and tasks are counted together.
        requests: what a goal, a take-off and a task of theirs may do.
        may_ask: whether memory and tasks answer their questions.
        may_fly: whether they may do what is for who flies: end tasks of others, bring a drone home,
            end an emergency on the ground.
    """

    name: str
    owner: str
    requests: RosRequests
    may_ask: bool = True
    may_fly: bool = True


def node_caller(requests: RosRequests) -> RosCaller:
    """Return all of ROS 2 as one caller: no node proves that it is another one."""
    return RosCaller(NODE_SENDER, NODE_OWNER, requests)
