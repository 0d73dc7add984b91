"""Where things are, which doors are open and what is on after each act of a scene; pure."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from housefly.errors import ConfigError
from housefly.twin.people.script import SceneScript
from housefly.twin.people.state import Act, SceneEvent, ThingState


@dataclass(frozen=True, slots=True)
class _Snapshot:
    """Things, open doors and what is switched on between one act and the next."""

    things: Mapping[str, ThingState]
    open: frozenset[str]
    on: frozenset[str] = frozenset()


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
        for event in events:
            known = (
                replace(event, where=self._origin(event, snapshot))
                if event.act is Act.TAKE
                else event
            )
            snapshot = _EFFECTS[event.act](self, known, snapshot)
            self._times.append(event.at)
            self._snapshots.append(snapshot)
            self.events.append(known)

    def at(self, time: float) -> _Snapshot:
        """Return the state at a time [s]."""
        return self._snapshots[bisect_right(self._times, time)]

    def _take(self, event: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after somebody took a thing."""
        thing = before.things[event.what]
        if thing.held_by:
            raise _impossible(event, f"takes {event.what!r}, which {thing.held_by} carries")
        return _with(before, replace(thing, inside="", held_by=event.by))

    def _put(self, event: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after somebody put a thing down."""
        thing = self._thing(event, before)
        if thing.held_by != event.by:
            raise _impossible(event, f"puts down {event.what!r} without carrying it")
        if event.position is None and not event.where:
            raise _impossible(event, f"puts {event.what!r} nowhere; give into or at")
        if event.where and event.where not in self._devices:
            raise _impossible(
                event,
                f"puts {event.what!r} into {event.where!r}; known devices:"
                f" {', '.join(self._devices)}",
            )
        position = event.position or self._home(event.where)
        return _with(before, ThingState(thing.name, position, event.where))

    def _open(self, event: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after a door was opened."""
        return replace(before, open=before.open | {self._device(event)})

    def _close(self, event: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after a door was closed."""
        return replace(before, open=before.open - {self._device(event)})

    def _on(self, event: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after a device was switched on."""
        return replace(before, on=before.on | {self._device(event)})

    def _off(self, event: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after a device was switched off."""
        return replace(before, on=before.on - {self._device(event)})

    def _press(self, event: SceneEvent, before: _Snapshot) -> _Snapshot:
        """Return the state after a button was pressed: unchanged."""
        self._device(event)
        return before

    def _origin(self, event: SceneEvent, before: _Snapshot) -> str:
        return self._thing(event, before).inside

    def _thing(self, event: SceneEvent, before: _Snapshot) -> ThingState:
        if event.what not in before.things:
            raise _impossible(
                event, f"wants {event.what!r}; known things: {', '.join(before.things)}"
            )
        return before.things[event.what]

    def _device(self, event: SceneEvent) -> str:
        if event.what not in self._devices:
            raise _impossible(
                event, f"handles {event.what!r}; known devices: {', '.join(self._devices)}"
            )
        return event.what

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
    Act.ON: SceneHistory._on,
    Act.OFF: SceneHistory._off,
}


def _with(before: _Snapshot, thing: ThingState) -> _Snapshot:
    return replace(before, things={**before.things, thing.name: thing})


def _impossible(event: SceneEvent, what: str) -> ConfigError:
    return ConfigError(f"people.{event.by}", f"at {event.at:.1f} s {what}", "scene")
