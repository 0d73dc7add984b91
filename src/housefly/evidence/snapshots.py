"""One picture out of a stream, as a JPEG file."""

from __future__ import annotations

import os
from io import BytesIO
from pathlib import Path

from PIL import Image

from housefly.config.durable import sync_folder
from housefly.evidence.clip_writer import create_private
from housefly.evidence.frame_blanker import FrameBlanker
from housefly.evidence.picture_codec import Picture
from housefly.evidence.privacy_mask import FrameToMask

SNAPSHOT_SUFFIX, _PART_SUFFIX = ".jpg", ".jpg.part"
_QUALITY = 92


def newest_picture(frames: tuple[FrameToMask, ...], blanker: FrameBlanker) -> Picture | None:
    """Return the newest picture of a group that begins with a key frame, or None."""
    newest = None
    for filmed in frames:
        newest = blanker.picture(filmed)
    return newest


def write_snapshot(path: Path, picture: Picture) -> int:
    """Write a picture as a file that only this user can read, and return its size [bytes].

    May raise OSError.
    """
    buffer = BytesIO()
    Image.fromarray(picture).save(buffer, "JPEG", quality=_QUALITY)
    part = path.with_name(path.stem + _PART_SUFFIX)
    create_private(part)
    try:
        with part.open("r+b") as file:
            file.write(buffer.getvalue())
            file.flush()
            os.fsync(file.fileno())
        part.replace(path)
        sync_folder(path.parent)
    except OSError:
        part.unlink(missing_ok=True)
        raise
    return len(buffer.getvalue())
