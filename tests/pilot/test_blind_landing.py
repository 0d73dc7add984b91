"""Without tracking, above what only the sonar shows: held, moved aside, landed when it can."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import inf
from typing import Any

import pytest

from housefly.geometry import Vec2, distance
from housefly.messages import DroneStatus, OrderKind, OrderSource, Phase, SafetyMode
from housefly.pilot.behavior import blind_landing

Fly = Callable[..., Any]
PLACE = (3.5, 2.5)


class Blind:
    """A drone that hovers above something of which only its sonar tells, and tracking is lost."""

    def __init__(self, fly: Fly, place: Vec2 = PLACE, top: float = 0.6) -> None:
        self.top, self.silent, self.reach = top, False, 0.4
        self.flight = flight = fly()
        flight.hover(place)
        self.place = flight.body.x, flight.body.y
        self._step, flight.pilot.step = flight.pilot.step, self.told
        flight.tracking.gaps = ((flight.now, inf),)

    @property
    def away(self) -> float:
        """How far the drone is from what stands there [m]."""
        return distance((self.flight.body.x, self.flight.body.y), self.place)

    def told(self, now: float, inputs: Any) -> Any:
        """Let the drone's own sensors tell what they meet."""
        below = self.top if self.away < self.reach else 0.0
        heard = inputs.telemetry
        heard = replace(heard, height=max(0.0, heard.height - below))
        if self.silent:
            heard = replace(heard, velocity=(0.0, 0.0, 0.0))
        return self._step(now, replace(inputs, telemetry=heard))

    def land(self, limit: float = 30.0) -> float:
        """Let it land; return how high it was at least where something stands [m]."""
        lowest, end = inf, self.flight.now + limit
        while self.flight.status is not DroneStatus.LANDED and self.flight.now < end:
            self.flight.step()
            lowest = min(lowest, self.flight.body.z) if self.away < 0.45 else lowest
        return lowest


def test_it_moves_aside_says_so_and_lands_there(fly: Fly) -> None:
    blind = Blind(fly)
    outputs = blind.flight.run(2.5)
    assert outputs.safety is SafetyMode.LAND and outputs.phase is Phase.LANDING
    assert "lost for" in outputs.reason and "0.6 m high" in outputs.reason
    assert blind.land() > 0.8
    assert blind.flight.status is DroneStatus.LANDED and 0.9 < blind.away < 2.3
    told = [event.text for event in blind.flight.events if event.code == "landing_blocked"]
    assert len(told) == 1 and "0.6 m high" in told[0] and "Press Land" in told[0]
    assert blind.flight.told("landing_elsewhere") and not blind.flight.told("landing_late")


def test_with_nothing_below_it_lands_where_it_is_at_once(fly: Fly) -> None:
    blind = Blind(fly, top=0.0)
    blind.land(8.0)
    assert blind.flight.status is DroneStatus.LANDED and blind.away < 0.3
    assert not blind.flight.told("landing_blocked")


def test_where_who_stood_below_goes_away_it_lands(fly: Fly) -> None:
    blind = Blind(fly, place=(1.0, 2.5))
    blind.flight.until(lambda o: blind.flight.told("tracking_old"), 5.0)
    blind.flight.run(1.4)
    blind.top = 0.0
    blind.land(10.0)
    assert blind.flight.status is DroneStatus.LANDED and blind.away < 0.5


def test_somebody_who_presses_land_lands_it_there_and_a_task_does_not(fly: Fly) -> None:
    blind = Blind(fly)
    flight = blind.flight
    flight.until(lambda o: flight.told("landing_blocked"), 5.0)
    flight.step(replace(flight.order(OrderKind.LAND), source=OrderSource.TASK))
    assert flight.run(0.3).safety is SafetyMode.LAND and flight.status is DroneStatus.FLYING
    flight.step(flight.order(OrderKind.LAND))
    flight.run(0.3)
    assert flight.status is DroneStatus.LANDING
    assert flight.told("landing_insisted")


def test_a_charge_that_ends_lands_it_where_it_is(fly: Fly) -> None:
    blind = Blind(fly)
    blind.flight.until(lambda o: blind.flight.told("landing_blocked"), 5.0)
    blind.flight.battery = 0.1
    blind.flight.run(1.8)
    assert blind.flight.status is DroneStatus.LANDING


def test_under_stop_it_stays_above_who_is_below_and_moves_nowhere(fly: Fly) -> None:
    blind = Blind(fly)
    blind.flight.step(blind.flight.order(OrderKind.STOP))
    assert blind.land(8.0) > 0.8
    assert blind.flight.status is DroneStatus.FLYING and blind.away < 0.3


def test_a_sonar_that_shows_something_everywhere_does_not_keep_it_up_for_ever(fly: Fly) -> None:
    blind = Blind(fly)
    blind.reach = inf
    blind.land(60.0)
    assert blind.flight.status is DroneStatus.LANDED
    assert any("everywhere" in event.text for event in blind.flight.events)


def test_a_drone_that_does_not_tell_how_it_moves_sinks_where_it_is(fly: Fly) -> None:
    blind = Blind(fly)
    blind.silent = True
    assert blind.flight.run(2.5).safety is SafetyMode.DESCEND
    assert not blind.flight.told("landing_elsewhere")


def test_beside_a_wall_it_lands_where_it_is(fly: Fly, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its own motion is not known well enough to stay there."""
    monkeypatch.setattr(blind_landing, "WALL_MARGIN", 0.3)
    blind = Blind(fly, place=(3.5, 0.55))
    blind.flight.run(2.5)
    assert blind.flight.status is DroneStatus.LANDING


@pytest.mark.parametrize("top", [0.34, 0.9])
def test_in_a_draught_it_leaves_who_lies_and_who_is_tall_alike(fly: Fly, top: float) -> None:
    blind = Blind(fly, top=top)
    blind.flight.wind = (0.25, -0.15)
    assert blind.land() > top + 0.1
    assert blind.flight.status is DroneStatus.LANDED and blind.away > 0.7
