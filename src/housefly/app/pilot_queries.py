"""Answers queries to the pilot process: the room, a path before anyone flies it, and readiness.

Answers are computed on the bus's own thread, so that no query delays a control step.
"""

from __future__ import annotations

from dataclasses import replace

from housefly.app.views import room_view
from housefly.bus.bus import Bus
from housefly.bus.topics import DroneTopics
from housefly.errors import WireError
from housefly.geometry import Vec2
from housefly.hub.api.pilot_queries import PlanRequest, PreflightView
from housefly.hub.api.pilot_queries_json import from_json, to_json
from housefly.messages import Path, PilotStep, PlanAnswer, PreflightCheck
from housefly.pilot.assembly import make_pilot
from housefly.pilot.behavior.preflight import preflight_refusal
from housefly.sites.loaded_site import LoadedSite


class PilotQueryServer:
    """Answers the queries of one drone on a bus until closed."""

    def __init__(self, loaded: LoadedSite, bus: Bus) -> None:
        self._room = to_json(room_view(loaded))
        self._loaded = loaded
        self._pilot = make_pilot(loaded.site, loaded.room, loaded.grid)
        self._drone_at: Vec2 = loaded.room.home
        self._preflight = to_json(PreflightView())
        topics = DroneTopics(loaded.site.drone.name)
        self._open = [
            bus.answer(topics.room, lambda _: self._room),
            bus.answer(topics.preflight, lambda _: self._preflight),
            bus.answer(topics.plan, self._plan),
        ]

    def update(self, step: PilotStep) -> None:
        """Keep the drone's position, where plans start."""
        if step.outputs.estimate is not None:
            self._drone_at = step.outputs.estimate.position[:2]

    def update_preflight(self, checks: tuple[PreflightCheck, ...]) -> None:
        """Keep what the pre-flight checks found."""
        ready = bool(checks) and not preflight_refusal(checks)
        self._preflight = to_json(PreflightView(ready, checks))

    def close(self) -> None:
        """Stop answering."""
        for subscription in self._open:
            subscription.close()

    def _plan(self, text: str) -> str:
        answer = self._answer(from_json(PlanRequest, text))
        path = answer.path
        # A way in space is told as the plan that it draws on the floor.
        drawn = Path(path.waypoints, path.length, path.clearance) if path is not None else None
        return to_json(replace(answer, path=drawn))

    def _answer(self, request: PlanRequest) -> PlanAnswer:
        start = request.start or self._drone_at
        if request.place:
            try:
                goal = self._loaded.room.place(request.place).viewpoint
            except KeyError as error:
                return PlanAnswer(start, start, None, error.args[0])
        elif request.goal is not None:
            goal = request.goal
        else:
            raise WireError("a plan needs a place or a goal")
        return self._pilot.plan(goal, start)
