"""The live picture as other programs may have it: whole groups, and only while it may be seen."""

from __future__ import annotations

from collections.abc import Callable

from housefly.config.house_mode import HouseMode
from housefly.evidence.live_blanker import LiveBlanker
from housefly.messages import VideoFrame


class PictureFilter:
    """Lets through what may be seen: whole groups of pictures, with the zones blank.

    Args:
        blanker: of the site's zones.
        may_be_seen: whether pictures go out, and the mode of the house.
    """

    def __init__(
        self, blanker: LiveBlanker, may_be_seen: Callable[[], tuple[bool, HouseMode | None]]
    ) -> None:
        self.blanker, self._may_be_seen = blanker, may_be_seen
        self._waits_for_key = True

    def shown(self, frame: VideoFrame) -> VideoFrame | None:
        """Return what may be seen of a frame, or None; some milliseconds where there are zones."""
        may, mode = self._may_be_seen()
        self.blanker.set_mode(mode)
        blanked = self.blanker.blanked_frame(frame)
        if not may or blanked is None:
            self._waits_for_key = True
            return None
        if self._waits_for_key and not blanked.keyframe:
            return None
        self._waits_for_key = False
        return blanked

    def miss(self) -> None:
        """Tell that frames pass by unseen: the next that is shown is a key frame."""
        self._waits_for_key = True
