"""The mode of the house."""

from __future__ import annotations

from enum import Enum


class HouseMode(Enum):
    """The mode of the house: gates launching, recording and zones."""

    HOME = "home"
    AWAY = "away"
    NIGHT = "night"
    PRIVACY = "privacy"
    MAINTENANCE = "maintenance"


_RECORDS = frozenset({HouseMode.HOME, HouseMode.AWAY, HouseMode.NIGHT})


def may_record(mode: HouseMode) -> bool:
    """Return whether clips and snapshots may be made in a mode."""
    return mode in _RECORDS
