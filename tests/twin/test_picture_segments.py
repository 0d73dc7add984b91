"""What the front camera shows, cast by rays: who is in it, how large, and through glass."""

from __future__ import annotations

from math import pi, tan

import pytest

from housefly.config.site import Site
from housefly.room.bsen import bsen
from housefly.room.model import Place, Room, Shape, Solid
from housefly.twin.quadrotor.body import FRONT_FIELD_OF_VIEW
from housefly.twin.world import SimulatedWorld


def world_with(*solids: Solid) -> SimulatedWorld:
    room = Room(
        "r",
        (-5.0, -5.0, 9.0, 5.0),
        2.5,
        solids,
        (Place("home", (0, 0), (1, 0, 1)),),
        (),
        (0.0, 0.0),
    )
    world = SimulatedWorld(Site(), room)
    world.put_drone((0.0, 0.0, 1.0), 0.0)
    return world


def board(name: str, x: float, edge: float, alpha: float = 1.0) -> Solid:
    return Solid(name, name, Shape.BOX, (x, 0.0, 1.0), (0.01, edge, edge), colour=(1, 1, 1, alpha))


def test_a_board_takes_the_share_of_the_picture_that_geometry_says() -> None:
    away = 3.0 - 0.005 - 0.21
    across = 2.0 * away * tan(FRONT_FIELD_OF_VIEW / 2)
    shown = world_with(board("board", 3.0, 1.0)).in_picture()
    assert shown["board"] == pytest.approx(1.0 / (across * across * 9 / 16), rel=0.1)


def test_what_is_behind_is_hidden_but_not_by_glass() -> None:
    assert "board" not in world_with(board("board", 3.0, 1.0), board("wall", 2.0, 4.0)).in_picture()
    shown = world_with(board("board", 3.0, 1.0), board("pane", 2.0, 4.0, 0.3)).in_picture()
    assert shown["board"] > 0.05 and "pane" not in shown


def test_what_is_beside_or_behind_the_drone_is_not_in_the_picture() -> None:
    world = world_with(board("board", -3.0, 1.0))
    assert world.in_picture() == {}
    world.put_drone((0.0, 0.0, 1.0), pi)
    assert world.in_picture()["board"] > 0.05


def test_the_visitor_is_in_the_picture_only_while_there() -> None:
    world = SimulatedWorld(Site(), bsen())
    world.put_drone((3.05, 4.25, 1.1), pi)
    assert world.in_picture()["visitor"] > 0.1
    world.set_visitor(False)
    assert "visitor" not in world.in_picture()
