"""Editing the places and zones of a room: view, save, undo. Blocking; the server uses a thread."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from housefly.config.edits import Edits
from housefly.config.site import Site
from housefly.errors import EditsError, StaleEdits
from housefly.hub.api.pilot_queries import PlaceView
from housefly.room.edit_versions import EditVersion, EditVersions
from housefly.room.edits import edited, edits_from_tree, with_places
from housefly.room.model import Place, Room

_APPLIES_FROM_NEXT_START = (
    "The drone keeps the map that it started with: this applies from the next start of Housefly on."
)

USE_TIME = 10.0
"""About how long the pilot is away while it takes a new map [s]."""


class EditsNotUsed(EditsError):
    """What was saved cannot be put into use now."""


@dataclass(frozen=True, slots=True)
class ZoneView:
    """A no-fly zone: x_min, y_min, x_max, y_max [m], and why."""

    rectangle: tuple[float, float, float, float]
    reason: str


@dataclass(frozen=True, slots=True)
class EditsView:
    """The newest version of a room's places and zones, and where it comes from.

    Attributes:
        version: its number; a save must name it.
        own: the room's places without edits.
        places: the places that apply.
        zones: the zones that apply, without those of the site file.
        undoable: whether there is a version before.
        saved_at: Unix time [s]; 0 for a room without edits.
        by: who saved it.
        words: what users should know about it, or "".
        in_use: whether the drone has it already.
        use_time: how long it takes to put it into use without a new start [s]; 0 where nothing
            can.
    """

    version: int
    own: tuple[PlaceView, ...]
    places: tuple[PlaceView, ...]
    zones: tuple[ZoneView, ...]
    undoable: bool
    saved_at: float
    by: str
    words: str
    in_use: bool = True
    use_time: float = 0.0


class EditService:
    """Views, checks and saves the edits of one room.

    Args:
        room: loads the room as its file has it; called once, on first use.
        site: the site that is flown, with the edits in force.
        versions: where edits are kept.
        in_force: the edits that the drone has now; by default those of the site.
        use: asks the launcher to put a version into use; "" or why not, in words. None where
            there is none that could.
    """

    def __init__(
        self,
        room: Callable[[], Room],
        site: Site,
        versions: EditVersions,
        *,
        in_force: Callable[[], Edits] | None = None,
        use: Callable[[int], str] | None = None,
    ) -> None:
        self._load, self._site, self._versions = room, site, versions
        self._in_force, self._use = in_force or (lambda: site.edits), use
        self._room: Room | None = None

    @property
    def disabled_reason(self) -> str:
        """Why nothing can be edited here, or ""."""
        if not self._site.hub.edits:
            return "editing is switched off here: hub.edits = false in the site file"
        if self._site.mode == "paper":
            return "mode paper flies the paper's own map: edit in mode default"
        return ""

    def view(self) -> EditsView:
        """Return the newest version; raises EditsError or RoomError."""
        return self._view(self._versions.newest())

    def save(self, tree: Any, based_on: int, by: str) -> EditsView:
        """Check and save edits; raises StaleEdits, or EditsError in words."""
        edits = edits_from_tree(tree)
        edited(self._own_room(), self._site, edits)
        return self._view(self._versions.save(edits, based_on, by))

    def undo(self, based_on: int, by: str) -> EditsView:
        """Go back one version; raises StaleEdits, or EditsError in words."""
        before = self._versions.before(self._versions.newest())
        if before is not None:
            edited(self._own_room(), self._site, before.edits)
        return self._view(self._versions.undo(based_on, by))

    def use(self, based_on: int) -> EditsView:
        """Put the newest version into use, which takes ``USE_TIME``.

        Raises:
            StaleEdits: somebody saved after the version ``based_on``.
            EditsNotUsed: it is in use already, or the drone does not stand, in words.
            EditsError: it does not fit the room any more.
        """
        newest = self._versions.newest()
        if newest.number != based_on:
            raise StaleEdits(f"version {newest.number} was saved in between: look at it first")
        if newest.edits == self._in_force():
            raise EditsNotUsed("the drone has this version already")
        edited(self._own_room(), self._site, newest.edits)
        if self._use is None:
            raise EditsNotUsed("nothing here can start the pilot again: it counts from the next")
        if objection := self._use(based_on):
            raise EditsNotUsed(objection)
        return self._view(newest)

    def _own_room(self) -> Room:
        if self._room is None:
            self._room = self._load()
        return self._room

    def _view(self, version: EditVersion) -> EditsView:
        room, words = self._own_room(), [self._versions.problem]
        in_use = version.edits == self._in_force()
        if not in_use:
            words.append(_APPLIES_FROM_NEXT_START)
        try:
            edited(room, self._site, version.edits)
        except EditsError as error:
            words.append(f"It does not fit the room any more: {error}.")
        changed = with_places(room, self._site.model_copy(update={"edits": version.edits}))
        return EditsView(
            version.number,
            tuple(_place(place) for place in room.places),
            tuple(_place(place) for place in changed.places),
            tuple(ZoneView(zone.rectangle, zone.reason) for zone in version.edits.zones),
            version.equals > 0,
            version.saved_at,
            version.by,
            " ".join(filter(None, words)),
            in_use,
            USE_TIME if self._use is not None else 0.0,
        )


def _place(place: Place) -> PlaceView:
    return PlaceView(
        place.name, place.title or place.name.capitalize(), place.viewpoint, place.look_at
    )
