"""The scanning range finders of a site."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from housefly.config.section import Section, quantity


class LaserConfig(Section):
    """A scanner that hangs level on a wall or stands on the floor, and where it answers."""

    name: str = Field(
        min_length=1, max_length=40, pattern=r"^[\w-]+$", description="source of what it sees"
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
    x: float = quantity(0.0, -1000.0, 1000.0, "m", "where it is in the room")
    y: float = quantity(0.0, -1000.0, 1000.0, "m", "likewise")
    z: float = quantity(
        1.1, 0.05, 5.0, "m", "height of its plane; what is not at this height it cannot see"
    )
    yaw: float = quantity(0.0, -3.1416, 3.1416, "rad", "where its front looks")
    latency: float = quantity(0.03, 0.0, 0.5, "s", "from the middle of a scan to its arrival")


def check_lasers(lasers: tuple[LaserConfig, ...]) -> None:
    """Raise ValueError when two scanners share a name or a place on the wire."""
    if len({laser.name for laser in lasers}) < len(lasers):
        raise ValueError("lasers: two scanners have the same name")
    if len({(laser.address, laser.port) for laser in lasers}) < len(lasers):
        raise ValueError("lasers: two scanners have the same address and port")
