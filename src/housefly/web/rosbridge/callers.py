"""What a session or a program may do in the terms of ROS."""

from __future__ import annotations

from housefly.config.ros2 import RosRequests
from housefly.ros2.ros_caller import RosCaller
from housefly.web.access.roles import Role
from housefly.web.access.session import Session

PROGRAM = "rosbridge"


def caller_of(session: Session | None, name: str, requests: RosRequests) -> RosCaller:
    """Return who calls; a session may what its role may, and no more than the site allows.

    Args:
        session: of a browser; None for a program with the key of the run.
        name: that others see for the session.
        requests: of the site.
    """
    if session is None:
        return RosCaller(PROGRAM, PROGRAM, requests)
    shown, role = f"{name} ({PROGRAM})", session.role
    if role.includes(Role.FLY):
        return RosCaller(shown, session.owner, requests)
    if role.includes(Role.ASK):
        asks: RosRequests = "off" if requests == "off" else "ask"
        return RosCaller(shown, session.owner, asks, may_fly=False)
    return RosCaller(shown, session.owner, "off", may_ask=False, may_fly=False)
