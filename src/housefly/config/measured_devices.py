"""The part of a site file about devices that measure one value, whoever made them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, Self

from pydantic import Field, model_validator

from housefly.config.json_path import JsonPath
from housefly.config.section import Section, quantity

_ID = r"^[A-Za-z0-9][A-Za-z0-9_.:-]{0,63}$"
_TOPIC = r"^([^\x00-\x20+#$][^\x00-\x1f+#]{0,199})?$"

MeasuredKind = Literal["switch", "power", "temperature", "contact", "level"]


@dataclass(frozen=True, slots=True)
class MeasuringUnit:
    """A unit in which a device may tell its value: ours is ``factor * value + offset``."""

    factor: float = 1.0
    offset: float = 0.0

    def ours(self, value: float) -> float:
        """Return a value in our unit."""
        return self.factor * value + self.offset


UNITS: dict[str, dict[str, MeasuringUnit]] = {
    "power": {"W": MeasuringUnit(), "kW": MeasuringUnit(1000.0), "mW": MeasuringUnit(0.001)},
    "temperature": {
        "°C": MeasuringUnit(),
        "°F": MeasuringUnit(5.0 / 9.0, -160.0 / 9.0),
        "K": MeasuringUnit(1.0, -273.15),
    },
    "level": {"%": MeasuringUnit(), "1": MeasuringUnit(100.0)},
}
"""Units by kind, as Home Assistant writes them; the first is ours."""
_RANGES = {
    ("power", "W"): (-100_000.0, 100_000.0),
    ("power", "kW"): (-100.0, 100.0),
    ("power", "mW"): (-1e6, 1e6),
    ("temperature", "°C"): (-100.0, 1000.0),
    ("temperature", "°F"): (-148.0, 1832.0),
    ("temperature", "K"): (173.15, 1273.15),
    ("level", "%"): (0.0, 100.0),
    ("level", "1"): (0.0, 1.0),
}
"""What a value may be unless the site file says less, by kind and unit."""


class MeasuredDeviceConfig(Section):
    """A device that measures one value; names and payloads as in Zigbee2MQTT and Home Assistant."""

    id: str = Field(pattern=_ID, description="id of the device; unique among all devices")
    kind: MeasuredKind = Field(description="what it measures")
    thing: str = Field(
        default="",
        pattern=r"^([a-z0-9][a-z0-9_.-]{0,79})?$",
        description='id of the thing that it tells about; "" is the device itself',
    )
    state_topic: str = Field(
        default="",
        pattern=_TOPIC,
        description='topic of its state; "" is housefly/<site>/<kind>/<id>/state',
    )
    availability_topic: str = Field(
        default="",
        pattern=_TOPIC,
        description='topic that says online or offline; "" for none',
    )
    field: str = Field(
        default="",
        max_length=300,
        description=(
            "key of the value in the JSON, with dots between nested keys, an element of an array by"
            " its number: ENERGY.Power, ENERGY.Power.0, params[0].value; "
            '"" is state, power, temperature, contact or level, by the kind'
        ),
    )
    unit: str = Field(
        default="",
        max_length=8,
        description='W, kW, mW; °C, °F, K; % or 1; "" is W, °C or %',
    )
    min: float | None = Field(
        default=None, allow_inf_nan=False, description="least value that is believed [unit]"
    )
    max: float | None = Field(
        default=None, allow_inf_nan=False, description="largest value that is believed [unit]"
    )
    above: float | None = Field(
        default=None,
        allow_inf_nan=False,
        description="on, hot or full from here [unit]; of power 10 W when not given",
    )
    below: float | None = Field(
        default=None,
        allow_inf_nan=False,
        description="off, cold or empty below this [unit]; of power 5 W when not given",
    )
    payload_on: str = Field(
        default="",
        max_length=80,
        description=(
            "what a switch says for on, or a contact for open, beside the words that are known;"
            " several with commas between them"
        ),
    )
    payload_off: str = Field(
        default="", max_length=80, description="what it says for off, or for closed, likewise"
    )
    invert: bool = Field(
        default=False, description="the other way round: what it says is open is closed, on is off"
    )
    heartbeat: float = quantity(
        0.0, 0.0, 86400.0, "s", "longest time between two states; 0 is that of its kind"
    )

    @property
    def on_words(self) -> tuple[str, ...]:
        """What it says for on, or for open, in lower case, beside the words that are known."""
        return _words_in(self.payload_on)

    @property
    def off_words(self) -> tuple[str, ...]:
        """What it says for off, or for closed, likewise."""
        return _words_in(self.payload_off)

    @property
    def value_unit(self) -> str:
        """The unit of its values, "" for a switch or a contact."""
        return self.unit or next(iter(UNITS.get(self.kind, {"": None})))

    @property
    def value_range(self) -> tuple[float, float]:
        """Least and largest value that is believed, in its unit."""
        low, high = _RANGES.get((self.kind, self.value_unit), (0.0, 1.0))
        return low if self.min is None else self.min, high if self.max is None else self.max

    def ours(self, value: float) -> float:
        """Return a value of the device's unit in W, degrees Celsius or %."""
        return UNITS.get(self.kind, {}).get(self.value_unit, MeasuringUnit()).ours(value)

    @model_validator(mode="after")
    def _measures_in_a_unit_of_its_kind(self) -> Self:
        known = UNITS.get(self.kind, {})
        if self.unit and self.unit not in known:
            allowed = ", ".join(known) or '"": it has no unit'
            raise ValueError(
                f"{self.id}: unit is {self.unit!r}; allowed for {self.kind}: {allowed}"
            )
        if not known and any(
            limit is not None for limit in (self.min, self.max, self.above, self.below)
        ):
            raise ValueError(f"{self.id}: min, max, above and below are not for a {self.kind}")
        if known and (self.payload_on or self.payload_off or self.invert):
            raise ValueError(
                f"{self.id}: payload_on, payload_off and invert are for a switch or a contact, not"
                f" for {self.kind}"
            )
        if both := set(self.on_words) & set(self.off_words):
            raise ValueError(f"{self.id}: {min(both)!r} is in payload_on and in payload_off")
        own = [name for name in ("field", "unit") if getattr(self, name)]
        if own and not self.state_topic:
            raise ValueError(
                f"{self.id}: {own[0]} is given without state_topic; on our own topics devices"
                " speak as docs/devices.md says"
            )
        if self.field:
            try:
                JsonPath(self.field)
            except ValueError as error:
                raise ValueError(f"{self.id}: field: {error}") from error
        return self

    @model_validator(mode="after")
    def _has_its_limits_in_order(self) -> Self:
        if self.kind not in UNITS:
            return self
        low, high = self.value_range
        known = _RANGES[self.kind, self.value_unit]
        if not known[0] <= low < high <= known[1]:
            raise ValueError(
                f"{self.id}: min {low:g} and max {high:g}; allowed: min below max, from"
                f" {known[0]:g} to {known[1]:g} {self.value_unit}"
            )
        for name, limit in (("above", self.above), ("below", self.below)):
            if limit is not None and not low <= limit <= high:
                raise ValueError(
                    f"{self.id}: {name} is {limit:g}; allowed: {low:g} to {high:g}"
                    f" {self.value_unit}"
                )
        if self.above is not None and self.below is not None and self.below > self.above:
            raise ValueError(
                f"{self.id}: below ({self.below:g}) is more than above ({self.above:g})"
                f" {self.value_unit}; in between the device stays as it was"
            )
        return self


def _words_in(text: str) -> tuple[str, ...]:
    return tuple(word.strip().lower() for word in text.split(",") if word.strip())
