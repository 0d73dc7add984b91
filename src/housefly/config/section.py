"""A table of a configuration file as a type whose quantities have a range and a unit."""

from __future__ import annotations

from ipaddress import IPv4Address
from typing import Any

from pydantic import BaseModel, ConfigDict, Field


def quantity(default: Any, low: float, high: float, unit: str, meaning: str) -> Any:
    """Declare a number: default (``...``: it must be given), inclusive range, unit, meaning."""
    return Field(
        default,
        ge=low,
        le=high,
        allow_inf_nan=False,
        description=meaning,
        json_schema_extra={"unit": unit},
    )


def port_number(default: int, meaning: str) -> Any:
    """Declare a port with its default and one-line meaning."""
    return Field(default, ge=1, le=65535, description=meaning, json_schema_extra={"unit": "1"})


def is_multicast_group(address: str) -> bool:
    """Return whether a text is an IPv4 multicast address."""
    try:
        return IPv4Address(address).is_multicast
    except ValueError:
        return False


class Section(BaseModel):
    """A frozen table of a configuration file; unknown keys are refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=False)
