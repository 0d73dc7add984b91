"""Pictures out of the drone's H.264 and back, one at a time and without delay."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import av
import numpy as np
from av.codec.context import Flags
from av.error import FFmpegError
from av.video.codeccontext import VideoCodecContext
from numpy.typing import NDArray

from housefly.messages import VideoFrame

Picture = NDArray[np.uint8]
"""RGB, shape (height, width, 3)."""
_BIT_RATE = 2_000_000
_RATE_HZ = 30
_GROUP_OF_PICTURES = 15


class PictureDecoder:
    """Decodes a stream from a key frame on; after a gap, from the next one."""

    def __init__(self) -> None:
        self._codec = _decoder()
        self._next: int | None = None

    def decode(self, frame: VideoFrame) -> Picture | None:
        """Return the picture, or None for one that cannot be decoded truthfully."""
        if not frame.keyframe and frame.sequence != self._next:
            # A picture after a lost one shows parts of an older one, in the wrong place.
            self._next = None
            return None
        try:
            decoded = self._codec.decode(av.Packet(frame.data))
        except FFmpegError:
            decoded = []
        if not decoded or decoded[-1].is_corrupt:
            self._codec, self._next = _decoder(), None
            return None
        self._next = (frame.sequence + 1) & 0xFFFFFFFF
        # Blocks of 16 pixels may reach below what is shown.
        shown = decoded[-1].to_ndarray(format="rgb24")[: frame.height, : frame.width]
        return np.asarray(shown, dtype=np.uint8)


class PictureEncoder:
    """Encodes pictures so that every browser shows them; the first is a key frame."""

    def __init__(self, width: int, height: int) -> None:
        self.size = width, height
        codec = VideoCodecContext.create("libx264", "w")
        codec.width, codec.height, codec.pix_fmt = width, height, "yuv420p"
        codec.framerate = Fraction(_RATE_HZ)
        codec.bit_rate, codec.gop_size, codec.thread_count = _BIT_RATE, _GROUP_OF_PICTURES, 1
        codec.options = {
            "preset": "ultrafast",
            "tune": "zerolatency",
            "profile": "baseline",
            "x264-params": "scenecut=0:repeat-headers=1",
        }
        self._codec, self._count = codec, 0

    def encode(self, picture: Picture, like: VideoFrame) -> VideoFrame:
        """Return a picture as a frame with the number and the times of another.

        Args:
            picture: of the encoder's size.
            like: the frame that it was.
        """
        frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(picture), format="rgb24")
        frame.pts, self._count = self._count, self._count + 1
        (packet,) = self._codec.encode(frame)
        return replace(like, data=bytes(packet), keyframe=packet.is_keyframe)


def _decoder() -> VideoCodecContext:
    decoder = VideoCodecContext.create("h264", "r")
    decoder.thread_count, decoder.flags = 1, decoder.flags | Flags.low_delay
    return decoder
