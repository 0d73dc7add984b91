"""Checks whether a depth image is plausible, and words what is wrong."""

from __future__ import annotations

from math import hypot, isfinite

import numpy as np

from housefly.config.depth import DepthCameraConfig
from housefly.messages import DepthImage

_MAX_AHEAD, _IMAGE_AGE_MAX = 0.05, 1.0
"""An image further in the future, or older, is refused [s]."""
_MAX_PIXELS = 1_000_000
"""Largest image [px]."""
FROZEN_IMAGES = 3
"""This many identical images in a row come from a frozen camera."""
_MIN_MEASURED_SHARE = 0.01
"""A camera with a smaller share of measured pixels is covered."""
_MAX_CAMERA_DISTANCE = 1000.0
"""Farthest position of a camera from the room's origin [m]."""
_MIN_PERIOD_SHARE = 0.9
"""An image may arrive after this share of the camera's period."""


class DepthChecks:
    """Keeps the last image of each camera; a refused image changes nothing.

    Args:
        cameras: of the site.
    """

    def __init__(self, cameras: tuple[DepthCameraConfig, ...]) -> None:
        self._cameras = {camera.name: camera for camera in cameras}
        self._last: dict[str, DepthImage] = {}
        self._alike: dict[str, int] = {}

    def fault(self, image: DepthImage, now: float) -> str:
        """Return why an image is refused at a time [s], in words, or ""."""
        if image.source not in self._cameras:
            return "not a depth camera of this site"
        problem = _nonsense(image) or _wrong_time(image, now) or self._too_soon(image)
        if problem:
            return problem
        last = self._last.get(image.source)
        is_alike = last is not None and last.data == image.data
        self._last[image.source] = image
        self._alike[image.source] = self._alike.get(image.source, 0) + 1 if is_alike else 0
        if (
            np.count_nonzero(np.frombuffer(image.data, dtype="<u2"))
            < _MIN_MEASURED_SHARE * image.width * image.height
        ):
            return "it measures next to nothing; does something cover it?"
        return (
            "the same image to the last bit again and again: it stands still"
            if self._alike[image.source] >= FROZEN_IMAGES
            else ""
        )

    def _too_soon(self, image: DepthImage) -> str:
        last, rate = self._last.get(image.source), self._cameras[image.source].rate_hz
        if last is None:
            return ""
        if image.captured_at <= last.captured_at:
            return "an image that is not newer than the last"
        return (
            f"more than {rate:g} images a second"
            if image.captured_at - last.captured_at < _MIN_PERIOD_SHARE / rate
            else ""
        )


def _nonsense(image: DepthImage) -> str:
    w, x, y, z = image.pose.orientation
    camera = (image.fx, image.fy, image.cx, image.cy)
    if not all(
        isfinite(number)
        for number in (image.captured_at, *camera, *image.pose.position, w, x, y, z)
    ):
        return "not all its numbers are finite"
    if image.width < 1 or image.height < 1 or image.width * image.height > _MAX_PIXELS:
        return f"it has no pixels, or more than {_MAX_PIXELS}"
    if len(image.data) != 2 * image.width * image.height:
        return "it does not hold two bytes a pixel"
    if min(image.fx, image.fy) < 1.0 or not (
        0.0 <= image.cx <= image.width and 0.0 <= image.cy <= image.height
    ):
        return "intrinsics that are none"
    if (
        abs(hypot(w, x, y, z) - 1.0) > 0.01
        or max(abs(number) for number in image.pose.position) > _MAX_CAMERA_DISTANCE
    ):
        return "a pose that is none"
    return ""


def _wrong_time(image: DepthImage, now: float) -> str:
    if image.captured_at > now + _MAX_AHEAD:
        return "an image from the future"
    return (
        f"images come more than {_IMAGE_AGE_MAX:.0f} s late"
        if image.captured_at < now - _IMAGE_AGE_MAX
        else ""
    )
