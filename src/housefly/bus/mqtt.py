"""Connections to an MQTT broker, and what is wrong with them in words."""

from __future__ import annotations

import asyncio
import logging
from pathlib import Path

import aiomqtt
from paho.mqtt.packettypes import PacketTypes
from paho.mqtt.properties import Properties

from housefly.bus.reconnect import connection_lost
from housefly.config.devices import MqttConfig
from housefly.config.text import read_text_file
from housefly.errors import ConfigError
from housefly.messages.words import Words, literal

MQTT_ERRORS = (aiomqtt.MqttError, OSError, UnicodeError)
"""What a connection may raise; UnicodeError comes from a malformed broker name."""
_TIMEOUT = 5.0
_KEEPALIVE = 10
"""A broker silent for one and a half times this [s] is gone: a pulled cable gives no notice."""
_QUEUE = 4096
_LOG = logging.getLogger("housefly.mqtt")
_LOG.addHandler(logging.NullHandler())
_LOG.propagate = False
_REFUSED = frozenset({4, 5, 134, 135})
"""Reason codes of MQTT 3.1.1 and 5: bad user name or password, not authorised."""
_REASONS = 128
"""Reason codes of MQTT 5 begin here."""
_VERSION_REFUSED, _OTHER_VERSION = 1, 132
"""Reason codes of MQTT 3.1.1 and 5: the broker does not speak this version."""
_PROBE_TIMEOUT = 1.0
"""How long a broker may take to say which version it speaks [s]."""


def mqtt_client(
    config: MqttConfig, will: aiomqtt.Will | None = None, largest: int | None = None
) -> aiomqtt.Client:
    """Return a client that is not connected yet.

    Args:
        config: where the broker is, who we are.
        will: published by the broker when the connection is lost.
        largest: the broker withholds longer messages [bytes].

    Raises:
        ConfigError: the password file cannot be read.
    """
    properties = Properties(PacketTypes.CONNECT)  # type: ignore[no-untyped-call]
    if largest is not None:
        properties.MaximumPacketSize = largest
    return aiomqtt.Client(
        config.broker,
        config.port,
        username=config.username or None,
        password=read_password(config),
        protocol=aiomqtt.ProtocolVersion.V5,
        properties=properties,
        will=will,
        timeout=_TIMEOUT,
        keepalive=_KEEPALIVE,
        max_queued_incoming_messages=_QUEUE,
        logger=_LOG,
    )


def read_password(config: MqttConfig) -> str | None:
    """Return the password or None; raises ConfigError when its file cannot be read."""
    if not config.password_file:
        return None
    try:
        return (read_text_file(Path(config.password_file)).splitlines() or [""])[0]
    except (OSError, UnicodeDecodeError) as error:
        raise ConfigError(
            "mqtt.password_file", f"cannot be read ({error})", config.password_file
        ) from error


async def mqtt_problem(error: Exception, config: MqttConfig, was_connected: bool) -> Words:
    """Return why there is no connection and what to do about it.

    Where a broker does not say why, it is asked which version of the protocol it speaks.
    """
    at = f"{config.broker}:{config.port}"
    code = getattr(getattr(error, "rc", None), "value", getattr(error, "rc", None))
    if code in _REFUSED:
        return Words(
            "the MQTT broker at {name} refuses us; check mqtt.username and mqtt.password_file",
            name=at,
        )
    if was_connected:
        return connection_lost(f"MQTT {at}")
    if isinstance(code, int) and code >= _REASONS and code != _OTHER_VERSION:
        return Words("the MQTT broker at {name} refuses us ({error})", name=at, error=str(error))
    try:
        speaks = await _spoken_version(config)
    except (OSError, UnicodeError):
        return Words(
            "no MQTT broker answers at {name}; is it running (mosquitto), is mqtt.port right?",
            name=at,
        )
    if speaks == _MQTT_5:
        return literal(f"the MQTT broker at {at} answers, but no connection comes about ({error})")
    if speaks:
        return literal(
            f"the MQTT broker at {at} speaks MQTT {speaks} and not MQTT 5, which Housefly speaks;"
            " update it (mosquitto from 1.6 on)"
        )
    return literal(
        f"something answers at {at}, but not as an MQTT broker without TLS does;"
        " is mqtt.port right?"
    )


_MQTT_5 = "5"
_CONNECTS = {
    _MQTT_5: b"\x10\x0d\x00\x04MQTT\x05\x02\x00\x0a\x00\x00\x00",
    "3.1.1": b"\x10\x0c\x00\x04MQTT\x04\x02\x00\x0a\x00\x00",
    "3.1": b"\x10\x13\x00\x06MQIsdp\x03\x02\x00\x0a\x00\x05house",
}
"""The shortest greeting in each version, the newest first."""
_CONNACK, _REASON_AT = 0x20, 3


async def _spoken_version(config: MqttConfig) -> str:
    """Return the newest version of MQTT in which a broker answers, "" for none; raises OSError."""
    for version, greeting in _CONNECTS.items():
        reader, writer = await asyncio.open_connection(config.broker, config.port)
        try:
            writer.write(greeting)
            answer = b""
            async with asyncio.timeout(_PROBE_TIMEOUT):
                answer = await reader.read(_REASON_AT + 1)
        except (TimeoutError, OSError):
            continue
        finally:
            writer.transport.abort()
        is_answer = len(answer) > _REASON_AT and answer[0] == _CONNACK
        if is_answer and answer[_REASON_AT] not in (_VERSION_REFUSED, _OTHER_VERSION):
            return version
    return ""
