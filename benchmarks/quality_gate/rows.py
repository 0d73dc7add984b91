"""The rows of the flight-quality gate: what is flown, and the limits that make it red.

The limits of trajectories in space (``Way.SPACE``) are the goals of the project; those of the grid
planner (``Way.GRID``) hold what it was measured to fly, so that it does not get worse.
"""

from __future__ import annotations

from dataclasses import replace

from housefly.twin.disturbance import Disturbances, Payload
from housefly.twin.quadrotor.body import DRONE_MASS
from quality_gate.errands import (
    BSEN_ERRANDS,
    DOOR_ERRANDS,
    SHORT_ERRANDS,
    SLALOM_ERRANDS,
    SMALL_HOUSE_ERRANDS,
    TABLE_ERRANDS,
)
from quality_gate.rooms import GateRoom
from quality_gate.scenario import ALL, BOTH, FlightKind, Limit, Scenario, Way

_GRID = (Way.GRID,)
_HELD = "measured, held"
_OURS = "chosen here"
_SAFE = (
    Limit("contacts", most=0.0, ways=ALL, source="nothing is touched"),
    Limit("off_goal", most=0.10, ways=BOTH, source=_OURS),
)
_TRACKING_BOUND = 0.10
"""Of the site: how far the drone may be off its path before a plan is no longer safe [m]."""
_DRAUGHT = 1.0
"""[m/s]"""
_GUST = 0.3 / 0.58
"""Gusts that push with 0.3 m/s^2, one sigma, at the drone's drag [m/s]."""
_LIFT_PER_AIR_SPEED, _GRAVITY = 0.35, 9.81
_LIGHTER = 0.1 * DRONE_MASS * _GRAVITY / _LIFT_PER_AIR_SPEED
"""Rising air that carries a tenth of the weight [m/s]."""


def _every(legs: int) -> Limit:
    return Limit("arrived", least=float(legs), ways=BOTH, source="every one arrives")


def _errands(speed: float, limits: tuple[Limit, ...], quick: bool = False) -> Scenario:
    return Scenario(
        name=f"errands-{speed}",
        title=f"25 errands in B-sen at {speed} m/s",
        kind=FlightKind.ERRANDS,
        goals=BSEN_ERRANDS,
        changes={"limits__speed": speed},
        limits=(*_SAFE, _every(25), *limits),
        quick=quick,
    )


_EXACT = (
    Limit("clearance", least=0.48),
    Limit("overshoot", most=0.020),
    Limit("clearance", least=0.46, ways=_GRID, source=_HELD),
    Limit("overshoot", most=0.065, ways=_GRID, source=_HELD),
    Limit("reference_rms", most=0.040, ways=_GRID, source=_HELD),
)
_ERRANDS = (
    _errands(0.5, (*_EXACT, Limit("reference_rms", most=0.030), Limit(
        "time", most=470.0, ways=_GRID, source=_HELD))),
    _errands(1.0, (*_EXACT, Limit("time", most=210.0), Limit("reference_rms", most=0.030), Limit(
        "time", most=375.0, ways=_GRID, source=_HELD)), quick=True),
    _errands(1.5, (*_EXACT, Limit("time", most=165.0), Limit("reference_rms", most=0.050), Limit(
        "time", most=365.0, ways=_GRID, source=_HELD))),
)  # fmt: skip

_PLACES = (
    Scenario(
        name="small-house",
        title="25 errands in a furnished house (a ROS map) at 1.0 m/s",
        kind=FlightKind.ERRANDS,
        room=GateRoom.SMALL_HOUSE,
        goals=SMALL_HOUSE_ERRANDS,
        changes={"limits__speed": 1.0},
        limits=(*_SAFE, _every(25), Limit("time", most=250.0)),
    ),
    Scenario(
        name="service",
        title="the paper's service: to the entrance, look 3 s, home, land; 1.0 m/s",
        kind=FlightKind.SERVICE,
        changes={"limits__speed": 1.0, "twin__visitor_present": True},
        limits=(
            *_SAFE, _every(2), Limit("whole", most=34.0), Limit("ratio", most=1.15),
            Limit("touchdown", most=0.10, ways=BOTH, source=_OURS),
        ),
        ways=ALL,
    ),
    Scenario(
        name="slalom",
        title="round three poles and back, twice, at 1.0 m/s",
        kind=FlightKind.ERRANDS,
        room=GateRoom.SLALOM,
        goals=SLALOM_ERRANDS,
        changes={"limits__speed": 1.0},
        limits=(*_SAFE, _every(4), Limit("clearance", least=0.45, source=_OURS)),
    ),
    Scenario(
        name="door",
        title="a door of 0.8 m, 20 rooms, 5 times each",
        kind=FlightKind.ERRANDS,
        room=GateRoom.DOOR,
        goals=DOOR_ERRANDS,
        changes={"limits__speed": 1.0},
        rooms=20,
        limits=(
            Limit("contacts", most=0.0, ways=BOTH, source="nothing is touched"),
            Limit("arrived", least=100.0), Limit("gap", least=0.05, source=_OURS),
        ),
    ),
    Scenario(
        name="over-table",
        title="over a table of 0.75 m that cannot be flown round, and back",
        kind=FlightKind.ERRANDS,
        room=GateRoom.TABLE,
        goals=TABLE_ERRANDS,
        changes={"limits__speed": 1.0},
        limits=(*_SAFE, _every(2), Limit("height_max", most=_TRACKING_BOUND, source=_OURS)),
    ),
)  # fmt: skip


