"""Moves the people of the simulated room: by their scene, or as they are put from outside."""

from __future__ import annotations

from housefly.errors import ConfigError
from housefly.messages import Pose
from housefly.twin.contracts import AWAY_Z
from housefly.twin.movable import AWAY_POSE
from housefly.twin.people import Scene
from housefly.twin.people.bodies import body_pose
from housefly.twin.people.motion import PersonMotion
from housefly.twin.people.script import PersonScript
from housefly.twin.people.state import PersonState
from housefly.twin.people.visitor import Visitor
from housefly.twin.physics import Physics

_MOVE_DIVIDER = 4
"""Control periods between two moves of the people: 50 Hz, 2 cm of a walker."""
_LOOK_DIVIDER = 40
"""Control periods between two checks whether the cameras see the visitor: 5 Hz."""


class ScenePlayer:
    """Plays a scene in one room; whoever is put somewhere no longer follows it.

    Args:
        scene: what its people do, or None.
        others: people without a scene, away until they are put somewhere.
        physics: where their bodies are.
        visitor: whose presence the scene may decide.

    Attributes:
        motion: how fast the people move.
    """

    def __init__(
        self,
        scene: Scene | None,
        others: tuple[PersonScript, ...],
        physics: Physics,
        visitor: Visitor,
    ) -> None:
        self.motion = PersonMotion()
        self._scene, self._physics, self._visitor = scene, physics, visitor
        played = scene.script.people if scene is not None else ()
        self._heights = {
            person.name: person.height for person in (*played, *others) if not person.visitor
        }
        self._poses = dict.fromkeys(self._heights, AWAY_POSE)
        self._driven = {person.name for person in others}
        self._visitors = frozenset(person.name for person in played if person.visitor)
        self._was_present: bool | None = None
        self.play(0, 0.0)

    @property
    def poses(self) -> tuple[Pose, ...]:
        """Poses of the people's bodies, those of the scene first, in the order of the scripts."""
        return tuple(self._poses.values())

    def has(self, name: str) -> bool:
        """Return whether somebody of this name has a body here."""
        return name in self._heights

    def height(self, name: str) -> float:
        """Return the body height of somebody [m]."""
        return self._heights[name]

    def present_pose(self, name: str) -> Pose | None:
        """Return the pose of somebody's body; None while they are away."""
        pose = self._poses[name]
        return pose if pose.position[2] > AWAY_Z / 2 else None

    def put(self, person: PersonState, now: float) -> None:
        """Put somebody somewhere at a time [s], from then on whatever the scene says.

        Raises ConfigError when nobody has this name.
        """
        if person.name not in self._heights:
            names = ", ".join(self._heights) or "nobody has a body here"
            raise ConfigError("people", f"nobody is called {person.name!r}; there are: {names}")
        self._driven.add(person.name)
        self._move(person, now)
        self._physics.set_people(self.poses)
        self._physics.show()

    def play(self, tick: int, now: float) -> None:
        """Show the state at a time [s]; ``tick`` counts control periods."""
        if self._scene is None or tick % _MOVE_DIVIDER:
            return
        people = self._scene.at(now).people
        for person in people:
            if person.name in self._heights and person.name not in self._driven:
                self._move(person, now)
        self._physics.set_people(self.poses)
        if self._visitors:
            self._show_visitor(
                any(person.present for person in people if person.name in self._visitors)
            )
        if tick % _LOOK_DIVIDER == 0:
            self._visitor.update_visibility()

    def _move(self, person: PersonState, now: float) -> None:
        pose = body_pose(person, self._heights[person.name])
        self._poses[person.name] = pose
        self.motion.placed(person.name, pose.position, now)

    def _show_visitor(self, present: bool) -> None:
        """Move the visitor when the script changes; in between, others may."""
        if present is not self._was_present:
            self._was_present = present
            self._visitor.set_present(present)
