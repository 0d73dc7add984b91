"""The room as a flying task sees it: memory over the bus, people and viewpoints as of now."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from housefly.app.live_obstacles import LiveObstacles
from housefly.app.loaded_site import LoadedSite
from housefly.bus.bus import Bus
from housefly.bus.topics import HUB_QUERY
from housefly.errors import LinkError
from housefly.geometry import Vec3
from housefly.hub.api.json import answer_from_json, question_to_json
from housefly.hub.api.questions import Question
from housefly.tasks.execution.task_room import SeenPerson
from housefly.tasks.vantage.named_subject import round_names, viewpoint_of
from housefly.tasks.vantage.viewing_room import ViewingRoom
from housefly.tasks.vantage.viewpoint import Viewpoint

_PATIENCE = 0.5
"""How long an answer of the memory may take [s]: a flying task waits for it."""
_PAUSE = 5.0
"""After a question without an answer the memory is not asked again for so long [s]."""


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
        if self._clock() < self._silent_until:
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
        # Whom only a scanner sees is an obstacle already; as a subject they are a person.
        scanned = (one for one in self._live.people(now) if one.id == subject)
        people = {one.id: one for one in (*self._live.tracked_people(now), *scanned)}
        return viewpoint_of(
            subject,
            self._viewing,
            self.ask,
            people.values(),
            drone,
            self._live.obstacles(now),
            now,
        )

    def round_names(self) -> tuple[str, ...]:
        """Return what a round looks at: named places, or else viewpoints that see the floor."""
        return round_names(self._viewing)
