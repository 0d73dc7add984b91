"""The batch and the twin are different drones: the twin has bodies, motors, sensors, an onboard
computer with its own estimates, and markers that eighteen cameras see or not. So only the size of
what is measured is compared, within a factor.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np
import pytest
from quick_flights import QUICK

from housefly.config.site import changed
from housefly.geometry import Vec2, distance
from housefly.lab.experiments.cases import cases
from housefly.lab.experiments.engine import fly_many
from housefly.lab.experiments.flight_plan import SETTLE, FlightPlan
from housefly.lab.experiments.planned_flight import planned_flight
from housefly.lab.lockstep.service import fly_lockstep
from housefly.messages import Order, OrderKind, Phase, PilotStep
from housefly.pilot.navigator import RoomNavigator
from housefly.sites.loaded_site import LoadedSite, open_site


def flown_on_the_twin(premises: LoadedSite) -> tuple[tuple[Vec2, ...], float, float]:
    """Fly the service to the entrance; return the path out, its duration [s] and the distance from
    it by tracking, as RMS [m].
    """
    steps: list[PilotStep] = []
    twin = open_site(changed(premises.site, **QUICK))
    fly_lockstep(twin, Order(OrderKind.GO, "entrance"), steps.append, give_up_after=40.0)
    assert steps[-1].outputs.phase is Phase.HOLDING
    out = [
        step
        for step in steps
        if step.outputs.phase is Phase.OUTBOUND and step.outputs.path and step.outputs.estimate
    ]
    path = out[0].outputs.path
    assert path is not None
    offs = [
        off_path(step.outputs.estimate.position[:2], path.waypoints)
        for step in out
        if step.outputs.estimate
    ]
    return path.waypoints, out[-1].now - out[0].now, float(np.sqrt(np.mean(np.square(offs))))


def off_path(here: Vec2, waypoints: tuple[Vec2, ...]) -> float:
    legs = []
    for (ax, ay), (bx, by) in pairwise(waypoints):
        share = ((here[0] - ax) * (bx - ax) + (here[1] - ay) * (by - ay)) / (
            (bx - ax) ** 2 + (by - ay) ** 2
        )
        share = min(max(share, 0.0), 1.0)
        legs.append(distance(here, (ax + share * (bx - ax), ay + share * (by - ay))))
    return min(legs)


@pytest.mark.parametrize(
    "way", ["space", *(pytest.param(way, marks=pytest.mark.interop) for way in ("grid", "paper"))]
)
def test_the_batch_flies_the_same_path_in_about_the_time_and_as_well_as_the_twin(
    way: str, premises_of: Callable[[str], LoadedSite]
) -> None:
    premises = premises_of(way)
    waypoints, duration, rms = flown_on_the_twin(premises)
    drones = cases(premises.site, 20, seed=np.arange(20), yaw_lag=25.0, climb_lag=1.4)
    mission = planned_flight(
        RoomNavigator(premises.site, premises.room, premises.grid),
        (*waypoints[0], premises.site.map.flight_height),
        premises.room.home_yaw,
        waypoints[-1],
        SETTLE + 2.0 * duration,
    )
    assert isinstance(mission, FlightPlan)
    flights = fly_many(drones, mission)
    assert flights["stable"].all()
    assert np.median(flights["arrival_time"]) == pytest.approx(duration, rel=0.35)
    assert 0.3 < np.median(flights["rms_error"]) / rms < 3.0
