"""Simulated people and things: a script in a file, and what of it holds at any time."""

from housefly.twin.people.scene import Scene, load_scene, scene_from_tree
from housefly.twin.people.state import Act, Occurrence, PersonState, Posture, SceneState, ThingState

__all__ = [
    "Act",
    "Occurrence",
    "PersonState",
    "Posture",
    "Scene",
    "SceneState",
    "ThingState",
    "load_scene",
    "scene_from_tree",
]
