"""A load and a draught in the simulated room, scored on the truth, with and without what the pilot
estimates in flight.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import dist

import pytest

from housefly.lab.lockstep.simulation import SETTLING_TIME, Simulation
from housefly.messages import DroneStatus, Order, OrderKind
from housefly.sites.loaded_site import load_site
from housefly.twin.disturbance import NEUTRAL, Disturbances, Payload
from housefly.twin.quadrotor.body import DRONE_MASS

AS_ONCE = {
    "estimation__disturbance_wander": 0.2,
    "estimation__lift_wander": 0.0,
    "estimation__delay_deviation": 0.0,
    "estimation__aims_upwind": False,
    "limits__climb_command_max": 0.0,
    "limits__landing_height": 0.45,
    "limits__landing_lead": 0.0,
}
"""Nothing but a slow push in the plane is found in flight."""
LOADED_AT, UNLOADED_AT, HOME_AT, GIVE_UP = 2.0, 8.0, 10.5, 20.0
DRAUGHT = Disturbances(wind=(0.0, 1.0, 0.0))


@dataclass
class PushedFlight:
    """What the truth says of a drone that holds its place, is loaded, blown at, and lands."""

    height_error: float = 0.0
    landing_error: float = 0.0
    codes: frozenset[str] = frozenset()


def pushed_flight(load: float, **changes: object) -> PushedFlight:
    """Hold 5 s under a load, a share of the weight; unload, land in a draught of 1 m/s."""
    loaded = load_site("bsen", hub__enabled=False, twin__video=False, **changes)
    loop, home = Simulation(loaded), loaded.room.home
    height, codes, flight = loaded.site.map.flight_height, set(), PushedFlight()
    loaded_down = Disturbances(payload=Payload(load * DRONE_MASS))
    hovers = False
    orders = [(1.0, OrderKind.HOVER), (HOME_AT, OrderKind.HOME)]
    while loop.now < GIVE_UP:
        if loop.now < SETTLING_TIME:
            loop.world.put_drone((*home, height), loaded.room.home_yaw)
        elif not hovers:
            loop.world.hover_drone((*home, height), loaded.room.home_yaw)
            hovers = True
        loop.advance()
        now = loop.now
        is_loaded = LOADED_AT <= now < UNLOADED_AT
        loop.world.disturb(loaded_down if is_loaded else DRAUGHT if now >= UNLOADED_AT else NEUTRAL)
        due = orders and now >= orders[0][0]
        given = (Order(orders.pop(0)[1], issued_at=now),) if due else ()
        step = loop.step(loop.inputs(*given))
        codes |= {event.code for event in step.outputs.events if now >= LOADED_AT}
        x, y, z = loop.world.truth().pose.position
        if LOADED_AT + 5.0 <= now < UNLOADED_AT:
            flight.height_error = max(flight.height_error, abs(z - height))
        report = step.inputs.telemetry
        if now > HOME_AT and report is not None and report.status is DroneStatus.LANDED:
            break
    flight.landing_error, flight.codes = dist((x, y), home), frozenset(codes)
    return flight


def test_a_load_is_carried_and_a_landing_in_a_draught_is_met() -> None:
    flight = pushed_flight(0.1)
    assert flight.height_error < 0.03
    assert flight.landing_error < 0.1
    assert "grounded" in flight.codes
    assert not flight.codes & {"height_off", "height_error", "blown_about", "drifting"}


@pytest.mark.safety
def test_without_it_the_drone_hangs_low_and_lands_beside() -> None:
    flight = pushed_flight(0.05, **AS_ONCE)
    assert flight.height_error > 0.25
    assert flight.landing_error > 0.12
    assert "height_off" in flight.codes
