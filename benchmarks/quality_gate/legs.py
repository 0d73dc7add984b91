"""The legs of one flight of the gate: errands, a service, a figure eight, a landing."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import hypot, inf

import numpy as np

from housefly.geometry import Vec2
from housefly.messages import Order, OrderKind, Phase
from housefly.numeric import FloatArray
from housefly.pilot.planning.space.oriented_hull import OrientedHull
from housefly.record.truth import HOME_RADIUS
from housefly.sites.loaded_site import LoadedSite
from quality_gate.flown_row import FlownLeg, drawn
from quality_gate.leg_measures import WANTED, leg_measures
from quality_gate.quality_flight import SENDER, QualityFlight
from quality_gate.scenario import FlightKind, Scenario
from quality_gate.time_bound import shortest_time

_LOOK_ON = 1.5
"""So long after an arrival the drone is watched for overshooting [s]."""
_GIVE_UP, _GIVE_UP_MORE = 4.0, 30.0
"""A leg is given up after this multiple of its least time, plus so many seconds."""
_LANDING_PATIENCE, _SERVICE_PATIENCE = 40.0, 120.0
_OFF_GOAL = 0.25
"""A drone that ends farther from its goal has not arrived [m]."""
_SERVICE_PLACE, _SERVICE_LOOK = "entrance", 3.0


@dataclass(frozen=True, slots=True)
class FlightStage:
    """What all legs of a flight share.

    Attributes:
        scenario: the row.
        loaded: the site.
        yardstick: the site as the grid planner sees it; it tells how long a leg may take.
        flight: the drone.
        solids: rows of the room's solids.
        hull: of the drone.
        line: that it should keep to, shape (n, 2) [m]; None for what its reference draws.
        errands_max: no more than this; None for all.
    """

    scenario: Scenario
    loaded: LoadedSite
    yardstick: LoadedSite
    flight: QualityFlight
    solids: FloatArray
    hull: OrientedHull
    line: FloatArray | None = None
    errands_max: int | None = None


def legs_of(stage: FlightStage) -> Iterator[FlownLeg]:
    """Fly a row's legs, one after the other; none when the drone does not come to hover."""
    return _LEGS[stage.scenario.kind](stage)


def _errands(stage: FlightStage) -> Iterator[FlownLeg]:
    goals = stage.scenario.goals[: stage.errands_max]
    if not stage.flight.rise():
        return
    for start, goal in pairwise((stage.loaded.room.home, *goals)):
        path = stage.yardstick.plan(goal, start).path
        length = hypot(goal[0] - start[0], goal[1] - start[1]) if path is None else path.length
        yield _leg(stage, goal, length)


def _eight(stage: FlightStage) -> Iterator[FlownLeg]:
    """Fly the line from where the drone hovers, wherever it is sent."""
    assert stage.line is not None
    if stage.flight.rise():
        x, y = stage.line[0].tolist()
        yield _leg(stage, (x, y), float(np.hypot(*np.diff(stage.line, axis=0).T).sum()))


def _landing(stage: FlightStage) -> Iterator[FlownLeg]:
    flight = stage.flight
    if not flight.rise():
        return
    first = len(flight.track.rows)
    flight.tick(Order(OrderKind.HOME, sender=SENDER))
    outcome = flight.until(Phase.IDLE, _LANDING_PATIENCE, Phase.OUTBOUND)
    yield _measured(stage, first, set(), stage.loaded.room.home, 0.0, outcome)


def _service(stage: FlightStage) -> Iterator[FlownLeg]:
    """Fly the paper's service: first the way to the visitor, then the whole."""
    flight, room = stage.flight, stage.loaded.room
    goal = room.place(_SERVICE_PLACE).viewpoint
    flight.wait(_SETTLING)
    first = len(flight.track.rows)
    flight.tick(Order(OrderKind.SERVICE, _SERVICE_PLACE, look_s=_SERVICE_LOOK, sender=SENDER))
    outcome = flight.until(Phase.OUTBOUND, _LANDING_PATIENCE)
    flight.begin_weather()
    out = len(flight.track.rows)
    outcome = outcome or flight.until(Phase.LOOKING, _SERVICE_PATIENCE, Phase.IDLE, Phase.LANDING)
    path = stage.yardstick.plan(goal).path
    length = 1.0 if path is None else path.length
    yield _measured(stage, out, set(), goal, length, outcome, watch=True)
    outcome = outcome or flight.until(Phase.IDLE, _SERVICE_PATIENCE, Phase.HOLDING)
    yield _measured(stage, first, set(), room.home, 0.0, outcome)


def _leg(stage: FlightStage, goal: Vec2, length: float) -> FlownLeg:
    """Fly one errand from a hover; ``length`` is about that of its way [m]."""
    flight = stage.flight
    first, touched = len(flight.track.rows), set(flight.contacts)
    flight.tick(Order(OrderKind.GO, goal=goal, sender=SENDER))
    patience = _GIVE_UP * _least(stage.loaded, length) + _GIVE_UP_MORE
    outcome = flight.refusal or flight.until(Phase.HOLDING, patience)
    return _measured(stage, first, touched, goal, length, outcome, watch=True)


def _measured(
    stage: FlightStage,
    first: int,
    touched: set[str],
    goal: Vec2,
    length: float,
    outcome: str,
    *,
    watch: bool = False,
) -> FlownLeg:
    """Return the leg that began with a row of the track and ends now.

    Args:
        stage: of the flight.
        first: number of its first row.
        touched: what had been touched before.
        goal: [m].
        length: about that of its way [m]; 0 for one that ends on the floor.
        outcome: what went wrong, or "".
        watch: look on for a while, for overshooting.
    """
    flight = stage.flight
    told_at = inf if outcome else flight.now
    last = len(flight.track.rows)
    if watch:
        flight.wait(_LOOK_ON)
    course = flight.track.part(first)
    measures = leg_measures(course, told_at, goal, stage.solids, stage.hull, _line(stage))
    new = set(flight.contacts) - touched
    if new:
        outcome = f"touched {', '.join(sorted(new))}"
    elif not outcome and measures.off_goal > (_OFF_GOAL if length else HOME_RADIUS):
        outcome = f"{measures.off_goal:.2f} m off its goal"
    if length and not outcome:
        length = _reference_length(course[: last - first])
    bound = _least(stage.loaded, length) if length else 0.0
    return FlownLeg(goal, bound, measures, outcome, drawn(course))


def _reference_length(course: FloatArray) -> float:
    """Return the length of the way that the reference went [m]."""
    wanted = course[:, WANTED][~np.isnan(course[:, 7])]
    return max(0.01, float(np.linalg.norm(np.diff(wanted, axis=0), axis=1).sum()))


def _line(stage: FlightStage) -> FloatArray | None:
    """Return the line to keep to, in space; coarse enough to look along quickly."""
    if stage.line is None:
        return None
    some = stage.line[::40]
    return np.hstack((some, np.full((len(some), 1), stage.loaded.site.map.flight_height)))


def _least(loaded: LoadedSite, length: float) -> float:
    limits = loaded.site.limits
    return shortest_time(length, limits.speed, limits.tilt_max, loaded.site.drone.drag)


_SETTLING = 0.5
"""World time before a service is ordered, so that tracking and telemetry are there [s]."""
_LEGS: dict[FlightKind, Callable[[FlightStage], Iterator[FlownLeg]]] = {
    FlightKind.ERRANDS: _errands,
    FlightKind.SERVICE: _service,
    FlightKind.EIGHT: _eight,
    FlightKind.LANDING: _landing,
}
