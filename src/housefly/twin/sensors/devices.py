"""The devices of a scene: what each would send over MQTT at any time.

Pure; noise is drawn with the scene's seed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import cos, sin

import numpy as np

from housefly.geometry import Vec2
from housefly.numeric import running_sum
from housefly.twin.people import Act, PersonState, Posture, Scene, SceneEvent, SceneState
from housefly.twin.people.script import DeviceScript, SceneScript
from housefly.wires.devices import KINDS, Channel, DeviceAddress, encode_payload

_FLOOR_PERIOD = 0.1
"""Period of a floor sensor's reports [s]."""
_STATES_PER_HEARTBEAT = 3.0
"""How often other devices repeat their state within the longest time allowed."""

_ON_FLOOR = 0.1
"""Who is carried at no more than this height lies or sits on the floor itself [m]."""
_FEET_EXTENT, _SITTING_EXTENT = 0.35, 0.8
"""Over what length those who stand and those who sit on the floor touch it [m]."""
_LYING_EXTENT = 0.95
"""Over what share of their height those who lie touch the floor."""

_Values = dict[str, object]


@dataclass(frozen=True, slots=True)
class DeviceMessage:
    """One message on its way to the broker.

    Attributes:
        address: of the device that sends it.
        channel: state or event.
        payload: the bytes.
        retain: whether the broker keeps it.
    """

    address: DeviceAddress
    channel: Channel
    payload: bytes
    retain: bool


class SimulatedDevices:
    """All devices of a scene.

    Args:
        scene: what they sense.
        site: second part of their topics.
    """

    def __init__(self, scene: Scene, site: str) -> None:
        self._scene, self._site = scene, site
        self._facts = _Facts(scene.script)
        seeds = np.random.SeedSequence(scene.script.seed + 1).spawn(len(scene.script.devices))
        self._senses = [
            _Device(device, np.random.default_rng(seed))
            for device, seed in zip(scene.script.devices, seeds, strict=True)
        ]
        self._heard_until = -1.0
        self._pressed: list[str] = []

    def press(self, device: str) -> None:
        """Press a device's button, whatever the scene says."""
        self._pressed.append(device)

    def messages(self, now: float, unix: float | None = None) -> tuple[DeviceMessage, ...]:
        """Return what the devices have sent since the last call.

        Args:
            now: time since the scene began [s].
            unix: the same moment [s, Unix time]; None for devices without a clock.
        """
        state = self._scene.at(now)
        stamp: _Values = {} if unix is None else {"time": round(unix, 3)}
        played = self._scene.between(self._heard_until, now)
        pressed = (SceneEvent(now, Act.PRESS, device, "visitor") for device in self._pressed)
        sent = [self._event(told, stamp) for told in (*played, *pressed)]
        self._heard_until, self._pressed = now, []
        for sense in self._senses:
            values = sense.due(state, self._facts)
            if values is not None:
                address = self._address(sense.device)
                sent.append(
                    DeviceMessage(
                        address, Channel.STATE, encode_payload({**values, **stamp}), retain=True
                    )
                )
        return tuple(message for message in sent if message is not None)

    def addresses(self) -> tuple[DeviceAddress, ...]:
        """Return the addresses of the devices."""
        return tuple(self._address(sense.device) for sense in self._senses)

    def _address(self, device: DeviceScript) -> DeviceAddress:
        return DeviceAddress(self._site, device.kind, device.id)

    def _event(self, told: SceneEvent, stamp: _Values) -> DeviceMessage | None:
        """Return the message of an event, None if no device notices it."""
        device = self._facts.devices.get(told.what if told.act in _ON_DEVICES else told.where)
        word = _WORDS.get((device.kind, told.act)) if device is not None else None
        if device is None or word is None:
            return None
        tagged: _Values = {} if told.act in _ON_DEVICES else self._facts.tagged(told.what)
        return DeviceMessage(
            self._address(device),
            Channel.EVENT,
            encode_payload({"event": word, **tagged, **stamp}),
            retain=False,
        )


class _Facts:
    """What devices know of things and people besides their place."""

    def __init__(self, script: SceneScript) -> None:
        self.devices: Mapping[str, DeviceScript] = {device.id: device for device in script.devices}
        self.weights: Mapping[str, float] = {person.name: person.weight for person in script.people}
        self.heights: Mapping[str, float] = {person.name: person.height for person in script.people}
        self._things = {thing.name: thing for thing in script.things}

    def tagged(self, thing: str) -> _Values:
        """Return tag and weight of a thing."""
        return {"tag": self._things[thing].tag, "weight": self._things[thing].weight}


class _Device:
    """One device: what it reads, and when it reports."""

    def __init__(self, device: DeviceScript, rng: np.random.Generator) -> None:
        self.device = device
        self._rng = rng
        self._read = _READERS[device.kind]
        self._period = (
            _FLOOR_PERIOD
            if device.kind == "floor"
            else KINDS[device.kind].heartbeat / _STATES_PER_HEARTBEAT
        )
        self._next = 0.0
        self._last: _Values | None = None

    def due(self, state: SceneState, facts: _Facts) -> _Values | None:
        """Return the state when it is due or has changed, else None; noise alone is no change."""
        true = self._read(self.device, state, facts)
        changed = true != self._last and self.device.kind != "floor"
        if state.at < self._next - 1e-9 and not changed:
            return None
        self._last = true
        self._next = (
            max(self._next + self._period, state.at)
            if self.device.kind == "floor"
            else state.at + self._period
        )
        return _noisy(true, self.device, self._rng)


