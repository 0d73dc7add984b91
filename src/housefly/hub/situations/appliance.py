"""Detects what is switched on, by switch or power meter, and which contacts stand open."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from housefly.hub.situations.confidence import freshness
from housefly.hub.situations.device_traits import DeviceTraits, traits_of
from housefly.hub.situations.hysteresis import Hysteresis, claimed_by
from housefly.hub.situations.kinds import SituationKind
from housefly.hub.situations.situation import (
    SOURCE_PREFIX,
    Assessment,
    DetectorInput,
    Evidence,
    Situation,
    fact,
    flag,
    is_refused,
    is_undated,
    number,
)
from housefly.messages import Facts, Observation, RoomEvent
from housefly.wires.devices import KINDS

_SOURCE = SOURCE_PREFIX + "appliances"
_METER_CONFIDENCE = 0.95
"""Confidence in a meter, switch or contact that reports."""
_DWELL = {SituationKind.APPLIANCE_ON: 0.0, SituationKind.CONTACT_OPEN: 0.0, None: 0.0}


@dataclass(slots=True)
class _Appliance:
    """What one device says of one thing."""

    hysteresis: Hysteresis
    source: str
    kind: SituationKind
    heartbeat: float
    on: bool | None = None
    since: float = 0.0
    heard: float = float("-inf")
    report: str = ""
    facts: Facts = ()


class Appliances:
    """Detects which things are on, and which open.

    Args:
        devices: what is known of measuring devices, by id.
    """

    def __init__(self, devices: Mapping[str, DeviceTraits]) -> None:
        self._devices = devices
        self._metered = {row.thing for row in devices.values() if row.kind == "power"}
        self._appliances: dict[str, _Appliance] = {}

    def add(self, item: DetectorInput) -> None:
        """Add what a switch, a power meter or a contact reports about itself."""
        if not isinstance(item, Observation) or item.thing != item.source or is_undated(item):
            return
        if not item.valid:
            self._forget(item)
            return
        traits, power = traits_of(self._devices, item.source), number(item, "power")
        kind, state = _state_in(item)
        if power is None and (state is None or _is_metered(traits, kind, self._metered)):
            return  # a switch that is on while its thing draws nothing says nothing
        own = self._appliances.get(item.source) or self._appliance(item.source, traits, kind)
        on = state if power is None else traits.is_on(power, own.on)
        if on != own.on:
            own.since = item.captured_at
        own.on, own.heard = on, item.captured_at
        own.report = _WORDS[kind][bool(on)] if power is None else f"{power:.0f} W"
        own.facts = () if power is None else (("power", power),)

    def update(self, now: float) -> tuple[RoomEvent, ...]:
        """Return what was switched on or off, opened or closed up to a time [s]."""
        return tuple(
            event
            for _, own in sorted(self._appliances.items())
            for event in own.hysteresis.update(now, _assess(own, now))
        )

    def active(self) -> tuple[Situation, ...]:
        """Return what is on or open."""
        return claimed_by(own.hysteresis for _, own in sorted(self._appliances.items()))

    def _forget(self, item: Observation) -> None:
        """Believe a device no longer that says what is not understood: its state is another now."""
        own = self._appliances.get(item.source)
        if own is not None and is_refused(item):
            own.on = None

    def _appliance(self, device: str, traits: DeviceTraits, kind: SituationKind) -> _Appliance:
        heartbeat = traits.heartbeat or KINDS[_HEARTBEAT_OF[kind]].heartbeat
        own = _Appliance(Hysteresis(traits.thing, _SOURCE, _DWELL), device, kind, heartbeat)
        return self._appliances.setdefault(device, own)


_WORDS = {
    SituationKind.APPLIANCE_ON: ("switched off", "switched on"),
    SituationKind.CONTACT_OPEN: ("closed", "open"),
}
_HEARTBEAT_OF = {SituationKind.APPLIANCE_ON: "power", SituationKind.CONTACT_OPEN: "contact"}


def _state_in(item: Observation) -> tuple[SituationKind, bool | None]:
    """Return the situation that a report is about, and whether a flag in it says that it holds."""
    if fact(item, "kind") == "contact":
        return SituationKind.CONTACT_OPEN, flag(item, "open")
    return SituationKind.APPLIANCE_ON, flag(item, "on")


def _is_metered(traits: DeviceTraits, kind: SituationKind, metered: Collection[str]) -> bool:
    return kind == SituationKind.APPLIANCE_ON and traits.thing in metered


def _assess(own: _Appliance, now: float) -> Assessment | None:
    confidence = _METER_CONFIDENCE * freshness(now - own.heard, own.heartbeat)
    if confidence == 0.0 or own.on is None:
        return None
    kind = own.kind if own.on else None
    return Assessment(kind, confidence, own.since, (Evidence(own.report, own.source),), own.facts)
