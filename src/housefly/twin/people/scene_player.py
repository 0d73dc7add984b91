"""Plays a scene in the simulated room: moves the people, brings and removes the visitor."""

from __future__ import annotations

from housefly.messages import Pose
from housefly.twin.people import Scene
from housefly.twin.people.bodies import body_pose
from housefly.twin.people.visitor import Visitor
from housefly.twin.physics import Physics

_MOVE_DIVIDER = 4
"""Control periods between two moves of the people: 50 Hz, 2 cm of a walker."""
_LOOK_DIVIDER = 40
"""Control periods between two checks whether the cameras see the visitor: 5 Hz."""


class ScenePlayer:
    """Plays one scene in one room.

    Attributes:
        poses: of the people's bodies, in the order of the script.
    """

    def __init__(self, scene: Scene, physics: Physics, visitor: Visitor) -> None:
        self.poses: tuple[Pose, ...] = ()
        self._scene, self._physics, self._visitor = scene, physics, visitor
        self._heights = {
            person.name: person.height for person in scene.script.people if not person.visitor
        }
        self._visitors = frozenset(person.name for person in scene.script.people if person.visitor)
        self._was_present: bool | None = None
        self.play(0, 0.0)

    def play(self, tick: int, now: float) -> None:
        """Show the state at a time [s]; ``tick`` counts control periods."""
        if tick % _MOVE_DIVIDER:
            return
        people = self._scene.at(now).people
        self.poses = tuple(
            body_pose(person, self._heights[person.name])
            for person in people
            if person.name in self._heights
        )
        self._physics.set_people(self.poses)
        if self._visitors:
            self._show_visitor(
                any(person.present for person in people if person.name in self._visitors)
            )
        if tick % _LOOK_DIVIDER == 0:
            self._visitor.update_visibility()

    def _show_visitor(self, present: bool) -> None:
        """Move the visitor when the script changes; in between, others may."""
        if present is not self._was_present:
            self._was_present = present
            self._visitor.set_present(present)
