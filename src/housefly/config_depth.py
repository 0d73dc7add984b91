"""The depth cameras of a site."""

from __future__ import annotations

from pydantic import Field

from housefly.config_section import Section, quantity


class DepthCameraConfig(Section):
    """An RGB-D camera whose driver sends its depth images, with the camera's pose, on the bus."""

    name: str = Field(min_length=1, max_length=40, pattern=r"^[\w-]+$", description="source of its images")
    rate_hz: float = quantity(10.0, 0.5, 30.0, "Hz", "images that come faster are left out")


def check_depth_cameras(cameras: tuple[DepthCameraConfig, ...]) -> None:
    """Raise ValueError when two cameras share a name."""
    if len({camera.name for camera in cameras}) < len(cameras):
        raise ValueError("depth_cameras: two cameras have the same name")
