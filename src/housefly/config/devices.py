"""The part of a site file about the room's devices."""

from __future__ import annotations

import re
from ipaddress import ip_address
from typing import Self

from pydantic import Field, field_validator, model_validator

from housefly.config.measured_devices import MeasuredDeviceConfig
from housefly.config.section import Section, quantity

_ID = r"^[A-Za-z0-9][A-Za-z0-9_.:-]{0,63}$"

_ALLOWED = re.compile(r"[a-z][a-z_-]{0,39}/[A-Za-z0-9][A-Za-z0-9_.:-]{0,63}")


class TagConfig(Section):
    """Which thing carries an RFID tag."""

    tag: str = Field(pattern=_ID, description="what the reader says")
    thing: str = Field(pattern=_ID, description="id of the thing")


class DeviceConfig(Section):
    """Where a device on MQTT stands in the room; it measures in its own frame."""

    id: str = Field(pattern=_ID, description="id of the device, as in its topics")
    position: tuple[float, float, float] = Field(
        default=(0.0, 0.0, 0.0), description="origin of its frame [m]"
    )
    yaw: float = quantity(0.0, -6.3, 6.3, "rad", "direction of its x axis")


class MqttConfig(Section):
    """The MQTT broker through which the room's devices speak; docs/devices.md has their topics."""

    broker: str = Field(
        default="",
        max_length=253,
        pattern=r"^([A-Za-z0-9:][A-Za-z0-9.:_-]*)?$",
        description='name or IP address; "" means no devices on MQTT',
    )
    start: bool = Field(
        default=False,
        description=(
            "start a mosquitto of our own at that address, for the time of a run; on loopback only,"
            " because it asks nobody who they are"
        ),
    )
    port: int = Field(
        default=1883,
        ge=0,
        le=65535,
        description="TCP port; 0 chooses a free one for a broker of our own",
        json_schema_extra={"unit": "1"},
    )
    site: str = Field(
        default="bsen",
        pattern=r"^[a-z0-9][a-z0-9_-]{0,39}$",
        description="second part of every topic",
    )
    username: str = Field(default="", max_length=200, description="for a broker that asks for one")
    password_file: str = Field(
        default="",
        description="file whose first line is the password, relative to the working folder",
    )
    rate_max_hz: float = quantity(
        50.0, 0.1, 1000.0, "Hz", "messages per second of one device; what is more is dropped"
    )
    clock_ahead: float = quantity(
        2.0, 0.0, 60.0, "s", "a device's time further ahead of ours is refused"
    )
    clock_behind: float = quantity(
        60.0, 0.1, 86400.0, "s", "a device's time further behind ours is refused"
    )
    allow: tuple[str, ...] = Field(
        default=(),
        max_length=256,
        description="kind/id of the devices that are listened to, such as door/entrance; () is all",
    )
    devices: tuple[DeviceConfig, ...] = Field(
        default=(), description="id, position [m] and yaw [rad] of devices with a frame"
    )
    sensors: tuple[MeasuredDeviceConfig, ...] = Field(
        default=(),
        max_length=256,
        description=(
            "devices that measure one value, on topics of any maker: id, kind, thing, state_topic,"
            " field, unit, min, max, above, below ...; docs/devices.md"
        ),
    )
    tags: tuple[TagConfig, ...] = Field(
        default=(), description="tag and thing; a tag that is not here is the thing's own id"
    )

    @field_validator("allow")
    @classmethod
    def _names_devices(cls, allow: tuple[str, ...]) -> tuple[str, ...]:
        for entry in allow:
            if not _ALLOWED.fullmatch(entry):
                raise ValueError(f"holds {entry!r}; allowed: kind/id, such as door/entrance")
        return allow

    @model_validator(mode="after")
    def _names_each_sensor_once(self) -> Self:
        ids = [sensor.id for sensor in self.sensors]
        if twice := sorted({name for name in ids if ids.count(name) > 1}):
            raise ValueError(f"sensors: two of them have the id {twice[0]!r}; give each its own")
        return self

    @model_validator(mode="after")
    def _keeps_its_own_broker_to_itself(self) -> Self:
        if self.start and not _is_loopback(self.broker):
            raise ValueError(
                f"start = true with broker {self.broker!r}: a broker of our own asks nobody who"
                " they are; allowed: a loopback address such as 127.0.0.1, or start = false and a"
                " broker with users"
            )
        return self


def _is_loopback(host: str) -> bool:
    try:
        return host == "localhost" or ip_address(host).is_loopback
    except ValueError:
        return False
