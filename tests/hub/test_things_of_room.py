"""What the room model already knows becomes things with ids, kinds and places."""

from __future__ import annotations

import re

from housefly.app.loaded_site import open_site, read_site
from housefly.config.furniture import FurnitureConfig
from housefly.hub.things.thing import ThingKind
from housefly.hub.things.world_model import WorldModel
from housefly.hub.things_of_room import things_of


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
