"""Rooms of some metres with boxes in them, for brute force."""

from __future__ import annotations

from functools import cache

from hypothesis import strategies as st

from housefly.config.site import Site
from housefly.room.grid import build_grid
from housefly.room.model import Room, Shape, Solid
from housefly.sites.loaded_site import load_site
from housefly.tasks.vantage.viewing_room import ViewingRoom

HOME = (0.9, 0.9)


@cache
def plain_site() -> Site:
    """Return a site whose rooms hold nothing but what they are made of."""
    return load_site("bsen", furniture=()).site


def viewing_room(size: tuple[float, float], *boxes: Solid) -> ViewingRoom:
    """Return a room of a length and a width [m] without walls inside, home in its corner."""
    room = Room("small", (0.0, 0.0, *size), 2.5, boxes, (), (), HOME)
    return ViewingRoom(plain_site(), room, build_grid(room, plain_site()))


def box(name: str, x: float, y: float, width: float, top: float) -> Solid:
    """Return a square box that stands on the floor [m]."""
    return Solid(name, name, Shape.BOX, (x, y, top / 2), (width, width, top))


small_viewing_rooms = st.builds(
    lambda size, first, second: viewing_room(
        size, box("table one", *first), box("table two", *second)
    ),
    st.tuples(st.floats(3.0, 4.4), st.floats(3.0, 4.4)),
    st.tuples(st.floats(1.6, 2.4), st.floats(0.2, 2.4), st.floats(0.2, 0.6), st.floats(0.35, 1.4)),
    st.tuples(st.floats(0.2, 2.4), st.floats(1.7, 2.4), st.floats(0.2, 0.6), st.floats(0.35, 1.4)),
)
