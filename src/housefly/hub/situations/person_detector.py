"""What the detectors of people share: they look at tracks and beds, which others feed."""

from __future__ import annotations

from housefly.hub.situations.bed import Beds
from housefly.hub.situations.layout import Layout
from housefly.hub.situations.person_tracks import PersonTracks
from housefly.hub.situations.situation import DetectorInput


class PersonDetector:
    """Knows where people are.

    Args:
        tracks: where people are; fed by whoever owns it.
        beds: which beds are occupied; likewise.
        layout: where one sits and lies.
    """

    def __init__(self, tracks: PersonTracks, beds: Beds, layout: Layout) -> None:
        self._tracks, self._beds, self._layout = tracks, beds, layout

    def add(self, item: DetectorInput) -> None:
        """Ignore the item: all that counts comes through tracks and beds."""
