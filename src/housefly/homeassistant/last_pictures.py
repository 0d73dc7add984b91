"""The last snapshot of each drone: what evidence has kept, with its zones and faces blank."""

from __future__ import annotations

from collections.abc import Callable

from housefly.config.house_mode import HouseMode, may_record
from housefly.errors import HouseflyError
from housefly.evidence.clip_index import ClipIndex
from housefly.evidence.clip_values import ClipInfo, ClipsQuestion
from housefly.homeassistant.drone_entities import picture_key
from housefly.homeassistant.home_requests import ASKER
from housefly.homeassistant.home_view import HomeMessage
from housefly.homeassistant.jpeg import jpeg_of_file
from housefly.homeassistant.topics import HomeTopics

_SNAPSHOT = "snapshot"
_LOOKED_AT = 50
"""So many of the newest clips are searched for a snapshot."""


class LastPictures:
    """Finds the newest snapshots; who is shown one is written down once, as of any other viewer.

    Args:
        index: of the clips.
        drones: their names; what an earlier version kept is of the first.
        topics: where pictures go.
        mode: tells the mode of the house, None while nobody knows.
    """

    def __init__(
        self,
        index: ClipIndex,
        drones: tuple[str, ...],
        topics: HomeTopics,
        mode: Callable[[], HouseMode | None],
    ) -> None:
        self._index, self._drones, self._topics, self._mode = index, drones, topics, mode
        self._logged: set[str] = set()

    def messages(self) -> list[HomeMessage]:
        """Return the newest picture of each drone; none in a mode that records nothing."""
        mode = self._mode()
        if mode is None or not may_record(mode):
            return []
        try:
            clips = self._index.find(ClipsQuestion(limit=_LOOKED_AT)).clips
            found = [
                (name, clip)
                for name in self._drones
                if (clip := next((one for one in clips if self._is_of(one, name)), None))
            ]
            return [told for name, clip in found if (told := self._message(name, clip))]
        except HouseflyError:  # it was deleted just now
            return []

    def _is_of(self, clip: ClipInfo, drone: str) -> bool:
        return clip.kind == _SNAPSHOT and (clip.drone or self._drones[0]) == drone

    def _message(self, drone: str, clip: ClipInfo) -> HomeMessage | None:
        picture = jpeg_of_file(self._index.file(clip.id))
        if not picture:
            return None
        if clip.id not in self._logged:
            self._index.log_access(clip.id, ASKER)
            self._logged.add(clip.id)
        return self._topics.picture(picture_key(drone, "image")), picture
