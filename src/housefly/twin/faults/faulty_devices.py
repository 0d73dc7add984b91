"""Devices whose messages are lost or damaged."""

from __future__ import annotations

from dataclasses import replace
from random import Random

from housefly.twin.faults.injector import FaultInjector
from housefly.twin.faults.vocabulary import FaultKind
from housefly.twin.people import Scene
from housefly.twin.sensors.devices import DeviceMessage, SimulatedDevices


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

    def messages(self, now: float, unix: float | None = None) -> tuple[DeviceMessage, ...]:
        """Return what arrives of what the devices have sent since the last call."""
        arrived = (self._befallen(message, now) for message in super().messages(now, unix))
        return tuple(message for message in arrived if message is not None)

    def _befallen(self, message: DeviceMessage, now: float) -> DeviceMessage | None:
        self._number += 1
        fault = self._faults.device_fault(now, self._number)
        if fault is None:
            return message
        if fault.kind is FaultKind.GARBAGE:
            noise = Random(f"{fault.seed} {self._number}").randbytes(len(message.payload))
            return replace(message, payload=noise)
        return None
