"""Pictures as JPEG of a bounded size: a broker of ours takes no packet above 64 KiB."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import numpy as np
from PIL import Image, UnidentifiedImageError

from housefly.evidence.frame_blanker import BLANK
from housefly.evidence.picture_codec import Picture

MAX_PICTURE = 60_000
"""Longest picture that is sent [bytes]."""
_WIDTH_MAX = 640
"""Wider pictures are made smaller [px]."""
_QUALITIES = (80, 65, 50, 35, 20)
_BLANK_SIZE = 64, 36


def jpeg_of(picture: Picture) -> bytes:
    """Return a picture as JPEG, the best that is short enough; b"" when there is none."""
    return _encoded(Image.fromarray(np.asarray(picture, dtype=np.uint8)))


def jpeg_of_file(path: Path) -> bytes:
    """Return a kept picture as it may be sent; b"" when it cannot be read."""
    try:
        with Image.open(path) as picture:
            return _encoded(picture.convert("RGB"))
    except (OSError, UnidentifiedImageError, Image.DecompressionBombError):
        return b""


def blank_jpeg() -> bytes:
    """Return a picture on which nothing is to be seen."""
    return _encoded(Image.new("RGB", _BLANK_SIZE, BLANK))


def _encoded(picture: Image.Image) -> bytes:
    picture.thumbnail((_WIDTH_MAX, _WIDTH_MAX))
    for quality in _QUALITIES:
        buffer = BytesIO()
        picture.save(buffer, "JPEG", quality=quality)
        if buffer.tell() <= MAX_PICTURE:
            return buffer.getvalue()
    return b""
