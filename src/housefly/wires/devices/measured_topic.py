"""One value on a topic of any maker's device: Zigbee2MQTT, Tasmota, Shelly, ESPHome.

The payload is JSON that holds the value somewhere, or the bare value.
"""

from __future__ import annotations

from dataclasses import replace

from housefly.config.json_path import JsonPath
from housefly.config.measured_devices import MeasuredDeviceConfig
from housefly.errors import UnknownState, WireError
from housefly.wires.devices.codec import Delivered, Reading, parsed_json, refused_state
from housefly.wires.devices.fields import (
    JsonField,
    JsonRecord,
    NumberField,
    WordField,
    known_value,
    value_refusal,
)
from housefly.wires.devices.kind import DeviceKind, DeviceReport
from housefly.wires.devices.measured import (
    MEASURED_ALLOWED,
    MEASURED_KINDS,
    MEASURED_WORDS,
    value_key,
)
from housefly.wires.devices.topics import Channel, DeviceAddress, printable_topic
from housefly.wires.devices.words import PRESENCE_WORDS

_PRESENCE_KEYS = ("state", "online", "status", "value", "val")
"""Where makers put whether a device is there; the first that is in the message counts."""


class MeasuredTopic:
    """What the site file says of one device, ready to decode its messages.

    Args:
        config: of the device.
        site: second part of its topics where it has none of its own.

    Attributes:
        config: the same.
        address: of the device among the room's own.
        kind: with the heartbeat of this device.
        state_topic: where its state comes.
        is_foreign: whether the topic is not one of ours.
    """

    def __init__(self, config: MeasuredDeviceConfig, site: str) -> None:
        kind = MEASURED_KINDS[config.kind]
        key = value_key(config.kind)
        own = _own_field(config)
        self.config = config
        self.address = DeviceAddress(site, config.kind, config.id)
        self.kind: DeviceKind = replace(
            kind,
            heartbeat=config.heartbeat or kind.heartbeat,
            state={key: own},
        )
        self.is_foreign = bool(config.state_topic)
        self.state_topic = config.state_topic or self.address.topic(Channel.STATE)
        self._field, self._key = own, key
        self._path = JsonPath(config.field or key)

    def decode(self, message: Delivered) -> Reading:
        """Return what a message on a topic of the site file says: a state, or an availability.

        A message in which the value is not to be found says nothing, and why. A state that the kind
        does not know makes an observation that is not valid.

        Raises:
            WireError: naming topic, key, value, and what is allowed with its unit.
        """
        if message.channel is Channel.AVAILABILITY:
            return self._availability(message)
        topic, at = printable_topic(self.state_topic), message.received_at
        notes = (("retained", True),) if message.retained else ()
        report = DeviceReport(self.config.id, at, at, notes=notes)
        tree, where = _text(message.payload, topic), topic
        if self.config.field or isinstance(tree, dict):
            try:
                tree, where = self._path.value_in(tree), f"{topic}.{self._path}"
            except LookupError as error:
                return Reading(absent=f"{topic}.{error.args[0]}; {self._remedy}")
        try:
            checked = known_value(self._field, tree, where)
        except UnknownState as error:
            refusal = f"{self._key} {str(error).removeprefix(where).lstrip()}"
            return Reading((refused_state(report, self._key, refusal),), refused=(str(error),))
        except WireError as error:
            raise WireError(f"{error}{self._hint(tree)}") from error
        if isinstance(checked, float):
            checked = self.config.ours(checked)
        return Reading(tuple(self.kind.observe(JsonRecord({self._key: checked}), report)))

    def _availability(self, message: Delivered) -> Reading:
        """Return whether the device is online: a word, or JSON with it under "state"."""
        topic = printable_topic(self.config.availability_topic)
        value: object = _text(message.payload, topic)
        if isinstance(value, dict):
            value = next((value[key] for key in _PRESENCE_KEYS if key in value), None)
        word = str(value).lower() if isinstance(value, str | bool) else ""
        if word not in PRESENCE_WORDS:
            raise value_refusal(topic, value, 'online or offline, bare or as {"state": "online"}')
        return Reading(online=PRESENCE_WORDS[word])

    @property
    def _remedy(self) -> str:
        return f"mqtt.sensors, {self.config.id}: field names the value"

    def _hint(self, tree: object) -> str:
        """Return which key of the site file finds a value inside what stands there."""
        return f"; {self._remedy} in it" if isinstance(tree, dict | list) else ""


def _own_field(config: MeasuredDeviceConfig) -> JsonField:
    """Return the check of a value with the range, unit and words of the site file."""
    if config.kind not in MEASURED_WORDS:
        return NumberField(*config.value_range, config.value_unit)
    words = MEASURED_WORDS[config.kind]
    told = {**dict.fromkeys(config.off_words, False), **dict.fromkeys(config.on_words, True)}
    yes, no = ("open", "closed") if config.kind == "contact" else ("on", "off")
    allowed = (
        f"{_quoted(config.on_words) or f'a word for {yes}'} or"
        f" {_quoted(config.off_words) or f'a word for {no}'}"
        if told
        else MEASURED_ALLOWED[config.kind]
    )
    return WordField(
        {word: says is not config.invert for word, says in {**words, **told}.items()},
        f"{allowed}; payload_on and payload_off name others",
    )


def _quoted(words: tuple[str, ...]) -> str:
    return ", ".join(f'"{word}"' for word in words)


def _text(payload: bytes, topic: str) -> object:
    """Return the JSON of a payload, or its text when it is none."""
    try:
        return parsed_json(payload, topic)
    except (ValueError, RecursionError):
        text = payload.decode(errors="replace").strip()
    if text[:1] in "{[":
        raise WireError(f"{topic}: not JSON")
    return text
