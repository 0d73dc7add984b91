"""What makes the demo lively is added to a site; what the site has of its own stays."""

from __future__ import annotations

from argparse import Namespace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from housefly.app.commands.shared import load
from housefly.hub.things_of_room import catalogue_of
from housefly.sites.loaded_site import load_site, read_site
from housefly.twin.demo_site import demo_changes, demo_site
from housefly.twin.people import Act, load_scene

_OWN = """
name = "Own"
[hub]
things = "my_things.toml"
[mqtt]
broker = "127.0.0.9"
[[mqtt.tags]]
tag = "E200-0001"
thing = "my-mug"
[[lasers]]
name = "mine"
x = 5.0
y = 1.0
z = 0.85
"""
_THINGS = """
[[thing]]
id = "keys"
name = "my keys"
position = [1.0, 4.0, 0.9]
[[thing]]
id = "cup"
name = "grandma's cup"
"""


@pytest.fixture
def own(tmp_path: Path) -> Path:
    """A site with things, a tag, a broker and a scanner of its own."""
    (tmp_path / "own.toml").write_text(_OWN)
    (tmp_path / "my_things.toml").write_text(_THINGS)
    return tmp_path / "own.toml"


def test_every_scanner_hangs_in_the_room_above_beds_and_chairs_and_below_the_drone() -> None:
    loaded = load_site("bsen", **demo_changes())
    x_min, y_min, x_max, y_max = loaded.room.bounds
    assert len(loaded.site.lasers) == len(demo_changes()["lasers"]) > 0
    for laser in loaded.site.lasers:
        assert x_min < laser.x < x_max and y_min < laser.y < y_max
        assert 0.8 < laser.z < loaded.site.map.flight_height


def test_somebody_lives_there_and_the_broker_is_its_own() -> None:
    site, words = demo_site(read_site("bsen"), has_broker=True)
    assert site.twin.scene == "demo"
    assert site.mqtt.start and site.mqtt.broker == "127.0.0.1"
    assert load_site("bsen").site.twin.scene == ""
    assert "added people, their things" in words and "own" not in words


def test_a_site_keeps_its_own_and_is_told_what_was_added(own: Path, capsys: Any) -> None:
    loaded = load(Namespace(site=str(own), mode=None, lively=True))
    told = " ".join(capsys.readouterr().out.split())
    things = {one.id: one.name for one in catalogue_of(loaded.site, loaded.room, own.parent)}
    assert things["keys"] == "my keys" and things["cup"] == "grandma's cup"
    assert things["person-1"] == "the resident"
    assert [laser.name for laser in loaded.site.lasers] == ["mine"]
    assert (loaded.site.mqtt.broker, loaded.site.mqtt.start) == ("127.0.0.9", False)
    tags = {row.tag: row.thing for row in loaded.site.mqtt.tags}
    assert tags["E200-0001"] == "my-mug" and tags["E200-0002"] == "tea-bottle"
    assert "added people, their things" in told
    for kept in ("the broker 127.0.0.9", "the scanners mine", "my_things.toml"):
        assert kept in told


def test_a_scene_of_its_own_stays(own: Path) -> None:
    (own.parent / "scene.toml").write_text('name = "Nobody"\n')
    own.write_text('[twin]\nscene = "scene.toml"\n')
    site, words = demo_site(read_site(str(own)), has_broker=True)
    assert site.twin.scene.endswith("scene.toml") and "scene.toml" in words


def test_another_room_stays_empty_and_is_told_what_to_do(own: Path) -> None:
    own.write_text('[room]\nmodel = "cellar"\n')
    site, words = demo_site(read_site(str(own)), has_broker=True)
    assert site == read_site(str(own))
    assert "'bsen'" in words and "'cellar'" in words and "[twin] scene" in words


def test_a_site_with_real_hardware_stays_as_it_is(own: Path) -> None:
    own.write_text("[twin]\nenabled = false\n[drone]\naddress = '192.168.1.1'\n")
    site, words = demo_site(read_site(str(own)), has_broker=True)
    assert site == read_site(str(own)) and "this room is real" in words


def test_without_mosquitto_people_are_there_and_the_words_say_what_is_not() -> None:
    site, words = demo_site(read_site("bsen"), has_broker=False)
    assert site.twin.scene == "demo" and site.lasers and not site.mqtt.broker
    assert "mosquitto is not installed" in words and "webhook" in words


def test_the_visitor_of_the_demo_comes_only_when_the_bell_is_pressed() -> None:
    scene = load_scene("demo")
    there = {one.name for k in range(60) for one in scene.at(5.0 * k).people if one.present}
    assert there == {"person-1", "person-2"}
    assert not [event for event in scene.between(0.0, 300.0) if event.act is Act.PRESS]


def test_nobody_of_the_demo_walks_where_the_drone_flies_to_the_entrance() -> None:
    loaded = load_site("bsen")
    path = loaded.plan("entrance").path
    assert path is not None
    way = np.array(path.waypoints)
    points = np.concatenate([np.linspace(a, b, 50) for a, b in pairwise(way)])
    scene = load_scene("demo")
    people = [
        person.position
        for k in range(600)
        for person in scene.at(0.25 * k).people
        if person.present
    ]
    nearest = min(np.hypot(*(points - np.array(at)).T).min() for at in people)
    assert nearest > 1.0
