"""A patrol's viewpoints see the floor, each adds something, and all can be flown to."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from housefly.geometry import distance
from housefly.room.coverage import seen_by
from housefly.sites.loaded_site import load_site
from housefly.tasks.vantage.patrol import floor_share, patrol_viewpoints
from housefly.tasks.vantage.viewing_room import ViewingRoom


def test_seven_viewpoints_see_most_of_the_floor_that_can_be_seen() -> None:
    loaded = load_site("bsen")
    viewing = ViewingRoom(loaded.site, loaded.room, loaded.grid)
    views = patrol_viewpoints(viewing)
    assert 3 <= len(views) <= 8
    assert floor_share(views, viewing) > 0.85
    shares = [floor_share(views[:n], viewing) for n in range(len(views) + 1)]
    assert all(after > before for before, after in pairwise(shares))
    for view in views:
        assert loaded.plan(view.position).path is not None
        place = np.array([[*view.position, loaded.site.map.flight_height]])
        assert seen_by(loaded.room, place).sum() >= 2


def test_the_round_is_not_longer_than_going_back_and_forth() -> None:
    loaded = load_site("bsen")
    viewing = ViewingRoom(loaded.site, loaded.room, loaded.grid)
    home = loaded.room.home
    stops = [home, *(view.position for view in patrol_viewpoints(viewing)), home]
    around = sum(distance(a, b) for a, b in pairwise(stops))
    star = sum(2.0 * distance(home, stop) for stop in stops)
    assert around < 0.8 * star


def test_fewer_viewpoints_are_the_best_of_all() -> None:
    loaded = load_site("bsen")
    viewing = ViewingRoom(loaded.site, loaded.room, loaded.grid)
    two, most = patrol_viewpoints(viewing, most=2), patrol_viewpoints(viewing)
    assert len(two) == 2
    assert floor_share(two, viewing) > max(floor_share([view], viewing) for view in most)
