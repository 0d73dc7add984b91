"""docs/devices.md tells what the tables know."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

from housefly.config.measured_devices import UNITS, MeasuredDeviceConfig
from housefly.config.site import site_from_tree
from housefly.wires.devices import KINDS, Delivered, decode_reading, parse_topic
from housefly.wires.devices.fields import RowsField
from housefly.wires.devices.words import CONTACT_ROWS, SWITCH_ROWS, MakerWords

PAGE = (Path(__file__).resolve().parents[3] / "docs" / "devices.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"^(housefly/\S+)\n(\{.*\})$", PAGE, flags=re.MULTILINE)


@pytest.mark.parametrize(("topic", "payload"), EXAMPLES)
def test_every_example_reads_and_has_no_unknown_key(topic: str, payload: str) -> None:
    address, channel = parse_topic(topic)
    reading = decode_reading(Delivered(address, channel, payload.encode(), 1_800_000_000.0))
    assert reading.unknown == ()
    assert reading.observations or reading.events


def test_every_kind_has_an_example_and_a_row_with_all_its_keys_and_its_heartbeat() -> None:
    assert {parse_topic(topic)[0].kind for topic, _ in EXAMPLES} == set(KINDS)
    for kind in KINDS.values():
        row = next(line for line in PAGE.splitlines() if line.startswith(f"| `{kind.name}` |"))
        assert f"| {kind.heartbeat:g} s |" in row
        for word in (*kind.state, *kind.events):
            assert f"`{word}`" in row, f"{kind.name}: {word}"
        inner = {
            key
            for field in kind.state.values()
            if isinstance(field, RowsField)
            for key in field.spec
        }
        assert all(f"`{key}`" in PAGE for key in inner)


def test_every_key_of_a_measuring_device_and_every_unit_is_on_the_page() -> None:
    assert all(f"`{key}`" in PAGE for key in MeasuredDeviceConfig.model_fields)
    assert all(f"`{unit}`" in PAGE for units in UNITS.values() for unit in units)


@pytest.mark.parametrize("rows", [SWITCH_ROWS, CONTACT_ROWS])
def test_the_words_of_every_maker_are_on_the_page(rows: tuple[MakerWords, ...]) -> None:
    for maker, yes, no in rows:
        cells = (", ".join(f"`{word}`" for word in words) for words in (yes, no))
        row = f"| {maker} | {' | '.join(cells)} |".replace("|  |", "| |")
        assert row in PAGE.replace(" (true is contact)", ""), row


def test_the_site_file_on_the_page_is_a_site_file() -> None:
    blocks = re.findall(r"```toml\n(.*?)```", PAGE, re.DOTALL)
    (sensors,) = (block for block in blocks if "[[mqtt.sensors]]" in block)
    site = site_from_tree(tomllib.loads(sensors))
    assert {row.kind for row in site.mqtt.sensors} >= {"power", "switch", "temperature"}
