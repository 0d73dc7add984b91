"""A pilot that falls silent or is gone, anywhere in a flight, in lock step, scored on the truth."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import hypot

import pytest

from housefly.lab.lockstep.lockstep_room import LockstepRoom
from housefly.messages import Inputs, Order, OrderKind, Telemetry
from housefly.pilot.assembly import make_pilot
from housefly.sites.loaded_site import LoadedSite, open_site, read_site
from housefly.twin.world import SimulatedWorld

STOPPING_DISTANCE_MAX = 0.6
"""From 0.5 m/s [m]."""
CRUISE, CORNERS = (8.5, 16.2), (6.2, 19.2, 20.4)
"""Moments on the way to the entrance [s]."""


@cache
def bsen() -> LoadedSite:
    return open_site(read_site("bsen"))


class WithoutFlow(LockstepRoom):
    """A drone that does not report its speed."""

    def telemetry(self) -> Telemetry:
        return replace(super().telemetry(), velocity=(0.0, 0.0, 0.0))


def way_to_rest(moment: float, *, gone: bool = False, flow: bool = True) -> float:
    """Fly until a moment, end the pilot, and return how far the drone goes before it rests [m]."""
    loaded = bsen()
    world = SimulatedWorld(loaded.site, loaded.room)
    room = (LockstepRoom if flow else WithoutFlow)(world, loaded.site)
    pilot = make_pilot(loaded.site, loaded.room, loaded.grid)
    given = False
    while room.now < moment:
        room.advance(0.01)
        orders: tuple[Order, ...] = ()
        if not given and room.now > 0.5:
            orders, given = (Order(OrderKind.GO, "entrance", issued_at=room.now),), True
        outputs = pilot.step(room.now, Inputs(room.sightings(), room.telemetry(), orders))
        room.send(outputs.command, pilot.known_motion)
    if gone:
        room._failsafe.abandon()
    (x, y, _), (vx, vy, _) = world.truth().pose.position, world.truth().velocity
    assert hypot(vx, vy) > 0.1, "nothing to brake"
    way = 0.0
    while room.now < moment + 1.9:
        room.advance(0.01)
        here = world.truth().pose.position
        way = max(way, hypot(here[0] - x, here[1] - y))
    assert hypot(*world.truth().velocity[:2]) < 0.08, "not at rest before it lands"
    return way


@pytest.mark.parametrize(
    "moment",
    [
        CORNERS[2],
        *(pytest.param(m, marks=pytest.mark.safety) for m in (*CRUISE, *CORNERS[:2])),
    ],
)
def test_a_drone_whose_pilot_falls_silent_is_soon_at_rest(moment: float) -> None:
    assert way_to_rest(moment) < STOPPING_DISTANCE_MAX


@pytest.mark.safety
def test_a_pilot_that_is_gone_costs_less_way_than_one_that_is_silent() -> None:
    assert way_to_rest(CRUISE[0], gone=True) < way_to_rest(CRUISE[0]) - 0.05


@pytest.mark.safety
@pytest.mark.parametrize("moment", [CRUISE[1], CORNERS[2]])
def test_without_a_report_of_its_speed_the_attitude_has_to_do(moment: float) -> None:
    assert way_to_rest(moment, flow=False) < STOPPING_DISTANCE_MAX
