"""docs/homeassistant.md: its site file is one, and reads what Home Assistant's statestream says."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
import yaml

from housefly.config.homeassistant import HomeAssistantConfig
from housefly.config.site import Site, site_from_tree
from housefly.errors import UnknownState, WireError
from housefly.homeassistant.commands import YesOrNo, answer_command
from housefly.homeassistant.topics import HomeTopics
from housefly.wires.devices import Channel, Delivered, MeasuredTopic, decode_reading, parse_topic

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "homeassistant.md").read_text("utf-8")
TOML = re.findall(r"^```toml\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
YAML = re.findall(r"^```yaml\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)
NOW = 1_800_000_000.0


@pytest.fixture(scope="module")
def site() -> Site:
    return site_from_tree(tomllib.loads("\n".join(TOML)))


def test_the_site_file_on_the_page_is_one(site: Site) -> None:
    assert site.homeassistant.enabled and len(site.mqtt.sensors) == 3


@pytest.mark.parametrize(
    ("device", "payload", "facts"),
    [
        ("kitchen-window", b"on", {"open": True}),
        ("kitchen-window", b"off", {"open": False}),
        ("oven-probe", b"180.5", {"temperature_c": 180.5}),
        ("stove-switch", b"on", {"on": True}),
    ],
)
def test_the_statestream_of_home_assistant_is_read_as_it_is(
    site: Site, device: str, payload: bytes, facts: dict[str, object]
) -> None:
    topic = {row.id: MeasuredTopic(row, "home") for row in site.mqtt.sensors}[device]
    streamed = next(part for part in YAML if "mqtt_statestream" in part)
    names = yaml.safe_load(streamed)["mqtt_statestream"]
    entity = topic.state_topic.removeprefix(f"{names['base_topic']}/").removesuffix("/state")
    assert entity.replace("/", ".") in names["include"]["entities"]
    reading = topic.decode(Delivered(topic.address, Channel.STATE, payload, NOW))
    assert {name: value for name, value in reading.observations[0].facts if name != "kind"} == facts


@pytest.mark.parametrize("word", [b"unavailable", b"unknown"])
def test_what_home_assistant_does_not_know_ends_the_state_before_it(
    site: Site, word: bytes
) -> None:
    for row in site.mqtt.sensors:
        topic = MeasuredTopic(row, "home")
        try:
            reading = topic.decode(Delivered(topic.address, Channel.STATE, word, NOW))
        except (UnknownState, WireError):
            continue
        assert not any(seen.valid for seen in reading.observations)


def test_the_automations_publish_what_is_read_here() -> None:
    published = re.findall(r"topic: (\S+)\n\s+payload: (.*)", "\n".join(YAML))
    (answer, _), (bell, payload) = published
    assert answer == HomeTopics("bsen").answer_command
    address, channel = parse_topic(bell)
    told = Delivered(address, channel, yaml.safe_load(payload).encode(), NOW)
    assert [event.kind for event in decode_reading(told).events] == ["bell pressed"]
    assert answer_command(b"12|confirm|yes").choice is YesOrNo.YES


def test_every_key_is_on_the_page() -> None:
    for key in HomeAssistantConfig.model_fields.keys() - {"prefix"}:
        assert f"{key} =" in PAGE, key
