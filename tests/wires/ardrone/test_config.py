"""Configuration keys, value formats and the dump."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from housefly.errors import WireError
from housefly.wires.ardrone import config
from housefly.wires.ardrone.config_keys import CONFIG_KEYS, Access, Category, ConfigKey, KeyType

CATEGORIES = {
    "common": Category.COMMON,
    "appli": Category.APPLICATION,
    "user": Category.USER,
    "session": Category.SESSION,
}
finite = st.floats(allow_nan=False, allow_infinity=False)
values = {
    KeyType.INT: st.integers(-(2**31), 2**31 - 1),
    KeyType.BOOL: st.booleans(),
    KeyType.FLOAT: finite,
    KeyType.DOUBLE: finite,
    KeyType.TEXT: st.text(st.characters(min_codepoint=33, max_codepoint=126), max_size=40),
    KeyType.PAIR: st.tuples(finite, finite),
    KeyType.VECTOR: st.tuples(finite, finite, finite),
    KeyType.MATRIX: st.tuples(*[finite] * 9),
}


def test_the_table_agrees_with_the_recorded_list_of_keys(shared_data: Path) -> None:
    with (shared_data / "ardrone" / "config_keys.tsv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    assert [row["key"] for row in rows] == [key.name for key in CONFIG_KEYS]
    for row, key in zip(rows, CONFIG_KEYS, strict=True):
        assert CATEGORIES[row["category"]] is key.category
        assert ("write" in row["rw"]) == (key.access in (Access.DEFAULT, Access.BOTH))
        assert ("write" in row["rw_in_custom_config"]) == (key.access in (Access.IDS, Access.BOTH))


def test_there_are_103_keys_and_eight_that_need_ids() -> None:
    assert len(config.KEYS_BY_NAME) == len(CONFIG_KEYS) == 103
    assert {key.name.removeprefix("video:") for key in CONFIG_KEYS if key.needs_ids} == {
        *("codec_fps", "video_codec", "video_slices", "video_live_socket"),
        *("bitrate", "max_bitrate", "bitrate_ctrl_mode", "bitrate_storage"),
    }


def test_values_are_written_as_the_drone_writes_them() -> None:
    def written(name: str, value: config.ConfigValue) -> str:
        return config.format_value(config.key_named(name), value)

    assert written("control:euler_angle_max", 0.20943952) == "2.0943952e-01"
    assert written("general:navdata_demo", True) == "TRUE"
    assert written("control:altitude_max", 3000) == "3000"
    assert (
        written("control:magneto_offset", (1.0, 2.0, 3.0))
        == "{ 1.0000000e+00 2.0000000e+00 3.0000000e+00 }"
    )


@given(st.data(), st.sampled_from(CONFIG_KEYS))
def test_every_value_is_read_back(data: st.DataObject, key: ConfigKey) -> None:
    value = data.draw(values[key.type])
    again = config.parse_value(key, config.format_value(key, value))
    assert again == (pytest.approx(value, rel=1e-6) if key.type in FLOATS else value)


FLOATS = {KeyType.FLOAT, KeyType.DOUBLE, KeyType.PAIR, KeyType.VECTOR, KeyType.MATRIX}


@given(
    st.sampled_from(CONFIG_KEYS),
    st.one_of(st.text(max_size=30), st.booleans(), st.integers(), finite, st.just((1.0,))),
)
def test_a_value_of_another_type_is_refused_with_the_key(
    key: ConfigKey, value: config.ConfigValue
) -> None:
    try:
        config.format_value(key, value)
    except WireError as error:
        assert key.name in str(error)


@given(st.sampled_from(CONFIG_KEYS), st.text(max_size=40))
def test_no_text_makes_the_value_parser_raise_anything_else(key: ConfigKey, text: str) -> None:
    try:
        config.parse_value(key, text)
    except WireError as error:
        assert key.name in str(error)


def test_the_dump_of_all_defaults_is_read_back() -> None:
    defaults = config.default_values()
    data = config.encode_dump(defaults)
    dump = config.parse_dump(data)
    assert data.endswith(b"\0") and data.count(b"\n") == 103
    assert dump.rejects == ()
    assert dump.values.keys() == defaults.keys()
    assert config.encode_dump(dump.values) == data


def test_defaults_are_parrots() -> None:
    defaults = config.default_values()
    assert defaults["control:control_yaw"] == pytest.approx(1.7453293)
    assert defaults["video:video_codec"] == config.VideoCodec.H264_360P
    assert defaults["general:navdata_demo"] is False


def test_bad_lines_of_a_dump_are_collected_and_unknown_keys_kept() -> None:
    dump = config.parse_dump(
        b"general:navdata_demo = TRUE\nnonsense\nnew:key = 7\ncontrol:altitude_max ="
        b" tall\n\0ignored"
    )
    assert dump.values == {"general:navdata_demo": True}
    assert dump.texts["new:key"] == "7"
    assert dump.rejects == ("nonsense", "control:altitude_max = tall")


@given(st.binary(max_size=500))
def test_no_bytes_make_the_dump_parser_raise_anything_else(data: bytes) -> None:
    config.parse_dump(data + b"\0")
    try:
        config.parse_dump(data)
    except WireError:
        assert b"\0" not in data


def test_a_dump_without_end_or_of_absurd_length_is_refused() -> None:
    with pytest.raises(WireError, match="NUL"):
        config.parse_dump(b"general:navdata_demo = TRUE\n")
    with pytest.raises(WireError, match="at most"):
        config.parse_dump(bytes(config.MAX_DUMP + 1))


def test_unknown_keys_are_named() -> None:
    with pytest.raises(WireError, match="general:nothing"):
        config.encode_dump({"general:nothing": 1})


def test_ids_are_eight_hex_digits() -> None:
    assert config.config_id("123456789") == "cbf43926"  # the check value of CRC-32
    assert config.is_config_id(config.config_id("housefly")) and config.is_config_id(
        config.DEFAULT_ID
    )
    assert not config.is_config_id("-all") and not config.is_config_id("CBF43926x")


def test_the_list_of_custom_configurations_has_three_sections() -> None:
    listing = config.encode_custom_list([("00000001", "app")], [("00000002", "me")], [])
    assert listing == b"[applis]\r00000001,app\r[profiles]\r00000002,me\r[sessions]\r\0"
