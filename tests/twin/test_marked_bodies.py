"""People with markers: tracking sees those whom the site names, and the noise of others stays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from housefly.config.site import Site, changed
from housefly.room.model import Room
from housefly.twin.people.script import PersonScript
from housefly.twin.people.state import Posture
from housefly.twin.world import SimulatedWorld

MakeRoom = Callable[..., Room]
ANN = PersonScript(name="ann", height=1.65, steps=())
BEN = PersonScript(name="ben", height=1.8, steps=())


def bodies(world: SimulatedWorld) -> dict[str, Any]:
    world.advance(0.05)
    return dict(world.mocap_frames()[-1].bodies)


def test_only_people_whom_the_site_names_are_tracked(make_room: MakeRoom) -> None:
    site = changed(Site(), people__bodies=("ann", "carl"), twin__mocap_noise=0.0)
    world = SimulatedWorld(site, make_room(), people=(ANN, BEN))
    assert bodies(world)["ann"] is None
    world.put_person("ann", (5.0, 2.0), yaw=1.0)
    world.put_person("ben", (6.0, 2.0))
    seen = bodies(world)
    assert set(seen) == {"ardrone", "visitor", "ann"}
    assert seen["ann"].position == pytest.approx((5.0, 2.0, 0.0))
    assert seen["ann"].yaw == pytest.approx(1.0)


def test_the_cameras_lose_who_lies_out_of_their_sight(
    make_room: MakeRoom, ceiling_cameras: tuple[Any, ...]
) -> None:
    site = changed(Site(), people__bodies=("ann",))
    world = SimulatedWorld(site, make_room(cameras=ceiling_cameras), people=(ANN,))
    world.put_person("ann", (2.3, 2.6))
    assert bodies(world)["ann"] is not None
    world.put_person("ann", (8.0, 2.6), posture=Posture.LYING)
    assert bodies(world)["ann"] is None
