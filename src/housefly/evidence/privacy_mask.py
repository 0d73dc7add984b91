"""What of a picture must be blank, and a picture with it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

from housefly.messages import VideoFrame
from housefly.room.reach import Mask


@dataclass(frozen=True, slots=True)
class PrivacyMask:
    """What of a picture must be blank.

    Attributes:
        is_whole: everything.
        polygons: convex parts, corners [px]; x to the right, y down, from the upper left corner.
    """

    is_whole: bool = False
    polygons: tuple[tuple[tuple[float, float], ...], ...] = ()

    @property
    def is_empty(self) -> bool:
        """Whether nothing must be blank."""
        return not (self.is_whole or self.polygons)

    def pixels(self, width: int, height: int) -> Mask:
        """Return which pixels must be blank, shape (height, width)."""
        if self.is_whole:
            return np.ones((height, width), dtype=np.bool_)
        picture = Image.new("1", (width, height))
        pen = ImageDraw.Draw(picture)
        for polygon in self.polygons:
            pen.polygon(polygon, fill=1, outline=1)
        return np.asarray(picture, dtype=np.bool_)


MASK_ALL = PrivacyMask(is_whole=True)
MASK_NONE = PrivacyMask()


@dataclass(frozen=True, slots=True)
class FrameToMask:
    """One encoded picture, and what of it must be blank."""

    frame: VideoFrame
    mask: PrivacyMask = MASK_NONE
