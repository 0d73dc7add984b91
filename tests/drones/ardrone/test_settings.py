"""What we set on the drone."""

from __future__ import annotations

import pytest

from housefly.config.limits import LimitsConfig
from housefly.drones.ardrone.settings import (
    is_needed_to_fly,
    maxima_in,
    maxima_of,
    setting_mismatches,
    wanted_settings,
)
from housefly.messages.stick import Maxima
from housefly.wires.ardrone.config import encode_dump, format_value, key_named, parse_dump

LIMITS = LimitsConfig(
    tilt_max=0.15, vertical_speed_max=0.5, climb_command_max=0.0, yaw_rate_max=1.0, height_max=2.5
)


def test_every_setting_is_a_writable_key_with_a_value_of_its_type() -> None:
    for name, value in wanted_settings(LIMITS):
        assert key_named(name).writable
        assert format_value(key_named(name), value)


def test_limits_go_out_in_the_drones_units() -> None:
    wanted = dict(wanted_settings(LIMITS))
    assert wanted["control:euler_angle_max"] == 0.15
    assert wanted["control:control_vz_max"] == pytest.approx(500.0)
    assert wanted["control:control_yaw"] == 1.0
    assert wanted["control:altitude_max"] == 2500


def test_a_drone_that_may_carry_more_is_given_the_stick_and_the_room_for_it() -> None:
    wanted = dict(wanted_settings(LIMITS.model_copy(update={"climb_command_max": 0.8})))
    assert wanted["control:control_vz_max"] == pytest.approx(800.0)
    assert wanted["control:altitude_max"] == 3500


def test_outdoor_comes_before_the_limits_that_it_replaces() -> None:
    assert next(name for name, _ in wanted_settings(LIMITS)) == "control:outdoor"


def test_a_drone_that_took_everything_differs_in_nothing() -> None:
    dump = parse_dump(encode_dump(dict(wanted_settings(LIMITS))))
    assert setting_mismatches(dump, LIMITS) == {}
    assert maxima_in(dump, Maxima(9, 9, 9)) == maxima_of(LIMITS)


def test_a_drone_that_keeps_its_own_watchdog_is_told_of_and_still_flies() -> None:
    assert dict(wanted_settings(LIMITS))["general:com_watchdog"] == 1
    kept = encode_dump(dict(wanted_settings(LIMITS)) | {"general:com_watchdog": 2})
    ((name, note),) = setting_mismatches(parse_dump(kept), LIMITS).items()
    assert note == "the drone keeps general:com_watchdog = 2 instead of 1"
    assert not is_needed_to_fly(name)


def test_what_the_drone_kept_is_told_and_counts() -> None:
    dump = parse_dump(
        encode_dump(dict(wanted_settings(LIMITS)) | {"control:euler_angle_max": 0.35})
    )
    ((name, note),) = setting_mismatches(dump, LIMITS).items()
    assert is_needed_to_fly(name)
    assert "control:euler_angle_max" in note and "3.5" in note
    assert maxima_in(dump, maxima_of(LIMITS)).tilt == pytest.approx(0.35)
