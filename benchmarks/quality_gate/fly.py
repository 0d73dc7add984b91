"""Flies one row of the gate in one way, and returns it in numbers."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from dataclasses import replace
from typing import Any

from housefly.numeric import FloatArray
from housefly.pilot.planning.space.oriented_hull import OrientedHull
from housefly.pilot.planning.space.solid_rows import room_rows
from housefly.sites.loaded_site import LoadedSite
from housefly.twin.disturbance import Disturbances
from quality_gate.flown_row import FlownLeg, FlownRow, row_measures
from quality_gate.legs import FlightStage, legs_of
from quality_gate.preset_way import figure_eight, preset_way
from quality_gate.quality_flight import QualityFlight
from quality_gate.rooms import gate_site
from quality_gate.scenario import WAY_CHANGES, FlightKind, Scenario, Way

_HULL_HALF_HEIGHT = 0.065
"""Of the AR.Drone with its indoor hull [m]."""
_EIGHT_WIDTH, _EIGHT_ROUNDS, _EIGHT_SPEED = 3.0, 1, 0.5
"""[m], times, [m/s]."""
_EIGHT_STEP, _PAPER_STEP = 0.1, 0.5
"""Corners of the eight: fine, and as far apart as on the paper's grid [m]."""
_LONG_BATTERY = {"limits__flight_time": 7200.0}
"""25 errands are flown on one charge [s]."""


def fly_row(
    scenario: Scenario,
    way: Way,
    key: str,
    changes: dict[str, Any],
    on_leg: Callable[[FlownLeg], None] = lambda leg: None,
    errands_max: int | None = None,
) -> FlownRow:
    """Fly a row.

    Args:
        scenario: which.
        way: how its ways are found and flown.
        key: kept with the result.
        changes: of the site's keys, beside those of the row.
        on_leg: called after each leg.
        errands_max: no more errands than this, and one room and one wind.

    Raises:
        ConfigError: this tree does not know a key of the row or the way.
    """
    began = time.process_time()
    legs: list[FlownLeg] = []
    touched, grounded = set[str](), ""
    for stage in _stages(scenario, way, changes, errands_max):
        for leg in legs_of(stage):
            legs.append(leg)
            on_leg(leg)
        touched.update(stage.flight.contacts)
        grounded = grounded or stage.flight.no_hover
    outcome = next((leg.outcome for leg in legs if leg.outcome), grounded)
    if touched:
        outcome = f"touched {', '.join(sorted(touched))}; {outcome}".rstrip("; ")
    return FlownRow(
        row=scenario.name,
        way=way.value,
        key=key,
        measures=row_measures(tuple(legs), len(touched)),
        legs=tuple(legs),
        outcome=outcome,
        processor_s=time.process_time() - began,
    )


def _stages(
    scenario: Scenario, way: Way, changes: dict[str, Any], errands_max: int | None
) -> Iterator[FlightStage]:
    """Yield the flights of a row: one for each room and wind, of a cut only the first."""
    common = _LONG_BATTERY | scenario.changes
    merged = common | WAY_CHANGES[way] | changes
    few = errands_max is not None
    for number in range(1 if few else scenario.rooms):
        yardstick = gate_site(scenario.room, number, **common)
        loaded = gate_site(scenario.room, number, **merged)
        believed = None
        if scenario.pilot_changes:
            believed = gate_site(scenario.room, number, **(merged | scenario.pilot_changes))
        for wind in scenario.winds[: 1 if few else None] or (None,):
            weather = scenario.weather
            if wind is not None:
                weather = replace(weather, wind=(*wind, 0.0))
            flight, line = _flight(scenario, way, loaded, believed, weather)
            drone = loaded.site.drone
            yield FlightStage(
                scenario=scenario,
                loaded=loaded,
                yardstick=yardstick,
                flight=flight,
                solids=room_rows(loaded.room),
                hull=OrientedHull(drone.hull_length / 2, drone.hull_width / 2, _HULL_HALF_HEIGHT),
                line=line,
                errands_max=errands_max,
            )


def _flight(
    scenario: Scenario,
    way: Way,
    loaded: LoadedSite,
    believed: LoadedSite | None,
    weather: Disturbances,
) -> tuple[QualityFlight, FloatArray | None]:
    """Return a drone on its pad, and the line that it should keep to, if it has one."""
    line, preset = None, nullcontext()
    if scenario.kind is FlightKind.EIGHT:
        (x0, y0, x1, y1), height = loaded.room.bounds, loaded.site.map.flight_height
        line = figure_eight(((x0 + x1) / 2, (y0 + y1) / 2), _EIGHT_WIDTH, _EIGHT_ROUNDS)
        step = _PAPER_STEP if way is Way.PAPER else _EIGHT_STEP
        preset = preset_way(line, step, _EIGHT_SPEED, height)  # type: ignore[assignment]
    with preset:
        flight = QualityFlight(loaded, believed, weather, scenario.gap_every, scenario.gap)
    return flight, line
