"""Any combination of limits and gains is refused in words, or flown stably: scored on the truth.

Each value of a combination may be legal and the combination still unstable; so whole combinations
are drawn, from the whole ranges of the site file.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import dist, hypot
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import Phase as Phases
from hypothesis import strategies as st

from housefly.config.control import ControlConfig
from housefly.config.limits import LimitsConfig
from housefly.config.section import Section
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.messages import DroneStatus, Inputs, OrderKind, Outputs, Phase

Fly = Callable[..., Any]
KEPT = (
    *("rate_hz", "take_off_timeout", "flight_time", "hold_timeout", "battery_floor"),
    *("acceleration", "jerk", "vertical_acceleration"),
)
"""Not drawn: the rate has its own strategy, the others make a flight only longer or shorter, or
count for trajectories in space only.
"""
RATES = st.sampled_from([100, 50, 25, 20])
GOAL = (4.0, 1.25)
"""Two metres ahead of the pad."""
STRAY_MAX, SWING_MAX, SPEED_MAX = 1.0, 0.5, 0.4
"""Farthest from the way [m]; largest swing [m] and speed [m/s] while it holds its place."""


def bounds(field: Any) -> tuple[float, float]:
    low = next(m.ge for m in field.metadata if hasattr(m, "ge"))
    return low, next(m.le for m in field.metadata if hasattr(m, "le"))


def values_of(section: type[Section], name: str) -> st.SearchStrategy[dict[str, float]]:
    """Return a strategy for some keys of a section; the ends of a range come often."""
    keys = {}
    for key, field in section.model_fields.items():
        if key not in KEPT:
            low, high = bounds(field)
            value = st.floats(low, high) | st.sampled_from([low, high])
            keys[f"{name}__{key}"] = value
    return st.fixed_dictionaries({}, optional=keys)


COMBINATIONS = st.builds(
    lambda limits, control: {**limits, **control},
    values_of(LimitsConfig, "limits"),
    values_of(ControlConfig, "control"),
)


class SlowPilot:
    """Steps a pilot at its own rate, in a loop of 100 Hz."""

    def __init__(self, pilot: Any, rate_hz: float) -> None:
        self._pilot, self._every, self._count = pilot, round(100 / rate_hz), 0
        self._waiting, self._last = Inputs(), None

    def step(self, now: float, inputs: Inputs) -> Outputs:
        self._waiting = replace(
            inputs,
            sightings=self._waiting.sightings + inputs.sightings,
            orders=self._waiting.orders + inputs.orders,
        )
        self._count += 1
        if self._last is None or self._count % self._every == 0:
            self._last, self._waiting = self._pilot.step(now, self._waiting), Inputs()
            return self._last
        return replace(self._last, events=())


def try_out(fly: Fly, keys: dict[str, float], rate_hz: float) -> str:
    """Take off, hold, fly two metres and hold; return how it ended, after checking the truth."""
    try:
        changed(Site(), **keys)
    except ConfigError as error:
        assert error.key and len(error.problem) > 20
        return "refused"
    flight = fly(**keys)
    flight.pilot = SlowPilot(flight.pilot, rate_hz)
    flight.run(0.5)
    flight.step(flight.order(OrderKind.GO, goal=GOAL))
    track = []
    for tick in range(2200):
        outputs = flight.step()
        track.append((flight.body.x, flight.body.y, flight.body.z))
        stray = max(0.0, 2.0 - flight.body.x, flight.body.x - GOAL[0]) + abs(flight.body.y - 1.25)
        assert stray < STRAY_MAX, f"{stray:.2f} m from its way at {0.01 * tick:.1f} s"
        if tick > 100 and flight.status is DroneStatus.LANDED:
            assert flight.events, "it landed without a word"
            return f"landed: {flight.events[-1].code}"
    if outputs.phase is Phase.HOLDING:
        held = np.array(track[-300:])
        swing = float(np.ptp(held[:, :2], axis=0).max())
        speed = hypot(flight.body.vx, flight.body.vy)
        assert swing < SWING_MAX and speed < SPEED_MAX, f"swings {swing:.2f} m at {speed:.2f} m/s"
        return f"held {dist(track[-1][:2], GOAL):.2f} m from its goal"
    return outputs.phase.value


def draw(fly: Fly, number: int) -> dict[str, int]:
    """Try so many combinations; return how they ended."""
    ends: dict[str, int] = {}

    @settings(
        max_examples=number,
        deadline=None,
        phases=(Phases.generate,),
        suppress_health_check=list(HealthCheck),
    )
    @given(COMBINATIONS, RATES)
    def one(keys: dict[str, float], rate_hz: float) -> None:
        end = try_out(fly, keys, rate_hz).split(" 0.")[0]
        ends[end] = ends.get(end, 0) + 1

    one()
    return ends


def test_a_combination_of_limits_and_gains_is_refused_or_flown_stably(fly: Fly) -> None:
    assert sum(draw(fly, 10).values()) == 10


@pytest.mark.safety
@pytest.mark.timeout(3600)
def test_two_hundred_combinations_are_refused_or_flown_stably(fly: Fly) -> None:
    ends = draw(fly, 200)
    assert sum(ends.values()) == 200 and len(ends) > 2, ends