def _eight(rate: float, most: float) -> Scenario:
    return Scenario(
        name=f"eight-{rate:.0f}",
        title=f"a figure eight at 0.5 m/s, tracking at {rate:.0f} Hz",
        kind=FlightKind.EIGHT,
        room=GateRoom.HALL,
        changes={"limits__speed": 0.5, "twin__mocap_rate_hz": rate},
        limits=(*_SAFE, _every(1), Limit("reference_rms", most=most)),
        ways=ALL,
        quick=rate == 100.0,
    )


_EIGHTS = (_eight(100.0, 0.020), _eight(30.0, 0.040), _eight(10.0, 0.040))


def _short(
    name: str, title: str, most: float = 0.050, off_goal: float = 0.10, **more: object
) -> Scenario:
    return Scenario(
        name=name,
        title=f"{title}; 5 errands at 1.0 m/s",
        kind=FlightKind.ERRANDS,
        goals=SHORT_ERRANDS,
        limits=(
            _SAFE[0], _every(5), Limit("reference_rms", most=most, source=_OURS),
            Limit("off_goal", most=off_goal, ways=BOTH, source=_OURS),
            Limit("clearance", least=0.343 + 0.05, ways=BOTH, source=_OURS),
        ),
        **{"changes": {"limits__speed": 1.0}, **more},  # type: ignore[arg-type]
    )  # fmt: skip


def _tracked(name: str, title: str, **keys: float) -> Scenario:
    changes = {"limits__speed": 1.0} | {f"twin__mocap_{key}": n for key, n in keys.items()}
    return _short(name, title, changes=changes)


_TRACKING = (
    _tracked("rate-30", "tracking at 30 Hz", rate_hz=30.0),
    _tracked("rate-10", "tracking at 10 Hz", rate_hz=10.0),
    _tracked("latency-0", "no latency", latency=0.0),
    _tracked("latency-50", "latency 50 ms", latency=0.05),
    _tracked("latency-100", "latency 100 ms", latency=0.10),
    _tracked("latency-150", "latency 150 ms", latency=0.15),
    _tracked("loss", "20 % of the frames lost", dropout=0.2),
    _short("gaps", "no tracking for 300 ms, every 3 s", gap_every=3.0, gap=0.3),
)
_LAG = 7.0
"""Pole of the attitude response of the site's drone [1/s]."""
_DRONE = (
    _short("lag-slow", "the drone answers 40 % slower than believed",
           pilot_changes={"drone__attitude_lag": _LAG / 0.6}),
    _short("lag-fast", "the drone answers 40 % faster than believed",
           pilot_changes={"drone__attitude_lag": _LAG / 1.4}),
    _short("gusts", "gusts of 0.3 m/s^2, one sigma", 0.100, 0.20,
           weather=Disturbances(gust=_GUST)),
    _short("sag", "1 V lost under load", weather=Disturbances(voltage_sag=1.0)),
    _short("heavier", "weight + 10 %", 0.100,
           weather=Disturbances(payload=Payload(0.1 * DRONE_MASS))),
    _short("lighter", "weight - 10 %, as rising air", 0.100,
           weather=Disturbances(wind=(0.0, 0.0, _LIGHTER))),
)  # fmt: skip
_WEIGHED = tuple(
    replace(
        row,
        limits=(
            _SAFE[0],
            Limit("arrived", least=5.0, source="every one arrives"),
            Limit("height_end", most=0.03),
        ),
    )
    if row.name in ("heavier", "lighter")
    else row
    for row in _DRONE
)
"""The grid planner's shipped pilot lands when its weight changes by a tenth in flight."""
_LANDING = Scenario(
    name="draught",
    title="landing in a draught of 1 m/s from four sides",
    kind=FlightKind.LANDING,
    winds=((_DRAUGHT, 0.0), (0.0, _DRAUGHT), (-_DRAUGHT, 0.0), (0.0, -_DRAUGHT)),
    limits=(
        Limit("contacts", most=0.0, ways=BOTH, source="nothing is touched"),
        Limit("arrived", least=4.0, ways=BOTH, source="every one lands"),
        Limit("touchdown", most=0.10),
    ),
    quick=True,
)
GATE_ROWS: tuple[Scenario, ...] = (*_ERRANDS, *_PLACES, *_EIGHTS, *_TRACKING, *_WEIGHED, _LANDING)
ABLATED = _short(
    "ablated",
    "in a draught of 0.5 m/s, 5 % heavier",
    weather=Disturbances(wind=(0.5, 0.0, 0.0), payload=Payload(0.05 * DRONE_MASS)),
)
"""What is flown with one thing switched off at a time."""
PAPER_RATIO = 10.0
"""The figure eight must be so many times nearer to its line than mode paper."""
