"""What a person who wrote a campaign may not have meant."""

from __future__ import annotations

from itertools import pairwise
from math import dist

from housefly.lab.campaigns.plan import Leg, Plan
from housefly.lab.experiments.mission import SETTLE, Task


def notes(plan: Plan) -> list[str]:
    """Return what is strange although it is allowed: ways that no drone can fly to the end in the
    time given.
    """
    given = {*plan.spec.fixed, *plan.spec.grid, *plan.spec.draw}
    return [] if "speed" in given else [note for leg in plan.legs for note in _too_short(leg)]


def _too_short(leg: Leg) -> list[str]:
    mission = leg.mission
    length = sum(dist(start, stop) for start, stop in pairwise(mission.waypoints))
    needed = SETTLE + length / leg.site.limits.speed
    if mission.task is not Task.PATH or needed <= mission.duration:
        return []
    way = f"the {length:.1f} m in mode {leg.site.mode} take at least {needed:.0f} s"
    return [f"mission.duration_s is {mission.duration:g} s, but {way}: no drone will arrive"]
