"""The depth cameras of a site."""

from __future__ import annotations

from pydantic import Field

from housefly.config.section import Section, quantity


class DepthCameraConfig(Section):
    """An RGB-D camera whose driver sends its depth images on the bus, each with its pose.

    The place given here is the twin's.
    """

    name: str = Field(
        min_length=1, max_length=40, pattern=r"^[\w-]+$", description="source of its images"
    )
    rate_hz: float = quantity(10.0, 0.5, 30.0, "Hz", "images that come faster are left out")
    x: float = quantity(0.0, -1000.0, 1000.0, "m", "where the twin's camera is in the room")
    y: float = quantity(0.0, -1000.0, 1000.0, "m", "likewise")
    z: float = quantity(1.1, 0.05, 5.0, "m", "its height")
    yaw: float = quantity(0.0, -3.1416, 3.1416, "rad", "where it looks")
    pitch: float = quantity(0.0, -1.5, 1.5, "rad", "how far it looks down")


def check_depth_cameras(cameras: tuple[DepthCameraConfig, ...]) -> None:
    """Raise ValueError when two cameras share a name."""
    if len({camera.name for camera in cameras}) < len(cameras):
        raise ValueError("depth_cameras: two cameras have the same name")
