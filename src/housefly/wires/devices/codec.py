"""Device payloads to observations and events, and back."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Never

from housefly.errors import UnknownState, WireError
from housefly.messages import Fact, Facts, Observation, RoomEvent
from housefly.wires.devices.bed import BED_KIND
from housefly.wires.devices.cabinet import CABINET_KIND
from housefly.wires.devices.fields import JsonRecord, JsonSpec, read_record
from housefly.wires.devices.floor import FLOOR_KIND
from housefly.wires.devices.kind import DeviceKind, DeviceReport, Placement
from housefly.wires.devices.measured import MEASURED_KINDS
from housefly.wires.devices.refrigerator import REFRIGERATOR_KIND
from housefly.wires.devices.switches import DOOR_KIND, DOORBELL_KIND, MOTION_KIND
from housefly.wires.devices.topics import Channel, DeviceAddress, printable_topic
from housefly.wires.devices.words import PRESENCE_WORDS

KINDS: dict[str, DeviceKind] = {
    kind.name: kind
    for kind in (
        FLOOR_KIND,
        CABINET_KIND,
        REFRIGERATOR_KIND,
        BED_KIND,
        DOOR_KIND,
        DOORBELL_KIND,
        MOTION_KIND,
        *MEASURED_KINDS.values(),
    )
}
"""All kinds of devices, by their name in topics."""
MAX_DEVICE_PAYLOAD = 16_384
"""Longest payload [bytes]."""


@dataclass(frozen=True, slots=True)
class ClockBounds:
    """How far a device's clock may be ahead of and behind ours before its time is refused [s]."""

    ahead: float = 2.0
    behind: float = 60.0


_DEFAULT_BOUNDS, _NO_PLACEMENT = ClockBounds(), Placement()
_EARLIEST = 1.6e9
"""A clock before this Unix time [s], in 2020, was never set."""


@dataclass(frozen=True, slots=True)
class Delivered:
    """One message as the broker handed it over.

    Attributes:
        address: of the sender.
        channel: that it was sent on.
        payload: the bytes.
        received_at: when it came [s, Unix time].
        retained: whether the broker had stored it, so that it is older than its arrival.
    """

    address: DeviceAddress
    channel: Channel
    payload: bytes
    received_at: float
    retained: bool = False


@dataclass(frozen=True, slots=True)
class Reading:
    """What one message report.

    Attributes:
        observations: of the device and of what it sees; one that is not valid when the device is in
            a state that is not understood.
        events: that it reports.
        online: its availability; None in other messages.
        unknown: unknown keys.
        clock_error: how far a refused time was ahead [s]; None when it was not refused.
        refused: what was not understood, in words; the rest was.
        absent: why the message does not hold what the device measures, in words, or "".
    """

    observations: tuple[Observation, ...] = ()
    events: tuple[RoomEvent, ...] = ()
    online: bool | None = None
    unknown: tuple[str, ...] = ()
    clock_error: float | None = None
    refused: tuple[str, ...] = ()
    absent: str = ""

    @property
    def is_understood(self) -> bool:
        """Whether anything of the message was understood."""
        return not self.refused or any(seen.valid for seen in self.observations)


def device_kind(address: DeviceAddress) -> DeviceKind:
    """Return the kind of a device; raises WireError that lists the known kinds."""
    if address.kind not in KINDS:
        raise WireError(
            f"{printable_topic(address.topic(Channel.STATE))}: unknown kind of device; known:"
            f" {', '.join(KINDS)}"
        )
    return KINDS[address.kind]


def decode_reading(
    message: Delivered,
    placement: Placement = _NO_PLACEMENT,
    bounds: ClockBounds = _DEFAULT_BOUNDS,
    kind: DeviceKind | None = None,
) -> Reading:
    """Return what a message report.

    A time outside the bounds is replaced by the time of arrival, and the observations carry the
    fact ``clock_error`` [s]. A retained state may have any age; it carries the fact ``retained``.
    A retained event is over and yields nothing. ``kind`` replaces the one in the topic. A bad value
    leaves the others alone, and is told by the facts ``refused`` and ``refused_key``; a state that
    the kind does not know makes an observation that is not valid, so that none before it goes on to
    hold.

    Raises:
        WireError: naming the topic, the key, the value and what is allowed.
    """
    kind = kind or device_kind(message.address)
    topic = message.address.topic(message.channel)
    if message.channel is Channel.AVAILABILITY:
        return Reading(online=_presence(message.payload, topic))
    is_event = message.channel is Channel.EVENT
    record = _parse(kind.event_spec() if is_event else kind.state_spec(), message.payload, topic)
    if record.missing:
        raise WireError(f"{topic}.{record.missing[0]} is missing")
    report, clock_error = _report(record, message, placement, bounds)
    seen = () if is_event else tuple(_observed(kind, record, report, topic))
    events = (_event(kind, record, report),) if is_event and not message.retained else ()
    complaints = tuple(map(str, record.refused.values()))
    return Reading(seen, events, None, record.unknown, clock_error, complaints)


