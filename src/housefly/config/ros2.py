"""The part of a site file about ROS 2: how the room appears there, and what may come from there."""

from __future__ import annotations

import re
from typing import Literal

from pydantic import Field, field_validator

from housefly.config.section import Section

RosRequests = Literal["off", "ask", "auto"]


class Ros2Config(Section):
    """The room as a ROS 2 node (``docs/ros2.md``)."""

    enabled: bool = Field(
        default=False,
        description="join ROS 2 as a node, by the rclpy of the sourced ROS or the extra ros2",
    )
    namespace: str = Field(
        default="",
        max_length=60,
        pattern=r"^([A-Za-z][A-Za-z0-9_]*)?$",
        description="of all topics and services; empty: the name of the site",
    )
    frame: str = Field(
        default="map",
        pattern=r"^[A-Za-z][A-Za-z0-9_/]{0,59}$",
        description="name of the world's frame",
    )
    domain: int | None = Field(
        default=None,
        ge=0,
        le=232,
        description="ROS domain; left out: ROS_DOMAIN_ID, or 0",
        json_schema_extra={"unit": "1"},
    )
    discovery: Literal["localhost", "subnet"] = Field(
        default="localhost",
        description="who finds the node: programs of this machine, or of the whole network",
    )
    requests: RosRequests = Field(
        default="ask",
        description=(
            "what a goal, a take-off or a task from ROS may do: nothing, ask a person, fly; no"
            " program proves to ROS who it is, so auto trusts all that reach the domain"
        ),
    )
    paper_names: bool = Field(
        default=False,
        description="serve the topics of the paper's own drone node, too (docs/ros2.md)",
    )


_ORIGIN = re.compile(r"https?://[A-Za-z0-9.\-\[\]:]{1,200}")


class RosbridgeConfig(Section):
    """Rosbridge on the console's port, at `/rosbridge` (``docs/rosbridge.md``).

    Names, frame and the paper's own topics are those of `[ros2]`; no ROS is needed.
    """

    enabled: bool = Field(default=False, description="serve it, for roslibjs and roslibpy")
    requests: RosRequests = Field(
        default="ask",
        description=(
            "what a goal, a take-off or a task may do at most: nothing, ask a person, fly; a"
            " session may no more than its role"
        ),
    )
    origins: tuple[str, ...] = Field(
        default=(),
        max_length=20,
        description=(
            "pages of other servers that may use it with the key of the run, by their origin"
            " (http://HOST:PORT); a program that is no browser names none"
        ),
    )

    @field_validator("origins")
    @classmethod
    def _pages(cls, origins: tuple[str, ...]) -> tuple[str, ...]:
        for origin in origins:
            if not _ORIGIN.fullmatch(origin):
                raise ValueError(
                    f"has {origin!r}; allowed: http://HOST:PORT or https://HOST, without a path"
                )
        return origins
