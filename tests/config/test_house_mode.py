"""What may be recorded in which mode of the house."""

from __future__ import annotations

from housefly.config.house_mode import HouseMode, may_record


def test_nothing_records_in_privacy_and_in_maintenance() -> None:
    assert {mode for mode in HouseMode if not may_record(mode)} == {
        HouseMode.PRIVACY,
        HouseMode.MAINTENANCE,
    }
