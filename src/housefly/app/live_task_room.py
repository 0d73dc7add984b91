"""The room as a flying task sees it: memory over the bus, people and viewpoints as of now."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY
from housefly.errors import LinkError
from housefly.geometry import Vec2, Vec3
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import Question
from housefly.sites.loaded_site import LoadedSite
from housefly.tasks.execution.live_obstacles import LiveObstacles
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.vantage.named_search import search_for
from housefly.tasks.vantage.named_subject import round_names, view_from, viewpoint_of
from housefly.tasks.vantage.patrol import shown_share
from housefly.tasks.vantage.thing_search import ThingSearch
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.tasks.vantage.viewpoint import Viewpoint

_PATIENCE = 0.5
"""How long an answer of the memory may take [s]: a flying task waits for it."""
_PAUSE = 5.0
"""After a question without an answer no flight asks the memory again for so long [s]; a person, who
can wait, does.
"""


class LiveTaskRoom:
    """Answers a flying task; thread-safe.

    Args:
        loaded: the site.
        bus: on which the hub answers.
        live: who and what is there now.
        clock: monotonic time [s].
    """

    def __init__(
        self,
        loaded: LoadedSite,
        bus: Bus,
        live: LiveObstacles,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._bus, self._live, self._clock = bus, live, clock
        self._has_memory = loaded.site.hub.enabled
        self._viewing = ViewingRoom(loaded.site, loaded.room, loaded.grid)
        self._silent_until = float("-inf")

    def ask(self, question: Question, patience: float = _PATIENCE) -> Any:
        """Return the memory's answer; raises ThingError, or LinkError when nobody remembers."""
        if not self._has_memory:
            raise LinkError("this site has no memory: hub.enabled is false")
        if patience <= _PATIENCE and self._clock() < self._silent_until:
            raise LinkError("the room's memory does not answer")
        try:
            text = self._bus.ask(HUB_QUERY, question_to_json(question), patience)
        except LinkError as error:
            self._silent_until = self._clock() + _PAUSE
            raise LinkError("the room's memory does not answer") from error
        return answer_from_json(question, text)

    def people(self) -> tuple[SeenPerson, ...]:
        """Return who is seen now."""
        return self._live.people(self._clock())

    def viewpoint(self, subject: str, drone: Vec3 | None = None) -> Viewpoint:
        """Return where to hover to see a place, a thing or a person; raises TaskError."""
        now = self._clock()
        people, told = self._people_about(subject, now), self._live.obstacles(now)
        return viewpoint_of(subject, self._viewing, self.ask, people, drone, told, now)

    def view_from(self, subject: str, place: Vec2) -> Viewpoint | None:
        """Return the viewpoint at a place [m] itself if it shows a subject well, else None."""
        now = self._clock()
        people, told = self._people_about(subject, now), self._live.obstacles(now)
        return view_from(subject, self._viewing, self.ask, place, people, told, now)

    def round_names(self, *, whole: bool = False) -> tuple[str, ...]:
        """Return what a round looks at: named places, or else viewpoints that see the floor."""
        return round_names(self._viewing, whole=whole)

    def shown_share(self, poses: tuple[tuple[Vec2, float], ...]) -> float:
        """Return the share of the floor that pictures from poses showed, [m] and [rad]."""
        return shown_share(poses, self._viewing)

    def search(self, thing: str, drone: Vec3 | None, look_time: float) -> ThingSearch:
        """Return a search for a lost thing; raises TaskError."""
        now = self._clock()
        people, told = self._live.people(now), self._live.obstacles(now)
        return search_for(thing, self._viewing, self.ask, people, drone, told, now, look_time)

    def _people_about(self, subject: str, now: float) -> tuple[SeenPerson, ...]:
        """Return who is tracked, and the subject itself when only a scanner sees them.

        Whom only a scanner sees is an obstacle already; as a subject they are a person.
        """
        scanned = (one for one in self._live.people(now) if one.id == subject)
        people = {one.id: one for one in (*self._live.tracked_people(now), *scanned)}
        return tuple(people.values())
