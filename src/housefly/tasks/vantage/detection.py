"""How likely somebody who watches recognises a small thing in the drone's picture.

The target transfer probability function of night vision work: J. Johnson, "Analysis of image
forming systems" (Image Intensifier Symposium, Fort Belvoir, 1958) counts the line pairs across a
target with which half of all observers recognise it; its growth with more of them is the fit of
J. A. Ratches and others, "Night Vision Laboratory static performance model for thermal viewing
systems" (ECOM-7043, 1975).
"""

from __future__ import annotations

import math
from math import tan

import numpy as np

from housefly.numeric import FloatArray, elementwise
from housefly.room.level_camera import FRONT_CAMERA

_PICTURE_WIDTH = 640
"""Of the AR.Drone 2.0's front camera [pixels]."""
_HALF_RECOGNISED = 4.0
"""Line pairs across a target with which half of all observers recognise it (Johnson 1958)."""
_ATTENTION = 0.9
"""Share of what can be recognised in a picture that whoever looks at it notices."""
THING_SIZE = 0.1
"""A cup, glasses or a bunch of keys [m]."""


def detection_probability(distances: FloatArray, size: float = THING_SIZE) -> FloatArray:
    """Return the probability that a thing in the picture is noticed, by its distance.

    Args:
        distances: from the camera [m], any shape.
        size: of the thing [m].

    Returns:
        The same shape, 0 to 1, falling with the distance.
    """
    per_metre = _PICTURE_WIDTH / (2.0 * tan(FRONT_CAMERA.width / 2.0))
    pairs = 0.5 * size * per_metre / np.maximum(distances, 0.1) / _HALF_RECOGNISED
    raised = elementwise(math.pow, pairs, 2.7 + 0.7 * pairs)
    result: FloatArray = _ATTENTION * raised / (1.0 + raised)
    return result
