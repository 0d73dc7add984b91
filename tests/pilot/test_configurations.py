"""Any combination of a site's numbers is refused in words, or flown stably: scored on the truth.

Each value of a combination may be legal and the combination still unstable; so whole combinations
are drawn, from the whole ranges of the site file: limits, gains, people, map, estimation, mode,
and how often and how late tracking sees the drone.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from math import dist, hypot
from typing import Any, get_args

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import Phase as Phases
from hypothesis import strategies as st
from pydantic.fields import FieldInfo

from housefly.config.control import ControlConfig
from housefly.config.estimation import EstimationConfig
from housefly.config.limits import LimitsConfig
from housefly.config.map import MapConfig
from housefly.config.people import PeopleConfig
from housefly.config.section import Section
from housefly.config.site import Site, changed
from housefly.errors import ConfigError
from housefly.geometry import Vec2
from housefly.messages import DroneStatus, Inputs, OrderKind, Outputs, Phase

Fly = Callable[..., Any]
SECTIONS: dict[str, type[Section]] = {
    "limits": LimitsConfig,
    "control": ControlConfig,
    "people": PeopleConfig,
    "map": MapConfig,
    "estimation": EstimationConfig,
}
KEPT = ("rate_hz", "take_off_timeout", "flight_time", "hold_timeout", "battery_floor")
"""Not drawn: the rate has its own strategy, the others make a flight only longer or shorter."""
RATES = st.sampled_from([100, 50, 25, 20])
TRACKING = st.fixed_dictionaries(
    {
        "rate_hz": st.sampled_from([200.0, 100.0, 50.0, 30.0, 20.0, 10.0]),
        "latency": st.sampled_from([0.0, 0.02, 0.05, 0.1, 0.3]),
        "noise": st.sampled_from([0.0002, 0.001, 0.005]),  # 5 mm only where a filter bears it
        "loss": st.sampled_from([0.0, 0.0, 0.1]),
    }
)
"""What motion capture systems do; the site says the latency."""
TOGETHER = 14
"""Most keys of one combination: of more, nearly all are refused for one that contradicts."""
GOAL = (4.0, 1.25)
"""Two metres ahead of the pad."""
QUICK_FILTER = 600.0
"""A filter of a larger ``acceleration_noise / position_noise`` bears tracking of 1 mm [1/s^2]."""
STRAY_MAX, SWING_MAX, SPEED_MAX = 1.0, 0.5, 0.4
"""Farthest from the way [m]; largest swing [m] and speed [m/s] while it holds its place."""
FLIGHT_MAX, HELD, JUDGED, LANDING_MAX = 2600, 900, 300, 9000
"""How long it may fly, how long it is to hold and is judged at the end of that (mode paper arrives
with speed: it overshoots by half a metre and comes back), how long it may take to land [ticks].
"""


def from_segment(here: Vec2, a: Vec2, b: Vec2) -> float:
    """Return the distance of a point from a line between two others [m]."""
    way, off = np.subtract(b, a), np.subtract(here, a)
    share = np.clip(off @ way / max(float(way @ way), 1e-12), 0.0, 1.0)
    return float(np.hypot(*(off - share * way)))


def value_of(field: FieldInfo) -> st.SearchStrategy[Any] | None:
    """Return a strategy for a number, a choice or a truth; the ends of a range come often."""
    low = next((m.ge for m in field.metadata if hasattr(m, "ge")), None)
    if low is not None:
        high = next(m.le for m in field.metadata if hasattr(m, "le"))
        return st.floats(low, high) | st.sampled_from([low, high])
    if field.annotation is bool:
        return st.booleans()
    words = [one for one in get_args(field.annotation) if isinstance(one, str)]
    return st.sampled_from(words) if words else None


VALUES = {
    f"{name}__{key}": value
    for name, section in SECTIONS.items()
    for key, field in section.model_fields.items()
    if key not in KEPT and (value := value_of(field)) is not None
}
COMBINATIONS = st.lists(
    st.sampled_from(sorted(VALUES)), min_size=1, max_size=TOGETHER, unique=True
).flatmap(lambda keys: st.fixed_dictionaries({key: VALUES[key] for key in keys}))
MODES = st.sampled_from(["default", "default", "default", "paper"])


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


def try_out(
    fly: Fly, mode: str, keys: dict[str, Any], rate_hz: float, tracking: dict[str, float]
) -> str:
    """Take off, fly two metres, hold and land; return how it ended, after checking the truth."""
    control = ControlConfig()
    ratio = keys.get("control__acceleration_noise", control.acceleration_noise) / keys.get(
        "control__position_noise", control.position_noise
    )
    if ratio > QUICK_FILTER:
        tracking = {**tracking, "noise": min(tracking["noise"], 0.001)}
    given_keys = {
        **keys,
        "map__paper_rectangle": (0.0, 0.0, 12.5, 5.0),
        "tracking__latency": tracking["latency"],
    }
    try:
        changed(Site(), mode=mode, **given_keys)
    except ConfigError as error:
        assert error.key and len(error.problem) > 20
        return "refused"
    flight = fly(mode=mode, tracking=tracking, is_mapped=True, tick=0.01, **given_keys)
    flight.pilot = SlowPilot(flight.pilot, rate_hz)
    flight.run(0.5)
    flight.step(flight.order(OrderKind.GO, goal=GOAL))
    held: list[tuple[float, float]] = []
    for tick in range(FLIGHT_MAX):
        outputs = flight.step()
        _check_way(flight, f"at {0.01 * tick:.1f} s")
        if tick > 100 and flight.status is DroneStatus.LANDED:
            assert flight.events, "it stands without a word"
            return f"stands: {flight.events[-1].code}"
        held = [*held, (flight.body.x, flight.body.y)] if outputs.phase is Phase.HOLDING else []
        if len(held) >= HELD:
            break
    end = outputs.phase.value
    if len(held) >= HELD:
        swing = float(np.ptp(np.array(held[-JUDGED:]), axis=0).max())
        speed = hypot(flight.body.vx, flight.body.vy)
        assert swing < SWING_MAX and speed < SPEED_MAX, f"swings {swing:.2f} m at {speed:.2f} m/s"
        end = f"held {dist(held[-1], GOAL):.2f} m from its goal"
    flight.step(flight.order(OrderKind.LAND))
    for tick in range(LANDING_MAX):
        flight.step()
        _check_way(flight, f"landing for {0.01 * tick:.1f} s")
        if flight.status is DroneStatus.LANDED:
            return end
    raise AssertionError(f"still in the air at {flight.body.z:.2f} m, {LANDING_MAX / 100} s later")


def _check_way(flight: Any, when: str) -> None:
    """Check that the drone is near the straight way, or near the one that is planned."""
    here = (flight.body.x, flight.body.y)
    stray = max(0.0, 2.0 - here[0], here[0] - GOAL[0]) + abs(here[1] - 1.25)
    path = flight.outputs.path
    if stray >= STRAY_MAX and path is not None and len(path.waypoints) > 1:
        ways = pairwise(path.waypoints)
        stray = min(from_segment(here, (a[0], a[1]), (b[0], b[1])) for a, b in ways)
    assert stray < STRAY_MAX, f"{stray:.2f} m from its way {when}"
    assert flight.status is not DroneStatus.EMERGENCY, f"its motors were cut {when}"


def draw(fly: Fly, number: int) -> dict[str, int]:
    """Try so many combinations; return how they ended."""
    ends: dict[str, int] = {}

    @settings(
        max_examples=number,
        deadline=None,
        phases=(Phases.generate,),
        suppress_health_check=list(HealthCheck),
    )
    @given(MODES, COMBINATIONS, RATES, TRACKING)
    def one(mode: str, keys: dict[str, Any], rate_hz: float, tracking: dict[str, float]) -> None:
        try:
            end = try_out(fly, mode, keys, rate_hz, tracking).split(" 0.")[0]
        except AssertionError as error:
            error.add_note(f"mode {mode} at {rate_hz} Hz with {keys}, tracking {tracking}")
            raise
        ends[end] = ends.get(end, 0) + 1

    one()
    return ends


def test_a_combination_of_a_sites_numbers_is_refused_or_flown_stably(fly: Fly) -> None:
    assert sum(draw(fly, 12).values()) == 12


@pytest.mark.safety
@pytest.mark.timeout(3600)
def test_four_hundred_combinations_are_refused_or_flown_stably(fly: Fly) -> None:
    ends = draw(fly, 400)
    assert sum(ends.values()) == 400 and len(ends) > 2, ends