def _floor(device: DeviceScript, state: SceneState, facts: _Facts) -> _Values:
    felt = (
        p
        for p in state.people
        if p.present
        and (p.posture is not Posture.LYING or p.support < _ON_FLOOR)
        and _covers(device, p.position)
    )
    people = [
        {
            "id": p.name,
            **_local(device, p.position),
            "weight": facts.weights[p.name],
            "extent": _extent(p, facts.heights[p.name]),
        }
        for p in felt
    ]
    return {"people": people}


def _extent(person: PersonState, height: float) -> float:
    """Return over what length somebody touches the floor [m]."""
    if person.posture is Posture.LYING:
        return round(_LYING_EXTENT * height, 2)
    return (
        _SITTING_EXTENT
        if person.posture is Posture.SITTING and person.support < _ON_FLOOR
        else _FEET_EXTENT
    )


def _switch(device: DeviceScript, state: SceneState, facts: _Facts) -> _Values:
    return {"state": "ON" if device.id in state.on else "OFF"}


def _contact(device: DeviceScript, state: SceneState, facts: _Facts) -> _Values:
    return {"contact": device.id not in state.open}


def _measured(key: str, on: float, off: float) -> _Reader:
    """Return what reads a value that is one when on and another when off."""

    def read(device: DeviceScript, state: SceneState, facts: _Facts) -> _Values:
        is_on = device.id in state.on
        own, usual = (device.value_on, on) if is_on else (device.value_off, off)
        return {key: usual if own is None else own}

    return read


def _cabinet(device: DeviceScript, state: SceneState, facts: _Facts) -> _Values:
    items = [facts.tagged(thing.name) for thing in state.inside(device.id)]
    return {"items": items, "open": device.id in state.open}


def _bed(device: DeviceScript, state: SceneState, facts: _Facts) -> _Values:
    lying = (p for p in state.people if p.posture is Posture.LYING and _covers(device, p.position))
    return {"load": running_sum(facts.weights[person.name] for person in lying)}


def _door(device: DeviceScript, state: SceneState, facts: _Facts) -> _Values:
    return {"open": device.id in state.open}


def _doorbell(device: DeviceScript, state: SceneState, facts: _Facts) -> _Values:
    return {}


def _motion(device: DeviceScript, state: SceneState, facts: _Facts) -> _Values:
    return {
        "motion": any(
            p.posture is Posture.WALKING and _covers(device, p.position) for p in state.people
        )
    }


_Reader = Callable[[DeviceScript, SceneState, _Facts], _Values]
_READERS: dict[str, _Reader] = {
    "floor": _floor,
    "cabinet": _cabinet,
    "refrigerator": _cabinet,
    "bed": _bed,
    "door": _door,
    "doorbell": _doorbell,
    "motion": _motion,
    "switch": _switch,
    "power": _measured("power", 1400.0, 0.4),
    "temperature": _measured("temperature", 180.0, 21.0),
    "contact": _contact,
    "level": _measured("level", 80.0, 20.0),
}
_ON_DEVICES = frozenset({Act.OPEN, Act.CLOSE, Act.PRESS, Act.ON, Act.OFF})
_WORDS = {
    ("cabinet", Act.TAKE): "taken",
    ("cabinet", Act.PUT): "put",
    ("refrigerator", Act.TAKE): "taken",
    ("refrigerator", Act.PUT): "put",
    ("refrigerator", Act.OPEN): "opened",
    ("refrigerator", Act.CLOSE): "closed",
    ("door", Act.OPEN): "opened",
    ("door", Act.CLOSE): "closed",
    ("doorbell", Act.PRESS): "pressed",
}
_MEASURED = frozenset({"x", "y", "load", "power", "temperature", "level"})
"""Keys of what is measured with noise."""


def _covers(device: DeviceScript, at: Vec2) -> bool:
    x_min, y_min, x_max, y_max = device.area
    return x_min <= at[0] <= x_max and y_min <= at[1] <= y_max


def _local(device: DeviceScript, at: Vec2) -> _Values:
    """Return a point of the world in the device's frame [m]."""
    turn = complex(cos(device.yaw), -sin(device.yaw))
    point = complex(at[0] - device.position[0], at[1] - device.position[1]) * turn
    return {"x": point.real, "y": point.imag}


def _noisy(values: _Values, device: DeviceScript, rng: np.random.Generator) -> _Values:
    """Return the values as they are measured, rounded to a tenth of a millimetre or gram."""
    noisy: _Values = {}
    for key, value in values.items():
        if key in _MEASURED and isinstance(value, int | float):
            noisy[key] = round(value + device.noise * float(rng.standard_normal()), 4)
        elif isinstance(value, list):
            noisy[key] = [_noisy(row, device, rng) for row in value]
        else:
            noisy[key] = value
    return noisy
