"""Simulated people and things: a script in a file, and what of it holds at any time."""

from housefly.twin.people.scene import Scene, load_scene, scene_from_tree
from housefly.twin.people.state import Act, PersonState, Posture, SceneEvent, SceneState, ThingState

__all__ = [
    "Act",
    "PersonState",
    "Posture",
    "Scene",
    "SceneEvent",
    "SceneState",
    "ThingState",
    "load_scene",
    "scene_from_tree",
]
