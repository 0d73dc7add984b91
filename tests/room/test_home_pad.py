"""Each drone of a site has a pad; the room that it flies in has that as home."""

from __future__ import annotations

from typing import Any

import pytest

from housefly.config.site import Site, site_from_tree
from housefly.errors import ConfigError
from housefly.room.bsen import bsen
from housefly.room.edits import room_of
from housefly.twin.drone_stands import drone_stands


def site_with(pad: Any) -> Site:
    blue = {"name": "blue", "address": "127.0.0.2", "pad": pad}
    return site_from_tree({"drones": [{"name": "red"}, blue]})


def test_the_room_of_one_drone_has_its_pad_as_home_and_shows_those_of_all() -> None:
    site = site_with((4.0, 4.0, 0.5))
    red, blue = room_of(site.for_drone("red")), room_of(site.for_drone("blue"))
    assert (red.home, red.home_yaw) == (bsen().home, bsen().home_yaw)
    assert (blue.home, blue.home_yaw) == ((4.0, 4.0), 0.5)
    assert blue.place("home").viewpoint == (4.0, 4.0)
    assert red.place("home") == bsen().place("home") and room_of(Site()) == bsen()
    for room in (red, blue, room_of(site)):
        pads = {solid.position[:2] for solid in room.solids if solid.thing == "home pad"}
        assert pads == {bsen().home, (4.0, 4.0)}
        assert len({solid.name for solid in room.solids}) == len(room.solids)


def test_every_drone_stands_on_its_pad_in_the_room_of_whichever_drone() -> None:
    site = site_with((4.0, 4.0, 0.5))
    of_all = drone_stands(site, room_of(site))
    assert [stand.pad for stand in of_all] == [bsen().home, (4.0, 4.0)]
    for name in ("red", "blue"):
        own = site.for_drone(name)
        stands = drone_stands(own, room_of(own))
        assert [(one.pad, one.yaw) for one in stands] == [(one.pad, one.yaw) for one in of_all]


def test_a_pad_outside_the_room_or_beside_the_rooms_own_is_refused() -> None:
    with pytest.raises(ConfigError, match=r"'blue' .50, 4 m. lies outside the room; allowed: x"):
        room_of(site_with((50.0, 4.0, 0.0)))
    x, y = bsen().home
    with pytest.raises(ConfigError, match=r"'red' and 'blue' are 0\.50 m apart; allowed"):
        room_of(site_with((x + 0.5, y, 0.0)))
