"""A scene: its state at any time, and its events between two times; deterministic."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import replace
from math import cos, floor, sin
from pathlib import Path
from typing import Any

import numpy as np

from housefly import sites
from housefly.config.toml import read_toml
from housefly.config.validation import validated
from housefly.errors import ConfigError
from housefly.twin.people.history import SceneHistory
from housefly.twin.people.script import SceneScript
from housefly.twin.people.state import PersonState, SceneEvent, SceneState, ThingState
from housefly.twin.people.timeline import Timeline

_SHIPPED_SUFFIX = "_scene.toml"
_ARM, _HAND = 0.35, 1.0
"""Where a carried thing is: this far in front [m], at this height [m]."""
_ROUND_MIN = 1.0
"""Shortest round of a scene that begins anew [s]: of shorter ones a day has endlessly many."""


class Scene:
    """An evaluated script.

    Args:
        script: people, things, devices.

    Raises:
        ConfigError: somebody does the impossible, or a round is over at once.

    Attributes:
        script: the same.
        length: how long one round takes [s]; afterwards everything stays as it is, or begins anew.
    """

    def __init__(self, script: SceneScript) -> None:
        self.script = script
        seeds = np.random.SeedSequence(script.seed).spawn(len(script.people))
        self._lines = [
            Timeline(person, np.random.default_rng(seed), script.variation)
            for person, seed in zip(script.people, seeds, strict=True)
        ]
        self._begins = [[leg.begin for leg in line.legs] for line in self._lines]
        acts = sorted(
            (event for line in self._lines for event in line.events), key=lambda event: event.at
        )
        self._history = SceneHistory(script, acts)
        self.length = max((line.end for line in self._lines), default=0.0) + script.pause
        if script.loop and 0.0 < self.length < _ROUND_MIN:
            words = f"one round takes {self.length:g} s; allowed: {_ROUND_MIN:g} s or longer"
            raise ConfigError("pause", words, "scene")

    def at(self, time: float) -> SceneState:
        """Return the state at a time [s since the scene began]."""
        local = self._local(time)
        snapshot = self._history.at(local)
        people = tuple(self._person(number, local) for number in range(len(self._lines)))
        things = _carried(snapshot.things, people)
        return SceneState(time, people, things, snapshot.open, snapshot.on)

    def between(self, since: float, until: float) -> tuple[SceneEvent, ...]:
        """Return the events after ``since`` up to and including ``until`` [s], oldest first."""
        rounds = range(self._round(since), self._round(until) + 1) if self.script.loop else range(1)
        events = (
            replace(act, at=act.at + number * self.length)
            for number in rounds
            for act in self._history.events
        )
        return tuple(act for act in events if since < act.at <= until)

    def _person(self, number: int, time: float) -> PersonState:
        leg = self._lines[number].legs[max(0, bisect_right(self._begins[number], time) - 1)]
        return leg.at(self.script.people[number].name, time)

    def _round(self, time: float) -> int:
        return floor(time / self.length) if self.length > 0.0 else 0

    def _local(self, time: float) -> float:
        return time - self._round(time) * self.length if self.script.loop else time


def load_scene(name: str, folder: Path = Path()) -> Scene:
    """Read a scene.

    Args:
        name: of a shipped one, or a path.
        folder: what a relative path is relative to.

    Raises:
        ConfigError: naming the key, the value and what is allowed.
    """
    shipped = Path(sites.__file__).parent / f"{name}{_SHIPPED_SUFFIX}"
    path = shipped if shipped.is_file() else folder / name
    tree = read_toml(path, "scene file")
    return scene_from_tree(tree, str(path))


def scene_from_tree(tree: Mapping[str, Any], source: str = "") -> Scene:
    """Return the scene of a tree of plain values; raises ConfigError for the first bad key."""
    script = validated(SceneScript, tree, "scene", source)
    for key in ("people", "things", "devices"):
        names = [getattr(row, "id", getattr(row, "name", "")) for row in getattr(script, key)]
        if len(set(names)) < len(names):
            raise ConfigError(key, f"two of the same name among {', '.join(names)}", source)
    return Scene(script)


def _carried(
    things: Mapping[str, ThingState], people: tuple[PersonState, ...]
) -> Mapping[str, ThingState]:
    """Return the things; those that are carried are at their carrier's hands."""
    hands = {person.name: _hand(person) for person in people}
    return {
        name: replace(thing, position=hands[thing.held_by]) if thing.held_by else thing
        for name, thing in things.items()
    }


def _hand(person: PersonState) -> tuple[float, float, float]:
    x, y = person.position
    return x + _ARM * cos(person.yaw), y + _ARM * sin(person.yaw), _HAND
