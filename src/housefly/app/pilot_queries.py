"""Answers queries to the pilot process: the room, and a path before anyone flies it.

Answers are computed on the bus's own thread, so that no query delays a control step.
"""

from __future__ import annotations

from housefly.app.loaded_site import LoadedSite
from housefly.app.views import room_view
from housefly.bus.bus import Bus
from housefly.bus.topics import PLAN_QUERY, ROOM_QUERY
from housefly.errors import WireError
from housefly.geometry import Vec2
from housefly.hub.api.pilot_queries import PlanRequest
from housefly.hub.api.pilot_queries_json import from_json, to_json
from housefly.messages import PilotStep, PlanAnswer
from housefly.pilot.assembly import make_pilot


class PilotQueryServer:
    """Answers ROOM_QUERY and PLAN_QUERY on a bus until closed."""

    def __init__(self, loaded: LoadedSite, bus: Bus) -> None:
        self._room = to_json(room_view(loaded))
        self._loaded = loaded
        self._pilot = make_pilot(loaded.site, loaded.room, loaded.grid)
        self._drone_at: Vec2 = loaded.room.home
        self._open = [
            bus.answer(ROOM_QUERY, lambda _: self._room),
            bus.answer(PLAN_QUERY, self._plan),
        ]

    def update(self, step: PilotStep) -> None:
        """Keep the drone's position, where plans start."""
        if step.outputs.estimate is not None:
            self._drone_at = step.outputs.estimate.position[:2]

    def close(self) -> None:
        """Stop answering."""
        for subscription in self._open:
            subscription.close()

    def _plan(self, text: str) -> str:
        return to_json(self._answer(from_json(PlanRequest, text)))

    def _answer(self, request: PlanRequest) -> PlanAnswer:
        start = request.start or self._drone_at
        if request.place:
            try:
                goal = self._loaded.room.place(request.place).viewpoint
            except KeyError as error:
                return PlanAnswer(start, start, None, str(error.args[0]))
        elif request.goal is not None:
            goal = request.goal
        else:
            raise WireError("a plan needs a place or a goal")
        return self._pilot.plan(goal, start)
