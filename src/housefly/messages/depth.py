"""One image of a depth camera."""

from __future__ import annotations

from dataclasses import dataclass

from housefly.messages.sensing import Pose


@dataclass(frozen=True, slots=True)
class DepthImage:
    """One depth image of a pinhole camera, row by row from the top left.

    Attributes:
        source: name of the camera.
        captured_at: when it was exposed [s, our monotonic clock].
        width, height: [px].
        data: distance along the camera's axis of each pixel [mm], 16 bits, low byte first; 0 where
            nothing was measured.
        fx, fy: focal lengths [px].
        cx, cy: the image's middle [px].
        pose: of the camera in the world; it looks along its own +z, x right in the image, y down.
    """

    source: str
    captured_at: float
    width: int
    height: int
    data: bytes
    fx: float
    fy: float
    cx: float
    cy: float
    pose: Pose
