"""The live pilot on the inputs of a flight of the batch: what it saw, when it saw it, and the word
of a drone that flies.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from math import cos, sin
from typing import Any

import numpy as np
import pytest
from made_up_drones import POSITION, VELOCITY, known_made_up_drones

from housefly.config.site import Site, changed
from housefly.geometry import Vec2, quaternion_from_euler
from housefly.lab.experiments.cases import Cases, cases
from housefly.lab.experiments.engine import fly_recorded
from housefly.lab.experiments.flight_plan import FlightPlan, Task
from housefly.lab.experiments.planned_flight import planned_flight
from housefly.messages import (
    Action,
    DroneStatus,
    Inputs,
    Order,
    OrderKind,
    Outputs,
    Pose,
    SafetyMode,
    Sighting,
    Telemetry,
)
from housefly.pilot.assembly import make_pilot
from housefly.pilot.behavior.acceptor import STATES
from housefly.pilot.navigator import RoomNavigator
from housefly.pilot.safety.rules import MODE_SEVERITY
from housefly.sites.loaded_site import LoadedSite, open_site, read_site

SETTLE = 0.3
"""The drone is found in the air and waits so long before it is ordered to go [s]."""
SIGNALS = ("cmd_theta", "cmd_phi", "cmd_vz", "cmd_yaw_rate")
ESTIMATES = ("est_x", "est_y", "est_z", "est_vx", "est_vy", "est_vz", "est_psi", "pose_age")
REFERENCES = ("ref_x", "ref_y", "ref_z", "ref_vx", "ref_vy", "ref_vz", "ref_psi")
SCREEN = {
    "kind": "keep_out",
    "polygon": ((7.0, -1.0), (7.5, -1.0), (7.5, 8.5), (7.0, 8.5)),
    "top": 1.5,
    "reason": "a screen across the room",
}
WAYS: dict[str, dict[str, Any]] = {
    "space": {},
    "over a screen": {"volumes": (SCREEN,), "limits__speed": 1.0},
    "grid": {"map__planner": "grid"},
    "paper": {"mode": "paper"},
    "by velocity": {"drone__kind": VELOCITY},
    "to places": {"drone__kind": POSITION},
}
"""What a pilot flies along, and the site that makes it."""


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


class Live:
    """A live pilot that sees what a drone of the batch was seen to do, and is ordered to a goal."""

    def __init__(self, premises: LoadedSite, goal: Vec2) -> None:
        self._site, self._goal = premises.site, goal
        self._pilot = make_pilot(premises.site, premises.room, premises.grid)
        # The batch has no monitors: what the drone tells is not held against tracking.
        settings = replace(self._pilot._settings, guarded=False)
        self._pilot._settings = settings
        self._seen = self._ordered = False

    def answers(self, ticks: Any, seen: Any, first: int = 0) -> Iterator[Outputs]:
        """Yield its answer to each tick from the first on."""
        for tick in range(first, len(ticks)):
            now = float(ticks["t"][tick])
            sightings = tuple(_sighting(self._site, row) for row in seen[seen["tick"] == tick])
            self._seen = self._seen or bool(sightings)
            orders: tuple[Order, ...] = ()
            if not self._ordered and now >= SETTLE - 1e-9:
                self._ordered = True
                orders = (Order(OrderKind.GO, goal=self._goal, issued_at=now),)
            telemetry = _told(ticks[tick], now) if self._seen else None
            yield self._pilot.step(now, Inputs(sightings, telemetry, orders))


def _told(row: Any, now: float) -> Telemetry:
    """Return a report with the true speed: a drone that tells none is held by our setpoint."""
    c, s = cos(row["psi"]), sin(row["psi"])
    ahead, left = c * row["vx"] + s * row["vy"], c * row["vy"] - s * row["vx"]
    velocity = (float(ahead), float(left), float(row["vz"]))
    return Telemetry(now, DroneStatus.FLYING, 1.0, velocity=velocity)


def fly_both(premises: LoadedSite, drone: Cases, goal: Vec2, duration: float) -> Twins:
    """Fly one case from the pad to a goal, and let a live pilot that is ordered there answer to
    what was seen.

    The way is planned from where the live pilot believes the drone at its order.
    """
    navigator = RoomNavigator(premises.site, premises.room, premises.grid)
    way, height = navigator.route(premises.room.home, goal).path, premises.site.map.flight_height
    assert way is not None
    start = way.waypoints[:1]
    waiting = FlightPlan(Task.PATH, start, SETTLE, height, settle=SETTLE)
    ticks, seen = fly_recorded(drone, waiting)
    pilot = Live(premises, goal)
    before = list(pilot.answers(ticks, seen))
    found = before[-1].estimate
    assert found is not None and before[-1].path is not None
    planned = planned_flight(navigator, found.position, found.yaw, goal, duration, settle=SETTLE)
    assert isinstance(planned, FlightPlan), planned
    assert planned.waypoints == before[-1].path.waypoints
    assert (planned.trajectory is not None) == navigator.in_space
    waypoints = (*start, *planned.waypoints[1:])
    planned = replace(planned, waypoints=waypoints, height=height, yaw=0.0)
    batch, seen = fly_recorded(drone, planned)
    assert batch[: len(ticks) - 1].tobytes() == ticks[:-1].tobytes()
    live = np.zeros_like(batch)
    for row, outputs in zip(live, (*before, *pilot.answers(batch, seen, len(before))), strict=True):
        _write(row, outputs)
    first = int(seen["tick"][0])
    return Twins(batch[first:], live[first:])


@pytest.fixture(autouse=True)
def made_up() -> Iterator[None]:
    with known_made_up_drones():
        yield


@cache
def _premises_of(way: str) -> LoadedSite:
    return open_site(changed(read_site("bsen"), **WAYS[way]))


@pytest.fixture
def premises_of() -> Callable[[str], LoadedSite]:
    """Return a maker of the real room B-sen with the map of a way of flying."""
    return _premises_of


@pytest.fixture
def fly_twice() -> FlyBoth:
    """Return a maker of twins: ``fly_twice("paper", mocap_rate_hz=10.0)`` flies from the pad to the
    entrance of B-sen.
    """

    def make(way: str, place: str = "entrance", seconds: float = 40.0, **columns: float) -> Twins:
        premises = _premises_of(way)
        goal = premises.room.place(place).viewpoint
        return fly_both(premises, cases(premises.site, 1, seed=7, **columns), goal, seconds)

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
    # The drone of the batch tells no velocity: what is only warned of is nothing to compare.
    is_warned = outputs.safety is SafetyMode.WARN
    safety = SafetyMode.NOMINAL if is_warned else outputs.safety
    row["behavior"], row["safety"] = STATES.index(outputs.behavior), MODE_SEVERITY[safety]
    for name, value in zip(
        SIGNALS, (setpoint.theta, setpoint.phi, setpoint.vz, setpoint.yaw_rate), strict=True
    ):
        row[name] = value
    if estimate is not None:
        numbers = (*estimate.position, *estimate.velocity, estimate.yaw, estimate.pose_age)
        for name, value in zip(ESTIMATES, numbers, strict=True):
            row[name] = value
    if reference is not None:
        wanted = (*reference.position, *reference.velocity, reference.yaw)
        for name, value in zip(REFERENCES, wanted, strict=True):
            row[name] = value
