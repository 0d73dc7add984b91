"""Looks ahead along the path in use: stops before what is in the way, finds a way around it, or
waits until it is gone.

flying ──blocked, near──► braking ──at rest──► a way around? ──yes──► flying
   └──blocked, far──► a way around? ──no──► waiting, asks again every 0.25 s ──too long──► home,
   then down
"""

from __future__ import annotations

from math import hypot

from housefly.geometry import stopping_distance
from housefly.messages import Event, OrderKind, Phase, Severity
from housefly.pilot.behavior.captain import Captain
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.scene import Scene
from housefly.pilot.behavior.tracking import Track

BRAKING = 1.0
"""How hard the drone can be counted on to brake [m/s^2]; at full tilt it is twice that."""
REACTION = 0.3
"""Time from seeing an obstacle to braking that distances allow for [s]."""
SPARE = 0.3
"""Beyond its stopping distance the drone begins to brake this much earlier [m]."""
AT_REST = 0.1
"""The drone stands when slower than this [m/s] ..."""
REST_PATIENCE = 1.5
"""... and is taken to stand this long after it began to brake [s]."""
ASK_AGAIN = 0.25
"""How often a waiting drone looks for a way [s]."""

ON_THE_WAY = frozenset({Phase.OUTBOUND, Phase.RETURNING})


class Lookout:
    """Follows one captain's course."""

    def __init__(self, captain: Captain, navigator: Navigator) -> None:
        self._captain = captain
        self._navigator = navigator
        self._course = captain.course
        self._asked_at = 0.0
        self._told = False

    def step(self, scene: Scene, track: Track | None) -> list[Event]:
        """Look ahead once.

        Args:
            scene: what is known.
            track: what was tracked in the last step, None while nothing was.
        """
        captain = self._captain
        if captain.course is not self._course:
            self._course, track = captain.course, None
        if (
            captain.errand.phase not in ON_THE_WAY
            or captain.errand.stopped
            or scene.estimate is None
        ):
            return []
        if captain.course.waiting:
            return self._wait(scene)
        if captain.course.path is None or captain.course.follower is None:
            return []
        block = self._navigator.block(
            scene.estimate.position[:2], captain.course.path, track.waypoint if track else 0
        )
        if block is None:
            return []
        if block.along > braking_distance(_speed(scene)) and not captain.go_around(scene):
            return [
                Event(
                    scene.now, Severity.INFO, "detour", f"{block.name} is in the way: going around"
                )
            ]
        words = f"{block.name} is in the way, {block.along:.1f} m ahead"
        captain.wait(words, scene)
        self._asked_at, self._told = scene.now, False
        return [Event(scene.now, Severity.WARNING, "way_blocked", f"{words}: stopping")]

    def waits_instead(self, problem: str, scene: Scene) -> bool:
        """Wait for a way that the phase just entered lacks, when it is only obstacles of now that
        close it; tell whether so.
        """
        captain = self._captain
        mission = (
            self._navigator.home()
            if captain.errand.phase is Phase.RETURNING
            else captain.errand.mission
        )
        if (
            mission.goal is None
            or scene.place is None
            or not self._navigator.is_passing(scene.place, mission.goal)
        ):
            return False
        captain.wait(problem, scene, mission)
        self._asked_at, self._told = scene.now, True
        return True

    def _wait(self, scene: Scene) -> list[Event]:
        course = self._captain.course
        standing = _speed(scene) < AT_REST or scene.now - course.since > REST_PATIENCE
        if not standing or (self._told and scene.now - self._asked_at < ASK_AGAIN):
            return []
        self._asked_at = scene.now
        problem = self._captain.go_around(scene)
        if not problem:
            return [Event(scene.now, Severity.INFO, "detour", "there is a way: going on")]
        if self._told:
            return []
        self._told = True
        whereto = "home" if self._captain.errand.mission.kind is OrderKind.HOME else "on"
        return [
            Event(
                scene.now,
                Severity.WARNING,
                "no_way",
                f"{course.waiting}; no way {whereto}, waiting here: {problem}",
            )
        ]


def braking_distance(speed: float) -> float:
    """Return how far ahead [m] a drone at this speed [m/s] begins to brake."""
    return stopping_distance(speed, BRAKING, REACTION) + SPARE


def _speed(scene: Scene) -> float:
    return hypot(*scene.estimate.velocity[:2]) if scene.estimate else 0.0
