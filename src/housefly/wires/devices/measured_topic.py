"""One value on a topic of any maker's device: Zigbee2MQTT, Tasmota, Shelly, ESPHome.

The payload is JSON that holds the value somewhere, or the bare value.
"""

from __future__ import annotations

from dataclasses import replace

from housefly.config.measured_devices import MeasuredDeviceConfig
from housefly.errors import WireError
from housefly.wires.devices.codec import Delivered, Reading, parsed_json
from housefly.wires.devices.fields import (
    JsonField,
    JsonRecord,
    NumberField,
    WordField,
    value_refusal,
)
from housefly.wires.devices.kind import DeviceKind, DeviceReport
from housefly.wires.devices.measured import MEASURED_KINDS, ON_WORDS, value_key
from housefly.wires.devices.topics import Channel, DeviceAddress, printable_topic

_PRESENCE_WORDS = {"online": True, "offline": False, "true": True, "false": False}


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
        own = _own_field(config, kind.state[key])
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

    def decode(self, message: Delivered) -> Reading:
        """Return what a message on a topic of the site file says: a state, or an availability.

        Raises:
            WireError: naming topic, key, value, and what is allowed with its unit.
        """
        if message.channel is Channel.AVAILABILITY:
            return self._availability(message)
        topic = printable_topic(self.state_topic)
        value, where = self._found(_text(message.payload, topic), topic)
        checked = self._field.check(value, where)
        if isinstance(checked, float):
            checked = self.config.ours(checked)
        report = DeviceReport(
            self.config.id,
            message.received_at,
            message.received_at,
            notes=(("retained", True),) if message.retained else (),
        )
        record = JsonRecord({self._key: checked})
        return Reading(tuple(self.kind.observe(record, report)))

    def _availability(self, message: Delivered) -> Reading:
        """Return whether the device is online: a word, or JSON with it under "state"."""
        topic = printable_topic(self.config.availability_topic)
        value: object = _text(message.payload, topic)
        if isinstance(value, dict):
            value = value.get("state")
        word = str(value).lower() if isinstance(value, str | bool) else ""
        if word not in _PRESENCE_WORDS:
            raise value_refusal(topic, value, 'online or offline, bare or as {"state": "online"}')
        return Reading(online=_PRESENCE_WORDS[word])

    def _found(self, tree: object, topic: str) -> tuple[object, str]:
        """Return the value and the place to name in a complaint; a bare payload is the value."""
        where = topic
        keys = (self.config.field or self._key).split(".")
        if not isinstance(tree, dict) and not self.config.field:
            return tree, where
        for key in keys:
            where = f"{where}.{key}"
            if not isinstance(tree, dict) or key not in tree:
                raise WireError(
                    f"{where} is missing; mqtt.sensors, {self.config.id}: field names it"
                )
            tree = tree[key]
        return tree, where


def _own_field(config: MeasuredDeviceConfig, usual: JsonField) -> JsonField:
    """Return the check of a value with the range, unit and words of the site file."""
    if isinstance(usual, NumberField):
        return NumberField(*config.value_range, config.value_unit)
    if config.kind != "switch" or not (config.payload_on or config.payload_off):
        return usual
    on, off = config.payload_on or "ON", config.payload_off or "OFF"
    return WordField({**ON_WORDS, off.lower(): False, on.lower(): True}, f'"{on}" or "{off}"')


def _text(payload: bytes, topic: str) -> object:
    """Return the JSON of a payload, or its text when it is none."""
    try:
        return parsed_json(payload, topic)
    except (ValueError, RecursionError):
        text = payload.decode(errors="replace").strip()
    if text[:1] in "{[":
        raise WireError(f"{topic}: not JSON")
    return text
