"""One still picture of a snapshot or a clip."""

from __future__ import annotations

import io

from PIL import Image, UnidentifiedImageError

from housefly.errors import RecordingError

_LARGEST = 1280
"""Longer sides are made smaller [pixels]."""


def clip_picture(content: bytes, kind: str) -> bytes:
    """Return a snapshot, or the middle of a clip, as JPEG.

    Args:
        content: of the file.
        kind: "snapshot" or "clip".

    Raises:
        RecordingError: it cannot be read.
    """
    try:
        picture = _middle(content) if kind == "clip" else Image.open(io.BytesIO(content))
        picture = picture.convert("RGB")
    except (UnidentifiedImageError, OSError, ValueError, Image.DecompressionBombError) as error:
        raise RecordingError(f"the picture cannot be read: {error}") from error
    picture.thumbnail((_LARGEST, _LARGEST))
    written = io.BytesIO()
    picture.save(written, "JPEG", quality=85)
    return written.getvalue()


def _middle(content: bytes) -> Image.Image:
    """Return the frame in the middle of a video."""
    import av

    with av.open(io.BytesIO(content), "r") as video:
        stream = video.streams.video[0]
        half = (stream.duration or 0) // 2 + (stream.start_time or 0)
        last = None
        for frame in video.decode(stream):
            last = frame
            if frame.pts is not None and frame.pts >= half:
                break
        if last is None:
            raise ValueError("there is no frame in it")
        picture: Image.Image = last.to_image()  # type: ignore[no-untyped-call]
        return picture
