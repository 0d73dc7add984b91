"""The plain picture sent where nothing can be rendered: why, and which command mends it."""

from __future__ import annotations

import textwrap

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

_REMEDY = "apt-get install libosmesa6"
_BACKGROUND, _TITLE, _TEXT = (32, 36, 42), (245, 246, 248), (178, 184, 192)
_LEFT = 48
_EXPLANATION = (
    "The drone flies all the same. This machine cannot draw\nwhat its camera sees; this line"
    " mends it:"
)


def draw_card(reasons: tuple[str, ...], width: int, height: int) -> NDArray[np.uint8]:
    """Return an RGB picture, shape (height, width, 3), with the reasons why there is no view."""
    image = Image.new("RGB", (width, height), _BACKGROUND)
    pen = ImageDraw.Draw(image)
    pen.text((_LEFT, 56), "No camera picture", _TITLE, ImageFont.load_default(34))
    pen.multiline_text((_LEFT, 110), _EXPLANATION, _TEXT, ImageFont.load_default(18), spacing=6)
    pen.text((_LEFT, 174), _REMEDY, _TITLE, ImageFont.load_default(22))
    small = "\n".join(line for reason in reasons for line in textwrap.wrap(reason, 84)[:3])
    pen.multiline_text((_LEFT, 226), small, _TEXT, ImageFont.load_default(13), spacing=4)
    return np.asarray(image, dtype=np.uint8)
