"""What a device's last report says about a state: on, open, hot, full, occupied."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum

from housefly.hub.situations.device_traits import DeviceTraits
from housefly.messages import Fact
from housefly.wires.devices import KINDS

_FactTable = Mapping[str, Fact]


class DeviceProperty(Enum):
    """What can be asked of a device."""

    ON = "on"
    OPEN = "open"
    OCCUPIED = "occupied"
    HIGH = "high"
    LOW = "low"
    MOTION = "motion"


@dataclass(frozen=True, slots=True)
class DeviceVerdict:
    """What one report says.

    Attributes:
        holds: whether the state holds; None when the report does not decide it.
        clause: the report as a clause without its subject: "draws 1 420 W".
        past: the same of a time that is over: "drew 1 420 W".
        lacks: what is missing for a decision, in words, or "".
    """

    holds: bool | None
    clause: str
    past: str
    lacks: str = ""


NO_VERDICT = DeviceVerdict(None, "", "")
DEVICE_STATES: dict[str, tuple[DeviceProperty, bool]] = {
    "on": (DeviceProperty.ON, True),
    "running": (DeviceProperty.ON, True),
    "off": (DeviceProperty.ON, False),
    "open": (DeviceProperty.OPEN, True),
    "closed": (DeviceProperty.OPEN, False),
    "shut": (DeviceProperty.OPEN, False),
    "occupied": (DeviceProperty.OCCUPIED, True),
    "free": (DeviceProperty.OCCUPIED, False),
    "hot": (DeviceProperty.HIGH, True),
    "high": (DeviceProperty.HIGH, True),
    "full": (DeviceProperty.HIGH, True),
    "cold": (DeviceProperty.LOW, True),
    "low": (DeviceProperty.LOW, True),
    "empty": (DeviceProperty.LOW, True),
    "moving": (DeviceProperty.MOTION, True),
}
"""The words for a state of a device: what to look at, and what must be true of it."""

_FACTS: dict[DeviceProperty, tuple[str, ...]] = {
    DeviceProperty.ON: ("power", "on"),
    DeviceProperty.OPEN: ("open",),
    DeviceProperty.OCCUPIED: ("occupied",),
    DeviceProperty.HIGH: ("temperature_c", "level_percent"),
    DeviceProperty.LOW: ("temperature_c", "level_percent"),
    DeviceProperty.MOTION: ("motion",),
}
"""Facts that speak of a property, the stronger word first: power tells more than a switch."""
_KIND_FACTS = {
    "power": "power",
    "switch": "on",
    "contact": "open",
    "temperature": "temperature_c",
    "level": "level_percent",
}
"""The fact that each kind of measuring device reports."""
_KEYS = {
    "state": DeviceProperty.ON,
    "contact": DeviceProperty.OPEN,
    "open": DeviceProperty.OPEN,
    "occupied": DeviceProperty.OCCUPIED,
    "motion": DeviceProperty.MOTION,
}
"""The property that each key of a payload tells of."""
_HEARTBEATS = {
    "power": KINDS["power"].heartbeat,
    "on": KINDS["switch"].heartbeat,
    "open": KINDS["door"].heartbeat,
    "occupied": KINDS["bed"].heartbeat,
    "temperature_c": KINDS["temperature"].heartbeat,
    "level_percent": KINDS["level"].heartbeat,
    "motion": KINDS["motion"].heartbeat,
}
"""Longest time between two reports of a fact [s], where the site file does not say."""


def refused_property(key: str) -> DeviceProperty | None:
    """Return the property that a refused key of a device would have told of."""
    return _KEYS.get(key)


def telling_fact(wanted: DeviceProperty, facts: _FactTable) -> str:
    """Return the fact of a report that speaks of a property, the strongest; "" for none."""
    return next((name for name in _FACTS[wanted] if _is_telling(name, facts.get(name))), "")


def _is_telling(name: str, value: Fact | None) -> bool:
    """Return whether a fact has a value of its type: a number, or a truth value."""
    if name in ("power", "temperature_c", "level_percent"):
        return isinstance(value, int | float) and not isinstance(value, bool)
    return isinstance(value, bool)


def tells(kind: str, wanted: DeviceProperty) -> bool:
    """Return whether devices of a kind tell of a property."""
    return _KIND_FACTS.get(kind, "") in _FACTS[wanted]


def weakest_fact(wanted: DeviceProperty) -> str:
    """Return the fact that says least of a property."""
    return _FACTS[wanted][-1]


def strength(fact: str) -> int:
    """Return how far down a fact is among those of its property; 0 is the strongest."""
    return min(names.index(fact) for names in _FACTS.values() if fact in names)


def heartbeat_of(fact: str, traits: DeviceTraits) -> float:
    """Return the longest time between two reports of a fact by a device [s]."""
    return traits.heartbeat or _HEARTBEATS[fact]


def device_verdict(
    wanted: DeviceProperty, fact: str, facts: _FactTable, traits: DeviceTraits
) -> DeviceVerdict:
    """Return what a report says of a property by one of its facts."""
    return _READERS[fact](wanted, facts[fact], traits)


def _power(wanted: DeviceProperty, value: Fact, traits: DeviceTraits) -> DeviceVerdict:
    watts = float(value) if not isinstance(value, str) else 0.0
    above, below = traits.limits_of_power()
    lacks = f"it is off below {below:g} W and on from {above:g} W"
    number = _grouped(watts)
    return DeviceVerdict(traits.is_on(watts), f"draws {number} W", f"drew {number} W", lacks)


def _measured(
    quantity: str, unit: str
) -> Callable[[DeviceProperty, Fact, DeviceTraits], DeviceVerdict]:
    def read(wanted: DeviceProperty, value: Fact, traits: DeviceTraits) -> DeviceVerdict:
        amount = float(value) if not isinstance(value, str) else 0.0
        words = f"{quantity} {amount:.3g} {unit}"
        limit = traits.above if wanted is DeviceProperty.HIGH else traits.below
        key = "above" if wanted is DeviceProperty.HIGH else "below"
        if limit is None:
            lacks = f"mqtt.sensors has no {key} for it"
            return DeviceVerdict(None, f"has {words}", f"had {words}", lacks)
        holds = amount >= limit if wanted is DeviceProperty.HIGH else amount < limit
        return DeviceVerdict(holds, f"has {words}", f"had {words}")

    return read


def _flag(yes: str, no: str) -> Callable[[DeviceProperty, Fact, DeviceTraits], DeviceVerdict]:
    def read(wanted: DeviceProperty, value: Fact, traits: DeviceTraits) -> DeviceVerdict:
        words = yes if value is True else no
        return DeviceVerdict(value is True, f"is {words}", f"was {words}")

    return read


_READERS: dict[str, Callable[[DeviceProperty, Fact, DeviceTraits], DeviceVerdict]] = {
    "power": _power,
    "on": _flag("switched on", "switched off"),
    "open": _flag("open", "closed"),
    "occupied": _flag("occupied", "free"),
    "temperature_c": _measured("a temperature of", "°C"),
    "level_percent": _measured("a level of", "%"),
    "motion": _flag("moving", "still"),
}


def _grouped(watts: float) -> str:
    """Return a power with thousands apart: "1 420", "0.4"."""
    return f"{watts:,.0f}".replace(",", " ") if abs(watts) >= 10.0 else f"{round(watts, 1) + 0.0:g}"
