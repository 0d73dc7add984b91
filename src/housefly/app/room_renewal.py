"""Puts saved places and zones into use without ending the run: who reads the room starts again.

Everything is checked before anybody is ended: the edits, the room on the disk, and the pilot's own
word that the drone stands and that it takes no order to fly meanwhile. Until the moment at which
the pilot is ended the run's site file keeps the old edits, so that a pilot that dies by itself
comes back with the map that it had.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from pathlib import Path

from housefly.app.launcher import Launcher, pilot_process
from housefly.app.take_off_pause import TAKE_OFF_PAUSE_TIME
from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics
from housefly.config.site import Site
from housefly.config.state import edits_folder
from housefly.errors import EditsError, HouseflyError, LinkError, StaleEdits
from housefly.room.edit_versions import EditVersions
from housefly.sites.loaded_site import open_site, with_newest_edits

_LOG = logging.getLogger(__name__)

ROOM_READERS = ("hub", "perception", "tasks", "ros2", "homeassistant")
"""They keep places, zones or the map; after the pilots, in this order, they start again. The room's
own solids, which the twin has, and what the console shows, which the pilot tells, are not among
them."""
_ANSWER_PAUSE = 0.5
"""Before the pilot is ended, through which the answer goes [s]."""
_PATIENCE = 2.0
"""How long the pilot may take to give its word [s]."""
_WORD_HOLDS = TAKE_OFF_PAUSE_TIME - _PATIENCE
"""So long after it was asked its word is relied on [s]."""


class RoomRenewal:
    """Answers the console's wish to use what was saved.

    Args:
        launcher: of the run.
        bus: of the run.
        is_recorded: whether the run is recorded, into one file that holds one map.
        clock: monotonic [s].
    """

    def __init__(
        self,
        launcher: Launcher,
        bus: Bus,
        *,
        is_recorded: bool,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._launcher, self._bus = launcher, bus
        self._is_recorded, self._clock = is_recorded, clock
        self._lock = threading.Lock()

    def answer(self, version: str) -> str:
        """Use a version of the edits, by its number; return "" or why not, in words."""
        if not self._lock.acquire(blocking=False):
            return "that is being done already"
        try:
            self._begin(int(version))
        except (HouseflyError, OSError, ValueError) as error:
            return str(error)
        finally:
            self._lock.release()
        return ""

    def _begin(self, version: int) -> None:
        if self._is_recorded:
            raise EditsError("this run is recorded, and a recording has one map: start anew")
        if self._launcher.is_renewing:
            raise EditsError("that is being done already")
        path = self._launcher.runtime.site_file
        staged = path.with_suffix(".next")
        staged.write_text(
            checked_site(self._launcher.runtime.site(), version).model_dump_json(indent=1),
            encoding="utf-8",
        )
        asked_at = self._clock()
        if objection := self._pilots_objection():
            staged.unlink()
            raise EditsError(objection)
        deadline = asked_at + _WORD_HOLDS

        def begin() -> bool:
            return self._swap(staged, path, deadline)

        site = self._launcher.runtime.site()
        pilots = tuple(pilot_process(site, name).name for name in site.drone_names)
        # Without a pilot it is the room's process that tells what the room is like.
        self._launcher.renew((*(pilots or ("room",)), *ROOM_READERS), _ANSWER_PAUSE, begin)

    def _pilots_objection(self) -> str:
        site = self._launcher.runtime.site()
        for name in site.drone_names or (site.drone.name,):
            try:
                objection = self._bus.ask(DroneTopics(name).stand_down, "", _PATIENCE)
            except LinkError:
                objection = "the pilot does not answer, so nobody knows whether the drone flies"
            if objection:
                return f"{name}: {objection}" if len(site.drone_names) > 1 else objection
        return ""

    def _swap(self, staged: Path, path: Path, deadline: float) -> bool:
        """Put the new site in place of the old one, while the pilot's word holds."""
        if self._clock() > deadline:
            staged.unlink(missing_ok=True)
            return False
        try:
            staged.replace(path)
        except OSError as error:
            _LOG.error("the new site cannot take the place of the old one: %s", error)
            return False
        return True


def checked_site(site: Site, version: int) -> Site:
    """Return a site with a version of its edits that is the newest, whole, and can be flown.

    Raises:
        StaleEdits: somebody saved after that version.
        EditsError: a version cannot be read.
        HouseflyError: the edits no longer fit the room, or it cannot be read.
    """
    versions = EditVersions(edits_folder(site))
    newest = versions.newest()
    if versions.problem:
        raise EditsError(versions.problem)
    if newest.number != version:
        raise StaleEdits(f"version {newest.number} was saved in between: look at it first")
    found, _ = with_newest_edits(site)
    if found.edits != newest.edits:
        raise StaleEdits("the edits changed in between: look at them first")
    open_site(found)
    return found
