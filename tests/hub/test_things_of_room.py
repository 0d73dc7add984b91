"""What the room model already knows becomes things with ids, kinds and places."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from housefly.config.furniture import FurnitureConfig
from housefly.config.site import changed
from housefly.hub.things.thing import ThingKind
from housefly.hub.things.world_model import WorldModel
from housefly.hub.things_of_room import (
    catalogue_of,
    surfaces_of,
    things_of,
    things_of_scene,
)
from housefly.sites.loaded_site import open_site, read_site


def test_b_sen_brings_its_furniture_places_cameras_drone_and_visitor() -> None:
    loaded = open_site(read_site("bsen"))
    things = things_of(loaded.site, loaded.room)
    world = WorldModel(things)
    assert len(world.of_kind(ThingKind.SENSOR)) == 18
    assert {"sofa", "bed", "refrigerator"} <= {
        thing.id for thing in world.of_kind(ThingKind.FURNITURE)
    }
    assert world.find("drone").kind is ThingKind.ROBOT
    assert world.find("Entrance").viewpoints[0].position[2] == loaded.site.map.flight_height
    assert all(re.fullmatch(r"[a-z0-9][a-z0-9-]*", thing.id) for thing in things)
    assert len({thing.id for thing in things}) == len(things)


def test_tracked_furniture_is_the_thing_of_the_room_model_or_one_of_its_own() -> None:
    sofa = FurnitureConfig(name="the big sofa", body="Sofa 1", model="sofa", length=2.4, width=0.9)
    cart = FurnitureConfig(name="tea cart", body="Cart")
    loaded = open_site(read_site("bsen", furniture=(sofa, cart)))
    world = WorldModel(things_of(loaded.site, loaded.room))
    assert world.find("Sofa 1") == world.find("the big sofa") == world.thing("sofa")
    assert (world.find("Cart").id, world.find("Cart").name, world.find("Cart").kind) == (
        "tea-cart",
        "tea cart",
        ThingKind.FURNITURE,
    )


def test_what_a_sensor_of_the_site_file_tells_about_is_a_thing_with_a_name() -> None:
    loaded = open_site(read_site("bsen"))
    plug = {"id": "stove-plug", "kind": "power", "thing": "gas-stove", "state_topic": "a/b"}
    site = changed(loaded.site, mqtt__sensors=[plug])
    world = WorldModel(things_of(site, loaded.room))
    assert world.find("the gas stove").id == "gas-stove"


def test_a_scene_that_is_a_file_anywhere_brings_no_names() -> None:
    assert things_of_scene("bsen")
    assert things_of_scene("/somewhere/fall.toml") == () == things_of_scene("")


def test_tables_and_shelves_are_surfaces_and_walls_doors_and_legs_are_not() -> None:
    loaded = open_site(read_site("bsen"))
    surfaces = surfaces_of(loaded.room)
    things = {thing.id: thing for thing in things_of(loaded.site, loaded.room)}
    tops = {surface.thing for surface in surfaces}
    assert {"sofa-table", "kitchen", "work-desk", "meeting-table", "wall-shelf", "wagon"} <= tops
    assert {things[top].kind for top in tops} == {ThingKind.FURNITURE}
    assert {surface.thing for surface in surfaces if surface.seat} == {"chair", "sofa", "bed"}
    (table,) = [
        surface for surface in surfaces if surface.thing == "sofa-table" and surface.half[1] > 0.5
    ]
    assert table.top == pytest.approx(0.43, abs=0.02)
    assert table.distance((12.85, 2.20)) == 0.0


def test_a_scene_brings_its_things_and_those_of_the_site_count_first(tmp_path: Path) -> None:
    own = tmp_path / "own.toml"
    own.write_text('[[thing]]\nid = "cup"\nname = "my cup"\n[[thing]]\nid = "keys"\n')
    plain = open_site(read_site("bsen", hub__things=str(own)))
    lively = open_site(read_site("bsen", hub__things=str(own), twin__scene="bsen"))
    names = [
        {thing.id: thing.name for thing in catalogue_of(loaded.site, loaded.room, tmp_path)}
        for loaded in (plain, lively)
    ]
    assert names[0]["cup"] == names[1]["cup"] == "my cup"
    assert "keys" in names[1] and names[1]["person-1"] == "the resident"
    assert "person-1" not in names[0]
