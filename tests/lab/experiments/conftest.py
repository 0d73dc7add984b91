"""The live pilot on the inputs of a flight of the batch: what it saw, when it saw it, and the word
of a drone that flies.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import pytest

from housefly.app.loaded_site import LoadedSite, open_site, read_site
from housefly.config.site import Site, changed
from housefly.geometry import Vec2, quaternion_from_euler
from housefly.lab.experiments.cases import Cases, cases
from housefly.lab.experiments.engine import fly_recorded
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.messages import (
    Action,
    DroneStatus,
    Inputs,
    Order,
    OrderKind,
    Outputs,
    Pose,
    Sighting,
    Telemetry,
)
from housefly.pilot.assembly import make_pilot
from housefly.pilot.behavior.acceptor import STATES
from housefly.pilot.navigator import RoomNavigator
from housefly.pilot.safety.rules import MODE_SEVERITY

SETTLE = 0.3
"""The drone is found in the air and waits so long before it is ordered to go [s]."""
SIGNALS = ("cmd_theta", "cmd_phi", "cmd_vz", "cmd_yaw_rate")
ESTIMATES = ("est_x", "est_y", "est_z", "est_vx", "est_vy", "est_vz", "est_psi", "pose_age")
REFERENCES = ("ref_x", "ref_y", "ref_vx", "ref_vy", "ref_psi")


@dataclass(frozen=True, slots=True, eq=False)
class Twins:
    """One flight twice: the batch's trace, and the live pilot's answers to the same inputs, one row
    a tick.
    """

    batch: Any
    live: Any

    def apart(self, names: tuple[str, ...]) -> float:
        """Return the largest difference in any of these columns."""
        return max(float(np.max(np.abs(self.batch[name] - self.live[name]))) for name in names)


FlyBoth = Callable[..., Twins]


def path_to(premises: LoadedSite, site: Site, start: Vec2, goal: Vec2) -> tuple[Vec2, ...]:
    """Return the waypoints that the live pilot would plan."""
    answer = RoomNavigator(site, premises.room, premises.grid).route(start, goal)
    assert answer.path is not None, answer.reason
    return answer.path.waypoints


def fly_both(
    premises: LoadedSite, drone: Cases, waypoints: tuple[Vec2, ...], goal: Vec2, duration: float
) -> Twins:
    """Fly one case along a path, and let a live pilot that is ordered to the goal answer to what
    was seen.
    """
    batch, seen = fly_recorded(drone, FlightPlan(Task.PATH, waypoints, duration, settle=SETTLE))
    pilot = make_pilot(premises.site, premises.room, premises.grid)
    live = np.zeros_like(batch)
    was_seen, ordered = False, False
    for tick, now in enumerate(batch["t"].tolist()):
        sightings = tuple(_sighting(premises.site, row) for row in seen[seen["tick"] == tick])
        was_seen = was_seen or bool(sightings)
        orders: tuple[Order, ...] = ()
        if not ordered and now >= SETTLE - 1e-9:
            ordered, orders = True, (Order(OrderKind.GO, goal=goal, issued_at=now),)
        telemetry = Telemetry(now, DroneStatus.FLYING, 1.0) if was_seen else None
        outputs = pilot.step(now, Inputs(sightings, telemetry, orders))
        _write(live[tick], outputs)
        assert not ordered or (outputs.path is not None and outputs.path.waypoints == waypoints)
    first = int(seen["tick"][0])
    return Twins(batch[first:], live[first:])


@cache
def premises_of(mode: str) -> LoadedSite:
    """The real room B-sen with the map of a mode."""
    return open_site(changed(read_site("bsen"), mode=mode))


@pytest.fixture
def fly_twice() -> FlyBoth:
    """Return a maker of twins: ``fly_twice("paper", mocap_rate_hz=10.0)`` flies from the pad to the
    entrance of B-sen.
    """

    def make(mode: str, site: Site | None = None, **columns: float) -> Twins:
        premises = premises_of(mode)
        goal = premises.room.place("entrance").viewpoint
        waypoints = path_to(premises, premises.site, premises.room.home, goal)
        return fly_both(
            premises, cases(site or premises.site, 1, seed=7, **columns), waypoints, goal, 40.0
        )

    return make


def _sighting(site: Site, row: Any) -> Sighting:
    pose = Pose(
        (float(row["x"]), float(row["y"]), float(row["z"])),
        quaternion_from_euler(0.0, 0.0, float(row["yaw"])),
    )
    return Sighting(site.tracking.body, pose, float(row["captured_at"]), float(row["received_at"]))


def _write(row: Any, outputs: Outputs) -> None:
    setpoint, estimate, reference = outputs.command.setpoint, outputs.estimate, outputs.reference
    row["flying"] = outputs.command.action is Action.FLY
    row["behavior"], row["safety"] = STATES.index(outputs.behavior), MODE_SEVERITY[outputs.safety]
    for name, value in zip(
        SIGNALS, (setpoint.theta, setpoint.phi, setpoint.vz, setpoint.yaw_rate), strict=True
    ):
        row[name] = value
    if estimate is not None:
        numbers = (*estimate.position, *estimate.velocity, estimate.yaw, estimate.pose_age)
        for name, value in zip(ESTIMATES, numbers, strict=True):
            row[name] = value
    if reference is not None:
        wanted = (*reference.position[:2], *reference.velocity[:2], reference.yaw)
        for name, value in zip(REFERENCES, wanted, strict=True):
            row[name] = value
