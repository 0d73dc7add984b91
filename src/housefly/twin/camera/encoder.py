"""H.264 as small drones send it: Baseline, Annex B, a key frame with SPS and PPS every 15."""

from __future__ import annotations

from fractions import Fraction

import av
import numpy as np
from av.video.reformatter import Interpolation, VideoReformatter
from numpy.typing import NDArray

_BIT_RATE = 1_200_000
"""Mean bit rate [bit/s]; peaks stay below a quarter more."""
_GROUP_OF_PICTURES = 15


class Encoder:
    """Scales, converts and encodes pictures with one thread and no delay.

    Args:
        width, height: size of the encoded pictures [px].
        rate_hz: pictures per second; the rate control counts on it.
        group: pictures from key frame to key frame.
        bit_rate: mean bit rate [bit/s].
    """

    def __init__(
        self,
        width: int,
        height: int,
        rate_hz: float,
        group: int = _GROUP_OF_PICTURES,
        bit_rate: int = _BIT_RATE,
    ) -> None:
        self._size = width, height
        self._count = 0
        self._reformatter = VideoReformatter()
        self._picture: NDArray[np.uint8] | None = None
        self._frame: av.VideoFrame | None = None
        rate = Fraction(rate_hz).limit_denominator(1000)
        codec = av.CodecContext.create("libx264", "w")
        codec.width, codec.height, codec.pix_fmt = width, height, "yuv420p"
        codec.framerate, codec.time_base = rate, 1 / rate
        codec.bit_rate = bit_rate
        codec.gop_size = group
        codec.thread_count = 1
        kbit = bit_rate // 1000
        codec.options = {
            "preset": "ultrafast",
            "tune": "zerolatency",
            "profile": "baseline",
            "x264-params": (
                f"scenecut=0:repeat-headers=1:vbv-maxrate={kbit * 5 // 4}:vbv-bufsize={kbit // 2}"
            ),
        }
        self._codec = codec

    def encode(self, picture: NDArray[np.uint8]) -> tuple[bytes, bool]:
        """Return the H.264 access unit of a picture, and whether it is a key frame.

        Args:
            picture: RGB, shape (rows, columns, 3), any size; not written to any more. The same
                array again is the same picture.
        """
        if self._frame is None or picture is not self._picture:
            self._picture, self._frame = picture, self._converted(picture)
        frame = self._frame
        frame.pts = self._count
        self._count += 1
        (packet,) = self._codec.encode(frame)
        return bytes(packet), packet.is_keyframe

    def _converted(self, picture: NDArray[np.uint8]) -> av.VideoFrame:
        # Area averaging: a picture rendered larger than it is shown comes out with smooth edges.
        return self._reformatter.reformat(
            av.VideoFrame.from_ndarray(picture, format="rgb24"),
            *self._size,
            "yuv420p",
            interpolation=Interpolation.AREA,
        )
