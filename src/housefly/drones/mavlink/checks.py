"""What must be set on a vehicle before it takes off with us, asked for until it is told. Pure."""

from __future__ import annotations

from typing import Any

from housefly.drones.mavlink.vehicle import Vehicle
from housefly.messages.words import Words
from housefly.wires.mavlink import requests
from housefly.wires.mavlink.requests import MessageId

RATES: dict[MessageId, float] = {
    MessageId.HEARTBEAT: 5.0,
    MessageId.ATTITUDE: 50.0,
    MessageId.EXTENDED_SYS_STATE: 10.0,
    MessageId.SYS_STATUS: 2.0,
}
"""How often each message is wanted [Hz]."""
_RATE_MIN = 20.0
"""Fewer reports than this are asked for again [Hz]."""
_LATITUDE, _LONGITUDE = 45.0, 7.0
"""Any place will do for the map's origin [degrees]; ArduPilot takes zeros for none."""
_NO_ORIGIN = Words("its map has no origin yet: it must be told where it is, standing")
_ORIGIN_PERIOD, _ORIGIN_AGE_MAX = 1.0, 3.5
"""A standing vehicle is asked for its origin again, and without an answer it has lost it [s]."""
_POSE_AGE_MAX = 0.5
"""The origin is set while the vehicle is told where it is [s]: its height is zero there."""


class Checks:
    """Asks a standing vehicle, and says what is wrong with it.

    Args:
        vehicle: what it tells.
        place: where it answers, for people.
    """

    def __init__(self, vehicle: Vehicle, place: str) -> None:
        self._vehicle, self._place = vehicle, place
        self.pose_sent_at = float("-inf")

    def due(self, target: requests.Target, now: float) -> list[Any]:
        """Return what to ask for next; to be called about twice a second [s]."""
        vehicle = self._vehicle
        if not vehicle.is_heard(now):
            return []
        asked: list[Any] = []
        if vehicle.rate_hz(now) < _RATE_MIN:
            asked += [requests.rate_order(target, *wanted) for wanted in RATES.items()]
        asked += [
            requests.parameter_request(target, need.name)
            for need in vehicle.autopilot.needs
            if need.name not in vehicle.parameters
        ]
        age = now - vehicle.origin_at
        if vehicle.autopilot.forgets_origin and not vehicle.armed:
            vehicle.has_origin &= age < _ORIGIN_AGE_MAX
        if not vehicle.has_origin or (not vehicle.armed and age > _ORIGIN_PERIOD):
            asked.append(requests.message_request(target, MessageId.GPS_GLOBAL_ORIGIN))
        knows_place = now - self.pose_sent_at < _POSE_AGE_MAX
        if not vehicle.has_origin and not vehicle.armed and knows_place:
            asked.append(requests.origin_order(target[0], _LATITUDE, _LONGITUDE, now))
        return asked

    @property
    def is_done(self) -> bool:
        """Whether it may take off with us."""
        return not self.notes

    @property
    def notes(self) -> tuple[Words, ...]:
        """What is not as it must be."""
        vehicle = self._vehicle
        if vehicle.is_another:
            return (
                Words(
                    "what answers at {name} does not speak {protocol} ({error})",
                    name=self._place,
                    protocol=vehicle.autopilot.name,
                    error=f"MAV_AUTOPILOT {vehicle.found}",
                ),
            )
        lacking = [self._lacking(need.name) for need in vehicle.autopilot.needs]
        if not vehicle.knows_charge:
            lacking.append(_untold("SYS_STATUS"))
        if not vehicle.has_origin:
            lacking.append(_NO_ORIGIN)
        return tuple(filter(None, lacking))

    def _lacking(self, name: str) -> Words | None:
        need = next(need for need in self._vehicle.autopilot.needs if need.name == name)
        value = self._vehicle.parameters.get(name)
        if value is None:
            return _untold(name)
        if need.meets(value):
            return None
        return Words(
            "set {setting} to {allowed} on the drone (it is {value}): {why}",
            setting=name,
            allowed=need.allowed,
            value=f"{value:g}",
            why=need.why,
        )


def _untold(setting: str) -> Words:
    return Words("the drone does not tell its {setting} yet", setting=setting)
