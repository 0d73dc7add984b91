"""The scanning range finders of a site."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from housefly.config.section import Section, quantity

LaserKind = Literal["scip", "ros2"]


class LaserConfig(Section):
    """A scanner that hangs level on a wall or stands on the floor, and where it answers."""

    name: str = Field(
        min_length=1, max_length=40, pattern=r"^[\w-]+$", description="source of what it sees"
    )
    kind: LaserKind = Field(
        default="scip",
        description="driver: SCIP over TCP, or a LaserScan topic of ROS 2",
    )
    model: Literal["urg-04lx", "ust-10lx"] = Field(
        default="ust-10lx", description="what the twin serves; a real one says itself"
    )
    address: str = Field(
        default="127.0.0.1", description="IP address; a real UST-10LX is 192.168.0.10"
    )
    port: int = Field(
        default=10940, ge=1, le=65535, description="TCP port", json_schema_extra={"unit": "1"}
    )
    ros_topic: str = Field(
        default="/scan",
        max_length=200,
        pattern=r"^(/[A-Za-z_][A-Za-z0-9_]*)+$",
        description=(
            "topic with sensor_msgs/LaserScan, when kind is ros2; where the scanner is, the keys"
            " below say, not /tf"
        ),
    )
    ros_domain: int | None = Field(
        default=None,
        ge=0,
        le=232,
        description="ROS domain; left out: ROS_DOMAIN_ID, or 0",
        json_schema_extra={"unit": "1"},
    )
    ros_discovery: Literal["localhost", "subnet"] = Field(
        default="localhost", description="where the ROS node that reads the scanner runs"
    )
    x: float = quantity(0.0, -1000.0, 1000.0, "m", "where it is in the room")
    y: float = quantity(0.0, -1000.0, 1000.0, "m", "likewise")
    z: float = quantity(
        1.1, 0.05, 5.0, "m", "height of its plane; what is not at this height it cannot see"
    )
    yaw: float = quantity(0.0, -3.1416, 3.1416, "rad", "where its front looks")
    latency: float = quantity(0.03, 0.0, 0.5, "s", "from the middle of a scan to its arrival")


def scip_lasers(lasers: tuple[LaserConfig, ...]) -> tuple[LaserConfig, ...]:
    """Return the scanners that answer at an address of their own."""
    return tuple(laser for laser in lasers if laser.kind == "scip")


def check_lasers(lasers: tuple[LaserConfig, ...]) -> None:
    """Raise ValueError when two scanners share a name, a place on the wire or a topic."""
    if len({laser.name for laser in lasers}) < len(lasers):
        raise ValueError("lasers: two scanners have the same name")
    wired = scip_lasers(lasers)
    if len({(laser.address, laser.port) for laser in wired}) < len(wired):
        raise ValueError("lasers: two scanners have the same address and port")
    heard = [laser for laser in lasers if laser.kind == "ros2"]
    if len({(laser.ros_domain, laser.ros_topic) for laser in heard}) < len(heard):
        raise ValueError("lasers: two scanners have the same topic")
