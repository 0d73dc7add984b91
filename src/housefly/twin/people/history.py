"""Where things are and which doors are open after each act of a scene; pure."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from housefly.errors import ConfigError
from housefly.twin.people.script import SceneScript
from housefly.twin.people.state import Act, SceneEvent, ThingState


@dataclass(frozen=True, slots=True)
class _Snapshot:
    """Things and open doors between one act and the next."""

    things: Mapping[str, ThingState]
    open: frozenset[str]


class SceneHistory:
    """Replays the acts of a scene once and keeps the state after each.

    Raises:
        ConfigError: somebody takes what another carries, puts down what they do not carry, or
            handles what does not exist.
    """

    def __init__(self, script: SceneScript, events: list[SceneEvent]) -> None:
        self._devices = {device.id: device for device in script.devices}
        things = {
            row.name: ThingState(row.name, row.at or self._home(row.inside), row.inside)
            for row in script.things
        }
        snapshot = _Snapshot(things, frozenset())
        self._times: list[float] = []
        self._snapshots = [snapshot]
        self.events: list[SceneEvent] = []
        for told in events:
            known = (
                replace(told, where=self._origin(told, snapshot)) if told.act is Act.TAKE else told
            )
            snapshot = _EFFECTS[told.act](self, known, snapshot)
            self._times.append(told.at)
            self._snapshots.append(snapshot)
            self.events.append(known)

    def at(self, time: float) -> _Snapshot:
        """Return the state at a time [s]."""
        return self._snapshots[bisect_right(self._times, time)]

    def _take(self, told: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after somebody took a thing."""
        thing = before.things[told.what]
        if thing.held_by:
            raise _impossible(told, f"takes {told.what!r}, which {thing.held_by} carries")
        return _with(before, replace(thing, inside="", held_by=told.by))

    def _put(self, told: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after somebody put a thing down."""
        thing = self._thing(told, before)
        if thing.held_by != told.by:
            raise _impossible(told, f"puts down {told.what!r} without carrying it")
        if told.position is None and not told.where:
            raise _impossible(told, f"puts {told.what!r} nowhere; give into or at")
        if told.where and told.where not in self._devices:
            raise _impossible(
                told,
                f"puts {told.what!r} into {told.where!r}; known devices:"
                f" {', '.join(self._devices)}",
            )
        position = told.position or self._home(told.where)
        return _with(before, ThingState(thing.name, position, told.where))

    def _open(self, told: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after a door was opened."""
        return _Snapshot(before.things, before.open | {self._device(told)})

    def _close(self, told: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after a door was closed."""
        return _Snapshot(before.things, before.open - {self._device(told)})

    def _press(self, told: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after a button was pressed: unchanged."""
        self._device(told)
        return before

    def _origin(self, told: SceneEvent, before: _Snapshot) -> str:
        return self._thing(told, before).inside

    def _thing(self, told: SceneEvent, before: _Snapshot) -> ThingState:
        if told.what not in before.things:
            raise _impossible(
                told, f"wants {told.what!r}; known things: {', '.join(before.things)}"
            )
        return before.things[told.what]

    def _device(self, told: SceneEvent) -> str:
        if told.what not in self._devices:
            raise _impossible(
                told, f"handles {told.what!r}; known devices: {', '.join(self._devices)}"
            )
        return told.what

    def _home(self, device: str) -> tuple[float, float, float]:
        if device not in self._devices:
            raise ConfigError(
                "things",
                f"a thing is inside {device!r}; known devices: {', '.join(self._devices)}",
                "scene",
            )
        return self._devices[device].position


_EFFECTS: dict[Act, Callable[[SceneHistory, SceneEvent, _Snapshot], _Snapshot]] = {
    Act.TAKE: SceneHistory._take,
    Act.PUT: SceneHistory._put,
    Act.OPEN: SceneHistory._open,
    Act.CLOSE: SceneHistory._close,
    Act.PRESS: SceneHistory._press,
}


def _with(before: _Snapshot, thing: ThingState) -> _Snapshot:
    return _Snapshot({**before.things, thing.name: thing}, before.open)


def _impossible(told: SceneEvent, what: str) -> ConfigError:
    return ConfigError(f"people.{told.by}", f"at {told.at:.1f} s {what}", "scene")
