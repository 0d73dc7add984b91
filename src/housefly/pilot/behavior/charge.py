"""Whether the charge suffices: for the way out, the way back and a landing above the floor."""

from __future__ import annotations

from housefly.config.limits import LimitsConfig
from housefly.geometry import Vec2
from housefly.messages.flight import OrderKind, OrderOutcome
from housefly.messages.words import Words, figure, percentage
from housefly.pilot.behavior.mission import Mission, Refused, VehicleStatus
from housefly.pilot.behavior.navigator import Navigator
from housefly.pilot.behavior.way_home import charge_for


def charge_refusal(
    mission: Mission, vehicle: VehicleStatus, navigator: Navigator, limits: LimitsConfig
) -> Refused | None:
    """Return why the charge does not suffice for a mission and the way home, None when it does."""
    if mission.kind is OrderKind.HOME or vehicle.place is None:
        return None
    home = navigator.home().goal
    goal = mission.goal or vehicle.place
    seconds = _duration(navigator, vehicle.place, mission.goal) + mission.look_s
    seconds += _duration(navigator, goal, home)
    needed = charge_for(seconds, 1.0 / limits.flight_time, limits)
    if vehicle.battery >= needed:
        return None
    words = Words(
        "the battery is too low: {p}%, there and back ({n} s) needs {q}%; charge it",
        p=percentage(vehicle.battery),
        n=figure(seconds, ".0f"),
        q=percentage(needed),
    )
    return Refused(OrderOutcome.BATTERY, words)


def _duration(navigator: Navigator, start: Vec2, goal: Vec2 | None) -> float:
    return navigator.route(start, goal).duration if goal is not None else 0.0
