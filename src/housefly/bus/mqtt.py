"""Connections to an MQTT broker, and what is wrong with them in words."""

from __future__ import annotations

import logging
from pathlib import Path

import aiomqtt
from paho.mqtt.packettypes import PacketTypes
from paho.mqtt.properties import Properties

from housefly.config.devices import MqttConfig
from housefly.config.text import read_text_file
from housefly.errors import ConfigError

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


def mqtt_problem(error: Exception, config: MqttConfig, was_connected: bool) -> str:
    """Return why there is no connection and what to do about it, in words."""
    where = f"{config.broker}:{config.port}"
    code = getattr(getattr(error, "rc", None), "value", getattr(error, "rc", None))
    if code in _REFUSED:
        return f"the MQTT broker at {where} refuses us; check mqtt.username and mqtt.password_file"
    if was_connected:
        return f"the connection to the MQTT broker at {where} was lost"
    return f"no MQTT broker answers at {where}; is it running (mosquitto), is mqtt.port right?"