def refused_state(report: DeviceReport, key: str, refusal: str) -> Observation:
    """Return the observation that a device says under a key what is not understood."""
    return replace(report.about_device(*_refusal(key, refusal)), valid=False)


def _refusal(key: str, refusal: str) -> Facts:
    return ("refused", refusal), ("refused_key", key)


def _observed(
    kind: DeviceKind, record: JsonRecord, report: DeviceReport, topic: str
) -> Iterable[Observation]:
    """Return what is understood of a state; raises WireError when that is nothing."""
    errors = [(key, error) for key, error in record.refused.items() if key in kind.state]
    if not errors:
        return kind.observe(record, report)
    key, error = errors[0]
    refusal = str(error).removeprefix(f"{topic}.")
    if any(key in record.values for key in kind.state):
        notes = (*report.notes, *_refusal(key, refusal))
        return kind.observe(record, replace(report, notes=notes))
    if not isinstance(error, UnknownState):
        raise error
    return (refused_state(report, key, refusal),)


def _parse(spec: JsonSpec, payload: bytes, topic: str) -> JsonRecord:
    """Return a payload as a checked record; raises WireError."""
    try:
        tree = parsed_json(payload, topic)
    except (ValueError, RecursionError) as error:
        raise WireError(f"{topic}: not JSON ({str(error)[:80]})") from error
    return read_record(spec, tree, topic)


def parsed_json(payload: bytes, topic: str) -> object:
    """Return the JSON of a payload.

    Raises:
        WireError: it is too long.
        ValueError: it is no JSON; NaN and infinity are none.
        RecursionError: it is nested too deeply.
    """
    if len(payload) > MAX_DEVICE_PAYLOAD:
        raise WireError(f"{topic}: {len(payload)} bytes; allowed: up to {MAX_DEVICE_PAYLOAD} bytes")
    return json.loads(payload.decode(), parse_constant=_no_number)


def encode_payload(values: Mapping[str, object]) -> bytes:
    """Return a payload."""
    return json.dumps(values, separators=(",", ":"), allow_nan=False).encode()


def _presence(payload: bytes, topic: str) -> bool:
    word = payload.decode(errors="replace").strip().strip('"').lower()
    if word not in PRESENCE_WORDS:
        raise WireError(
            f"{topic} is {ascii(payload[:40])[1:]}; allowed: online or offline, without quotes"
        )
    return PRESENCE_WORDS[word]


def _report(
    record: JsonRecord, message: Delivered, placement: Placement, bounds: ClockBounds
) -> tuple[DeviceReport, float | None]:
    """Return the report of a message, and how far its time was off if refused [s]."""
    now, told = message.received_at, record.number_or_none("time")
    error = None if told is None or _is_plausible(told, message, bounds) else told - now
    captured_at = now if told is None or error is not None else min(told, now)
    battery = record.number_or_none("battery")
    notes: list[tuple[str, Fact]] = [("battery", battery)] if battery is not None else []
    notes += [("retained", True)] if message.retained else []
    notes += [("clock_error", error)] if error is not None else []
    return DeviceReport(message.address.id, captured_at, now, placement, tuple(notes)), error


def _is_plausible(told: float, message: Delivered, bounds: ClockBounds) -> bool:
    ahead = told - message.received_at
    return (
        ahead <= bounds.ahead
        and told >= _EARLIEST
        and (message.retained or -ahead <= bounds.behind)
    )


def _event(kind: DeviceKind, record: JsonRecord, report: DeviceReport) -> RoomEvent:
    for key, error in record.refused.items():
        if kind.event_spec()[key].required:
            raise error
    tag = record.word("tag")
    weight = record.number_or_none("weight")
    facts: tuple[tuple[str, Fact], ...] = (
        (("weight", weight), *report.notes) if weight is not None else report.notes
    )
    thing = report.placement.thing(tag) if tag else report.source
    return RoomEvent(
        kind.events[record.word("event")], thing, report.captured_at, report.source, facts=facts
    )


def _no_number(word: str) -> Never:
    raise ValueError(f"{word} is not a number")
