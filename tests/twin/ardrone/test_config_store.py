"""The configuration store follows the drone's own rules."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.twin.ardrone.config_store import MAX_CUSTOM_CONFIGS, ConfigStore
from housefly.twin.contracts import DroneCamera
from housefly.wires.ardrone.config import DEFAULT_ID, MulticonfigIds, config_id, parse_dump
from housefly.wires.ardrone.config_keys import CONFIG_KEYS, Access

OWN = MulticonfigIds(config_id("session"), config_id("user"), config_id("application"))


def logged_in() -> ConfigStore:
    store = ConfigStore()
    assert store.write("custom:session_id", OWN.session, OWN)
    assert store.write("custom:profile_id", OWN.user, OWN)
    assert store.write("custom:application_id", OWN.application, OWN)
    return store


def test_a_new_drone_has_the_real_drones_limits():
    limits = ConfigStore().limits
    assert limits.tilt == pytest.approx(0.20943952)
    assert (limits.climb, limits.altitude) == (0.7, 3.0)
    assert limits.yaw_rate == pytest.approx(1.7453293)


@given(
    st.text(max_size=30),
    st.text(max_size=30),
    st.none() | st.builds(MulticonfigIds, st.text(max_size=9), st.text(), st.text()),
)
def test_no_write_raises_and_the_dump_stays_readable(name, text, ids):
    store = ConfigStore()
    store.write(name, text, ids)
    assert parse_dump(store.describe()).rejects == ()


@given(st.sampled_from(CONFIG_KEYS), st.text(max_size=30))
def test_a_known_key_with_any_text_keeps_the_dump_readable(key, text):
    store = logged_in()
    store.write(key.name, text, OWN)
    dump = parse_dump(store.describe())
    assert dump.rejects == ()
    assert set(dump.texts) == {key.name for key in CONFIG_KEYS}


@given(st.sampled_from([key for key in CONFIG_KEYS if key.access is Access.NO]))
def test_a_read_only_key_is_never_written(key):
    store = logged_in()
    before = store.describe()
    assert not store.write(key.name, key.default, OWN)
    assert store.describe() == before


@given(st.sampled_from([key for key in CONFIG_KEYS if key.access is Access.IDS]))
def test_keys_that_need_ids_are_written_only_with_them(key):
    value = "7"
    assert not ConfigStore().write(key.name, value, None)
    assert not ConfigStore().write(key.name, value, MulticonfigIds())
    assert not logged_in().write(key.name, value, None)
    store = logged_in()
    assert store.write(key.name, value, OWN)
    assert store.value(key.name) == 7


def test_ids_that_are_not_in_force_spoil_a_write():
    store = logged_in()
    assert not store.write(
        "control:control_vz_max", "500", OWN._replace(session=config_id("other"))
    )
    assert store.write("control:control_vz_max", "500", OWN)
    assert store.limits.climb == 0.5


def test_custom_values_belong_to_their_user_and_come_back_with_him():
    store = logged_in()
    assert store.write("control:euler_angle_max", "0.1", OWN)
    store.write("custom:profile_id", DEFAULT_ID, None)
    assert store.limits.tilt == pytest.approx(0.20943952)
    store.write("custom:profile_id", OWN.user, None)
    assert store.limits.tilt == 0.1


def test_deleting_all_sessions_returns_to_the_default_one():
    store = logged_in()
    store.write("video:video_channel", "1", OWN)
    assert store.camera is DroneCamera.BOTTOM
    assert store.write("custom:session_id", "-all", None)
    assert store.ids.session == DEFAULT_ID
    assert store.camera is DroneCamera.FRONT


def test_ids_are_eight_hexadecimal_digits_and_do_not_pile_up():
    store = ConfigStore()
    assert not store.write("custom:session_id", "house", None)
    counted = [
        store.write("custom:session_id", f"{number:08x}", None)
        for number in range(1, 2 * MAX_CUSTOM_CONFIGS)
    ]
    assert counted == [number < MAX_CUSTOM_CONFIGS for number in range(1, 2 * MAX_CUSTOM_CONFIGS)]


def test_outdoor_switches_the_set_of_limits():
    store = ConfigStore()
    store.write("control:outdoor", "TRUE", None)
    assert store.limits.tilt == pytest.approx(0.34906584)
    assert store.limits.climb == 1.0
    store.write("control:control_vz_max", "900", None)
    store.write("control:outdoor", "FALSE", None)
    assert store.limits.climb == 0.7
    store.write("control:outdoor", "TRUE", None)
    assert store.limits.climb == 0.9


def test_writing_the_set_in_force_changes_the_live_limit_and_the_other_set_waits():
    store = ConfigStore()
    store.write("control:indoor_control_yaw", "1.0", None)
    store.write("control:outdoor_control_yaw", "5.0", None)
    assert store.limits.yaw_rate == 1.0


@given(st.floats(allow_nan=False, allow_infinity=False, width=32))
def test_limits_stay_between_zero_and_what_the_firmware_follows(value):
    store = ConfigStore()
    for name in ("euler_angle_max", "control_vz_max", "control_yaw"):
        store.write(f"control:{name}", f"{value:.6f}", None)
    limits = store.limits
    assert 0.0 <= limits.tilt <= 0.52
    assert 0.0 <= limits.climb <= 2.0
    assert 0.0 <= limits.yaw_rate <= 6.11


@pytest.mark.parametrize(("written", "silence"), [("1", 1.0), ("5", 5.0), ("0", 1.0), ("-3", 1.0)])
def test_the_watchdog_of_the_link_is_set_in_whole_seconds_from_one_on(written, silence):
    store = ConfigStore()
    assert store.limits.silence == 2.0
    assert store.write("general:com_watchdog", written, None)
    assert store.limits.silence == silence


def test_the_channel_after_the_last_is_the_first():
    store = ConfigStore()
    store.write("video:video_channel", "4", None)
    assert store.camera is DroneCamera.BOTTOM
    store.write("video:video_channel", "4", None)
    assert store.camera is DroneCamera.FRONT


def test_the_custom_list_names_ids_with_their_descriptions():
    store = logged_in()
    store.write("custom:application_desc", "housefly", OWN)
    text = store.describe(customs=True)
    assert text.endswith(b"\0")
    assert f"{OWN.application},housefly\r".encode() in text
    assert text.index(b"[applis]") < text.index(b"[profiles]") < text.index(b"[sessions]")


def test_only_writes_that_counted_are_told():
    told: list[str] = []
    store = ConfigStore(told.append)
    store.write("control:altitude_max", "2000", None)
    store.write("control:altitude_max", "high", None)
    store.write("general:drone_serial", "1", None)
    assert told == ["control:altitude_max"]


@pytest.mark.parametrize(
    ("name", "written", "read"),
    [
        ("general:navdata_demo", "true", True),
        ("GENERAL:Navdata_Demo", "True", True),
        ("control:outdoor", "f", False),
        ("control:altitude_max", "2500.0", 2500),
        ("Control:altitude_max", " 1500 mm", 1500),
    ],
)
def test_a_value_is_read_as_the_makers_parser_reads_it(name, written, read):
    store = ConfigStore()
    assert store.write(name, written, None)
    assert store.value(name.lower()) == read
