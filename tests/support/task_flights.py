"""Flies shipped services in the simulated B-sen, scored on the truth."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from quick_flights import QUICK

from housefly.lab.lockstep.task_flight import NO_SCRIPT, TaskFlight, TaskScript
from housefly.lab.lockstep.task_lockstep import UNIX_BEGIN, fly_task_lockstep
from housefly.messages import PilotStep
from housefly.sites.loaded_site import LoadedSite, load_site
from housefly.tasks.api.values import ParameterValue
from housefly.tasks.document.library import BoundTask, bind, load_library
from housefly.tasks.document.task_document import TaskDocument
from housefly.twin.people.scene import Scene, scene_from_tree
from scores.played_memory import PlayedMemory

FLOOR = {
    "kind": "floor",
    "id": "floor-1",
    "area": [4.8, 0.6, 14.7, 6.2],
    "noise": 0.03,
}


@cache
def premises(quick: bool = True, **changes: Any) -> LoadedSite:
    """Return B-sen with the visitor at the door."""
    return load_site("bsen", **(QUICK if quick else {}), **changes)


@cache
def library() -> Mapping[str, TaskDocument]:
    """Return the shipped documents."""
    return load_library()


def shipped(service: str, **parameters: ParameterValue) -> BoundTask:
    """Return a shipped service with parameters."""
    return bind(library()[service], parameters)


def scene_of(*people: Mapping[str, Any], devices: tuple[Any, ...] = (FLOOR,)) -> Scene:
    """Return a scene of people whom the floor feels."""
    tree = {"name": "test", "seed": 1, "people": list(people), "devices": list(devices)}
    return scene_from_tree(tree)


def flown(
    service: str,
    script: TaskScript = NO_SCRIPT,
    *,
    scene: Scene | None = None,
    memory: bool = False,
    loaded: LoadedSite | None = None,
    options: Mapping[str, Any] | None = None,
    **parameters: ParameterValue,
) -> TaskFlight:
    """Fly a shipped service, with the hub's memory of the scene when it is wanted."""
    here, task = loaded or premises(), shipped(service, **parameters)
    more = dict(options or {})
    if not memory:
        return fly_task_lockstep(here, task, script, scene=scene, **more)
    with tempfile.TemporaryDirectory() as folder:
        hub = PlayedMemory(here, Path(folder), UNIX_BEGIN)
        if scene is not None:
            hub.listen_to(scene)

        def on_step(step: PilotStep) -> None:
            while hub.now < UNIX_BEGIN + step.now:
                hub.advance()
            hub.hear(step)

        try:
            return fly_task_lockstep(
                here, task, script, scene=scene, ask=hub.ask, on_step=on_step, **more
            )
        finally:
            hub.close()
