"""Devices whose messages are lost, late, or not true."""

from __future__ import annotations

import json
from dataclasses import replace
from random import Random

from housefly.twin.faults.delay_line import DelayLine
from housefly.twin.faults.fault import Fault
from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.slots import Slots
from housefly.twin.faults.vocabulary import FaultComponent, FaultKind
from housefly.twin.people import Scene
from housefly.twin.sensors.devices import DeviceMessage, SimulatedDevices
from housefly.wires.devices import Channel, DeviceAddress, encode_payload

_MEASURED = frozenset({"x", "y", "weight", "load", "power", "temperature", "level"})
"""Keys of what a device measures."""
_STAMP = "time"
_OTHER = {"ON": "OFF", "OFF": "ON"}


class FaultyDevices(SimulatedDevices):
    """The devices of a scene, with faults.

    Args:
        scene: what they sense.
        site: second part of their topics.
        faults: what befalls their messages.
    """

    def __init__(self, scene: Scene, site: str, faults: FaultInjector) -> None:
        super().__init__(scene, site)
        self._faults = faults
        self._number = 0
        self._slots: dict[DeviceAddress, Slots] = {}
        self._states: dict[DeviceAddress, bytes] = {}
        self._frozen: dict[tuple[Fault, DeviceAddress], bytes] = {}
        self._under_way: DelayLine[DeviceMessage] = DelayLine()

    def messages(self, now: float, unix: float | None = None) -> tuple[DeviceMessage, ...]:
        """Return what arrives of what the devices have sent since the last call."""
        active = self._faults.schedule.active(now, FaultComponent.DEVICES)
        for message in super().messages(now, unix):
            sent = self._befallen(message, active, now)
            if sent is not None:
                self._under_way.put(sent, active, now)
        return tuple(message for _, message in self._under_way.arrived(now))

    def _befallen(
        self, message: DeviceMessage, active: tuple[Fault, ...], now: float
    ) -> DeviceMessage | None:
        """Return what a device sends in place of a message; None for nothing."""
        self._number += 1
        changed: DeviceMessage | None = message
        for fault in active:
            if changed is None or self._loses(fault, message, now):
                return None
            changed = self._changed(fault, changed)
        if message.channel is Channel.STATE and not active:
            self._states[message.address] = message.payload
        return changed

    def _loses(self, fault: Fault, message: DeviceMessage, now: float) -> bool:
        if fault.kind is FaultKind.SLOW:
            return not self._slots.setdefault(message.address, Slots()).opens(fault, now)
        return fault.kind is FaultKind.OFF or (
            fault.kind is FaultKind.INTERMITTENT and fault.strikes(self._number)
        )

    def _changed(self, fault: Fault, message: DeviceMessage) -> DeviceMessage | None:
        if fault.kind is FaultKind.GARBAGE:
            noise = Random(f"{fault.seed} {self._number}").randbytes(len(message.payload))
            return replace(message, payload=noise)
        if fault.kind is FaultKind.STUCK:
            return self._stuck(fault, message)
        if fault.kind is FaultKind.WRONG:
            told = _told(message.payload)
            lied = _measured(told, fault.size) if fault.aspect == "values" else _reversed(told)
            return replace(message, payload=encode_payload(lied))
        return message

    def _stuck(self, fault: Fault, message: DeviceMessage) -> DeviceMessage | None:
        """Return the last state from before, under a fresh stamp; what stands still has no news."""
        if message.channel is not Channel.STATE:
            return None
        before = self._states.get(message.address, message.payload)
        old = _told(self._frozen.setdefault((fault, message.address), before))
        fresh = _told(message.payload)
        stamp = {_STAMP: fresh[_STAMP]} if _STAMP in fresh else {}
        return replace(message, payload=encode_payload({**old, **stamp}))


def _told(payload: bytes) -> dict[str, object]:
    """Return what a payload says; nothing when another fault has made noise of it."""
    try:
        told = json.loads(payload)
    except ValueError:
        return {}
    return told if isinstance(told, dict) else {}


def _measured(told: dict[str, object], times: float) -> dict[str, object]:
    """Return a payload in which what was measured is so many times as much."""
    lied: dict[str, object] = {}
    for key, value in told.items():
        if key in _MEASURED and isinstance(value, int | float):
            lied[key] = value * times
        elif isinstance(value, list):
            lied[key] = [_measured(row, times) for row in value]
        else:
            lied[key] = value
    return lied


def _reversed(told: dict[str, object]) -> dict[str, object]:
    """Return a payload in which what was so is not, and the other way round."""
    return {
        key: (not value) if isinstance(value, bool) else _OTHER.get(str(value), value)
        for key, value in told.items()
    }
