"""Pictures of a camera as the drone sends them, each with its number readable in its colours."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from housefly.messages import VideoFrame
from housefly.twin.camera.encoder import Encoder

SIZE = (320, 192)
RATE_HZ = 15.0


def striped(number: int) -> NDArray[np.uint8]:
    """Return a picture with a bright bar for each set bit of its number, and a little noise."""
    picture = np.random.default_rng(number).integers(90, 110, (*SIZE[::-1], 3), dtype=np.uint8)
    for bit in range(10):
        picture[:, bit * 32 : bit * 32 + 32] += np.uint8(100 * (number >> bit & 1))
    return picture


def number_of(picture: NDArray[np.uint8]) -> int:
    """Return the number of a striped picture."""
    bars = picture.astype(float).mean(axis=(0, 2)).reshape(10, 32)[:, 8:24].mean(axis=1)
    return sum(1 << bit for bit in range(10) if bars[bit] > 150)


def video(
    seconds: float, start: float = 100.0, *, group: int = 15, first: int = 0
) -> Iterator[VideoFrame]:
    """Yield encoded striped pictures; ``start`` is when the first arrives [s]."""
    encoder = Encoder(*SIZE, RATE_HZ, group=group)
    for n in range(first, first + round(seconds * RATE_HZ)):
        data, keyframe = encoder.encode(striped(n))
        yield VideoFrame(data, keyframe, *SIZE, n, start + (n - first) / RATE_HZ)
